// SPDX-License-Identifier: AGPL-3.0-or-later
// New vertices on round walls lie on the cylinders, cones and spheres behind their facets.
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "mesh/adapt/wall_demands.hpp"
#include "mesh/adapt/wall_places.hpp"
#include "mesh/io/import.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/services/host_services.hpp"
#include "tests/support/parts.hpp"

namespace tedit::ops {
namespace {

exact_wall cylinder(vec3 point, vec3 axis, double radius) {
  return {{wall_shape::kind::cylinder, point, axis, radius, 1, 0}, 0};
}

TEST(PlaceOnWalls, OneWallTakesTheNearestPoint) {
  const auto wall = cylinder({}, {0, 0, 1}, 5);

  const auto place = place_on_walls({{&wall, {}}}, {3.6, 2.7, 1});

  ASSERT_TRUE(place.found);
  EXPECT_NEAR(norm(place.at - vec3{4, 3, 1}), 0, 1e-12);
  EXPECT_NEAR(place.before, 0.5, 1e-12);
}

TEST(PlaceOnWalls, AWallAndAPlaneTakeAPointOfTheirRim) {
  const auto wall = cylinder({}, {0, 0, 1}, 5);
  const vec3 slanted = normalized({0, 1, 1});

  const auto place = place_on_walls({{&wall, {}}, {nullptr, slanted}}, {3.6, 2.7, 1});

  ASSERT_TRUE(place.found);
  EXPECT_NEAR(std::hypot(place.at.x, place.at.y), 5, 1e-12);
  EXPECT_NEAR(place.at.y + place.at.z, 3.7, 1e-12);
}

TEST(PlaceOnWalls, ThreeWallsTakeTheirCorner) {
  // x^2 + y^2 = 25, x^2 + z^2 = 25 and the plane x = 3 meet at (3, 4, 4).
  const auto one = cylinder({}, {0, 0, 1}, 5);
  const auto other = cylinder({}, {0, 1, 0}, 5);

  const auto place =
    place_on_walls({{&one, {}}, {&other, {}}, {nullptr, {1, 0, 0}}}, {3, 3.8, 3.9});

  ASSERT_TRUE(place.found);
  EXPECT_NEAR(norm(place.at - vec3{3, 4, 4}), 0, 1e-12);
}

TEST(PlaceOnWalls, WhatLiesThereStays) {
  const auto wall = cylinder({}, {0, 0, 1}, 5);

  EXPECT_TRUE(place_on_walls({{&wall, {}}}, {4, 3, 1}).is_there());
}

TEST(PlaceOnWalls, WallsThatDoNotMeetAreTold) {
  const auto one = cylinder({}, {0, 0, 1}, 5);
  const auto other = cylinder({12, 0, 0}, {0, 0, 1}, 5);

  const auto place = place_on_walls({{&one, {}}, {&other, {}}}, {5.5, 0, 0});

  EXPECT_FALSE(place.found);
  EXPECT_EQ(place.at, (vec3{5.5, 0, 0}));
}

class CurvedWalls : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
    plugins_.load_directory(TEDIT_BIN "/../lib/tedit/plugins");
  }

  version_ptr part(const std::string& name) {
    const auto imported = import_mesh(test::parts_folder / name / (name + ".coarse.msh"), "mm");
    EXPECT_TRUE(imported);
    return imported->version;
  }

  /// How many vertices after have another place than all before, and how far they are off the round
  /// walls of before at most, m.
  static std::pair<int, double> new_vertices(const mesh_version& before, const mesh_version& after,
                                             const std::set<surface_id>& but) {
    std::set<std::array<double, 3>> known;
    for (vertex_id v = 0; v < before.vertex_slots(); ++v)
      if (before.is_live_vertex(v))
        known.insert({before.position(v).x, before.position(v).y, before.position(v).z});
    wall_places walls(before);
    int count = 0;
    double most = 0;
    for (facet_id f = 0; f < after.facet_slots(); ++f) {
      if (!after.is_live_facet(f) || but.contains(after.facet(f).surface) ||
          !before.find_surface(after.facet(f).surface) || !walls.is_round(after.facet(f).surface))
        continue;
      for (const auto v : after.facet(f).v) {
        const vec3 p = after.position(v);
        if (known.contains({p.x, p.y, p.z}))
          continue;
        ++count;
        most = std::max(most, walls.off(after.facet(f).surface, p));
      }
    }
    return {count, most};
  }

  std::unique_ptr<services> host_ = make_host_services();
  catalogue plugins_;
};

TEST_F(CurvedWalls, AFlatWallThatIsLoweredKeepsItsRoundNeighboursRound) {
  const auto mesh = part("inch_block");
  context ctx;
  ctx.host = host_.get();

  const auto eroded = run_operation(plugins_, "erode", mesh, {{2}}, {{"depth", 1e-3}}, ctx);

  ASSERT_TRUE(eroded) << render(eroded.error());
  const auto [count, off] = new_vertices(*mesh, *eroded->candidate, {2});
  EXPECT_GT(count, 0);
  EXPECT_LE(off, 1e-12);
}

}  // namespace
}  // namespace tedit::ops
