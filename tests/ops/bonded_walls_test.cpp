// SPDX-License-Identifier: AGPL-3.0-or-later
// Walls of one of two bonded regions: what is taken off and put on is that region's alone. Volumes
// of each region and areas of the face between them by hand.
#include <cmath>

#include <gtest/gtest.h>

#include "mesh/checks.hpp"
#include "mesh/features/wall_shape.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/io/import.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/services/host_services.hpp"
#include "ops/shapes/move_by_tool.hpp"
#include "ops/shapes/move_by_vertices.hpp"
#include "tests/support/bonded_boxes.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/two_regions.hpp"

namespace tedit::ops {
namespace {

using test::boundary_area;
using test::volume_of;

constexpr surface_id seam = 9;
/// Surfaces of region 2 have this more than those of `box_mesh`.
constexpr surface_id second = 20;

/// Region 2 where that is so at the middle of a tet, region 1 elsewhere; bonded.
version_ptr bonded(const version_ptr& plain, const std::function<bool(vec3)>& is_second) {
  raw_mesh raw;
  std::vector<vertex_id> place(plain->vertex_slots(), no_id);
  const auto index = [&](vertex_id v) {
    if (place[v] == no_id) {
      place[v] = static_cast<vertex_id>(raw.positions.size());
      raw.positions.push_back(plain->position(v));
    }
    return place[v];
  };
  const auto region = [&](tet_id t) {
    const auto p = plain->corners(t);
    return region_id{is_second(0.25 * (p[0] + p[1] + p[2] + p[3])) ? 2 : 1};
  };
  for (const auto t : test::all_tets(*plain)) {
    const auto& v = plain->tet_at(t).v;
    raw.tets.push_back({{index(v[0]), index(v[1]), index(v[2]), index(v[3])}});
    raw.tet_regions.push_back(region(t));
    for (int k = 0; k < 4; ++k) {
      const auto& f = tet_faces[k];
      const std::array corners{index(v[f[0]]), index(v[f[1]]), index(v[f[2]])};
      const auto beside = plain->neighbours(t)[k];
      if (is_facet(beside))
        raw.triangles.push_back(
          {corners,
           plain->facet(beside & ~facet_flag).surface + (region(t) == 2 ? second : surface_id{0}),
           true});
      else if (region(t) == 1 && region(beside) == 2)
        raw.triangles.push_back({corners, seam, true});
    }
  }
  return build_version(std::move(raw), 1)->version;
}

/// x < 1 and x > 1 of a bar 2 x 1 x 1.
version_ptr bar() {
  return bonded(test::box_mesh({12, 6, 6}, {2, 1, 1}), [](vec3 p) { return p.x > 1; });
}

/// A plate 3 x 3 x 1, region 1, and in the middle of it a cube of edge 1 that stands on it.
version_ptr cube_on_plate() {
  const auto plain = test::dig(
    test::box_mesh({9, 9, 6}, {3, 3, 2}),
    [](vec3 p) { return p.z > 1 && !(p.x > 1 && p.x < 2 && p.y > 1 && p.y < 2); }, 7);
  return bonded(plain, [](vec3 p) { return p.z > 1; });
}

/// Of all faces between tets of different regions, whether listed or not.
double bond_area(const mesh_version& mesh) {
  double sum = 0;
  for (const auto t : test::all_tets(mesh)) {
    const auto p = mesh.corners(t);
    for (int k = 0; k < 4; ++k) {
      const auto beside = mesh.neighbours(t)[k];
      const auto& f = tet_faces[k];
      if (!is_facet(beside) && mesh.region_of(beside) > mesh.region_of(t))
        sum += norm(area_vector(p[f[0]], p[f[1]], p[f[2]]));
    }
  }
  return sum;
}

/// The wall of `mesh` with that id which lies in the plane x = at gets the id `fresh`.
version_ptr with_wall_at(const version_ptr& mesh, surface_id old, double at, surface_id fresh) {
  raw_mesh raw;
  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v)
    raw.positions.push_back(mesh->position(v));
  for (const auto t : test::all_tets(*mesh)) {
    raw.tets.push_back(mesh->tet_at(t));
    raw.tet_regions.push_back(mesh->region_of(t));
  }
  for (facet_id f = 0; f < mesh->facet_slots(); ++f) {
    const auto& facet = mesh->facet(f);
    const bool there = std::ranges::all_of(
      facet.v, [&](auto v) { return std::abs(mesh->position(v).x - at) < 1e-9; });
    raw.triangles.push_back({facet.v, facet.surface == old && there ? fresh : facet.surface, true});
  }
  for (const auto& row : mesh->data().interfaces.to_vector())
    raw.triangles.push_back({row.v, row.surface, true});
  return build_version(std::move(raw), 1)->version;
}

class BondedWalls : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
    plugins_.load_directory(TEDIT_BIN "/../lib/tedit/plugins");
    ctx_.host = host_.get();
  }

  static version_ptr checked(const version_ptr& base, const expected<edit_result>& result) {
    EXPECT_TRUE(result) << render(result.error());
    if (!result)
      return base;
    edit_claim claim;
    claim.touched = result->touched;
    claim.volume_change = result->volume_change;
    finish_settings settings;
    settings.quality_floor = result->quality_floor;
    const auto done = finish_edit(base, result->candidate, claim, result->improve, settings, {});
    EXPECT_TRUE(done) << render(done.error());
    if (!done)
      return base;
    EXPECT_EQ(check_version(*done->version).total, 0u);
    return done->version;
  }

  version_ptr by_operation(const version_ptr& mesh, const std::string& operation, surface_id wall,
                           double depth) {
    return checked(mesh,
                   run_operation(plugins_, operation, mesh, {{wall}}, {{"depth", depth}}, ctx_));
  }

  version_ptr by_tool(const version_ptr& mesh, surface_id wall, double distance) {
    return checked(mesh, move_by_tool(mesh, {wall}, distance, ctx_));
  }

  catalogue plugins_;
  std::unique_ptr<services> host_ = make_host_services();
  context ctx_;
};

