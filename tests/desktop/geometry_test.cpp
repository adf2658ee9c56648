// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <vtkPolyData.h>

#include <cmath>

#include "client-qt/tools/loads/load_glyphs.hpp"
#include "client-qt/tools/probes/plot_panel.hpp"
#include "client-qt/view/box_pick.hpp"
#include "client-qt/view/isolines.hpp"

namespace tedit::desktop {
namespace {

/// A flat square of 1 m in 2 n^2 triangles on surface 1, its normal along +z.
shown_part plate(std::uint32_t n) {
  client::surface_update update;
  update.version_id = "v";
  update.surfaces = {{1, "top", 2ULL * n * n, 1.0}};
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i) {
      update.vertices.push_back(j * (n + 1) + i);
      for (const double c : {i / double(n), j / double(n), 0.0})
        update.positions.push_back(c);
    }
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i;
      for (const std::uint32_t v : {a, a + 1, a + n + 2, a, a + n + 2, a + n + 1})
        update.facet_vertices.push_back(v);
    }
  for (std::uint32_t f = 0; f < 2 * n * n; ++f) {
    update.facets.push_back(f);
    update.facet_surfaces.push_back(1);
  }
  client::surface_model surface;
  EXPECT_TRUE(surface.apply(update));
  return {std::make_shared<const client::surface_model>(surface), nullptr, 0};
}

TEST(Spread, CoversTheSurfaceWithPlacesFarFromEachOther) {
  const auto places = spread(plate(20), {1}, 24, 0.05);

  ASSERT_EQ(places.size(), 24U);
  std::array<int, 4> quarters{};
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(places[i].normal, (vec3{0, 0, 1}));
    ++quarters[(places[i].at.x > 0.5 ? 1 : 0) + (places[i].at.y > 0.5 ? 2 : 0)];
    for (std::size_t j = 0; j < i; ++j) {
      const vec3 way = places[i].at - places[j].at;
      EXPECT_GE(std::sqrt(dot(way, way)), 0.05);
    }
  }
  for (const int count : quarters)
    EXPECT_GE(count, 4);
}

TEST(Spread, GivesOnePlaceToASmallSurfaceAndNoneToNone) {
  EXPECT_EQ(spread(plate(2), {1}, 24, 10).size(), 1U);
  EXPECT_TRUE(spread(plate(2), {5}, 24, 0.1).empty());
}

TEST(Glyphs, ALoadThatHasNoSizeYetHasNoMarkWhileItsSupportHas) {
  fem::load_case draft;
  draft.loads = {{{1}, fem::force{}}};
  draft.constraints = {{{1}, fem::fixed{}}};

  const auto made = make_glyphs(plate(4), {draft});

  EXPECT_FALSE(made.loads);
  EXPECT_TRUE(made.supports);
}

TEST(Areas, OfPointsAddUpToThatOfThePart) {
  const auto part = plate(7);
  const auto made = build_part(*part.surface, {}, {}, 0);

  double sum = 0;
  for (const float one : made->areas)
    sum += one;
  EXPECT_EQ(made->areas.size(), made->vertices.size());
  EXPECT_NEAR(sum, 1, 1e-5);
}

TEST(Outline, GoesAroundSurfacesAndNotThroughThem) {
  const auto made = build_part(*plate(5).surface, {}, {}, 0);

  EXPECT_EQ(outline(*made, {1})->GetNumberOfLines(), 4 * 5);
  EXPECT_EQ(outline(*made, {})->GetNumberOfLines(), 0);
  EXPECT_EQ(outline(*made, {77})->GetNumberOfLines(), 0);
}

TEST(Glyphs, WhatPushesEndsOnThePartAndWhatPullsBeginsThere) {
  fem::load_case loads;
  loads.loads = {{{1}, fem::force{{0, 0, -5}}}};
  const auto part = plate(4);

  const auto pushed = make_glyphs(part, {loads});
  loads.loads[0].kind = fem::pressure{-1e6};  // Pulls.
  const auto pulled = make_glyphs(part, {loads});

  for (const auto& made : {pushed, pulled}) {
    ASSERT_TRUE(made.loads);
    EXPECT_FALSE(made.supports);
    EXPECT_NEAR(made.loads->GetBounds()[4], 0, 1e-3);  // All above the plate.
    EXPECT_GT(made.loads->GetBounds()[5], 0.05);
  }
}

