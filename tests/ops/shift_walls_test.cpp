// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/shift_walls.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/distances.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/io/import.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/services/host_services.hpp"
#include "ops/shapes/walls/wall_tool.hpp"
#include "tests/support/blocks.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/tube.hpp"

namespace tedit::ops {
namespace {

using test::polygon;
using test::tube;
using test::tube_mesh;
using ::testing::HasSubstr;

/// The plugins `erode` and `thicken` on round walls.
class RoundWalls : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
    plugins_.load_directory(TEDIT_BIN "/../lib/tedit/plugins");
  }

  /// Moves surfaces outward, or inward for a negative distance.
  expected<edit_result> shift(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                              double distance) {
    context ctx;
    ctx.host = host_.get();
    return run_operation(plugins_, distance < 0 ? "erode" : "thicken", mesh, {surfaces},
                         {{"depth", std::abs(distance)}}, ctx);
  }

  /// The version that the host would keep.
  static version_ptr finish(const version_ptr& base, const expected<edit_result>& result) {
    EXPECT_TRUE(result) << render(result.error());
    if (!result)
      return nullptr;
    edit_claim claim;
    claim.touched = result->touched;
    claim.volume_change = result->volume_change;
    claim.quality_floor = result->quality_floor;
    const auto done = finish_edit(base, result->candidate, claim, result->improve, {}, {});
    EXPECT_TRUE(done) << render(done.error());
    if (!done)
      return nullptr;
    EXPECT_TRUE(check_version(*done->version).ok());
    const auto& now = done->version->surfaces();
    for (const auto& row : base->surfaces())
      EXPECT_TRUE(std::ranges::count(now, row)) << "surface " << row.id << " is gone";
    return done->version;
  }

  static void expect_radius(const mesh_version& mesh, surface_id id, double radius) {
    const auto facets = facets_of(mesh, std::vector{id});
    EXPECT_FALSE(facets.empty());
    for (const auto f : facets)
      for (const auto v : mesh.facet(f).v)
        EXPECT_NEAR(std::hypot(mesh.position(v).x, mesh.position(v).y), radius, 1e-9);
  }

  static double figure_of(const edit_result& result, const std::string& id) {
    const auto found = std::ranges::find(result.figures, id, &figure::id);
    return found == result.figures.end() ? -1 : found->value;
  }

  catalogue plugins_;
  std::unique_ptr<services> host_ = make_host_services();
};

TEST_F(RoundWalls, ABoreAndABossChangeByExactlyTheDistance) {
  const tube shape;
  const auto base = tube_mesh(shape);
  for (const double distance : {-0.1, 0.1})
    for (const surface_id wall : {1, 2}) {
      SCOPED_TRACE(std::to_string(wall) + " by " + std::to_string(distance));

      const auto result = shift(base, {wall}, distance);

      const auto after = finish(base, result);
      ASSERT_TRUE(after);
      const double r = wall == 1 ? 1 - distance : 1.0;
      const double R = wall == 2 ? 2 + distance : 2.0;
      EXPECT_NEAR(total_volume(*after), polygon(16, R) - polygon(16, r), 1e-9);
      EXPECT_NEAR(result->volume_change,
                  polygon(16, R) - polygon(16, r) - polygon(16, 2) + polygon(16, 1), 1e-9);
      expect_radius(*after, 1, r);
      expect_radius(*after, 2, R);
      EXPECT_NEAR(figure_of(*result, "thickness_change_mm"), 100, 1e-6);
      EXPECT_NEAR(figure_of(*result, "thickness_change_worst_mm"), 100, 1e-6);
      EXPECT_NEAR(figure_of(*result, "radius_change_mm"),
                  wall == 1 ? -1e3 * distance : 1e3 * distance, 1e-6);
    }
}

