// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/coarsen/coarsen.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "mesh/facet_pages.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"
#include "tests/support/tube.hpp"
#include "tests/support/two_regions.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

class Coarsen : public test::tool_edits {
protected:
  expected<edit_result> coarsened(const version_ptr& mesh, const mesh_pick& pick,
                                  const coarsen_settings& settings) {
    return coarsen(mesh, pick, settings, ctx_);
  }

  static double figure_of(const edit_result& result, const std::string& id) {
    for (const auto& f : result.figures)
      if (f.id == id)
        return f.value;
    ADD_FAILURE() << "no figure " << id;
    return 0;
  }

  static bool has_vertex_at(const mesh_version& mesh, vec3 p) {
    for (vertex_id v = 0; v < mesh.vertex_slots(); ++v)
      if (mesh.is_live_vertex(v) && norm(mesh.position(v) - p) < 1e-12)
        return true;
    return false;
  }
};

// A box of 6 x 6 x 6 cells holds 1,296 tets; its shape needs its eight corners alone.
TEST_F(Coarsen, ABoxKeepsItsShapeExactlyWithAFractionOfItsTets) {
  const auto box = test::box_mesh({6, 6, 6}, {1, 1, 1});

  const auto result = coarsened(box, {{1, 2, 3, 4, 5, 6}, {}, 0}, {.size = 0.8});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(box, *result);
  const auto& after = *result->candidate;
  EXPECT_LT(after.tet_count(), 1296u / 4);
  EXPECT_NEAR(total_volume(after), 1, 1e-13);
  EXPECT_LE(figure_of(*result, "deviation_mm"), 1e-10);
  EXPECT_EQ(figure_of(*result, "tets_gone"), 1296.0 - after.tet_count());
  for (const auto& [id, size] : surface_sizes(after))
    EXPECT_NEAR(size.area_m2, 1, 1e-12) << id;
  EXPECT_EQ(surface_sizes(after).size(), 6u);
  for (int corner = 0; corner < 8; ++corner)
    EXPECT_TRUE(
      has_vertex_at(after, {1.0 * (corner & 1), 1.0 * (corner >> 1 & 1), 1.0 * (corner >> 2)}));
}

TEST_F(Coarsen, WhatIsDeeperThanAskedForStaysAsItIs) {
  const auto box = test::box_mesh({4, 4, 8}, {1, 1, 2});

  const auto result = coarsened(box, {{6}, {}, 0}, {.size = 0.6, .depth = 0.5});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(box, *result);
  for (int x = 0; x <= 4; ++x)
    for (int y = 0; y <= 4; ++y)
      for (int z = 0; z <= 5; ++z)
        EXPECT_TRUE(has_vertex_at(*result->candidate, {0.25 * x, 0.25 * y, 0.25 * z}));
}

// Half of 32 sides leave a gap of R (1 - cos(2 pi / 32)) between chord and corner: 0.019.
TEST_F(Coarsen, ARoundWallIsLeftAsFineAsTheToleranceAsks) {
  const auto tube = test::tube_mesh({.sides = 32, .layers = 6, .inner = 1, .outer = 2});
  const double gap = 1 - std::cos(2 * std::numbers::pi / 32);

  const auto strict = coarsened(tube, {{1}, {}, 0}, {.size = 0.6, .tolerance = 0.5 * gap});
  const auto loose = coarsened(tube, {{1}, {}, 0}, {.size = 0.6, .tolerance = 1.5 * gap});

  ASSERT_TRUE(strict) << render(strict.error());
  ASSERT_TRUE(loose) << render(loose.error());
  expect_good(tube, *loose);
  // Along the axis vertices may go either way, around it only with the larger tolerance.
  EXPECT_LE(figure_of(*strict, "deviation_mm"), 500 * gap);
  EXPECT_LE(figure_of(*loose, "deviation_mm"), 1500 * gap);
  EXPECT_GT(figure_of(*loose, "deviation_mm"), 999 * gap);
  EXPECT_LT(loose->candidate->tet_count(), strict->candidate->tet_count());
}

TEST_F(Coarsen, RegionsKeepTheirVolumeAndTheSurfaceBetweenThem) {
  const auto mesh = test::two_regions(3);

  const auto result = coarsened(mesh, {{1, 2, 3, 4, 5, 6}, {}, 0}, {.size = 0.3});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  const auto& after = *result->candidate;
  EXPECT_LT(after.tet_count(), mesh->tet_count() / 3);
  for (const auto region : {4, 90})
    EXPECT_NEAR(test::region_volume(after, region), 0.125, 1e-13);
  EXPECT_LT(after.data().interfaces.size(), mesh->data().interfaces.size());
  EXPECT_NEAR(test::interface_area(after), 0.25, 1e-12);
  EXPECT_EQ(after.surfaces(), mesh->surfaces());
  EXPECT_EQ(after.regions(), mesh->regions());
}

TEST_F(Coarsen, WhereNothingCanGoThatIsSaid) {
  const auto cube = test::box_mesh({1, 1, 1}, {1, 1, 1});
  const auto corners = coarsened(cube, {{6}, {}, 0}, {.size = 3});
  const auto nothing = coarsened(cube, {}, {});

  ASSERT_FALSE(corners);
  EXPECT_THAT(corners.error().message, HasSubstr("no edge there can go"));
  EXPECT_FALSE(corners.error().remedy.empty());
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, ec::empty_selection);
}

}  // namespace
}  // namespace tedit::ops
