// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/print_checks.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tests/support/meshes.hpp"

namespace tedit::gateway {
namespace {

/// A cube of 12 facets, of which 3 is thin, 5 overhangs and 8 does both.
actors::print_checked checked_cube() {
  actors::print_checked made;
  made.document = "cube";
  made.number = 4;
  made.settings = {{0, 1, 0}, 2e-3, 0.5};
  made.mesh = tedit::test::box_mesh({1, 1, 1}, {1, 1, 1});
  auto what = std::make_shared<print_report>();
  what->bodies = 1;
  what->thickness.assign(made.mesh->facet_slots(), std::numeric_limits<double>::infinity());
  what->overhanging.assign(made.mesh->facet_slots(), false);
  what->thickness[3] = what->thickness[8] = 1e-3;
  what->overhanging[5] = what->overhanging[8] = true;
  made.what = what;
  return made;
}

TEST(PrintCheckAnswers, TheStreamHasTheMarkedFacetsAlone) {
  const auto made = checked_cube();
  ASSERT_EQ(made.mesh->facet_slots(), 12U);
  const auto result = make_print_check(made);

  const auto& message = result.header.print_checked();
  EXPECT_EQ(message.document(), "cube");
  EXPECT_EQ(message.version(), 4U);
  EXPECT_EQ(message.version_id(), to_hex(made.mesh->id()));
  EXPECT_EQ(message.thinner_than_m(), 2e-3);
  EXPECT_EQ(message.direction().y(), 1);
  ASSERT_EQ(message.stream().arrays_size(), 2);
  EXPECT_EQ(message.stream().arrays(0).name(), "facets");
  EXPECT_EQ(message.stream().arrays(1).name(), "marks");
  ASSERT_EQ(message.stream().bytes(), 3U * (4 + 1));
  const auto bytes = result.parts.front();
  const std::pair<std::uint32_t, unsigned> expected[] = {{3, 1}, {5, 2}, {8, 3}};
  for (std::size_t i = 0; i < 3; ++i) {
    std::uint32_t slot = 0;
    std::memcpy(&slot, bytes.data() + 4 * i, sizeof(slot));
    EXPECT_EQ(slot, expected[i].first);
    EXPECT_EQ(static_cast<unsigned>(bytes[12 + i]), expected[i].second);
  }
}

}  // namespace
}  // namespace tedit::gateway