TEST_F(BondedWalls, ErodingOneHalfsTopLeavesTheOtherHalfAStep) {
  const auto base = bar();
  for (const auto& cut : {by_tool(base, 6, -0.3), by_operation(base, "erode", 6, 0.3)}) {
    EXPECT_NEAR(volume_of(*cut, 1), 0.7, 1e-12);
    EXPECT_NEAR(volume_of(*cut, 2), 1, 1e-12);
    EXPECT_NEAR(bond_area(*cut), 0.7, 1e-12);
    EXPECT_NEAR(boundary_area(*cut, seam), 0.3, 1e-12);
    EXPECT_NEAR(boundary_area(*cut, 6), 1, 1e-12);
    EXPECT_NEAR(boundary_area(*cut, 6 + second), 1, 1e-12);
  }
}

TEST_F(BondedWalls, ErodingDeeperThanALayerOfTetsTakesWholeOnesOfOneRegionOnly) {
  const auto cut = by_tool(bar(), 6, -0.62);

  EXPECT_NEAR(volume_of(*cut, 1), 0.38, 1e-12);
  EXPECT_NEAR(volume_of(*cut, 2), 1, 1e-12);
  EXPECT_NEAR(bond_area(*cut), 0.38, 1e-12);
}

TEST_F(BondedWalls, ThickeningOneHalfsTopLeavesTheOtherHalfAsItIs) {
  const auto base = bar();
  for (const auto& more : {by_tool(base, 6, 0.3), by_operation(base, "thicken", 6, 0.3)}) {
    EXPECT_NEAR(volume_of(*more, 1), 1.3, 1e-12);
    EXPECT_NEAR(volume_of(*more, 2), 1, 1e-12);
    EXPECT_NEAR(bond_area(*more), 1, 1e-12);
    EXPECT_NEAR(boundary_area(*more, 6 + second), 1, 1e-12);
  }
}

TEST_F(BondedWalls, ErodingWhatStandsOnAPlateTakesNothingOfThePlate) {
  const auto base = with_wall_at(cube_on_plate(), 7 + second, 1, 30);
  for (const auto& cut : {by_tool(base, 30, -0.3), by_operation(base, "erode", 30, 0.3)}) {
    EXPECT_NEAR(volume_of(*cut, 1), 9, 1e-11);
    EXPECT_NEAR(volume_of(*cut, 2), 0.7, 1e-12);
    EXPECT_NEAR(bond_area(*cut), 0.7, 1e-12);
    EXPECT_NEAR(boundary_area(*cut, 30), 1, 1e-12);
  }
}

TEST_F(BondedWalls, ErodingThePlateAroundLeavesAPedestal) {
  const auto base = cube_on_plate();
  const auto cut = by_tool(base, 7, -0.3);

  EXPECT_NEAR(volume_of(*cut, 1), 9 - 8 * 0.3, 1e-11);
  EXPECT_NEAR(volume_of(*cut, 2), 1, 1e-12);
  EXPECT_NEAR(bond_area(*cut), 1, 1e-12);
}

TEST_F(BondedWalls, WhatIsPutOnAWallOfBothRegionsIsOfEach) {
  // Higher than its cells: a slab would be of one region.
  const auto base = test::two_regions();
  const auto more = by_operation(base, "thicken", 6, 0.3);
  EXPECT_NEAR(volume_of(*more, 4), 0.5 * 0.5 * 0.8, 1e-12);
  EXPECT_NEAR(volume_of(*more, 90), 0.5 * 0.5 * 0.8, 1e-12);
  EXPECT_NEAR(bond_area(*more), 0.5 * 0.8, 1e-12);

  const auto tool = move_by_tool(base, {6}, 0.3, ctx_);
  ASSERT_FALSE(tool);
  EXPECT_EQ(tool.error().message, "what is put on surface 6 would be of one region alone");
}