TEST_F(RoundWalls, ADistanceOfSeveralTetsGoesInSteps) {
  tube shape;
  shape.rings = 5;
  const auto base = tube_mesh(shape);

  const auto result = shift(base, {1}, -0.45);

  // Two rings of vertices had to give way.
  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  expect_radius(*after, 1, 1.45);
  expect_radius(*after, 2, 2);
  EXPECT_LT(after->tet_count(), base->tet_count());
}

TEST_F(RoundWalls, BothSidesOfAWallMoveTogether) {
  const auto base = tube_mesh({});

  const auto after = finish(base, shift(base, {1, 2}, -0.2));

  ASSERT_TRUE(after);
  EXPECT_NEAR(total_volume(*after), polygon(16, 1.8) - polygon(16, 1.2), 1e-9);
}

TEST_F(RoundWalls, AWallsEndsStayOnTheirPlanes) {
  // Half a tube: surfaces 3 and 4 lie in y = 0.
  const auto base = test::box_mesh({3, 8, 3}, {1, 1, 1}, [](vec3 p) {
    const double angle = std::numbers::pi * p.y;
    return vec3{(1 + p.x) * std::cos(angle), (1 + p.x) * std::sin(angle), p.z};
  });

  const auto after = finish(base, shift(base, {1}, -0.15));

  ASSERT_TRUE(after);
  expect_radius(*after, 1, 1.15);
  EXPECT_NEAR(total_volume(*after), 0.5 * (polygon(16, 2) - polygon(16, 1.15)), 1e-9);
}

TEST_F(RoundWalls, AConeMovesAlongItsNormal) {
  tube shape;
  shape.slope = 0.2;
  const auto base = tube_mesh(shape);

  const auto result = shift(base, {1}, -0.1);

  const auto after = finish(base, result);
  ASSERT_TRUE(after);
  for (const auto f : facets_of(*after, std::vector<surface_id>{1}))
    for (const auto v : after->facet(f).v) {
      const vec3 p = after->position(v);
      EXPECT_NEAR(std::hypot(p.x, p.y) - (1 + 0.2 * p.z), 0.1 * std::hypot(1, 0.2), 1e-9);
    }
  EXPECT_NEAR(figure_of(*result, "thickness_change_worst_mm"), 100, 1e-6);
}

/// The tube's inner wall in two halves: surfaces 1 (y < 0) and 5.
version_ptr halved(const version_ptr& whole) {
  mesh_builder naming(whole);
  const auto half = naming.add_surface("half");
  for (const auto f : facets_of(*whole, std::vector<surface_id>{1})) {
    const auto& v = whole->facet(f).v;
    if (whole->position(v[0]).y + whole->position(v[1]).y + whole->position(v[2]).y > 0)
      naming.set_surface(f, half);
  }
  return naming.freeze();
}

TEST_F(RoundWalls, BothHalvesOfAWallMoveWithoutAStep) {
  const auto base = halved(tube_mesh({}));

  const auto both = finish(base, shift(base, {1, 5}, -0.1));

  ASSERT_TRUE(both);
  EXPECT_EQ(both->surfaces(), base->surfaces());
  EXPECT_NEAR(total_volume(*both), polygon(16, 2) - polygon(16, 1.1), 1e-9);
}

TEST_F(RoundWalls, HalfAWallMovesWithAStepAndTheOtherHalfIsNamed) {
  const auto base = halved(tube_mesh({}));
  for (const double distance : {-0.1, 0.1}) {
    SCOPED_TRACE(distance);

    const auto result = shift(base, {1}, distance);

    const auto after = finish(base, result);
    ASSERT_TRUE(after);
    EXPECT_NEAR(total_volume(*after),
                polygon(16, 2) - 0.5 * (polygon(16, 1) + polygon(16, 1 - distance)), 1e-9);
    EXPECT_THAT(result->notices, ::testing::Contains(HasSubstr("beside surface 5; select it")));
    EXPECT_NEAR(figure_of(*result, "thickness_change_mm"), 100, 1e-6);
    // The other half's facets are where they were, and the steps are a surface of their own.
    for (const auto f : facets_of(*after, std::vector<surface_id>{5}))
      for (const auto v : after->facet(f).v) {
        const vec3 p = after->position(v);
        EXPECT_LE(std::hypot(p.x, p.y), 1 + 1e-9);
        EXPECT_GE(std::hypot(p.x, p.y), std::cos(std::numbers::pi / 16) - 1e-9);
      }
    EXPECT_EQ(after->surfaces().back().name, "step beside 5");
    double steps = 0;
    for (const auto f : facets_of(*after, std::vector{after->surfaces().back().id}))
      steps += norm(area_vector(*after, after->facet(f)));
    EXPECT_NEAR(steps, 2 * 0.1 * 1, 1e-9);
  }
}

