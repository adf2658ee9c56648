// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/move/move.hpp"

#include <gmock/gmock.h>

#include "tests/support/features_on_plate.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

class Move : public test::features_on_plate {
protected:
  expected<edit_result> moved(const version_ptr& mesh, surface_id pick, vec3 by,
                              bool copy = false) {
    return move_features(mesh, {pick}, by, copy, ctx_);
  }
};

TEST_F(Move, AHoleIsClosedWhereItWasAndKeepsItsNumberWhereItGoes) {
  const auto mesh = with_hole({0.3, 0.5, 0.2});
  const auto bore = surface_named(*mesh, "bore");

  const auto result = moved(mesh, bore, {0.4, 0.1, 0});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  EXPECT_NEAR(result->volume_change, 0, 1e-9);
  EXPECT_EQ(surface_named(*result->candidate, "bore"), bore);
  EXPECT_NEAR(area_of(*result->candidate, "bore"), area_of(*mesh, "bore"), 1e-9);
  EXPECT_LT(norm(middle_of_surface(*result->candidate, bore) - vec3{0.7, 0.6, 0.1}), 1e-6);
}

TEST_F(Move, ACopyLeavesTheHoleAndHasWallsOfItsOwn) {
  const auto mesh = with_hole({0.3, 0.5, 0.2});
  const auto bore = surface_named(*mesh, "bore");

  const auto result = moved(mesh, bore, {0.4, 0, 0}, true);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  EXPECT_NEAR(result->volume_change, -hole_volume(0.2), 1e-9);
  EXPECT_EQ(result->candidate->surfaces().size(), mesh->surfaces().size() + 1);
  EXPECT_LT(norm(middle_of_surface(*result->candidate, bore) - vec3{0.3, 0.5, 0.1}), 1e-6);
}

TEST_F(Move, AThroughHoleGoesThroughWhereThePartIsThicker) {
  // A block of 0.4 x 0.4 x 0.1 on the plate's right side.
  const auto mesh = with_boss(with_hole({0.25, 0.5, 0.2}), {0.5, 0.3, 0.2}, {0.9, 0.7, 0.3});

  const auto result = moved(mesh, surface_named(*mesh, "bore"), {0.45, 0, 0});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  EXPECT_NEAR(result->volume_change, hole_volume(0.2) - hole_volume(0.3), 1e-6);
  // All of its wall is the one surface, 0.3 m long now.
  EXPECT_EQ(result->candidate->surfaces().size(), mesh->surfaces().size());
  EXPECT_NEAR(area_of(*result->candidate, "bore"), 1.5 * area_of(*mesh, "bore"), 1e-5);
}

TEST_F(Move, ATiltedHoleGoesOnAlongItsAxis) {
  const vec3 axis = normalized({0.4, 0, 1});
  const vec3 mouth{0.25, 0.5, 0.2};
  const double r = diameter / 2;
  const auto tilted = combined(
    plate_,
    revolve(make_frame(mouth, axis),
            {{0, 0.2, ""}, {r, 0.2, "top"}, {r, -0.4, "bore"}, {0, -0.4, "bottom"}}, 24, 0.04),
    boolean_mode::cut);
  const auto mesh = with_boss(tilted, {0.5, 0.3, 0.2}, {0.95, 0.7, 0.3});

  const auto result = moved(mesh, surface_named(*mesh, "bore"), {0.4, 0, 0});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  const auto& after = *result->candidate;
  double highest = 0;
  for (const auto f : facets_of(after, std::array{surface_named(after, "bore")}))
    for (const auto v : after.facet(f).v) {
      const vec3 p = after.position(v) - mouth - vec3{0.4, 0, 0};
      // A corner, or a place on a chord of the 24.
      EXPECT_NEAR(norm(p - dot(p, axis) * axis), r,
                  r * (1 - std::cos(std::numbers::pi / 24)) + 1e-9);
      highest = std::max(highest, after.position(v).z);
    }
  EXPECT_NEAR(highest, 0.3, 1e-9);
}

/// A countersink of 45 degrees, brought below a block: the cone ends where it did, and a wall of
/// its own goes on to the block's top.
class MovedCountersink : public Move {
protected:
  static tool_surface countersink(int facets) {
    return revolve(make_frame({0.25, 0.5, 0.2}, {0, 0, 1}),
                   {{0, 0.1, ""},
                    {0.2, 0.1, "top"},
                    {0.06, -0.04, "sink"},
                    {0.06, -0.4, "bore"},
                    {0, -0.4, "bottom"}},
                   facets, 0.04);
  }

