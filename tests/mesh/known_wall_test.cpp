// SPDX-License-Identifier: AGPL-3.0-or-later
// What a CAD model says is behind a surface, where facets could be those of several shapes.
#include "mesh/features/known_wall.hpp"

#include <cmath>
#include <numbers>

#include "gmock/gmock.h"
#include "mesh/builder.hpp"
#include "tests/support/frustum.hpp"

namespace tedit {
namespace {

using namespace test::frustum_part;

std::vector<facet_id> side_of(const mesh_version& mesh) {
  return facets_of(mesh, std::array{skirt});
}

std::optional<exact_wall> found(const version_ptr& mesh) {
  return find_exact(*mesh, side_of(*mesh));
}

TEST(KnownWall, TwoRowsOfCornersAreTheFilletThatTheModelHas) {
  const auto wall = found(frustum_with(fillet));

  ASSERT_TRUE(wall);
  EXPECT_TRUE(wall->is_known);
  EXPECT_EQ(wall->tube_radius, 0.002);
  // In the middle of a quarter of the tube, whose middle is in the plane of the top.
  const double across = 0.002 * std::sqrt(0.5);
  EXPECT_NEAR(wall->distance({0.008 + across, 0, 0.002 - across}), 0, 1e-15);
  EXPECT_TRUE(has_round_corners(*wall, {}));
}

TEST(KnownWall, TheyAreNoConeThen) {
  const auto known = frustum_with(fillet);
  const auto unknown = frustum_with({});

  EXPECT_FALSE(fit_wall(*known, side_of(*known), {.cones = true}));
  const auto guess = fit_wall(*unknown, side_of(*unknown), {.cones = true});
  ASSERT_TRUE(guess);
  EXPECT_NEAR(std::abs(guess->slope), 1, 1e-12);
}

TEST(KnownWall, AConesRadiusIsThatBesideItsFacets) {
  const auto mesh = frustum_with(cone);
  const auto wall = found(mesh);

  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->shape.point.z, 0.001, 1e-15);
  EXPECT_NEAR(wall->shape.radius, 0.009, 1e-15);
  EXPECT_NEAR(wall->distance({0.010, 0, 0.001}), 0.001 * std::sqrt(0.5), 1e-15);
  EXPECT_FALSE(fit_wall(*mesh, side_of(*mesh)));
  EXPECT_TRUE(fit_wall(*mesh, side_of(*mesh), {.cones = true}));
}

TEST(KnownWall, LooksOffTheMaterialWhateverTheModelsAxisDoes) {
  auto turned = cone;
  turned.axis = {0, 0, -1};
  turned.slope = -1;
  for (const auto& geometry : {cone, turned})
    EXPECT_GT(found(frustum_with(geometry))->distance({1, 0, 0}), 0);
  const auto flat = frustum_with({});
  EXPECT_GT(find_exact(*flat, facets_of(*flat, std::array{roof}))->distance({0, 0, 1}), 0);
}

TEST(KnownWall, HoldsNoLongerWhereTheFacetsHaveMoved) {
  const auto mesh = frustum_with(fillet);
  mesh_builder wider(mesh);
  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v)
    wider.set_position(v, 1.001 * mesh->position(v));
  const auto moved = wider.freeze();

  EXPECT_EQ(moved->find_surface(skirt)->geometry, fillet);
  EXPECT_FALSE(known_wall(*moved, side_of(*moved), corners_of(*moved, side_of(*moved))));
}

/// Is it still the fillet where so many corners are off it by so much, m?
bool holds_with(const surface_geometry& geometry, vertex_id corners, double off) {
  const auto mesh = frustum_with(geometry);
  mesh_builder work(mesh);
  for (vertex_id v = 0; v < corners; ++v)
    work.set_position(v, mesh->position(v) + vec3{0, 0, off});
  const auto moved = work.freeze();
  return known_wall(*moved, side_of(*moved), corners_of(*moved, side_of(*moved))).has_value();
}

TEST(KnownWall, NumbersThatMakeNoWallAreNone) {
  for (auto bad : {surface_geometry{kind::torus, {0, 0, 0.002}, {0, 0, 1}, 0.008, 0, -0.002},
                   surface_geometry{kind::torus, {}, {}, 1e308, 0, 1e308},
                   surface_geometry{kind::cylinder, {1e308, 1e308, 0}, {0, 0, 1}, 1e308},
                   surface_geometry{kind::cone, {}, {1e200, 0, 0}, 1, 1e200},
                   surface_geometry{kind::sphere, {}, {}, -1}}) {
    const auto mesh = frustum_with(bad);
    EXPECT_FALSE(known_wall(*mesh, side_of(*mesh), corners_of(*mesh, side_of(*mesh))));
  }
}

