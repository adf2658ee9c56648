// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/level_set.hpp"

#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "mesh/checks.hpp"
#include "mesh/level_set_freedom.hpp"
#include "mesh/level_set_tidy.hpp"
#include "tests/support/bonded_boxes.hpp"

namespace tedit {
namespace {

std::map<surface_id, double> areas(const mesh_version& mesh) {
  std::map<surface_id, double> result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      result[mesh.facet(f).surface] += norm(area_vector(mesh, mesh.facet(f)));
  return result;
}

/// No edge has ends of both signs; vertices without a value lie outside the region.
bool separated(const mesh_version& mesh, const level_set_cut& cut) {
  for (const auto t : test::all_tets(mesh)) {
    double low = 0;
    double high = 0;
    for (const auto v : mesh.tet_at(t).v)
      if (const auto found = cut.values.find(v); found != cut.values.end()) {
        low = std::min(low, found->second);
        high = std::max(high, found->second);
      }
    if (low < 0 && high > 0)
      return false;
  }
  return true;
}

void expect_same_part(const mesh_version& before, const mesh_version& after) {
  RC_ASSERT(check_version(after).ok());
  RC_ASSERT(std::abs(total_volume(after) - total_volume(before)) <= 1e-12 * total_volume(before));
  const auto old_areas = areas(before);
  const auto new_areas = areas(after);
  RC_ASSERT(old_areas.size() == new_areas.size());
  for (const auto& [id, area] : old_areas)
    RC_ASSERT(std::abs(new_areas.at(id) - area) <= 1e-12 * area);
}

version_ptr two_regions() {
  return test::bonded_boxes({2, 2, 2}, {2, 2, 2});
}

double interface_area(const mesh_version& mesh) {
  double sum = 0;
  for (const auto& row : mesh.data().interfaces.to_vector())
    sum +=
      norm(area_vector(mesh.position(row.v[0]), mesh.position(row.v[1]), mesh.position(row.v[2])));
  return sum;
}

// -- properties -----------------------------------------------------------------------

RC_GTEST_PROP(LevelSet, RandomValuesKeepThePart, (std::uint32_t seed, bool snaps)) {
  const auto base = test::box_mesh({2, 3, 2}, {1, 1.5, 1});
  std::mt19937 random(seed);
  std::vector<double> values(base->vertex_slots());
  for (auto& f : values)
    f = std::uniform_int_distribution(-5, 5)(random);
  mesh_builder builder(base);
  level_set_settings settings;
  // Without an exact function the values of moved vertices are the level's by definition.
  settings.snap = snaps ? 0.2 : 0;

  const auto cut = split_at_level(builder, test::all_tets(*base),
                                  [&](vertex_id v) { return values[v]; }, settings, {});

  RC_ASSERT(cut.has_value());
  const auto after = builder.freeze();
  expect_same_part(*base, *after);
  RC_ASSERT(separated(*after, *cut));
}

RC_GTEST_PROP(LevelSet, PlanesAreMetExactly, (std::uint32_t seed)) {
  const auto base = test::box_mesh({3, 3, 3}, {1, 1, 1});
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const vec3 normal = normalized({number(random), number(random), number(random)});
  const double offset = dot(normal, vec3{0.5, 0.5, 0.5}) + 0.3 * number(random);
  const auto height = [&](vec3 p) { return dot(normal, p) - offset; };
  mesh_builder builder(base);
  level_set_settings settings;
  settings.zero = 1e-12;

  const auto cut =
    split_at_level(builder, test::all_tets(*base),
                   [&](vertex_id v) { return height(base->position(v)); }, settings, {});

  RC_ASSERT(cut.has_value());
  const auto after = builder.freeze();
  expect_same_part(*base, *after);
  RC_ASSERT(separated(*after, *cut));
  for (const auto v : cut->on_level)
    RC_ASSERT(std::abs(height(after->position(v))) <= 1e-12);
  double below = 0;
  for (const auto t : test::all_tets(*after)) {
    const auto c = after->corners(t);
    if (height(0.25 * (c[0] + c[1] + c[2] + c[3])) < 0)
      below += signed_volume(c);
  }
  RC_ASSERT(below > 0 && below < 1);
}

RC_GTEST_PROP(LevelSet, TidyingKeepsThePartAndNeverLowersTheWorst, (std::uint32_t seed)) {
  const auto base = test::box_mesh({2, 2, 2}, {1, 1, 1});
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const vec3 normal = normalized({number(random), number(random), number(random)});
  mesh_builder builder(base);
  level_set_settings settings;
  settings.snap = 0;
  const auto cut = split_at_level(builder, test::all_tets(*base),
                                  [&](vertex_id v) {
                                    return dot(normal, base->position(v) - vec3{0.5, 0.5, 0.5});
                                  },
                                  settings, {});
  RC_ASSERT(cut.has_value());

  const auto report = tidy_cut(builder, builder.touched(), {}, {});

  RC_ASSERT(report.has_value());
  RC_ASSERT(report->min_after >= report->min_before);
  expect_same_part(*base, *builder.freeze());
}

// -- single facts ---------------------------------------------------------------------

TEST(LevelSet, OneTetInFour) {
  raw_mesh raw;
  raw.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  raw.tets = {{{0, 1, 2, 3}}};
  raw.tet_regions = {1};
  const auto base = build_version(std::move(raw), 1)->version;
  mesh_builder builder(base);

  const auto cut =
    split_at_level(builder, {0}, [&](vertex_id v) { return base->position(v).z - 0.5; }, {}, {});

  ASSERT_TRUE(cut.has_value());
  EXPECT_EQ(cut->splits, 3u);
  EXPECT_EQ(cut->on_level.size(), 3u);
  EXPECT_EQ(builder.freeze()->tet_count(), 4u);
}

TEST(LevelSet, AVertexBesideTheLevelIsMovedOntoIt) {
  const auto base = test::box_mesh({4, 4, 4}, {4, 4, 4});
  mesh_builder builder(base);

  const auto cut = split_at_level(builder, test::all_tets(*base),
                                  [&](vertex_id v) { return base->position(v).z - 1.9; }, {}, {});

  ASSERT_TRUE(cut.has_value());
  // All 25 vertices at z = 2 go down: those on faces within them, on edges along them.
  EXPECT_EQ(cut->snaps, 25u);
  EXPECT_EQ(cut->splits, 0u);
  const auto after = builder.freeze();
  EXPECT_TRUE(check_version(*after).ok());
  EXPECT_EQ(after->tet_count(), base->tet_count());
}

TEST(LevelSet, AVertexOnARoundWallIsNotMovedOffIt) {
  // The x = 4 side bulges in both directions: none of its five vertices at z = 2 may move, and
  // those at its rims not either.
  const auto base = test::box_mesh({4, 4, 4}, {4, 4, 4}, [](vec3 p) {
    return vec3{p.x + (p.x == 4 ? 0.05 * p.y * (4 - p.y) * p.z * (4 - p.z) : 0), p.y, p.z};
  });
  mesh_builder builder(base);

  const auto cut = split_at_level(builder, test::all_tets(*base),
                                  [&](vertex_id v) { return base->position(v).z - 1.9; }, {}, {});

  ASSERT_TRUE(cut.has_value());
  EXPECT_EQ(cut->snaps, 25u - 5u);
  const auto after = builder.freeze();
  EXPECT_NEAR(total_volume(*after), total_volume(*base), 1e-12 * total_volume(*base));
  for (vertex_id v = 0; v < base->vertex_slots(); ++v)
    if (base->position(v).x > 4) {
      EXPECT_EQ(after->position(v), base->position(v));
    }
}

TEST(LevelSet, AnExactFunctionIsMetOnEveryEdge) {
  const auto base = test::box_mesh({5, 5, 5}, {1, 1, 1});
  const auto sphere = [](vec3 p) { return norm(p - vec3{0.5, 0.5, 0.5}) - 0.37; };
  mesh_builder builder(base);
  level_set_settings settings;
  settings.exact = sphere;

  const auto cut =
    split_at_level(builder, test::all_tets(*base),
                   [&](vertex_id v) { return sphere(base->position(v)); }, settings, {});

  ASSERT_TRUE(cut.has_value());
  EXPECT_FALSE(cut->on_level.empty());
  for (const auto v : cut->on_level)
    EXPECT_NEAR(sphere(builder.position(v)), 0, 1e-12);
}

TEST(LevelSet, RegionsAndTheirInterfaceAreCutAlike) {
  const auto base = two_regions();
  ASSERT_EQ(base->data().interfaces.size(), 8u);
  mesh_builder builder(base);

  const auto cut = split_at_level(builder, test::all_tets(*base),
                                  [&](vertex_id v) { return base->position(v).z - 0.6; }, {}, {});

  ASSERT_TRUE(cut.has_value());
  const auto after = builder.freeze();
  expect_same_part(*base, *after);
  EXPECT_NEAR(interface_area(*after), interface_area(*base), 1e-12);
  EXPECT_GT(after->data().interfaces.size(), 8u);
  double left = 0;
  for (const auto t : test::all_tets(*after)) {
    const auto c = after->corners(t);
    const bool on_left = c[0].x + c[1].x + c[2].x + c[3].x < 4;
    EXPECT_EQ(after->region_of(t), on_left ? 1 : 2);
    left += on_left ? signed_volume(c) : 0;
  }
  EXPECT_NEAR(left, 4, 1e-12);
}

TEST(LevelSet, OnlyTheRegionIsCut) {
  const auto base = test::box_mesh({4, 1, 1}, {4, 1, 1});
  std::vector<tet_id> region;
  for (const auto t : test::all_tets(*base)) {
    const auto c = base->corners(t);
    if (c[0].x + c[1].x + c[2].x + c[3].x < 4)
      region.push_back(t);
  }
  mesh_builder builder(base);

  const auto cut =
    split_at_level(builder, region, [&](vertex_id v) { return base->position(v).z - 0.5; }, {}, {});

  ASSERT_TRUE(cut.has_value());
  const auto after = builder.freeze();
  expect_same_part(*base, *after);
  for (vertex_id v = base->vertex_slots(); v < after->vertex_slots(); ++v)
    EXPECT_LE(after->position(v).x, 1);
}

TEST(LevelSet, FreedomOfACubesVertices) {
  const auto base = test::box_mesh({2, 2, 2}, {2, 2, 2});
  const mesh_builder builder(base);
  std::map<int, int> count;
  for (vertex_id v = 0; v < base->vertex_slots(); ++v)
    ++count[freedom_of(builder, v, builder.star(v)).dimensions];

  EXPECT_EQ(count, (std::map<int, int>{{0, 8}, {1, 12}, {2, 6}, {3, 1}}));
}

}  // namespace
}  // namespace tedit
