// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/refine/refine.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include <gmock/gmock.h>

#include "mesh/adapt/split_edges.hpp"
#include "mesh/facet_pages.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"
#include "tests/support/tube.hpp"
#include "tests/support/two_regions.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

double longest_edge_on(const mesh_version& mesh, surface_id surface) {
  double longest = 0;
  for (const auto f : facets_of(mesh, std::array{surface})) {
    const auto t = mesh.facet(f).tet;
    const auto p = mesh.corners(t);
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        longest = std::max(longest, norm(p[i] - p[j]));
  }
  return longest;
}

class Refine : public test::tool_edits {
protected:
  expected<edit_result> refined(const version_ptr& mesh, const mesh_pick& pick, double size) {
    return refine(mesh, pick, size, ctx_);
  }
};

// A cube of six tets around its diagonal, sqrt(3) long; all other edges are 1 or sqrt(2).
TEST_F(Refine, TheDiagonalOfACubeIsHalvedWithAllSixTets) {
  const auto cube = test::box_mesh({1, 1, 1}, {1, 1, 1});

  const auto result = refined(cube, {{6}, {}, 0}, 1.5);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(cube, *result);
  EXPECT_EQ(result->candidate->tet_count(), 12u);
  EXPECT_EQ(result->candidate->vertex_count(), 9u);
  EXPECT_EQ(result->candidate->facet_count(), 12u);
  EXPECT_NEAR(total_volume(*result->candidate), 1, 1e-15);
}

TEST_F(Refine, EdgesAtTheSurfaceAreAsShortAsAskedForAndFlatWallsStayExactly) {
  const auto box = test::box_mesh({3, 3, 3}, {1, 1, 1});

  const auto result = refined(box, {{6}, {}, 0}, 0.1);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(box, *result);
  EXPECT_LE(longest_edge_on(*result->candidate, 6), 0.1);
  EXPECT_NEAR(result->volume_change, 0, 1e-14);
  for (const auto& [id, size] : surface_sizes(*result->candidate))
    EXPECT_NEAR(size.area_m2, 1, 1e-12) << id;
  for (const auto f : facets_of(*result->candidate, std::array<surface_id, 1>{6}))
    for (const auto v : result->candidate->facet(f).v)
      EXPECT_EQ(result->candidate->position(v).z, 1);
}

TEST_F(Refine, FurtherOffEdgesAreLongerByNoMoreThanTheGrowth) {
  const auto box = test::box_mesh({3, 3, 3}, {1, 1, 1});
  adapt_mesh work(*box);
  const mesh_pick pick{{6}, {}, 0};

  ASSERT_TRUE(split_edges(*box, work, {pick, 0.1}, {}));

  std::size_t unchanged = 0;
  for (std::uint32_t t = 0; t < work.tet_slots(); ++t) {
    if (!work.is_live(t))
      continue;
    unchanged += t < box->tet_slots();
    const auto p = work.corners(t);
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        EXPECT_LE(norm(p[i] - p[j]), 0.1 + size_growth * (1 - std::max(p[i].z, p[j].z)) + 1e-12);
  }
  EXPECT_GT(unchanged, 0u);
}

TEST_F(Refine, ChordsOfABoreAreHalvedWhereTheyAreTooFarOffIt) {
  // A chord of a sixteenth of the circle is 1 - cos(pi / 16) = .0192 off, of a half of it .0048.
  const auto tube = test::tube_mesh({.sides = 16, .inner = 1, .outer = 2, .length = 1});
  adapt_mesh work(*tube);
  chord_settings settings;
  settings.near = {{0.1, -3, -1}, {3, 3, 2}};
  settings.is_round = [](surface_id id) { return id == 1; };
  settings.most_off = 0.005;

  const auto made = split_chords(*tube, work, settings, {});

  ASSERT_TRUE(made);
  EXPECT_GT(made->vertices, 0u);
  mesh_builder builder(tube);
  ASSERT_TRUE(work.write(builder));
  const auto after = builder.freeze();
  EXPECT_EQ(check_version(*after).total, 0u);
  std::size_t long_chords = 0;
  for (const auto f : facets_of(*after, std::array<surface_id, 1>{1}))
    for (int k = 0; k < 3; ++k) {
      const vec3 a = after->position(after->facet(f).v[k]);
      const vec3 b = after->position(after->facet(f).v[(k + 1) % 3]);
      EXPECT_NEAR(std::hypot(a.x, a.y), 1, 1e-12);
      const vec3 middle = 0.5 * (a + b);
      const double off = 1 - std::hypot(middle.x, middle.y);
      if (std::max(a.x, b.x) >= 0.1)
        EXPECT_LE(off, 0.005);
      else
        long_chords += off > 0.019;
    }
  EXPECT_GT(long_chords, 0u);
}

