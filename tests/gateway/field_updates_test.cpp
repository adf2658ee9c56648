// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/field_updates.hpp"

#include <gtest/gtest.h>

#include "tests/support/meshes.hpp"

namespace tedit::gateway {
namespace {

/// A solve of a cube whose fields are all `value`.
actors::solved solved_with(double value) {
  actors::solved event;
  event.document = "cube";
  event.version = test::box_mesh({1, 1, 1}, {1, 1, 1});
  event.number = 7;
  const auto slots = event.version->vertex_slots();
  const auto array = [&](const char* name, int components) {
    const std::vector<double> values(slots * static_cast<std::size_t>(components), value);
    return field{name, field_location::vertex, components, paged_array<double>::from(values)};
  };
  event.fields = std::make_shared<const std::vector<field>>(std::vector<field>{
    array("displacement_m", 3), array("von_mises_pa", 1), array("stress_pa", 6)});
  event.outcome = std::make_shared<const solve_outcome>(solve_outcome{{solve_report{}}, {}, 7});
  return event;
}

TEST(FieldUpdates, WhatSeveralWatchIsMadeOnce) {
  field_updates updates;
  auto event = solved_with(1);
  const auto first = updates.get(event, 0, {});
  event.document = "dice";  // Renamed since.
  auto second = updates.get(event, 0, {});
  const auto more = updates.get(event, 0, {"stress_pa"});

  ASSERT_TRUE(first && second && more);
  EXPECT_EQ(first->owner, second->owner);
  EXPECT_NE(first->owner, more->owner);
  EXPECT_EQ(first->header.field_update().document(), "cube");
  EXPECT_EQ(second->header.field_update().document(), "dice");
  EXPECT_EQ(second->header.field_update().solve(), 7u);
  EXPECT_EQ(second->stream, second->header.mutable_field_update()->mutable_stream());
  // Vertices, displacement, von Mises: 8 of each, 4 bytes a number.
  EXPECT_EQ(second->stream->bytes(), 8u * (1 + 3 + 1) * 4);
  EXPECT_EQ(more->stream->bytes(), 8u * (1 + 3 + 1 + 6) * 4);
  EXPECT_FALSE(updates.get(event, 1, {}).has_value());
}

TEST(FieldUpdates, AnotherSolveHasItsOwn) {
  field_updates updates;
  auto event = solved_with(1);
  const auto first = updates.get(event, 0, {});
  event = solved_with(2);
  auto second = updates.get(event, 0, {});

  ASSERT_TRUE(first && second);
  EXPECT_NE(first->owner, second->owner);
  float value = 0;
  std::memcpy(&value, second->parts.front().data() + std::size_t{8} * 4, sizeof(value));
  EXPECT_EQ(value, 2);
}

TEST(FieldUpdates, WhatIsMadeOfResultsThatAreGoneIsNotKept) {
  field_updates updates;
  auto first = solved_with(1);
  const std::weak_ptr<const void> made = updates.get(first, 0, {})->owner;
  const auto second = solved_with(2);
  ASSERT_TRUE(updates.get(second, 0, {}).has_value());
  EXPECT_FALSE(made.expired()) << "somebody who has these results may want it";

  first.fields.reset();
  ASSERT_TRUE(updates.get(second, 0, {}).has_value());

  EXPECT_TRUE(made.expired());
}

}  // namespace
}  // namespace tedit::gateway