TEST(Glyphs, SupportsStandOutsideThePart) {
  fem::load_case loads;
  loads.constraints = {{{1}, fem::fixed{}}};

  const auto made = make_glyphs(plate(4), {loads});

  ASSERT_TRUE(made.supports);
  EXPECT_FALSE(made.loads);
  EXPECT_NEAR(made.supports->GetBounds()[4], 0, 1e-9);
}

TEST(Isolines, LieWhereTheFieldHasTheLevel) {
  const auto drawn = build_part(*plate(4).surface, {}, {}, 0);
  std::vector<float> values;  // x.
  for (vtkIdType i = 0; i < drawn->faces->GetNumberOfPoints(); ++i)
    values.push_back(static_cast<float>(drawn->faces->GetPoint(i)[0]));
  const double levels[] = {-1, 0.3, 0.6, 2};

  const auto lines = make_isolines(*drawn, values, levels, {});

  double length_at_first = 0;
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i) {
    std::array<double, 6> box{};
    lines->GetCellBounds(i, box.data());
    EXPECT_NEAR(box[0], box[1], 1e-6);  // Along y.
    const bool first = std::abs(box[0] - 0.3) < 1e-6;
    EXPECT_TRUE(first || std::abs(box[0] - 0.6) < 1e-6);
    if (first)
      length_at_first += box[3] - box[2];
  }
  EXPECT_NEAR(length_at_first, 1, 1e-6);  // All across the plate, without a gap.
  EXPECT_EQ(make_isolines(*drawn->faces, values, levels)->GetNumberOfCells(),
            lines->GetNumberOfCells());
  EXPECT_EQ(make_isolines(*drawn, values, levels, {1})->GetNumberOfCells(), 0);
  std::ranges::fill(values, NAN);
  EXPECT_EQ(make_isolines(*drawn, values, levels, {})->GetNumberOfCells(), 0);
}

/// A box over a part of the plate, seen from above by a parallel camera: 100 pixels are 1 m.
pick_box over(double left, double bottom, double width, double height) {
  pick_box box;
  box.left = left;
  box.bottom = bottom;
  box.width = width;
  box.height = height;
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = (left + (i % 2 == 0 ? 0 : width)) / 100;
    const double y = (bottom + (i < 2 ? 0 : height)) / 100;
    box.rays[i] = {vec3{x, y, 1}, vec3{x, y, -1}};
  }
  box.to_pixels.matrix = {2, 0, 0, -1, 0, 2, 0, -1, 0, 0, 1, 0, 0, 0, 0, 1};
  box.to_pixels.width = box.to_pixels.height = 100;
  return box;
}

TEST(Box, TouchesWhatIsSeenInItAndEnclosesWhatLiesInItAltogether) {
  const auto drawn = build_part(*plate(4).surface, {}, {}, 0);
  auto small = over(20, 20, 30, 30);
  auto beside = over(120, 20, 30, 30);
  auto large = over(-5, -5, 110, 110);

  EXPECT_EQ(surfaces_in(*drawn, small), (std::vector<surface_id>{1}));
  EXPECT_TRUE(surfaces_in(*drawn, beside).empty());
  small.by = large.by = pick_box::rule::enclosed;
  EXPECT_TRUE(surfaces_in(*drawn, small).empty());
  EXPECT_EQ(surfaces_in(*drawn, large), (std::vector<surface_id>{1}));
  large.hidden = {1};
  EXPECT_TRUE(surfaces_in(*drawn, large).empty());
  large.hidden.clear();
  large.section = section_plane{{0, 0, -0.5}, {0, 0, 1}};  // All of it is cut away.
  EXPECT_TRUE(surfaces_in(*drawn, large).empty());
}

TEST(Along, TakesTheFieldOnTheLineAndLeavesGapsBesideThePart) {
  const auto part = plate(4);
  const auto drawn = build_part(*part.surface, {}, {}, 0);
  std::vector<float> values;
  for (const auto slot : drawn->vertices)
    values.push_back(static_cast<float>(part.surface->positions().find(slot)->x));

  const auto line = along(*drawn, values, {0.25, 0.3, 0}, {1.25, 0.3, 0}, 5);

  ASSERT_EQ(line.size(), 5U);
  EXPECT_NEAR(line[0], 0.25, 1e-6);
  EXPECT_NEAR(line[2], 0.75, 1e-6);
  EXPECT_NEAR(line[3], 1, 1e-6);
  EXPECT_TRUE(std::isnan(line[4]));  // 0.25 m beside it.
}

}  // namespace
}  // namespace tedit::desktop
