// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/probes.hpp"

#include <gtest/gtest.h>

namespace tedit::desktop {
namespace {

/// Two triangles of a unit square, 1 and 2, on surfaces `first` and 7; vertex 2 lifted by `up`.
client::surface_model square(surface_id first = 7, double up = 0) {
  client::surface_update update;
  update.version_id = "v";
  update.vertices = {0, 1, 2, 3};
  update.positions = {0, 0, 0, 1, 0, 0, 1, 1, up, 0, 1, 0};
  update.facets = {0, 1};
  update.facet_vertices = {0, 1, 2, 0, 2, 3};
  update.facet_surfaces = {first, 7};
  client::surface_model result;
  EXPECT_TRUE(result.apply(update));
  return result;
}

client::field_event field() {
  client::field_event result;
  result.vertices = {0, 1, 2, 3};
  result.values["von_mises_pa"] = {0, 3, 6, 9};
  return result;
}

const std::array<double, 3> middle{0.25, 0.5, 0.25};

TEST(Locate, StaysOnAnUnchangedTriangle) {
  const auto what = make_probe(1, 7, {0, 1, 2}, middle, square());

  const auto place = locate(what, square());

  ASSERT_TRUE(place);
  EXPECT_TRUE(place->same);
  EXPECT_EQ(place->at, (vec3{0.75, 0.25, 0}));
  EXPECT_DOUBLE_EQ(*value_at(*place, field(), shown_field::von_mises), 3);
}

TEST(Value, OfAStrainIsReadAsThatOfAStress) {
  auto strained = field();
  strained.values["largest_strain"] = {0, 2e-6F, 4e-6F, 8e-6F};
  const auto what = make_probe(1, 7, {0, 1, 2}, middle, square());

  const auto here = value_at(*locate(what, square()), strained, field_named("largest_strain"));

  EXPECT_NEAR(*here, 2e-6, 1e-12);
}

TEST(Locate, TakesTheNearestPointOfTheSurfaceWhenTheTriangleMoved) {
  const auto what = make_probe(1, 7, {0, 2, 3}, {0, 0, 1}, square());

  const auto place = locate(what, square(7, 0.5));

  ASSERT_TRUE(place);
  EXPECT_FALSE(place->same);
  EXPECT_EQ(place->at, (vec3{0, 1, 0}));  // Its own corner did not move.
}

TEST(Locate, TakesAnotherTriangleOfTheSurfaceWhenItsOwnBelongsToAnother) {
  const auto what = make_probe(1, 7, {0, 1, 2}, {0, 1, 0}, square());

  const auto place = locate(what, square(8));

  ASSERT_TRUE(place);
  EXPECT_FALSE(place->same);
  EXPECT_NEAR(place->at.x, 0.5, 1e-15);  // The foot of (1, 0) on the diagonal.
  EXPECT_NEAR(place->at.y, 0.5, 1e-15);
}

TEST(Locate, FindsNothingWhenTheSurfaceIsGone) {
  const auto what = make_probe(1, 9, {0, 1, 2}, middle, square(9));

  EXPECT_FALSE(locate(what, square()));
}

TEST(ValueAt, IsNothingWhereTheFieldHasNone) {
  const auto what = make_probe(1, 7, {0, 1, 2}, middle, square());
  auto less = field();
  less.vertices = {1, 2};
  less.values["von_mises_pa"] = {3, 6};

  EXPECT_FALSE(value_at(what.place, less, shown_field::von_mises));
  EXPECT_FALSE(value_at(what.place, field(), shown_field::displacement));
}

TEST(Histogram, CountsTrianglesByTheirAreaAndMean) {
  auto values = field();
  values.values["von_mises_pa"] = {0, 0, 0, 9};  // Means 0 and 3, each half of the area.

  const auto counted = histogram_of(square(), values, shown_field::von_mises, 3);

  EXPECT_EQ(counted.low, 0);
  EXPECT_EQ(counted.high, 3);
  EXPECT_EQ(counted.share, (std::vector<double>{0.5, 0, 0.5}));
}

TEST(Histogram, OfAUniformFieldIsOneBar) {
  auto values = field();
  values.values["von_mises_pa"] = {5, 5, 5, 5};

  const auto counted = histogram_of(square(), values, shown_field::von_mises, 3);

  EXPECT_DOUBLE_EQ(counted.share[0] + counted.share[1] + counted.share[2], 1);
  EXPECT_TRUE(histogram_of(square(), values, shown_field::displacement, 3).share.empty());
}

}  // namespace
}  // namespace tedit::desktop