TEST_F(RoundWalls, AWallThinnerThanTheDepthIsRefusedWithThePlace) {
  tube shape;
  shape.outer = 1.5;
  const auto base = tube_mesh(shape);

  const auto result = shift(base, {1}, -0.6);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::invalid_argument);
  EXPECT_THAT(result.error().message, HasSubstr("the part is only 490.4 mm thick"));  // cos 11.25
  EXPECT_THAT(result.error().message, HasSubstr("between surfaces 1 and 2 at ("));
}

TEST_F(RoundWalls, ABoreIsNotNarrowedBeyondItsAxis) {
  tube shape;
  shape.inner = 0.5;
  const auto base = tube_mesh(shape);

  const auto result = shift(base, {1}, 0.6);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::invalid_argument);
  EXPECT_THAT(result.error().message, HasSubstr("round with a radius of 500 mm"));
  EXPECT_THAT(result.error().remedy, HasSubstr("fill_hole"));
}

TEST_F(RoundWalls, WhatStandsInTheWayIsNamed) {
  raw_mesh raw;
  test::add_tube(raw, {});
  tube around;
  around.inner = 2.2;
  around.outer = 3;
  around.surface = 11;
  test::add_tube(raw, around);
  const auto base = build_version(std::move(raw), 1)->version;

  const auto near = shift(base, {2}, 0.15);
  const auto far = shift(base, {2}, 0.3);

  ASSERT_TRUE(finish(base, near));
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().code, ec::invalid_argument);
  EXPECT_THAT(far.error().message, HasSubstr("mm of space between surfaces 2 and 11 at ("));
}

TEST_F(RoundWalls, ASquareBossMovesBothSidesOfItsCorners) {
  tube shape;
  shape.sides = 4;
  const auto base = tube_mesh(shape);
  for (const double distance : {-0.1, 0.1}) {
    const auto result = shift(base, {2}, distance);

    // Its sides are sqrt(2) off the axis.
    const auto after = finish(base, result);
    ASSERT_TRUE(after);
    EXPECT_NEAR(total_volume(*after), 4 * std::pow(std::sqrt(2.0) + distance, 2) - polygon(4, 1),
                1e-9);
    EXPECT_NEAR(figure_of(*result, "thickness_change_worst_mm"), 100, 1e-6);
  }
}

/// Its upper edge goes along what the facets of the top stand for: these are up to 4e-3 off it.
TEST_F(RoundWalls, AWallBesideFreeFormGoesAlongIt) {
  const auto height = [](double x, double y) {
    return 0.4 + 0.3 * std::sin(2.5 * x + 0.2) * std::sin(2 * y + 0.4);
  };
  const auto base = test::box_mesh({10, 10, 3}, {1, 1, 1}, [&](vec3 p) {
    return vec3{p.x, p.y, p.z * height(p.x, p.y)};
  });
  const auto after = finish(base, shift(base, {1}, -0.045));

  ASSERT_TRUE(after);
  double furthest = 0;
  for (const auto f : facets_of(*after, std::vector<surface_id>{6}))
    for (const auto v : after->facet(f).v) {
      const vec3 p = after->position(v);
      furthest = std::max(furthest, std::abs(p.z - height(p.x, p.y)));
    }
  EXPECT_LT(furthest, 2e-4);
}

