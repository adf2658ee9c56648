// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/carried_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedit::desktop {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

client::surface_model surface(const std::string& version,
                              const std::vector<std::uint32_t>& vertices,
                              const std::vector<double>& positions) {
  client::surface_update update;
  update.version_id = version;
  update.vertices = vertices;
  update.positions = positions;
  client::surface_model made;
  EXPECT_TRUE(made.apply(update).has_value());
  return made;
}

TEST(CarriedField, KeepsTheValuesOfVerticesThatStayWhereTheyAre) {
  // 3 stays, 4 moves, 5 goes, 6 comes.
  const auto before = surface("a", {3, 4, 5}, {0, 0, 0, 1, 0, 0, 2, 0, 0});
  const auto after = surface("b", {3, 4, 6}, {0, 0, 0, 1, 0, 0.5, 2, 0, 0});
  client::field_event field;
  field.report.version_id = "a";
  field.vertices = {3, 4, 5};
  field.von_mises = {10, 20, 30};
  field.displacement = {1, 2, 3, 4, 5, 6, 7, 8, 9};

  const auto carried = carried_field(field, before, after);

  EXPECT_EQ(carried->version_id(), "b");
  EXPECT_THAT(carried->vertices, ElementsAre(3));
  EXPECT_THAT(carried->von_mises, ElementsAre(10));
  EXPECT_THAT(carried->displacement, ElementsAre(1, 2, 3));
  EXPECT_THAT(carried->stress, IsEmpty());
}

TEST(CarriedField, OfAnEnvelopeIsAnEnvelope) {
  const auto before = surface("a", {0, 1}, {0, 0, 0, 1, 0, 0});
  const auto after = surface("b", {0, 1}, {5, 0, 0, 1, 0, 0});
  client::field_event field;
  field.envelope.emplace();
  field.envelope->version_id = "a";
  field.vertices = {0, 1};
  field.von_mises = {10, 20};
  field.von_mises_case = {0, 1};

  const auto carried = carried_field(field, before, after);

  ASSERT_TRUE(carried->envelope);
  EXPECT_EQ(carried->version_id(), "b");
  EXPECT_THAT(carried->von_mises, ElementsAre(20));
  EXPECT_THAT(carried->von_mises_case, ElementsAre(1));
  EXPECT_THAT(carried->displacement, IsEmpty());
}

}  // namespace
}  // namespace tedit::desktop