TEST_F(BondedWalls, AFaceBetweenRegionsThatIsInTheWayIsNoSurfaceToSelect) {
  // The plate's top goes on as the face below the cube, which stays.
  const auto moved = move_by_vertices(cube_on_plate(), {7}, 0.1, shift_patience::all, {});

  ASSERT_FALSE(moved);
  EXPECT_EQ(moved.error().message.substr(0, 57),
            "the face between two regions leaves surface 7 no way at (");
  EXPECT_EQ(moved.error().remedy, "Take a smaller depth, or other surfaces");
}

TEST_F(BondedWalls, ThickeningThePlateBondsItToTheCubesSides) {
  const auto base = cube_on_plate();
  const auto more = by_tool(base, 7, 0.3);

  EXPECT_NEAR(volume_of(*more, 1), 9 + 8 * 0.3, 1e-11);
  EXPECT_NEAR(volume_of(*more, 2), 1, 1e-12);
  EXPECT_NEAR(bond_area(*more), 1 + 4 * 0.3, 1e-12);
}

/// The floor of a groove, 0.5 wide, belongs to region 1, its sides to region 2, which is covered
/// more by what fills it.
TEST_F(BondedWalls, WhatIsPutOnAWallIsPartOfTheWallsRegion) {
  const auto plain = test::dig(
    test::box_mesh({9, 4, 8}, {1.5, 0.5, 2}),
    [](vec3 p) { return p.z > 0.5 && p.x > 0.5 && p.x < 1; }, 7);
  const auto base = bonded(plain, [](vec3 p) { return p.z > 0.5; });

  const auto more = by_tool(base, 7, 1);

  EXPECT_NEAR(volume_of(*more, 1) - volume_of(*base, 1), 0.5 * 0.5, 1e-12);
  EXPECT_NEAR(volume_of(*more, 2), volume_of(*base, 2), 1e-12);
  EXPECT_NEAR(bond_area(*more) - bond_area(*base), 2 * 0.5, 1e-12);
}

/// A coat of 1/3, region 2, on a block.
version_ptr coated_block() {
  return bonded(test::box_mesh({6, 6, 8}, {1, 1, 4.0 / 3}), [](vec3 p) { return p.z > 1; });
}

TEST_F(BondedWalls, ErodingACoatTakesNothingOfWhatItLiesOn) {
  const auto base = coated_block();

  const auto thinner = by_operation(base, "erode", 6 + second, 0.25);
  const auto gone = run_operation(plugins_, "erode", base, {{6 + second}}, {{"depth", 0.4}}, ctx_);

  EXPECT_NEAR(volume_of(*thinner, 1), 1, 1e-12);
  EXPECT_NEAR(volume_of(*thinner, 2), 1.0 / 3 - 0.25, 1e-12);
  EXPECT_FALSE(gone);
}

TEST_F(BondedWalls, LayersOfTetsEndAtTheOtherRegion) {
  const auto base = coated_block();
  const auto peel = [&](std::int64_t layers) {
    return run_operation(plugins_, "erode", base, {{6 + second}},
                         {{"depth", 0.0}, {"layers", layers}}, ctx_);
  };

  const auto two = checked(base, peel(2));
  const auto three = peel(3);

  EXPECT_LT(volume_of(*two, 2), 0.3);
  EXPECT_NEAR(volume_of(*two, 1), 1, 1e-12);
  EXPECT_GT(boundary_area(*two, seam), 0.1);
  ASSERT_FALSE(three);
  EXPECT_EQ(three.error().code, ec::empty_selection);
}

/// Halves of round walls that end at another region.
TEST_F(BondedWalls, OnARealAssemblyOneRegionAloneGetsSmaller) {
  const auto imported =
    import_mesh(test::parts_folder / "as1_assembly/as1_assembly.coarse.msh", "mm");
  ASSERT_TRUE(imported) << render(imported.error());
  const auto base = imported->version;
  for (const surface_id wall : {151, 65}) {
    SCOPED_TRACE(wall);
    const double depth = 0.04;
    const auto facets = facets_of(*base, std::vector{wall});
    const auto own = base->region_of(base->facet(facets.front()).tet);
    const auto shape = fit_wall(*base, facets, {3e-3, true, true});
    ASSERT_TRUE(shape);

    const auto cut = by_operation(base, "erode", wall, depth);

    for (const auto& region : base->regions()) {
      const double was = volume_of(*base, region.id);
      if (region.id != own) {
        EXPECT_NEAR(volume_of(*cut, region.id), was, 1e-9 * was);
      }
    }
    const double loss = volume_of(*base, own) - volume_of(*cut, own);
    // All corners lie on the cylinder: the wall where it goes is the wall made narrower.
    double around = 0;
    for (const auto f : facets) {
      const auto& v = base->facet(f).v;
      const vec3 middle = (base->position(v[0]) + base->position(v[1]) + base->position(v[2])) / 3;
      const vec3 off = middle - shape->point;
      around +=
        0.5 * dot(area_vector(*base, base->facet(f)), off - dot(off, shape->axis) * shape->axis);
    }
    const double left = 1 - depth / shape->radius;
    EXPECT_NEAR(loss, (1 - left * left) * around, 0.03 * loss);
    EXPECT_LT(bond_area(*cut), bond_area(*base));
  }
}

}  // namespace
}  // namespace tedit::ops