TEST_F(RoundWalls, AWallOfFreeFormMovesAlongItsNormals) {
  const auto height = [](double x, double y) {
    return 1 + 0.1 * std::sin(3 * x) * std::cos(2 * y);
  };
  const auto base = test::box_mesh({8, 8, 4}, {2, 2, 1}, [&](vec3 p) {
    return vec3{p.x, p.y, p.z * height(p.x, p.y)};
  });
  ASSERT_FALSE(fit_wall(*base, facets_of(*base, std::vector<surface_id>{6})));
  for (const double distance : {-0.05, 0.05}) {
    SCOPED_TRACE(distance);

    const auto after = finish(base, shift(base, {6}, distance));

    ASSERT_TRUE(after);
    EXPECT_EQ(after->surfaces(), base->surfaces());
    // Where the wall is off its border each point is as far from where it was.
    for (const auto f : facets_of(*after, std::vector<surface_id>{6}))
      for (const auto v : after->facet(f).v) {
        const vec3 p = after->position(v);
        if (std::min({p.x, p.y, 2 - p.x, 2 - p.y}) < 0.2)
          continue;
        double least = 1;
        for (const auto g : facets_of(*base, std::vector<surface_id>{6})) {
          const auto& c = base->facet(g).v;
          least = std::min(least, point_to_triangle(p, base->position(c[0]), base->position(c[1]),
                                                    base->position(c[2])));
        }
        EXPECT_NEAR(least, 0.05, 0.01 * 0.05);
      }
    // Sides stay where they were.
    for (const auto f : facets_of(*after, std::vector<surface_id>{1}))
      for (const auto v : after->facet(f).v)
        EXPECT_NEAR(after->position(v).x, 0, 1e-12);
  }
}

/// A unit cube of region 2 on the middle of a 3 x 3 x 1 block of region 1: what is left of the
/// block's top is surface 8, a frame around the cube.
version_ptr cube_on_block() {
  const auto plain =
    test::blocks({3, 3, 2}, [](int x, int y, int z) { return z == 0 || (x == 1 && y == 1); });
  raw_mesh raw;
  const auto level = [&](const std::array<vertex_id, 3>& v) {
    return std::ranges::all_of(v, [&](vertex_id i) { return plain->position(i).z == 1; });
  };
  for (vertex_id v = 0; v < plain->vertex_slots(); ++v)
    raw.positions.push_back(plain->position(v));
  for (const auto t : test::all_tets(*plain)) {
    raw.tets.push_back(plain->tet_at(t));
    const auto c = plain->corners(t);
    const bool upper = c[0].z + c[1].z + c[2].z + c[3].z > 4;
    raw.tet_regions.push_back(upper ? 2 : 1);
    for (int i = 0; upper && i < 4; ++i) {
      const auto& v = plain->tet_at(t).v;
      const auto& f = tet_faces[i];
      const std::array<vertex_id, 3> face{v[f[0]], v[f[1]], v[f[2]]};
      if (level(face) && !is_facet(plain->neighbours(t)[i]))
        raw.triangles.push_back({face, 9, true});
    }
  }
  for (facet_id f = 0; f < plain->facet_slots(); ++f) {
    const auto& facet = plain->facet(f);
    raw.triangles.push_back({facet.v, level(facet.v) ? 8 : facet.surface, true});
  }
  return build_version(std::move(raw), 1)->version;
}

TEST_F(RoundWalls, AWallBesideAnotherRegionMovesAlone) {
  const auto base = cube_on_block();
  ASSERT_EQ(base->data().interfaces.size(), 2u);

  const auto after = finish(base, shift(base, {8}, -0.1));

  ASSERT_TRUE(after);
  EXPECT_NEAR(total_volume(*after), 10 - 0.1 * 8, 1e-9);
  EXPECT_EQ(after->data().interfaces.size(), 2u);
}

