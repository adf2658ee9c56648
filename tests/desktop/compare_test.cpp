// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "client-qt/model/field_values.hpp"

namespace tedit::desktop {
namespace {

/// One triangle on slots 0, 1, 2 and a field of 10, 20 and 30 MPa, and x, 0, 0 as displacement.
version_record version(double lifted = 0, float stress = 10e6F) {
  client::surface_update update;
  update.version_id = "v";
  update.surfaces = {{1, "top", 1, 0.5}};
  update.vertices = {0, 1, 2};
  update.positions = {0, 0, 0, 1, 0, 0, 0, 1, lifted};
  update.facets = {0};
  update.facet_vertices = {0, 1, 2};
  update.facet_surfaces = {1};
  client::surface_model surface;
  EXPECT_TRUE(surface.apply(update));
  auto field = std::make_shared<client::field_event>();
  field->report.version_id = "v";
  field->report.load_case = "a";
  field->vertices = {0, 1, 2};
  field->values["von_mises_pa"] = {stress, 2 * stress, 3 * stress};
  field->values["displacement_m"] = {1, 0, 0, 2, 0, 0, 3, 4, 0};
  version_record result;
  result.surface = std::make_shared<const client::surface_model>(surface);
  result.fields = {field};
  return result;
}

TEST(Difference, IsTakenWhereSlotAndPositionAreTheSame) {
  const auto before = version();
  const auto after = version(0.1, 15e6F);

  const auto change =
    difference(before, before.fields[0], after, after.fields[0], shown_field::von_mises);

  EXPECT_EQ(change->vertices, (std::vector<std::uint32_t>{0, 1}));  // Slot 2 was moved.
  EXPECT_FLOAT_EQ(change->values.of("von_mises_pa")[0], 5e6F);
  EXPECT_FLOAT_EQ(change->values.of("von_mises_pa")[1], 10e6F);
}

TEST(Difference, OfASlotWithoutAFieldIsNone) {
  const auto before = version();
  auto after = version();
  auto shorter = std::make_shared<client::field_event>(*before.fields[0]);
  shorter->vertices = {1, 2};
  shorter->values["von_mises_pa"] = {20e6F, 30e6F};

  const auto change = difference(before, shorter, after, after.fields[0], shown_field::von_mises);

  EXPECT_EQ(change->vertices, (std::vector<std::uint32_t>{1, 2}));
}

TEST(Difference, OfTheDisplacementIsThatOfItsSize) {
  const auto before = version();
  auto after = version();
  auto moved = std::make_shared<client::field_event>(*after.fields[0]);
  moved->values["displacement_m"] = {1, 0, 0, 0, 2, 0, 0, 0, 0};

  const auto change = difference(before, before.fields[0], after, moved, shown_field::displacement);

  const auto as = difference_field(shown_field::displacement);
  EXPECT_FLOAT_EQ(value_at(*change, 1, as), 0);  // Turned, but as long as before.
  EXPECT_FLOAT_EQ(value_at(*change, 2, as), -5);
}

TEST(Difference, OfAStrainIsAStrainAndOfAPrincipalStressAStress) {
  const auto before = version();
  const auto after = version();
  for (const auto& [one, strain] : {std::pair(&before, 1e-6F), {&after, 3e-6F}}) {
    auto& values = std::const_pointer_cast<client::field_event>(one->fields[0])->values;
    values["largest_strain"].assign(3, strain);
    values["stress_pa"].assign(18, 1e12F * strain);  // All alike: thrice that is principal.
  }
  const auto change_of = [&](shown_field what) {
    const auto change = difference(before, before.fields[0], after, after.fields[0], what);
    return value_at(*change, 1, difference_field(what));
  };

  EXPECT_EQ(difference_field(field_named("largest_strain")), field_named("largest_strain"));
  EXPECT_FLOAT_EQ(change_of(field_named("largest_strain")), 2e-6F);
  EXPECT_EQ(field_unit(difference_field(field_named("principal_1"))), "Pa");
  EXPECT_NEAR(change_of(field_named("principal_1")), 6e6F, 10);
}

/// Three vertices, of which the last one lies outside of the version before.
client::comparison from_server() {
  client::comparison made;
  made.after = 2;
  made.load_case = "a";
  made.what.after_id = "after";
  made.vertices = {4, 7, 9};
  made.marks = {difference_mark::same, difference_mark::interpolated, difference_mark::outside};
  made.differences["von_mises_pa"] = {5e6F, -2e6F, 0};
  made.differences["displacement_m"] = {1, 2, 3, 4, 5, 6, 0, 0, 0};
  made.differences["safety_factor"] = {0.5F, 0, 0};
  return made;
}

TEST(DifferenceOfTheServer, HasNoValueOutsideOfTheVersionBefore) {
  const auto change = difference(from_server(), shown_field::von_mises);

  ASSERT_TRUE(change);
  EXPECT_EQ(change->report.load_case, "a");
  EXPECT_EQ(change->version_id(), "after");
  EXPECT_EQ(change->vertices, (std::vector<std::uint32_t>{4, 7}));
  EXPECT_EQ(change->values.of("von_mises_pa"), (std::vector<float>{5e6F, -2e6F}));
  EXPECT_FLOAT_EQ(value_at(*difference(from_server(), shown_field::displacement_y), 7,
                           shown_field::displacement_y),
                  5);
}

TEST(DifferenceOfTheServer, IsNoneOfWhatItCannotTell) {
  EXPECT_FALSE(difference(from_server(), shown_field::displacement)) << "the size of a difference";
  EXPECT_FALSE(difference(from_server(), shown_field::safety_factor)) << "0 says not known";
  EXPECT_FALSE(difference(from_server(), field_named("principal_1"))) << "was not watched";
  auto none = from_server();
  none.differences = {};
  EXPECT_FALSE(difference(none, shown_field::von_mises));
}

TEST(FieldOf, FindsTheLoadCaseOrTheOnlyOne) {
  const auto one = version();

  EXPECT_EQ(field_of(one, "a"), one.fields[0]);
  EXPECT_EQ(field_of(one, ""), one.fields[0]);
  EXPECT_EQ(field_of(one, "b"), nullptr);
}

TEST(NotHeld, SaysWhatIsMissing) {
  auto one = version();
  EXPECT_EQ(not_held(one, "a"), "");

  one.fields.clear();
  EXPECT_TRUE(not_held(one, "a").contains("no field"));
  one.surface.reset();
  EXPECT_TRUE(not_held(one, "a").contains("surface"));
}

legend legend_of(const version_record& a, const version_record& b, range_mode mode) {
  legend by;
  by.mode = mode;
  by.low = 1;
  by.high = 2;
  return common_legend(by, {*a.surface, *a.fields[0]}, {*b.surface, *b.fields[0]});
}

TEST(CommonLegend, CoversBothFields) {
  const auto by = legend_of(version(), version(0, 15e6F), range_mode::full);

  EXPECT_FLOAT_EQ(static_cast<float>(by.low), 10e6F);
  EXPECT_FLOAT_EQ(static_cast<float>(by.high), 45e6F);
  EXPECT_FALSE(by.beyond);
  EXPECT_EQ(by.mode, range_mode::manual);
}

/// The three corners of one facet stand for the same area: the one with 1000 times the stress for a
/// sixth of both versions' is inside, and so is all.
TEST(CommonLegend, AShareOfOnePercentIsNotLeftOutOfSixEqualOnes) {
  const auto by = legend_of(version(), version(0, 15e9F), range_mode::automatic);

  EXPECT_FLOAT_EQ(static_cast<float>(by.high), 45e9F);
}

TEST(CommonLegend, WhatAPersonTypedStays) {
  const auto by = legend_of(version(), version(0, 15e6F), range_mode::locked);

  EXPECT_EQ(by.low, 1);
  EXPECT_EQ(by.high, 2);
}

TEST(TitleOf, GivesTheChangeAgainstTheVersionBefore) {
  auto before = version();
  auto after = version();
  solve_report report;
  report.max_von_mises_pa = 10e6;
  report.mass_kg = 0.2;
  before.outcome = solve_outcome{{report}, {}};
  report.max_von_mises_pa = 12e6;
  after.outcome = solve_outcome{{report}, {}};
  after.info.number = 3;

  const QString title = title_of(after, &before);

  EXPECT_TRUE(title.startsWith("v3")) << title.toStdString();
  EXPECT_TRUE(title.contains("12 MPa (+20 %)")) << title.toStdString();
  EXPECT_TRUE(title.contains("mass 200 g (0.0 %)")) << title.toStdString();
}

}  // namespace
}  // namespace tedit::desktop
