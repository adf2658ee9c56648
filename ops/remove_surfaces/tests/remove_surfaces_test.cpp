// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/features/remove_protrusion.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/features/protrusion.hpp"
#include "mesh/finish_edit.hpp"
#include "tests/support/blocks.hpp"

namespace tedit::ops {
namespace {

using test::blocks;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Gives the facets for which `pick(middle)` holds the surface `id`, which is new.
version_ptr with_surface(const version_ptr& mesh, const std::function<bool(vec3)>& pick) {
  mesh_builder builder(mesh);
  const auto id = builder.add_surface("named");
  for (facet_id f = 0; f < mesh->facet_slots(); ++f) {
    const auto& v = mesh->facet(f).v;
    if (pick((mesh->position(v[0]) + mesh->position(v[1]) + mesh->position(v[2])) / 3))
      builder.set_surface(f, id);
  }
  return builder.freeze();
}

/// A plate of 5 x 5 x 2 with a boss of 1 x 1 x 2 in its middle: surface 6 is the boss' top, 7 the
/// plate's top, 8 the boss' sides.
version_ptr plate_with_boss(const std::function<vec3(vec3)>& place = {}) {
  const auto mesh =
    blocks({5, 5, 4}, [](int x, int y, int z) { return z < 2 || (x == 2 && y == 2); });
  const auto named = with_surface(mesh, [](vec3 p) { return p.z > 2 && p.z < 4; });
  if (!place)
    return named;
  mesh_builder builder(named);
  for (vertex_id v = 0; v < named->vertex_slots(); ++v)
    builder.set_position(v, place(named->position(v)));
  return builder.freeze();
}

struct removed {
  expected<edit_result> edit;
  expected<finished_edit> finished = fail(ec::internal, "not run");
};

removed take_off(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                 bool exact = false) {
  context ctx;
  removed result{remove_protrusion(mesh, surfaces, exact, ctx)};
  if (result.edit) {
    edit_claim claim;
    claim.touched = result.edit->touched;
    claim.volume_change = result.edit->volume_change;
    result.finished = finish_edit(mesh, result.edit->candidate, claim, improvement::local, {}, {});
  }
  return result;
}

TEST(Protrusion, GrowsFromOneSideToAllOfTheBoss) {
  const auto mesh = plate_with_boss();

  const auto feature = complete_protrusion(*mesh, {8}, false);

  ASSERT_TRUE(feature.has_value());
  EXPECT_THAT(feature->surfaces, ElementsAre(6, 8));
  EXPECT_THAT(feature->added, ElementsAre(6));
  ASSERT_EQ(feature->feet.size(), 1u);
  EXPECT_EQ(feature->feet[0].normal, (vec3{0, 0, 1}));
  EXPECT_DOUBLE_EQ(feature->feet[0].length, 4);
}

TEST(Protrusion, APlateStandsOnNothing) {
  const auto mesh = blocks(2, [](int, int, int) { return true; });

  const auto feature = complete_protrusion(*mesh, {6}, false);

  ASSERT_FALSE(feature.has_value());
  EXPECT_EQ(feature.error().code, ec::not_a_protrusion);
}

TEST(RemoveSurfaces, ABossComesOffAndThePlateIsFlatAgain) {
  const auto mesh = plate_with_boss();

  const auto result = take_off(mesh, {6});

  ASSERT_TRUE(result.edit.has_value()) << render(result.edit.error());
  EXPECT_NEAR(result.edit->volume_change, -2, 1e-12);
  ASSERT_TRUE(result.finished.has_value()) << render(result.finished.error());
  const auto& after = *result.finished->version;
  EXPECT_NEAR(total_volume(after), 50, 1e-12);
  EXPECT_EQ(after.find_surface(6), nullptr);
  EXPECT_EQ(after.find_surface(8), nullptr);
  for (vertex_id v = 0; v < after.vertex_slots(); ++v)
    if (after.is_live_vertex(v)) {
      EXPECT_LE(after.position(v).z, 2 + 1e-12);
    }
}

TEST(RemoveSurfaces, TetsThatTheFootCrossesAreCut) {
  // The grid point under the boss' middle lies between layers: the plane z = 2 is no mesh face.
  const auto mesh = blocks(
    {6, 6, 4}, [](int x, int y, int z) { return z < 2 || (x >= 2 && x <= 3 && y >= 2 && y <= 3); });
  const auto named = with_surface(mesh, [](vec3 p) { return p.z > 2 && p.z < 4; });
  mesh_builder builder(named);
  for (vertex_id v = 0; v < named->vertex_slots(); ++v)
    if (named->position(v) == vec3{3, 3, 2})
      builder.set_position(v, {3, 3, 2.45});
  const auto bumped = builder.freeze();

  const auto result = take_off(bumped, {8});

  ASSERT_TRUE(result.finished.has_value())
    << render(result.edit ? result.finished.error() : result.edit.error());
  EXPECT_NEAR(total_volume(*result.finished->version), 72, 1e-10);
}

TEST(RemoveSurfaces, ARibBetweenPlateAndWallIsCutAtBoth) {
  // A wall at x < 1, a plate at z < 1, a rib of one cell in the corner between them.
  const auto mesh = blocks(
    {4, 5, 4}, [](int x, int y, int z) { return x < 1 || z < 1 || (y == 2 && x < 3 && z < 3); });
  const auto named = with_surface(mesh, [](vec3 p) {
    return p.x > 1 && p.z > 1 && p.y > 1.9 && p.y < 3.1 && p.x < 3.1 && p.z < 3.1;
  });

  const auto result = take_off(named, {8});

  ASSERT_TRUE(result.finished.has_value())
    << render(result.edit ? result.finished.error() : result.edit.error());
  EXPECT_NEAR(result.edit->volume_change, -4, 1e-12);
  EXPECT_NEAR(total_volume(*result.finished->version), 5 * (4 + 3), 1e-10);
}

TEST(RemoveSurfaces, AFinThatSharesItsEndsWithThePlateIsCutOffThem) {
  // The fin runs over the whole length: its ends lie in the sides 3 and 4 of the plate.
  const auto mesh = blocks({5, 4, 4}, [](int x, int, int z) { return z < 2 || x == 2; });
  const auto named =
    with_surface(mesh, [](vec3 p) { return p.z > 2 && p.z < 4 && p.y > 0 && p.y < 4; });

  const auto result = take_off(named, {8});

  ASSERT_TRUE(result.finished.has_value())
    << render(result.edit ? result.finished.error() : result.edit.error());
  EXPECT_NEAR(total_volume(*result.finished->version), 40, 1e-10);
  EXPECT_NE(result.finished->version->find_surface(3), nullptr);
}

TEST(RemoveSurfaces, ABossOnACylinderLeavesTheCylinder) {
  const auto bend = [](vec3 p) -> vec3 {
    const double angle = (p.x - 2.5) / 20;
    return {(20 + p.z) * std::sin(angle), p.y, (20 + p.z) * std::cos(angle)};
  };
  const auto mesh = plate_with_boss(bend);
  const auto plain = blocks(
    {5, 5, 2}, [](int, int, int) { return true; }, bend);

  const auto result = take_off(mesh, {8});

  ASSERT_TRUE(result.finished.has_value())
    << render(result.edit ? result.finished.error() : result.edit.error());
  const auto& after = *result.finished->version;
  EXPECT_NEAR(total_volume(after), total_volume(*plain), 1e-9);
  EXPECT_EQ(after.surfaces().size(), 6u) << "the cut goes on the plate's top";
}

TEST(RemoveSurfaces, TheMainBodyIsNoProtrusion) {
  const auto mesh = plate_with_boss();

  const auto result = take_off(mesh, {5});

  ASSERT_FALSE(result.edit.has_value());
  EXPECT_EQ(result.edit.error().code, ec::not_a_protrusion);
}

TEST(RemoveSurfaces, CancelStopsTheEdit) {
  const auto mesh = plate_with_boss();
  context ctx;
  ctx.run.cancel.cancel();

  const auto result = remove_protrusion(mesh, {6}, false, ctx);

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::cancelled);
}

}  // namespace
}  // namespace tedit::ops
