// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/thicken/thicken.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/finish_edit.hpp"
#include "ops/services/host_services.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

class Thicken : public ::testing::Test {
protected:
  expected<edit_result> raise(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                              double height) {
    return thicken(mesh, surfaces, height, ctx_);
  }

  static void expect_good(const version_ptr& base, const edit_result& result) {
    edit_claim claim;
    claim.touched = result.touched;
    claim.volume_change = result.volume_change;
    claim.quality_floor = result.quality_floor;
    const auto done = finish_edit(base, result.candidate, claim, improvement::local, {}, {});
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

  std::unique_ptr<services> host_ = make_host_services();
  context ctx_{{}, host_.get(), {}, 1e9};
};

TEST_F(Thicken, ACubeGrowsStraightUp) {
  const auto base = test::box_mesh({4, 4, 4}, {1, 1, 1});

  const auto result = raise(base, {6}, 0.25);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(base, *result);
  const auto& after = *result->candidate;
  EXPECT_NEAR(result->volume_change, 0.25, 1e-12);
  EXPECT_NEAR(total_volume(after), 1.25, 1e-12);
  EXPECT_EQ(after.surfaces().size(), 6u);
  EXPECT_NEAR(area(after, 6), 1, 1e-12);
  for (const surface_id side : {1, 2, 3, 4})
    EXPECT_NEAR(area(after, side), 1.25, 1e-12);
  for (const auto f : facets_of(after, std::vector<surface_id>{6}))
    for (const auto v : after.facet(f).v)
      EXPECT_NEAR(after.position(v).z, 1.25, 1e-12);
  const auto measured = std::ranges::find(result->figures, "thickness_change_mm", &figure::id);
  ASSERT_NE(measured, result->figures.end());
  EXPECT_NEAR(measured->value, 250, 1e-9);
}

TEST_F(Thicken, SlantedNeighboursGetSidesOfTheirOwn) {
  const auto base = test::box_mesh({4, 4, 4}, {1, 1, 1}, [](vec3 p) {
    return vec3{p.x * (1 - 0.3 * p.z), p.y, p.z};
  });

  const auto result = raise(base, {6}, 0.25);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(base, *result);
  EXPECT_NEAR(result->volume_change, 0.7 * 0.25, 1e-12);
  // Only x = max leans: the others are continued.
  EXPECT_EQ(result->candidate->surfaces().size(), 7u);
  EXPECT_NEAR(area(*result->candidate, 7), 0.25, 1e-12);
}

TEST_F(Thicken, AStepIsFilledUpAgainstItsWall) {
  const auto block = test::box_mesh({4, 4, 4}, {1, 1, 1});
  const auto dug = test::dig(
    block, [](vec3 p) { return p.x > 0.5 && p.z > 0.5; }, 7);
  mesh_builder naming(dug);
  ASSERT_EQ(naming.add_surface("dug"), 7);
  const auto wall = naming.add_surface("wall");
  for (facet_id f = 0; f < dug->facet_slots(); ++f)
    if (dug->is_live_facet(f) && dug->facet(f).surface == 7 &&
        std::abs(area_vector(*dug, dug->facet(f)).z) < 1e-12)
      naming.set_surface(f, wall);
  const auto base = naming.freeze();

  const auto result = raise(base, {7}, 0.2);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(base, *result);
  EXPECT_NEAR(result->volume_change, 0.5 * 0.2, 1e-12);
  EXPECT_NEAR(area(*result->candidate, wall), 0.3, 1e-12);
  EXPECT_NEAR(area(*result->candidate, 7), 0.5, 1e-12);
}

TEST_F(Thicken, ASlabThatRunsIntoTheRoofIsRefused) {
  // A slot through the block: raising its floor by more than its height meets the roof.
  const auto block = test::box_mesh({4, 4, 4}, {1, 1, 1});
  const auto dug = test::dig(
    block, [](vec3 p) { return p.x > 0.5 && p.z > 0.5 && p.z < 0.75; }, 7);
  mesh_builder naming(dug);
  ASSERT_EQ(naming.add_surface("dug"), 7);
  const auto floor = naming.add_surface("floor");
  for (facet_id f = 0; f < dug->facet_slots(); ++f)
    if (dug->is_live_facet(f) && dug->facet(f).surface == 7 &&
        area_vector(*dug, dug->facet(f)).z > 1e-12)
      naming.set_surface(f, floor);
  const auto base = naming.freeze();

  const auto result = raise(base, {floor}, 0.4);

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ec::cap_intersects) << render(result.error());
}

}  // namespace
}  // namespace tedit::ops
