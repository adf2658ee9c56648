// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/print_rows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedit::desktop {
namespace {

using ::testing::IsEmpty;

QString name(surface_id id) {
  return QString("s%1").arg(id);
}

/// A plate of 20 x 10 x 2 mm with a ceiling of 3 mm2.
client::print_check plate() {
  client::print_check made;
  made.settings = {{0, 0, 1}, 2.5e-3, 45 * degree};
  auto& what = made.what;
  what.volume = 400e-9;
  what.area = 520e-6;
  what.extent = {{0, 0, 0}, {20e-3, 10e-3, 2e-3}};
  what.bodies = 1;
  what.plate_area = 200e-6;
  what.thin = {{{1, 2, 3, 4}, 8, 400e-6, 2e-3, {1e-3, 0, 0}}};
  what.thin_area = 400e-6;
  made.thin_places = 1;
  what.overhangs = {{{6}, 2, 3e-6, 90 * degree, {0, 0, 1e-3}}};
  what.overhang_area = 3e-6;
  made.overhanging_places = 4;
  return made;
}

const print_row& row(const std::vector<print_row>& rows, const QString& title) {
  static const print_row none{"none", "none"};
  const auto found = std::ranges::find(rows, title, &print_row::title);
  EXPECT_NE(found, rows.end()) << title.toStdString();
  return found == rows.end() ? none : *found;
}

TEST(PrintRows, SayWhatWasFoundInShownUnits) {
  const auto rows = print_rows(plate(), name);

  EXPECT_EQ(row(rows, "Watertight").value, "yes");
  EXPECT_FALSE(row(rows, "Watertight").fault);
  EXPECT_EQ(row(rows, "Volume").value, QString::fromUtf8("400 mm³"));
  EXPECT_EQ(row(rows, "Bounding box").value, QString::fromUtf8("20 × 10 × 2 mm"));
  EXPECT_EQ(row(rows, "On the plate").value, QString::fromUtf8("200 mm²"));
  EXPECT_EQ(row(rows, "Thin walls").value,
            QString::fromUtf8("400 mm² under 2.5 mm, both sides counted"));
  EXPECT_TRUE(row(rows, "Thin walls").fault);
  EXPECT_EQ(row(rows, "Overhangs").value, QString::fromUtf8("3 mm² lean more than 45°"));
  EXPECT_FALSE(std::ranges::count(rows, QString("Closed voids"), &print_row::title));
}

TEST(PrintRows, APlaceHasItsWorstValueItsAreaAndTheWayToIt) {
  const auto rows = print_rows(plate(), name);

  const auto& thin = row(rows, "Thin walls").places;
  ASSERT_EQ(thin.size(), 1U);
  EXPECT_EQ(thin[0].title, "s1, s2, s3 and 1 more");
  EXPECT_EQ(thin[0].value, QString::fromUtf8("down to 2 mm, 400 mm²"));
  EXPECT_EQ(thin[0].at, (vec3{1e-3, 0, 0}));
  EXPECT_EQ(thin[0].surfaces.size(), 4U);
  const auto& overhangs = row(rows, "Overhangs").places;
  ASSERT_EQ(overhangs.size(), 2U) << "one that was sent, and how many more there are";
  EXPECT_EQ(overhangs[0].value, QString::fromUtf8("up to 90°, 3 mm²"));
  EXPECT_EQ(overhangs[1].title, "... and 3 smaller");
  EXPECT_FALSE(overhangs[1].at);
}

TEST(PrintRows, WhatWasNotLookedForIsNotSaidToBeSound) {
  auto made = plate();
  made.settings.thinner_than = 0;
  made.what.thin.clear();
  EXPECT_FALSE(
    std::ranges::count(print_rows(made, name), QString("Thin walls"), &print_row::title));
  made.settings.thinner_than = 1.5e-3;
  EXPECT_EQ(row(print_rows(made, name), "Thin walls").value, "none under 1.5 mm");
}

TEST(PrintRows, FaultsOfTheShellHaveTheirNumbers) {
  auto made = plate();
  made.what.open_edges = 3;
  made.what.hinge_edges = 1;
  made.what.crossing_facets = 12;
  made.what.closed_voids = 2;
  made.what.overhangs.clear();
  const auto rows = print_rows(made, name);

  EXPECT_EQ(row(rows, "Watertight").value, "no: 3 open edges");
  EXPECT_TRUE(row(rows, "Watertight").fault);
  EXPECT_EQ(row(rows, "Edges of more than two facets").value, "1");
  EXPECT_EQ(row(rows, "Facets that meet others they should not").value, "12");
  EXPECT_EQ(row(rows, "Closed voids").value, "2");
  EXPECT_EQ(row(rows, "Overhangs").value, QString::fromUtf8("none beyond 45°"));
  EXPECT_THAT(row(rows, "Overhangs").places, IsEmpty());
}

/// Squares of 1 m side: 1 and 2 beside each other on z = 0, looking down, 3 on z = 1 above 1,
/// likewise.
client::surface_model squares(double lifted = 0) {
  client::surface_update update;
  update.version_id = "v";
  update.vertices = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  update.positions = {0, 0, 0,      1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, lifted,
                      2, 1, lifted, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
  update.facets = {0, 1, 2, 3, 4, 5};
  update.facet_vertices = {0, 2, 1, 0, 3, 2, 1, 5, 4, 1, 2, 5, 6, 8, 7, 6, 9, 8};
  update.facet_surfaces = {1, 1, 2, 2, 3, 3};
  client::surface_model result;
  EXPECT_TRUE(result.apply(update));
  return result;
}

TEST(UpFrom, IsAwayFromAFlatWall) {
  EXPECT_EQ(up_from(squares(), {1}), (vec3{0, 0, 1}));
  EXPECT_EQ(up_from(squares(), {1, 2}), (vec3{0, 0, 1}));
}

TEST(UpFrom, NeedsOneFlatWall) {
  EXPECT_FALSE(up_from(squares(), {}));
  EXPECT_FALSE(up_from(squares(), {99}));
  EXPECT_FALSE(up_from(squares(0.1), {1, 2})) << "bent by 5.7 degrees";
  EXPECT_FALSE(up_from(squares(), {1, 3})) << "one above the other";
}

}  // namespace
}  // namespace tedit::desktop
