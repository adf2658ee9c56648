// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/erode/erode.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/finish_edit.hpp"
#include "ops/services/host_services.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

class Erode : public ::testing::Test {
protected:
  expected<edit_result> lower(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                              double depth) {
    return erode(mesh, surfaces, {depth, 1, piece_policy::refuse}, ctx_);
  }

  expected<edit_result> peel(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                             int layers, piece_policy pieces = piece_policy::refuse) {
    return erode(mesh, surfaces, {0, layers, pieces}, ctx_);
  }

  /// The postconditions of an edit, with the host's improvement, and the worst q below `floor`.
  static void expect_good(const version_ptr& base, const edit_result& result, double floor = 0.1) {
    edit_claim claim;
    claim.touched = result.touched;
    claim.volume_change = result.volume_change;
    claim.bodies_added = result.bodies_added;
    finish_settings settings;
    settings.quality_floor = floor;
    const auto done = finish_edit(base, result.candidate, claim, improvement::local, settings, {});
    EXPECT_TRUE(done) << render(done.error());
    if (done) {
      EXPECT_TRUE(check_version(*done->version).ok());
    }
  }

  static double area(const mesh_version& mesh, surface_id id) {
    double sum = 0;
    for (const auto f : facets_of(mesh, std::vector{id}))
      sum += norm(area_vector(mesh, mesh.facet(f)));
    return sum;
  }

  static double figure_of(const edit_result& result, const std::string& id) {
    const auto found = std::ranges::find(result.figures, id, &figure::id);
    return found == result.figures.end() ? -1 : found->value;
  }

  std::unique_ptr<services> host_ = make_host_services();
  context ctx_{{}, host_.get(), {}, 1e9};
};

/// A block 4 x 4 x 4 with a pocket 2 x 2 x 2 in the middle of its top: floor 7 at z = 2.
version_ptr pocket() {
  const auto block = test::box_mesh({4, 4, 4}, {4, 4, 4});
  auto dug = test::dig(
    block, [](vec3 p) { return p.x > 1 && p.x < 3 && p.y > 1 && p.y < 3 && p.z > 2; }, 7);
  return dug;
}

/// The same mesh with surface 7 named anew by centre and normal of its facets.
version_ptr named(const version_ptr& mesh, const std::function<surface_id(vec3, vec3)>& name) {
  raw_mesh raw;
  std::map<vertex_id, vertex_id> index;
  for (vertex_id v = 0; v < mesh->vertex_slots(); ++v)
    if (mesh->is_live_vertex(v)) {
      index[v] = static_cast<vertex_id>(raw.positions.size());
      raw.positions.push_back(mesh->position(v));
    }
  for (tet_id t = 0; t < mesh->tet_slots(); ++t) {
    if (!mesh->is_live_tet(t))
      continue;
    tet moved = mesh->tet_at(t);
    for (auto& v : moved.v)
      v = index.at(v);
    raw.tets.push_back(moved);
    raw.tet_regions.push_back(mesh->region_of(t));
  }
  for (facet_id f = 0; f < mesh->facet_slots(); ++f) {
    if (!mesh->is_live_facet(f))
      continue;
    auto v = mesh->facet(f).v;
    const vec3 centre = (mesh->position(v[0]) + mesh->position(v[1]) + mesh->position(v[2])) / 3;
    const vec3 n = normalized(area_vector(*mesh, mesh->facet(f)));
    for (auto& i : v)
      i = index.at(i);
    const auto id = mesh->facet(f).surface;
    raw.triangles.push_back({v, id == 7 ? name(centre, n) : id, true});
  }
  return build_version(std::move(raw), 1)->version;
}

// -- depth ----------------------------------------------------------------------------

