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
  field.values["von_mises_pa"] = {10, 20, 30};
  field.values["displacement_m"] = {1, 2, 3, 4, 5, 6, 7, 8, 9};

  const auto carried = carried_field(field, before, after);

  EXPECT_EQ(carried->version_id(), "b");
  EXPECT_THAT(carried->vertices, ElementsAre(3));
  EXPECT_THAT(carried->values.of("von_mises_pa"), ElementsAre(10));
  EXPECT_THAT(carried->values.of("displacement_m"), ElementsAre(1, 2, 3));
  EXPECT_THAT(carried->values.of("stress_pa"), IsEmpty());
}

TEST(CarriedField, OfAnEnvelopeIsAnEnvelope) {
  const auto before = surface("a", {0, 1}, {0, 0, 0, 1, 0, 0});
  const auto after = surface("b", {0, 1}, {5, 0, 0, 1, 0, 0});
  client::field_event field;
  field.envelope.emplace();
  field.envelope->version_id = "a";
  field.vertices = {0, 1};
  field.values["von_mises_pa"] = {10, 20};
  field.worst_cases["von_mises_pa"] = {0, 1};

  const auto carried = carried_field(field, before, after);

  ASSERT_TRUE(carried->envelope);
  EXPECT_EQ(carried->version_id(), "b");
  EXPECT_THAT(carried->values.of("von_mises_pa"), ElementsAre(20));
  EXPECT_THAT(carried->worst_cases.of("von_mises_pa"), ElementsAre(1));
  EXPECT_THAT(carried->values.of("displacement_m"), IsEmpty());
}

}  // namespace
}  // namespace tedit::desktop
