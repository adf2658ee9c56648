// SPDX-License-Identifier: AGPL-3.0-or-later
// What a preview says is new or gone, on a square of 1 m that can be counted by hand.
#include "client-qt/view/preview_geometry.hpp"

#include <gtest/gtest.h>

#include <vtkPolyData.h>

namespace tedit::desktop {
namespace {

using triangle = std::array<std::uint32_t, 3>;

/// The square of 1 m at a height, its corners 0 to 3 and its middle 4; slots begin at `first`.
client::surface_model square(const std::vector<triangle>& triangles, double height = 0,
                             std::uint32_t first = 0) {
  client::surface_update update;
  update.version_id = "v";
  update.vertices = {0, 1, 2, 3, 4};
  update.positions = {0, 0, height, 1, 0, height, 1, 1, height, 0, 1, height, 0.5, 0.5, height};
  for (const auto& t : triangles) {
    update.facets.push_back(first++);
    update.facet_vertices.insert(update.facet_vertices.end(), t.begin(), t.end());
    update.facet_surfaces.push_back(1);
  }
  client::surface_model model;
  EXPECT_TRUE(model.apply(update));
  return model;
}

const std::vector<triangle> four{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

std::int64_t facets(const std::shared_ptr<const part_geometry>& part) {
  return part ? part->faces->GetNumberOfCells() : 0;
}

TEST(PreviewGeometry, OtherTrianglesOfTheSameWallAreNoChange) {
  const auto change = differences_of(square({{0, 1, 2}, {0, 2, 3}}), square(four, 0, 7));

  EXPECT_EQ(change->added, nullptr);
  EXPECT_EQ(change->removed, nullptr);
}

TEST(PreviewGeometry, AWallThatMovesIsNewAndGone) {
  const auto change = differences_of(square(four), square({{0, 1, 2}, {0, 2, 3}}, 0.01));

  EXPECT_EQ(facets(change->added), 2);
  EXPECT_EQ(facets(change->removed), 4);
  EXPECT_DOUBLE_EQ(change->removed->bounds[5], 0);
  EXPECT_NEAR(change->added->bounds[4], 0.01, 1e-9);
}

TEST(PreviewGeometry, ALidIsNewAndNothingIsGone) {
  const std::vector<triangle> open{four[0], four[1], four[2]};

  const auto change = differences_of(square(open), square(four, 0, 3));

  EXPECT_EQ(facets(change->added), 1);
  EXPECT_EQ(change->removed, nullptr);
}

}  // namespace
}  // namespace tedit::desktop