TEST(KnownWall, IsToldAsTheGeometryThatItIs) {
  const auto part = frustum_with(fillet);
  EXPECT_EQ(find_geometry(*part, skirt), fillet);
  const auto top = find_geometry(*part, roof);
  EXPECT_EQ(top.type, kind::plane);
  EXPECT_NEAR(top.point.z, 0.002, 1e-15);
  EXPECT_NEAR(std::abs(top.axis.z), 1, 1e-12);
  for (const auto& geometry : {fillet, cone}) {
    const auto mesh = frustum_with(geometry);
    const auto wall = found(mesh);
    const auto again = known_wall(geometry_of(*wall), corners_of(*mesh, side_of(*mesh)));
    ASSERT_TRUE(again);
    for (const vec3 p : {vec3{0.009, 0, 0.001}, vec3{0.02, 0.01, 0.003}})
      EXPECT_NEAR(again->distance(p), wall->distance(p), 1e-15);
  }
  EXPECT_TRUE(has_geometries(*part));
  EXPECT_FALSE(has_geometries(*frustum_with({})));
}

TEST(KnownWall, OneCornerMayHaveBeenMovedByAMeshersRepair) {
  // 2 % of 2 mm.
  EXPECT_TRUE(holds_with(fillet, 1, 0.03e-3));
  EXPECT_FALSE(holds_with(fillet, 1, 0.05e-3));
  EXPECT_FALSE(holds_with(fillet, 2, 0.03e-3));
}

TEST(KnownWall, CornersMayBeOffAsMuchAsEdgesOfTheModelAre) {
  auto loose = fillet;
  loose.tolerance = 1e-6;
  EXPECT_TRUE(holds_with(loose, sectors, 0.9e-6));
  EXPECT_FALSE(holds_with(loose, sectors, 1.1e-6));
  EXPECT_FALSE(holds_with(fillet, sectors, 0.9e-6));
  // Whatever the model says of them: 1e-5 of 2 mm.
  EXPECT_TRUE(holds_with(fillet, sectors, 0.9e-8));
  EXPECT_FALSE(holds_with(fillet, sectors, 2.5e-8));
  // What a damaged file says of its edges says nothing of the wall.
  loose.tolerance = 1;
  EXPECT_FALSE(holds_with(loose, sectors, 0.05e-3));
  loose.tolerance = -1;
  EXPECT_TRUE(holds_with(loose, 0, 0));
}

// -- manifests ------------------------------------------------------------------------------------

TEST(SurfaceGeometry, GoesIntoTheVersionsIdAndComesBack) {
  const auto known = frustum_with(fillet);
  const auto unknown = frustum_with({});

  EXPECT_NE(known->id(), unknown->id());
  const auto back = manifest::from_bytes(known->pages().to_bytes());
  ASSERT_TRUE(back);
  EXPECT_EQ(back->surfaces, known->pages().surfaces);
}

TEST(SurfaceGeometry, WhatCannotBeIsRefused) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto good = frustum_with(fillet)->pages();
  const auto refuses = [&](const surface_geometry& geometry) {
    auto list = good;
    list.surfaces.front().geometry = geometry;
    return !manifest::from_bytes(list.to_bytes());
  };

  EXPECT_FALSE(refuses(cone));
  EXPECT_TRUE(refuses({static_cast<kind>(6), {}, {0, 0, 1}, 1}));
  EXPECT_TRUE(refuses({kind::plane, {0, none, 0}, {0, 0, 1}}));
  EXPECT_TRUE(refuses({kind::plane, {}, {0, 0, none}}));
  EXPECT_TRUE(refuses({kind::sphere, {}, {}, none}));
  EXPECT_TRUE(refuses({kind::cone, {}, {0, 0, 1}, 1, HUGE_VAL}));
  EXPECT_TRUE(refuses({kind::torus, {}, {0, 0, 1}, 1, 0, -HUGE_VAL}));
  EXPECT_TRUE(refuses({kind::torus, {}, {0, 0, 1}, 1, 0, 1, none}));
}

TEST(SurfaceGeometry, OneOfASurfaceThatIsNotThereIsRefused) {
  auto bytes = frustum_with(fillet)->pages().to_bytes();
  // Count, then id, kind and ten numbers at the end: surface 1 becomes 9.
  bytes[bytes.size() - 89] = std::byte{9};

  EXPECT_FALSE(manifest::from_bytes(bytes));
}

}  // namespace
}  // namespace tedit
