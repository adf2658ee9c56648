// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/surface_map.hpp"

#include <gtest/gtest.h>

#include "mesh/builder.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

using test::unit_box;

TEST(SurfaceMap, EqualVersionsHaveNoChange) {
  EXPECT_TRUE(compare_surfaces(*unit_box(), *unit_box()).empty());
}

TEST(SurfaceMap, AMergedSurfaceNamesWhereItWent) {
  const auto before = unit_box();
  mesh_builder builder(before);
  const std::vector<surface_id> list{2};
  for (const auto f : facets_of(*before, list))
    builder.set_surface(f, 4);

  const auto map = compare_surfaces(*before, *builder.freeze());

  ASSERT_EQ(map.size(), 2u);
  EXPECT_EQ(map[0].id, 2);
  EXPECT_EQ(map[0].fate, surface_fate::merged_into);
  EXPECT_EQ(map[0].other, 4);
  EXPECT_EQ(map[1].fate, surface_fate::changed);
  EXPECT_NEAR(map[1].area_after, 2, 1e-14);
}

TEST(SurfaceMap, ASplitSurfaceNamesWhereItCameFrom) {
  const auto before = unit_box();
  mesh_builder builder(before);
  const auto fresh = builder.add_surface("part");
  const std::vector<surface_id> list{6};
  builder.set_surface(facets_of(*before, list).front(), fresh);

  const auto map = compare_surfaces(*before, *builder.freeze());

  ASSERT_EQ(map.size(), 2u);
  EXPECT_EQ(map[0].fate, surface_fate::changed);
  EXPECT_EQ(map[1].id, 7);
  EXPECT_EQ(map[1].fate, surface_fate::split_from);
  EXPECT_EQ(map[1].other, 6);
  EXPECT_EQ(map[1].name, "part");
  EXPECT_NEAR(map[1].area_after, 0.125, 1e-15);
}

TEST(SurfaceMap, ASurfaceBetweenRegionsThatGoesIsSaidToGo) {
  const auto plain = unit_box();
  mesh_builder with(plain);
  const auto seam = with.add_surface("seam");
  const auto corners = plain->tet_at(0).v;
  with.set_interfaces({{{corners[0], corners[1], corners[2]}, 0, seam}});
  const auto before = with.freeze();
  mesh_builder without(before);
  without.set_interfaces({});

  const auto map = compare_surfaces(*before, *without.freeze());

  ASSERT_EQ(map.size(), 1u);
  EXPECT_EQ(map[0].id, seam);
  EXPECT_GT(map[0].area_before, 0);
  EXPECT_EQ(map[0].area_after, 0);
}

TEST(SurfaceMap, AMovedVertexChangesItsSurfaces) {
  const auto before = unit_box();
  mesh_builder builder(before);
  builder.set_position(4, before->position(4) + vec3{0, 0, -0.1});  // middle of z = 0

  const auto map = compare_surfaces(*before, *builder.freeze());

  ASSERT_EQ(map.size(), 1u);
  EXPECT_EQ(map[0].id, 5);
  EXPECT_GT(map[0].area_after, map[0].area_before);
}

}  // namespace
}  // namespace tedit