TEST_F(Erode, LoweringACubesTopTrimsItsSides) {
  const auto base = test::box_mesh({4, 4, 4}, {1, 1, 1});
  // By moving the top's vertices, and by a cut: the first layer is 0.25 thick.
  for (const double depth : {0.1, 0.3}) {
    SCOPED_TRACE(depth);

    const auto result = lower(base, {6}, depth);

    ASSERT_TRUE(result) << render(result.error());
    expect_good(base, *result);
    const auto& after = *result->candidate;
    EXPECT_EQ(after.tet_count() == base->tet_count(), depth < 0.25);
    EXPECT_NEAR(total_volume(after), 1 - depth, 1e-12);
    EXPECT_NEAR(result->volume_change, -depth, 1e-12);
    EXPECT_EQ(after.surfaces(), base->surfaces());
    EXPECT_NEAR(area(after, 6), 1, 1e-12);
    for (const surface_id side : {1, 2, 3, 4})
      EXPECT_NEAR(area(after, side), 1 - depth, 1e-12);
    for (const auto f : facets_of(after, std::vector<surface_id>{6}))
      for (const auto v : after.facet(f).v)
        EXPECT_NEAR(after.position(v).z, 1 - depth, 1e-12);
  }
}

TEST_F(Erode, AnObliqueTopStaysParallel) {
  const auto base = test::box_mesh({4, 4, 4}, {1, 1, 1}, [](vec3 p) {
    return vec3{p.x, p.y, p.z * (1 + 0.2 * p.x + 0.1 * p.y)};
  });
  const vec3 n = normalized({-0.2, -0.1, 1});

  for (const double depth : {0.137, 0.337}) {
    const auto result = lower(base, {6}, depth);

    ASSERT_TRUE(result) << render(result.error());
    expect_good(base, *result);
    const auto lowered = facets_of(*result->candidate, std::vector<surface_id>{6});
    EXPECT_FALSE(lowered.empty());
    for (const auto f : lowered)
      for (const auto v : result->candidate->facet(f).v)
        EXPECT_NEAR(dot(n, result->candidate->position(v) - vec3{0, 0, 1}), -depth, 1e-12);
  }
}

TEST_F(Erode, APocketsFloorGoesDownBetweenItsWalls) {
  const auto base = named(pocket(), [](vec3, vec3 n) { return n.z > 0.5 ? 7 : 8; });

  const auto result = lower(base, {7}, 0.5);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(base, *result);
  const auto& after = *result->candidate;
  EXPECT_NEAR(result->volume_change, -2 * 2 * 0.5, 1e-12);
  // The walls, in one plane with what is laid bare, go on; the floor is as large as it was.
  EXPECT_NEAR(area(after, 8), 4 * 2 * 2.5, 1e-12);
  EXPECT_NEAR(area(after, 7), 4, 1e-12);
  EXPECT_EQ(after.surfaces().size(), 8u);
}

TEST_F(Erode, APlateBesideABossGetsAStep) {
  const auto block = test::box_mesh({4, 4, 4}, {4, 4, 4});
  const auto base = named(
    test::dig(
      block, [](vec3 p) { return p.z > 2 && !(p.x > 1 && p.x < 3 && p.y > 1 && p.y < 3); }, 7),
    [](vec3, vec3 n) { return n.z > 0.5 ? 7 : 8; });

  const auto result = lower(base, {7}, 0.5);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(base, *result);
  EXPECT_NEAR(result->volume_change, -(16 - 4) * 0.5, 1e-12);
  EXPECT_NEAR(area(*result->candidate, 8), 4 * 2 * 2.5, 1e-12);
}

