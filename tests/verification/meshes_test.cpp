// SPDX-License-Identifier: AGPL-3.0-or-later
#include "verification/meshes.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "verification/cases.hpp"
#include "verification/fields.hpp"

namespace tedit::verification {
namespace {

double area_of(const mesh_version& mesh, surface_id id) {
  double area = 0;
  for (const auto f : facets_of(mesh, std::array{id}))
    area += norm(area_vector(mesh, mesh.facet(f)));
  return area;
}

TEST(BlockMesh, FillsTheBoxAndNamesItsSides) {
  const auto mesh = block_mesh({4, 3, 2}, shaken_box({2, 3, 5}));

  ASSERT_TRUE(mesh.has_value());
  EXPECT_EQ((*mesh)->tet_count(), 4u * 3 * 2 * 6);
  EXPECT_NEAR(total_volume(**mesh), 30, 1e-12);
  EXPECT_NEAR(area_of(**mesh, s_low), 15, 1e-12);
  EXPECT_NEAR(area_of(**mesh, t_high), 10, 1e-12);
  EXPECT_NEAR(area_of(**mesh, u_high), 6, 1e-12);
}

TEST(BlockMesh, AMirroredPlacementIsTurned) {
  const auto mesh = block_mesh({2, 2, 2}, [](vec3 p) { return vec3{p.y, p.x, p.z}; });

  ASSERT_TRUE(mesh.has_value());
  EXPECT_NEAR(total_volume(**mesh), 1, 1e-14);
}

TEST(BlockMesh, AFoldedPlacementIsRefused) {
  const auto mesh = block_mesh({4, 2, 2}, [](vec3 p) { return vec3{p.x * (1 - p.x), p.y, p.z}; });

  ASSERT_FALSE(mesh.has_value());
  EXPECT_EQ(mesh.error().code, ec::invalid_mesh);
}

TEST(QuarterRing, LiesBetweenTheEllipses) {
  const auto mesh =
    block_mesh({3, 64, 1}, quarter_ring{.inside = {2, 1}, .outside = {3, 4}, .height = 2});

  ASSERT_TRUE(mesh.has_value());
  const double area = std::numbers::pi / 4 * (12 - 2);
  EXPECT_NEAR(total_volume(**mesh), 2 * area, 3e-4 * area);
  EXPECT_LT(total_volume(**mesh), 2 * area);
}

TEST(TaperedSphere, HasTheVolumeOfItsThreePieces) {
  const auto mesh = block_mesh({4, 40, 40}, tapered_sphere);

  ASSERT_TRUE(mesh.has_value());
  // A quarter of the revolved pieces, by Pappus: pi/2 times the integral of (R^2 - r^2) / 2 over z.
  const double knee = std::numbers::sqrt2 / 2;
  const double sphere = (1.96 - 1) * knee;
  const double rim = std::sqrt(1.96 - 0.5);
  const double taper = 0.69 * ((1 + rim + rim * rim) / 3 - 0.5);
  const double volume = std::numbers::pi / 4 * (sphere + taper + 0.4 * 0.5);
  EXPECT_NEAR(total_volume(**mesh), volume, 2e-3 * volume);
  EXPECT_NEAR(area_of(**mesh, u_low), area_of(**mesh, u_high), 1e-12);
  EXPECT_NEAR(area_of(**mesh, t_high), std::numbers::pi / 8, 1e-3);
}

TEST(OctantMesh, LiesBetweenTheSpheres) {
  const auto mesh = octant_mesh(24, 3, 1, 2);

  ASSERT_TRUE(mesh.has_value());
  const double volume = std::numbers::pi / 6 * 7;
  EXPECT_EQ((*mesh)->tet_count(), 24u * 24 * 3 * 3);
  EXPECT_NEAR(total_volume(**mesh), volume, 4e-3 * volume);
  EXPECT_NEAR(area_of(**mesh, inner), std::numbers::pi / 2, 4e-3);
  for (const auto id : {x_zero, y_zero, z_zero})
    EXPECT_NEAR(area_of(**mesh, id), std::numbers::pi / 4 * 3, 2e-3);
}

TEST(Fields, LoadsKeepTheirTotals) {
  for (const int order : {1, 2}) {
    const auto mesh = *block_mesh({2, 2, 2}, shaken_box({1, 2, 3}));
    auto p = *bare_problem(*mesh, with_material(1, 0.3), order);
    add_body_force(p, [](vec3 x) { return vec3{x.x * x.x, x.y, 1}; });
    vec3 sum;
    for (std::size_t n = 0; n < p.node_count(); ++n)
      sum += node_value(p.loads, n);
    // Integrals of x^2, y and 1 over [0,1] x [0,2] x [0,3].
    EXPECT_NEAR(norm(sum - vec3{2, 6, 6}), 0, 1e-12);

    clear_conditions(p);
    add_traction(p, *mesh, std::array<surface_id, 1>{s_high}, [](vec3 x) {
      return std::array<double, 6>{x.y * x.y, 0, 0, x.z};
    });
    sum = {};
    for (std::size_t n = 0; n < p.node_count(); ++n)
      sum += node_value(p.loads, n);
    // Integrals of y^2 and z over the side x = 1.
    EXPECT_NEAR(norm(sum - vec3{8, 9, 0}), 0, 1e-12);
  }
}

TEST(Fields, AnEvenInitialStressPullsOnTheSurfaceOnly) {
  constexpr std::array<double, 6> stress{3, 2, 1, 0.5, 0.25, 0.125};
  for (const int order : {1, 2}) {
    const auto mesh = *block_mesh({2, 2, 2}, shaken_box({1, 2, 3}));
    auto p = *bare_problem(*mesh, with_material(1, 0.3), order);
    auto q = p;

    add_initial_stress(p, [&](vec3) { return stress; });

    add_traction(q, *mesh, std::array<surface_id, 6>{s_low, s_high, t_low, t_high, u_low, u_high},
                 [&](vec3) { return stress; });
    for (std::size_t i = 0; i < p.dofs(); ++i)
      EXPECT_NEAR(p.loads[i], q.loads[i], 1e-13);
  }
}

TEST(Fields, ErrorsOfAKnownDifference) {
  const auto mesh = *block_mesh({2, 2, 2}, shaken_box({1, 1, 1}));
  const auto p = *bare_problem(*mesh, with_material(1, 0.3), 2);
  std::vector<double> u(p.dofs());
  for (std::size_t n = 0; n < p.node_count(); ++n)
    u[3 * n] = 1.25 * p.nodes[n].x;

  const auto error = errors_of(
    p, u,
    [](vec3 x) {
      return vec3{x.x, 0, 0};
    },
    [](vec3) {
      return std::array<vec3, 3>{{{1, 0, 0}, {}, {}}};
    });

  EXPECT_NEAR(error.l2, 0.25, 1e-12);
  EXPECT_NEAR(error.energy, 0.25, 1e-12);
}

}  // namespace
}  // namespace tedit::verification
