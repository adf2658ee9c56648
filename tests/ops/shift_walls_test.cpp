// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/shift_walls.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/finish_edit.hpp"
#include "mesh/io/import.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/services/host_services.hpp"
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
    EXPECT_EQ(done->version->surfaces(), base->surfaces());
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

TEST_F(RoundWalls, HalfAWallIsRefusedAndTheOtherHalfNamed) {
  const auto whole = tube_mesh({});
  mesh_builder naming(whole);
  const auto half = naming.add_surface("half");
  for (const auto f : facets_of(*whole, std::vector<surface_id>{1})) {
    const auto& v = whole->facet(f).v;
    if (whole->position(v[0]).y + whole->position(v[1]).y + whole->position(v[2]).y > 0)
      naming.set_surface(f, half);
  }
  const auto base = naming.freeze();

  const auto alone = shift(base, {1}, -0.1);

  ASSERT_FALSE(alone);
  EXPECT_EQ(alone.error().code, ec::invalid_argument);
  EXPECT_THAT(alone.error().message, HasSubstr("surface 5 runs on flush with surface 1"));
  EXPECT_THAT(alone.error().remedy, HasSubstr("Select surface 5, too"));
  const auto both = finish(base, shift(base, {1, half}, -0.1));
  ASSERT_TRUE(both);
  EXPECT_NEAR(total_volume(*both), polygon(16, 2) - polygon(16, 1.1), 1e-9);
}

TEST_F(RoundWalls, AWallThinnerThanTheDepthIsRefusedWithThePlace) {
  tube shape;
  shape.outer = 1.5;
  const auto base = tube_mesh(shape);

  const auto result = shift(base, {1}, -0.6);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::invalid_argument);
  EXPECT_THAT(result.error().message, HasSubstr("surface 1 cannot be moved so far"));
  EXPECT_THAT(result.error().message, HasSubstr("leaves no room"));
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
  EXPECT_THAT(far.error().message, HasSubstr("is in the way"));
}

TEST_F(RoundWalls, ASquareBossIsNotRound) {
  tube shape;
  shape.sides = 4;
  const auto base = tube_mesh(shape);

  const auto result = shift(base, {2}, -0.1);

  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("surface 2 is neither flat nor a round"));
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

TEST_F(RoundWallsOfParts, EverySurfaceAloneMovesSoundlyOrIsRefusedByName) {
  const auto base = part("bracket_4040");
  ASSERT_TRUE(base);
  const auto id = base->id();
  int done = 0;
  for (const auto& row : base->surfaces()) {
    const auto shape = fit_wall(*base, facets_of(*base, std::vector{row.id}));
    if (shape && shape->type == wall_shape::kind::plane)
      continue;
    SCOPED_TRACE(row.id);
    const auto result = shift(base, {row.id}, row.id % 2 ? -1e-4 : 1e-4);
    if (!result) {
      EXPECT_EQ(result.error().code, ec::invalid_argument) << render(result.error());
      EXPECT_THAT(result.error().message, HasSubstr("surface"));
    } else if (finish(base, result)) {
      ++done;
    }
  }
  EXPECT_EQ(base->id(), id);
  EXPECT_GT(done, 0);
}

}  // namespace
}  // namespace tedit::ops