TEST_F(Erode, BothRegionsOfABondedBlockAreLowered) {
  const auto block = test::box_mesh({4, 4, 4}, {1, 1, 1});
  raw_mesh raw;
  for (vertex_id v = 0; v < block->vertex_slots(); ++v)
    raw.positions.push_back(block->position(v));
  for (tet_id t = 0; t < block->tet_slots(); ++t) {
    raw.tets.push_back(block->tet_at(t));
    const auto c = block->corners(t);
    raw.tet_regions.push_back(c[0].x + c[1].x + c[2].x + c[3].x < 2 ? 1 : 2);
  }
  for (facet_id f = 0; f < block->facet_slots(); ++f)
    raw.triangles.push_back({block->facet(f).v, block->facet(f).surface, true});
  const auto base = build_version(std::move(raw), 1)->version;

  const auto result = lower(base, {6}, 0.1);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(base, *result, 0.05);
  double left = 0;
  const auto& after = *result->candidate;
  for (tet_id t = 0; t < after.tet_slots(); ++t)
    if (after.is_live_tet(t) && after.region_of(t) == 1)
      left += signed_volume(after.corners(t));
  EXPECT_NEAR(left, 0.45, 1e-12);
}

TEST_F(Erode, AWallThinnerThanTheDepthIsNamed) {
  const auto base = test::box_mesh({4, 4, 2}, {1, 1, 0.25});

  const auto result = lower(base, {6}, 0.3);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::invalid_argument);
  EXPECT_THAT(result.error().message, HasSubstr("250 mm thick"));
}

TEST_F(Erode, TheMostThatWorksDependsOnTheWallAloneAndWorks) {
  const auto base = test::box_mesh({4, 4, 2}, {1, 1, 0.25});

  const auto a_little = lower(base, {6}, 0.3);
  const auto a_lot = lower(base, {6}, 0.9);

  ASSERT_FALSE(a_little || a_lot);
  ASSERT_TRUE(a_little.error().most && a_lot.error().most);
  EXPECT_EQ(a_little.error().most, a_lot.error().most);
  EXPECT_EQ(a_little.error().message, a_lot.error().message);
  EXPECT_EQ(a_lot.error().most->parameter, "depth");
  const double most = a_lot.error().most->value;
  EXPECT_GT(most, 0.2);
  EXPECT_LT(most, 0.25);
  const auto result = lower(base, {6}, most);
  ASSERT_TRUE(result) << render(result.error());
  expect_good(base, *result);
}

TEST_F(Erode, ARefusalOfAPreviewSearchesNothing) {
  const auto base = test::box_mesh({4, 4, 2}, {1, 1, 0.25});
  ctx_.search_s = 0;

  const auto refused = lower(base, {6}, 0.3);

  ASSERT_FALSE(refused);
  EXPECT_FALSE(refused.error().most);
  EXPECT_THAT(refused.error().remedy, HasSubstr("smaller depth"));
}

TEST_F(Erode, AWallThatIsTooThinIsRefusedWithoutAnotherTry) {
  const auto base = test::box_mesh({4, 4, 2}, {1, 1, 0.25});
  ctx_.search_s = 0;
  const auto polls_of = [&](double depth) {
    ctx_.run.cancel = {};
    const auto done = lower(base, {6}, depth);
    EXPECT_EQ(done.has_value(), depth < 0.25);
    return ctx_.run.cancel.polls();
  };

  EXPECT_LE(polls_of(0.3), polls_of(0.1));  // Each way that is tried asks again.
}

TEST_F(Erode, WithoutDepthAndLayersThereIsNothingToDo) {
  const auto refused = erode(test::box_mesh({4, 4, 2}, {1, 1, 1}), {6}, {}, ctx_);

  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ec::invalid_parameter);
  EXPECT_THAT(refused.error().remedy, HasSubstr("depth"));
}