TEST_F(Refine, OnlyTheNamedWallsChordsAreHalved) {
  const auto tube = test::tube_mesh({.sides = 16, .inner = 1, .outer = 2, .length = 1});
  adapt_mesh work(*tube);
  chord_settings settings;
  settings.near = {{-3, -3, -1}, {3, 3, 2}};
  settings.is_round = [](surface_id id) { return id == 3; };  // An end, which is flat.
  settings.most_off = 1e-3;

  const auto made = split_chords(*tube, work, settings, {});

  ASSERT_TRUE(made);
  EXPECT_EQ(made->vertices, 0u);
}

TEST_F(Refine, NewVerticesOfASmoothWallLieOnWhatItsFacetsStandFor) {
  const auto height = [](double x, double y) {
    return 0.4 + 0.3 * std::sin(2.5 * x + 0.2) * std::sin(2 * y + 0.4);
  };
  const auto dome = test::box_mesh({10, 10, 3}, {1, 1, 1}, [&](vec3 p) {
    return vec3{p.x, p.y, p.z * height(p.x, p.y)};
  });

  const auto result = refined(dome, {{6}, {}, 0}, 0.04);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(dome, *result);
  // What the top is higher than its facets, of which the sides' rims are a part.
  EXPECT_GT(result->volume_change, 3e-4);
  EXPECT_LT(result->volume_change, 3e-3);
  double furthest = 0;
  for (const auto f : facets_of(*result->candidate, std::array<surface_id, 1>{6}))
    for (const auto v : result->candidate->facet(f).v) {
      const vec3 p = result->candidate->position(v);
      furthest = std::max(furthest, std::abs(p.z - height(p.x, p.y)));
    }
  // Of chords it would be 3e-3.
  EXPECT_LT(furthest, 2e-4);
}

TEST_F(Refine, NewVerticesOfABoreLieOnItsCylinder) {
  const auto tube = test::tube_mesh({.sides = 16, .inner = 1, .outer = 2, .length = 1});

  const auto result = refined(tube, {{1}, {}, 0}, 0.1);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(tube, *result);
  std::size_t corners = 0;
  for (const auto f : facets_of(*result->candidate, std::array<surface_id, 1>{1}))
    for (const auto v : result->candidate->facet(f).v) {
      const vec3 p = result->candidate->position(v);
      EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-9);
      ++corners;
    }
  EXPECT_GT(corners, 3000u);
  // The prism with 16 sides becomes nearly the cylinder: of 64 sides or more.
  const double least = test::polygon(64, 1) - test::polygon(16, 1);
  const double most = std::numbers::pi - test::polygon(16, 1);
  EXPECT_LT(result->volume_change, -0.9 * least);
  EXPECT_GT(result->volume_change, -1.3 * most);
}

TEST_F(Refine, NewVerticesOfAConeLieOnIt) {
  const auto tube = test::tube_mesh({.sides = 24, .slope = 0.3});

  const auto result = refined(tube, {{1}, {}, 0}, 0.15);

  ASSERT_TRUE(result) << render(result.error());
  for (const auto f : facets_of(*result->candidate, std::array<surface_id, 1>{1}))
    for (const auto v : result->candidate->facet(f).v) {
      const vec3 p = result->candidate->position(v);
      EXPECT_NEAR(std::hypot(p.x, p.y), 1 + 0.3 * p.z, 1e-9);
    }
}

TEST_F(Refine, NewVerticesOfASphereLieOnIt) {
  // The cube [-1, 1]^3 bent to a ball: all six sides are of one sphere.
  const auto ball = test::box_mesh({6, 6, 6}, {2, 2, 2}, [](vec3 p) {
    const vec3 q = p - vec3{1, 1, 1};
    const double wide = std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z)});
    return wide > 0 ? wide * normalized(q) : q;
  });

  const auto result = refined(ball, {{6}, {}, 0}, 0.2);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(ball, *result);
  for (const auto f : facets_of(*result->candidate, std::array<surface_id, 1>{6}))
    for (const auto v : result->candidate->facet(f).v)
      EXPECT_NEAR(norm(result->candidate->position(v)), 1, 1e-9);
}