TEST_F(RoundWalls, TheFourSidesOfASquareHoleAreNoPlane) {
  // Their area vectors sum up to nothing, so that every point is as far off "the plane".
  const auto base = test::blocks({3, 3, 1}, [](int x, int y, int) { return x != 1 || y != 1; });
  ASSERT_FALSE(fit_wall(*base, facets_of(*base, std::vector<surface_id>{7}), round_enough));

  const auto after = finish(base, shift(base, {7}, -0.1));

  ASSERT_TRUE(after);
  EXPECT_NEAR(total_volume(*after), 9 - 1.2 * 1.2, 1e-9);
}

TEST_F(RoundWalls, AStepFarSmallerThanTheMeshIsRefusedWithItsSize) {
  const auto base = halved(tube_mesh({}));

  const auto result = make_wall_tool(*base, *fit_walls(*base, {1}), -1e-4);

  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("a step of 0.1 mm is too small for a mesh"));
}

// -- real parts ------------------------------------------------------------------------

class RoundWallsOfParts : public RoundWalls {
protected:
  static version_ptr part(const std::string& name) {
    const auto folder = std::filesystem::path(TEDIT_TEST_DATA "/parts") / name;
    auto imported = import_mesh(folder / (name + ".coarse.msh"), "mm");
    EXPECT_TRUE(imported);
    return imported ? imported->version : nullptr;
  }
};

TEST_F(RoundWallsOfParts, BoresOfPartsChangeByTheDistance) {
  struct bore {
    const char* part;
    std::vector<surface_id> walls;
    double distance;
  };
  for (const auto& [name, walls, distance] :
       {bore{"ctc01_plate", {1, 2}, 2e-3}, bore{"ctc01_plate", {51, 52}, 1e-3},
        bore{"holes_block", {80, 81}, 0.5e-3}, bore{"holes_block", {52, 53}, 1e-3},
        bore{"heatsink_125", {71}, 0.2e-3}, bore{"foot_cup", {16, 87}, 0.1e-3}}) {
    const auto base = part(name);
    ASSERT_TRUE(base);
    for (const double d : {-distance, distance}) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(walls.front()) + " by " +
                   std::to_string(1e3 * d) + " mm");

      const auto result = shift(base, walls, d);

      ASSERT_TRUE(finish(base, result));
      const double asked = 1e3 * distance;
      EXPECT_NEAR(figure_of(*result, "thickness_change_mm"), asked, 0.01 * asked);
      EXPECT_NEAR(figure_of(*result, "thickness_change_worst_mm"), asked, 0.01 * asked);
      EXPECT_NEAR(figure_of(*result, "radius_change_mm"), -1e3 * d, 0.01 * asked);
    }
  }
}

TEST_F(RoundWallsOfParts, ASurfaceAloneMovesSoundlyOrIsRefusedByName) {
  const auto base = part("bracket_4040");
  ASSERT_TRUE(base);
  const auto id = base->id();
  int done = 0;
  int tried = 0;
  for (const auto& row : base->surfaces()) {
    const auto shape = fit_wall(*base, facets_of(*base, std::vector{row.id}));
    if (shape && shape->type == wall_shape::kind::plane)
      continue;
    if (row.id % 4 != 0 && row.id != 61 && row.id != 143)  // Those two touch themselves.
      continue;
    SCOPED_TRACE(row.id);
    ++tried;
    const auto result = shift(base, {row.id}, row.id % 2 ? -1e-4 : 1e-4);
    if (!result) {
      EXPECT_THAT(result.error().code,
                  ::testing::AnyOf(ec::invalid_argument, ec::postcondition_failed))
        << render(result.error());
    } else if (finish(base, result)) {
      ++done;
    }
  }
  EXPECT_EQ(base->id(), id);
  EXPECT_GT(10 * done, 9 * tried);
}

}  // namespace
}  // namespace tedit::ops