TEST_F(Erode, TheShareOfThePartIsToldAndThatADepthGoesBeforeLayers) {
  const auto base = test::box_mesh({4, 4, 4}, {1, 1, 1});

  const auto result = erode(base, {6}, {0.3, 2, piece_policy::refuse}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  EXPECT_NEAR(figure_of(*result, "volume_change_percent"), -30, 1e-9);
  EXPECT_THAT(result->notices, ::testing::Contains(HasSubstr("the depth was taken off")));
}

TEST_F(Erode, GoingBelowALowerStepLeavesAWall) {
  const auto block = test::box_mesh({4, 4, 4}, {4, 4, 4});
  const auto base = named(test::dig(
                            block, [](vec3 p) { return p.x > 2 && p.z > 3; }, 7),
                          [](vec3, vec3 n) { return n.z > 0.5 ? 7 : 8; });

  const auto result = lower(base, {6}, 1.5);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(base, *result);
  EXPECT_NEAR(result->volume_change, -2 * 4 * 1.5, 1e-12);
  const auto& after = *result->candidate;
  // The old wall is gone; the new one faces the other way.
  EXPECT_EQ(after.find_surface(8), nullptr);
  EXPECT_NEAR(area(after, 6), 8, 1e-12);
  EXPECT_NEAR(area(after, 9), 4 * 0.5, 1e-12);
}

TEST_F(Erode, ALowerStepBelowASlopeIsNamed) {
  const auto block = test::box_mesh({4, 4, 4}, {4, 4, 4});
  const auto step = named(test::dig(
                            block, [](vec3 p) { return p.x > 2 && p.z > 3; }, 7),
                          [](vec3, vec3 n) { return n.z > 0.5 ? 7 : 8; });
  const auto base = test::move(step, [](vec3 p) {
    return p.x == 2 && p.z == 4 ? vec3{1.8, p.y, p.z} : p;
  });

  const auto result = lower(base, {6}, 1.5);

  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("surface 7, which lies 1000 mm below"));
}

TEST_F(Erode, TheThicknessChangeIsMeasured) {
  const auto base = test::box_mesh({4, 4, 4}, {1, 1, 1});

  const auto result = lower(base, {6}, 0.3);

  ASSERT_TRUE(result) << render(result.error());
  EXPECT_NEAR(figure_of(*result, "thickness_change_mm"), 300, 1e-9);
  EXPECT_NEAR(figure_of(*result, "thickness_change_worst_mm"), 300, 1e-9);
  EXPECT_EQ(figure_of(*result, "pieces"), 1);
  EXPECT_EQ(figure_of(*result, "hinges_repaired"), 0);
}

/// The cut runs between two layers of cells: whole tets go, none is made.
TEST_F(Erode, WhatOnlyTakesTetsOffTellsNoRatios) {
  const auto mesh = test::box_mesh({4, 4, 4}, {4, 4, 4});

  const auto result = lower(mesh, {6}, 1);

  ASSERT_TRUE(result) << render(result.error());
  EXPECT_EQ(result->candidate->tet_count(), mesh->tet_count() * 3 / 4);
  edit_claim claim;
  claim.touched = result->touched;
  claim.volume_change = result->volume_change;
  const auto done = finish_edit(mesh, result->candidate, claim, improvement::none, {}, {});
  ASSERT_TRUE(done) << render(done.error());
  EXPECT_EQ(done->ratios, std::nullopt);
}

TEST_F(Erode, TwoSidesOfAnEdgeAreLoweredTogether) {
  const auto base = test::box_mesh({4, 4, 4}, {1, 1, 1});

  const auto result = lower(base, {6, 2}, 0.1);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(base, *result);
  EXPECT_NEAR(total_volume(*result->candidate), 0.81, 1e-12);
}

TEST_F(Erode, APocketsFloorAndWallsGrowToACorner) {
  const auto base = named(pocket(), [](vec3, vec3 n) { return n.z > 0.5 ? 7 : n.x > 0.5 ? 8 : 9; });

  const auto result = lower(base, {7, 8}, 0.5);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(base, *result);
  EXPECT_NEAR(result->volume_change, -(2.5 * 2 * 2.5 - 2 * 2 * 2), 1e-12);
}

// -- layers ---------------------------------------------------------------------------