  version_ptr moved_below_a_block(const version_ptr& part) {
    const auto mesh = with_boss(part, {0.5, 0.25, 0.2}, {0.9, 0.75, 0.3});
    const auto result =
      move_features(mesh, {surface_named(*mesh, "sink"), surface_named(*mesh, "bore")},
                    {0.45, 0, 0}, false, ctx_);
    EXPECT_TRUE(result) << render(result.error());
    if (!result)
      return mesh;
    expect_good(mesh, *result);
    return result->candidate;
  }

  /// Calls `check` with each corner of a surface, and how far that is off the axis.
  template <class Check>
  void each_corner(const mesh_version& mesh, const std::string& name, const Check& check) {
    for (const auto f : facets_of(mesh, std::array{surface_named(mesh, name)}))
      for (const auto v : mesh.facet(f).v) {
        const vec3 p = mesh.position(v);
        check(p, norm(p - vec3{0.7, 0.5, p.z}));
      }
  }
};

TEST_F(MovedCountersink, StaysAConeWhereThePartIsThicker) {
  const double chord = 0.1 * (1 - std::cos(std::numbers::pi / 24));
  const auto after = moved_below_a_block(combined(plate_, countersink(24), boolean_mode::cut));
  each_corner(*after, "sink", [&](vec3 p, double radius) {
    EXPECT_LT(p.z, 0.2 + 1e-9);
    EXPECT_NEAR(radius, p.z - 0.1, chord + 1e-9);
  });
  each_corner(*after, "straight on",
              [&](vec3, double radius) { EXPECT_NEAR(radius, 0.1, chord + 1e-9); });
}

/// Of twelve facets, whose chords are .0034 off it: part and tool say what their walls are.
TEST_F(MovedCountersink, GoesOnAsACylinder) {
  using kind = surface_geometry::kind;
  mesh_builder named(plate_);
  const auto side = named.add_surface("side", {kind::plane, {0, 0, 0}, {-1, 0, 0}});
  for (facet_id f = 0; f < plate_->facet_slots(); ++f)
    if (std::ranges::all_of(plate_->facet(f).v,
                            [&](vertex_id v) { return plate_->position(v).x == 0; }))
      named.set_surface(f, side);
  auto tool = countersink(12);
  tool.geometries.resize(tool.names.size());
  for (std::size_t face = 0; face < tool.names.size(); ++face)
    if (tool.names[face] == "sink")
      tool.geometries[face] = {kind::cone, {0.25, 0.5, 0.2}, {0, 0, 1}, 0.1, 1};

  const auto after = moved_below_a_block(combined(named.freeze(), tool, boolean_mode::cut));

  const auto& straight = after->find_surface(surface_named(*after, "straight on"))->geometry;
  EXPECT_EQ(straight.type, kind::cylinder);
  EXPECT_NEAR(straight.radius, 0.1, 1e-9);
  each_corner(*after, "straight on", [](vec3, double radius) { EXPECT_NEAR(radius, 0.1, 1e-9); });
}

TEST_F(Move, ABossMovesWithItsNumbers) {
  const auto mesh = with_boss(plate_, {0.15, 0.35, 0.2}, {0.35, 0.65, 0.3});
  const auto top = surface_named(*mesh, "boss top");

  const auto result = moved(mesh, top, {0.45, 0, 0});

  ASSERT_TRUE(result) << render(result.error());
  expect_good(mesh, *result);
  EXPECT_NEAR(result->volume_change, 0, 1e-9);
  EXPECT_EQ(surface_named(*result->candidate, "boss top"), top);
  EXPECT_LT(norm(middle_of_surface(*result->candidate, top) - vec3{0.7, 0.5, 0.3}), 1e-6);
}

TEST_F(Move, WhatCannotBeIsRefusedByName) {
  const auto mesh = with_hole({0.3, 0.5, 0.2});
  const auto bore = surface_named(*mesh, "bore");

  const auto nowhere = moved(mesh, bore, {});
  const auto outside = moved(mesh, bore, {3, 0, 0});
  const auto wall = moved(mesh, 6, {0.1, 0, 0});

  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().message, HasSubstr("stay where it is"));
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().code, ec::empty_selection);
  ASSERT_FALSE(wall);
  EXPECT_THAT(wall.error().message, HasSubstr("neither to a hole nor to a boss"));
}

}  // namespace
}  // namespace tedit::ops
