// SPDX-License-Identifier: AGPL-3.0-or-later
// New vertices on chords of a wall that the CAD model has.
#include "mesh/adapt/settle_on_walls.hpp"

#include "mesh/checks.hpp"
#include "mesh/finish_edit.hpp"
#include "mesh/level_set.hpp"
#include "tests/support/frustum.hpp"

namespace tedit {
namespace {

using namespace test::frustum_part;

constexpr double lowest_q = 0.02;
constexpr vertex_id rim_below = 0;            ///< (8, 0, 0) mm, on the skirt's lower rim.
constexpr vertex_id rim_above = sectors + 1;  ///< (10, 0, 2) mm, above it.

/// In the middle of a quarter of the fillet's tube, whose middle is at (8, 0, 2) mm.
const double across = 0.002 * std::sqrt(0.5);
const vec3 middle_of_arc{0.008 + across, 0, 0.002 - across};

/// The edge between them, which is a chord of the fillet, with a vertex in its middle.
vertex_id split_chord(mesh_builder& builder) {
  const auto made = split_edge(builder, rim_below, rim_above, {0.009, 0, 0.001});
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return made.value_or(no_id);
}

std::optional<settled_edit> settled(const version_ptr& base, const version_ptr& candidate) {
  const auto made = settle_on_walls(*base, candidate, lowest_q, {});
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return made ? *made : std::nullopt;
}

TEST(SettleOnWalls, AVertexOnAChordGoesOntoTheFillet) {
  const auto base = frustum_with(fillet);
  mesh_builder builder(base);
  const auto v = split_chord(builder);
  const auto candidate = builder.freeze();

  const auto made = settled(base, candidate);

  ASSERT_TRUE(made);
  EXPECT_NEAR(norm(made->version->position(v) - middle_of_arc), 0, 1e-15);
  for (vertex_id u = 0; u < base->vertex_slots(); ++u)
    EXPECT_EQ(made->version->position(u), base->position(u)) << u;
  EXPECT_FALSE(made->touched.empty());
  EXPECT_TRUE(check_version(*made->version).ok());
}

TEST(SettleOnWalls, WithoutAModelItStays) {
  const auto base = frustum_with({});
  mesh_builder builder(base);
  split_chord(builder);
  EXPECT_FALSE(settled(base, builder.freeze()));
}

TEST(SettleOnWalls, NothingHasToMoveWhereItIsOnItsWall) {
  const auto base = frustum_with(fillet);
  mesh_builder builder(base);
  builder.set_position(split_chord(builder), middle_of_arc);
  EXPECT_FALSE(settled(base, builder.freeze()));
}

/// Who drags a wall by less than its chords are off it wants it there.
TEST(SettleOnWalls, WhatWasDraggedStaysThere) {
  const auto base = frustum_with(fillet);
  mesh_builder builder(base);
  builder.set_position(rim_above, {0.0101, 0, 0.002});
  EXPECT_FALSE(settled(base, builder.freeze()));
  split_chord(builder);
  EXPECT_FALSE(settled(base, builder.freeze()));
}

/// Who only makes tets better does not.
TEST(SettleOnWalls, WhatHasMovedGoesBackWhereThatIsMeant) {
  const auto base = frustum_with(fillet);
  mesh_builder builder(base);
  builder.set_position(rim_above, {0.01002, 0, 0.002});
  builder.set_position(rim_below, {0.00801, 0, 0});
  const auto made =
    settle_on_walls(*base, builder.freeze(), lowest_q, {}, settling_vertices::moved);
  ASSERT_TRUE(made && *made);
  EXPECT_NEAR(norm((*made)->version->position(rim_above) - vec3{0.010, 0, 0.002}), 0, 1e-12);
  // The torus touches the plane z = 0 there: along it the rim is anywhere.
  EXPECT_NEAR((*made)->version->position(rim_below).z, 0, 1e-9);
}

/// A surface that is new, and whose tool has said that it is the fillet.
TEST(SettleOnWalls, AVertexOnAChordOfWhatAToolHasMadeGoesOntoIt) {
  const auto base = frustum_with(fillet);
  mesh_builder builder(base);
  const auto fresh = builder.add_surface("made", fillet);
  for (const auto f : facets_of(*base, std::array{skirt}))
    builder.set_surface(f, fresh);
  const auto v = split_chord(builder);
  const auto made = settled(base, builder.freeze());
  ASSERT_TRUE(made);
  EXPECT_NEAR(norm(made->version->position(v) - middle_of_arc), 0, 1e-15);
}

/// All of it 1 mm further out, where the model has no wall.
TEST(SettleOnWalls, AWallThatHasMovedIsNotBroughtBack) {
  const auto base = frustum_with(fillet);
  mesh_builder builder(base);
  for (const vertex_id first : {rim_below, rim_above})
    for (vertex_id v = first; v < first + sectors; ++v) {
      const vec3 p = base->position(v);
      builder.set_position(v, p + 0.001 * normalized({p.x, p.y, 0}));
    }
  const auto made = split_edge(builder, rim_below, rim_above, {0.010, 0, 0.001});
  ASSERT_TRUE(made);
  const auto after = settled(base, builder.freeze());
  EXPECT_FALSE(after && norm(after->version->position(*made) - middle_of_arc) < 0.0009);
}

TEST(SettleOnWalls, BetweenRegionsItStays) {
  auto raw = frustum();
  raw.surface_names = {{skirt, "skirt", fillet}};
  for (std::size_t t = 0; t < raw.tets.size() / 2; ++t)
    raw.tet_regions[t] = 2;
  const auto base = build_version(std::move(raw), 1, slot_order::as_given);
  ASSERT_TRUE(base) << base.error().message;
  mesh_builder builder(base->version);
  split_chord(builder);
  EXPECT_FALSE(settled(base->version, builder.freeze()));
}

TEST(SettleOnWalls, CanBeCancelled) {
  const auto base = frustum_with(fillet);
  mesh_builder builder(base);
  split_chord(builder);
  execution run;
  run.cancel.cancel();
  const auto made = settle_on_walls(*base, builder.freeze(), lowest_q, run);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ec::cancelled);
}

/// The part of the tube's cross section between the chord and the arc is put on: the operation's
/// own word says nothing of it.
TEST(SettleOnWalls, AnEditIsFinishedWithItAndItsVolume) {
  const auto base = frustum_with(fillet);
  mesh_builder builder(base);
  const auto v = split_chord(builder);
  edit_claim claim;
  claim.touched = builder.touched();
  claim.quality_floor = lowest_quality_floor;
  finish_settings settings;
  for (const bool settle : {true, false}) {
    settings.settle = settle;
    const auto done = finish_edit(base, builder.freeze(), claim, improvement::none, settings, {});
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_NEAR(norm(done->version->position(v) - (settle ? middle_of_arc : vec3{0.009, 0, 0.001})),
                0, 1e-15);
    EXPECT_NEAR(done->volume_change, total_volume(*done->version) - total_volume(*base), 1e-20);
    EXPECT_EQ(done->volume_change > 1e-11, settle);
  }
}

}  // namespace
}  // namespace tedit