TEST_F(Erode, ALayerLeavesOneCleanPiece) {
  const auto base = test::box_mesh({6, 6, 6}, {1, 1, 1});

  const auto result = peel(base, {6}, 1);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(base, *result);
  EXPECT_LT(result->volume_change, 0);
  EXPECT_NE(result->candidate->find_surface(7), nullptr);
  EXPECT_EQ(figure_of(*result, "pieces"), 1);
  EXPECT_NEAR(area(*result->candidate, 5), 1, 1e-12);
  // The frame of the top that touches the other sides stays.
  EXPECT_GT(area(*result->candidate, 6), 0);
}

TEST_F(Erode, TwoLayersTakeMoreThanOne) {
  const auto base = test::box_mesh({8, 8, 8}, {1, 1, 1});

  const auto one = peel(base, {6}, 1);
  const auto two = peel(base, {6}, 2);

  ASSERT_TRUE(one && two);
  expect_good(base, *two);
  EXPECT_LT(two->volume_change, 1.5 * one->volume_change);
}

TEST_F(Erode, ASurfaceWithoutInnerVerticesIsRefused) {
  const auto base = test::box_mesh({1, 1, 1}, {1, 1, 1});

  const auto result = peel(base, {6}, 1);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::empty_selection);
  EXPECT_THAT(result.error().message, HasSubstr("surface 6 has no vertex inside its border"));
  EXPECT_THAT(result.error().remedy, HasSubstr("depth"));
}

// -- pieces ---------------------------------------------------------------------------

/// A bar 8 x 2 x 2; surface 7 runs around its middle third, from x = 2 to 5. One layer below it
/// cuts the bar in two, the longer part behind.
version_ptr belted_bar() {
  const auto bar = test::box_mesh({8, 2, 2}, {8, 2, 2});
  mesh_builder naming(bar);
  const auto belt = naming.add_surface("belt");
  for (facet_id f = 0; f < bar->facet_slots(); ++f) {
    const auto& v = bar->facet(f).v;
    const double x = (bar->position(v[0]).x + bar->position(v[1]).x + bar->position(v[2]).x) / 3;
    if (x > 2 && x < 5)
      naming.set_surface(f, belt);
  }
  return naming.freeze();
}

TEST_F(Erode, APartThatFallsApartIsRefusedUnlessThatIsWanted) {
  const auto base = belted_bar();

  const auto refused = peel(base, {7}, 1);
  const auto largest = peel(base, {7}, 1, piece_policy::keep_largest);
  const auto both = peel(base, {7}, 1, piece_policy::allow);

  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("would fall into 2 pieces"));
  EXPECT_THAT(refused.error().remedy, HasSubstr("parameter pieces"));
  ASSERT_TRUE(largest) << render(largest.error());
  expect_good(base, *largest, 0.05);
  EXPECT_EQ(figure_of(*largest, "pieces"), 1);
  EXPECT_EQ(largest->bodies_added, 0u);
  EXPECT_EQ(largest->candidate->find_surface(1), nullptr);
  EXPECT_THAT(largest->notices, ::testing::Contains(HasSubstr("1 loose piece")));
  ASSERT_TRUE(both) << render(both.error());
  expect_good(base, *both, 0.05);
  EXPECT_EQ(figure_of(*both, "pieces"), 2);
  EXPECT_EQ(both->bodies_added, 1u);
  EXPECT_NE(both->candidate->find_surface(1), nullptr);
  EXPECT_LT(largest->volume_change, both->volume_change);
}

TEST_F(Erode, APieceMoreThanClaimedIsRolledBack) {
  const auto base = belted_bar();
  const auto result = peel(base, {7}, 1, piece_policy::allow);
  ASSERT_TRUE(result) << render(result.error());
  edit_claim claim;
  claim.touched = result->touched;
  claim.volume_change = result->volume_change;
  claim.quality_floor = 0.05;

  const auto done = finish_edit(base, result->candidate, claim, improvement::local, {}, {});

  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, HasSubstr("separate boundary"));
}

}  // namespace
}  // namespace tedit::ops