TEST_F(Refine, AroundAPlaceTheMeshIsFineAndFarOffItIsAsItWas) {
  const auto box = test::box_mesh({6, 6, 6}, {1, 1, 1});

  const auto result = refined(box, {{}, vec3{0, 0, 0}, 0.1}, 0.05);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(box, *result);
  const std::set<tet_id> touched(result->touched.begin(), result->touched.end());
  for (tet_id t = 0; t < box->tet_slots(); ++t) {
    const auto p = box->corners(t);
    const double near = std::min({norm(p[0]), norm(p[1]), norm(p[2]), norm(p[3])});
    // The longest edge there is 0.29 m: beyond 0.1 + (0.29 - 0.05) / 0.75 nothing is too long.
    if (near > 0.8) {
      EXPECT_EQ(result->candidate->tet_at(t), box->tet_at(t));
      EXPECT_FALSE(touched.contains(t));
    }
  }
}

TEST_F(Refine, RegionsAndTheSurfaceBetweenThemAreKept) {
  const auto mesh = test::two_regions();
  ASSERT_EQ(mesh->data().interfaces.size(), 8u);

  const auto result = refined(mesh, {{2, 4}, {}, 0}, 0.1);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  EXPECT_EQ(result->candidate->regions(), mesh->regions());
  const auto& after = *result->candidate;
  for (const auto& row : after.data().interfaces.to_vector()) {
    EXPECT_EQ(row.surface, 77);
    for (const auto v : row.v)
      EXPECT_EQ(after.position(v).x, 0.5);
  }
  EXPECT_GT(after.data().interfaces.size(), 8u);
  EXPECT_NEAR(test::interface_area(after), 0.25, 1e-12);
  EXPECT_NEAR(test::region_volume(after, 4), 0.125, 1e-12);
}

TEST_F(Refine, SoManyTetsAsAreExpectedComeOut) {
  const auto box = test::box_mesh({4, 4, 4}, {1, 1, 1});
  for (const double size : {0.1, 0.05}) {
    const split_settings settings{{{6}, {}, 0}, size};
    adapt_mesh work(*box);
    ASSERT_TRUE(split_edges(*box, work, settings, {}));
    const double ratio = tets_after_split(*box, settings) / static_cast<double>(work.tet_count());
    EXPECT_GT(ratio, 0.5) << size;
    EXPECT_LT(ratio, 2) << size;
  }
}

TEST_F(Refine, TooManyTetsAreRefusedBeforeAnyWorkWithASizeThatDoes) {
  const auto box = test::box_mesh({3, 3, 3}, {1, 1, 1});

  for (const double size : {1e-3, 1e-5, 5e-324}) {
    const auto result = refined(box, {{6}, {}, 0}, size);

    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ec::invalid_parameter);
    EXPECT_THAT(result.error().message, HasSubstr("million tets would come out"));
    EXPECT_THAT(result.error().remedy, HasSubstr("Take a size of"));
  }
}

TEST_F(Refine, WhatWouldChangeNothingIsRefusedByName) {
  const auto box = test::box_mesh({3, 3, 3}, {1, 1, 1});
  const auto coarse = refined(box, {{6}, {}, 0}, 2);
  const auto nothing = refined(box, {}, 0.1);
  const auto off = refined(box, {{}, vec3{3, 0, 0}, 0.5}, 0.1);
  const auto inside = refined(test::two_regions(), {{77}, {}, 0}, 0.1);

  for (const auto* refused : {&coarse, &nothing, &off, &inside}) {
    ASSERT_FALSE(*refused);
    EXPECT_FALSE(refused->error().remedy.empty());
  }
  EXPECT_THAT(coarse.error().message, HasSubstr("longer than 2000 mm"));
  EXPECT_EQ(nothing.error().code, ec::empty_selection);
  EXPECT_THAT(off.error().message, HasSubstr("off the part"));
  EXPECT_THAT(inside.error().message, HasSubstr("surface 77"));
}

}  // namespace
}  // namespace tedit::ops
