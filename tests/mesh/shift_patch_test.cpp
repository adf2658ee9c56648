// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/shift_patch.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/checks.hpp"
#include "tests/support/blocks.hpp"
#include "tests/support/meshes.hpp"

namespace tedit {
namespace {

version_ptr shifted(const version_ptr& mesh, surface_id surface, double distance, bool expected) {
  mesh_builder builder(mesh);
  const auto patch = find_patch(builder, surface);
  EXPECT_TRUE(patch.has_value());
  EXPECT_EQ(shift_patch(builder, *patch, distance, 0.1), expected);
  return builder.freeze();
}

TEST(ShiftPatch, ABoxGrowsAndShrinksExactly) {
  const auto box = test::blocks(2, [](int, int, int) { return true; });

  const auto thinner = shifted(box, 6, -0.25, true);
  EXPECT_DOUBLE_EQ(total_volume(*thinner), 7);
  EXPECT_TRUE(check_version(*thinner).ok());
  EXPECT_EQ(thinner->surfaces(), box->surfaces());
  EXPECT_DOUBLE_EQ(total_volume(*shifted(box, 6, 0.5, true)), 10);
}

/// Whichever facet lies across, the first of the mesh too.
TEST(FindPatch, EachSideOfABoxHasARightAngleAtItsFourEdges) {
  const mesh_builder box(test::box_mesh({1, 1, 1}, {1, 1, 1}));
  for (surface_id side = 1; side <= 6; ++side) {
    const auto patch = find_patch(box, side);
    ASSERT_TRUE(patch.has_value()) << "side " << side << ": " << render(patch.error());
    EXPECT_EQ(patch->facets.size(), 2U);
    ASSERT_EQ(patch->border.size(), 4U);
    for (const auto& edge : patch->border) {
      EXPECT_EQ(box.facet(edge.inner).surface, side);
      EXPECT_NE(box.facet(edge.outer).surface, side);
      EXPECT_TRUE(edge.convex() && edge.vertical()) << edge.angle;
    }
  }
}

TEST(ShiftPatch, BordersSlideAlongSlopingNeighbours) {
  // A frustum: sides 1 to 4 lean inwards by 1/4 each over the height of 2.
  const auto frustum = test::box_mesh({2, 2, 2}, {2, 2, 2}, [](vec3 p) -> vec3 {
    const double scale = 1 - 0.125 * p.z;
    return {1 + scale * (p.x - 1), 1 + scale * (p.y - 1), p.z};
  });

  const auto lower = shifted(frustum, 6, -0.5, true);

  // The top at z = 1.5 is a square of 2 (1 - 0.1875): volume of a frustum with 4 and 2.640625.
  EXPECT_NEAR(total_volume(*lower), 1.5 / 3 * (4 + 2.640625 + 2 * 1.625), 1e-12);
}

TEST(ShiftPatch, TooFarOrFlushChangesNothing) {
  const auto box = test::blocks(2, [](int, int, int) { return true; });
  EXPECT_EQ(shifted(box, 6, -1, false)->id(), box->id()) << "the layer's tets would be flat";

  // Half of the top gets a name of its own: the other half runs on flush.
  mesh_builder builder(box);
  const auto half = builder.add_surface("half");
  for (facet_id f = 0; f < box->facet_slots(); ++f) {
    const auto& v = box->facet(f).v;
    if (box->facet(f).surface == 6 &&
        box->position(v[0]).x + box->position(v[1]).x + box->position(v[2]).x < 3)
      builder.set_surface(f, half);
  }
  const auto split = builder.freeze();
  EXPECT_EQ(shifted(split, half, -0.1, false)->id(), split->id());
}

TEST(ShiftPatch, ARoundNeighbourIsNotBent) {
  // Side 2 is a quarter of a cylinder of radius 0.5 in two rows of facets; the top touches it.
  const auto rounded = test::box_mesh({2, 1, 2}, {2, 1, 0.5}, [](vec3 p) -> vec3 {
    const double turn = std::numbers::pi * p.z;
    return p.x < 2 ? p : vec3{1.5 + 0.5 * std::cos(turn), p.y, 0.5 * std::sin(turn)};
  });
  EXPECT_EQ(shifted(rounded, 6, -0.05, false)->id(), rounded->id());

  // Its straight lines stand upright on the sides 3 and 4.
  const auto narrower = shifted(rounded, 3, -0.25, true);
  EXPECT_NEAR(total_volume(*narrower), 0.75 * total_volume(*rounded), 1e-14);
}

TEST(ShiftPatch, ItDoesNotGrowIntoWhatStandsOpposite) {
  // A slot of height 1 between two plates that are joined at x < 1.
  const auto clamp = test::blocks({3, 2, 3}, [](int x, int, int z) { return x == 0 || z != 1; });
  mesh_builder named(clamp);
  const auto floor = named.add_surface("floor of the slot");
  for (facet_id f = 0; f < clamp->facet_slots(); ++f)
    if (clamp->facet(f).surface == 7 && std::ranges::all_of(clamp->facet(f).v, [&](vertex_id v) {
          return clamp->position(v).z == 1;
        }))
      named.set_surface(f, floor);
  const auto slot = named.freeze();

  EXPECT_NEAR(total_volume(*shifted(slot, floor, 0.25, true)), total_volume(*slot) + 1, 1e-12);
  EXPECT_EQ(shifted(slot, floor, 1.25, false)->id(), slot->id());
}

}  // namespace
}  // namespace tedit
