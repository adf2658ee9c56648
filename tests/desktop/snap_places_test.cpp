// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/snap_places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "client-qt/model/circle_fit.hpp"
#include "client-qt/model/handle_pose.hpp"
#include "client-qt/model/pick_words.hpp"
#include "client-qt/model/round_edges.hpp"
#include "client-qt/model/wall_spot.hpp"

namespace tedit::desktop {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr std::uint32_t corners = 16;

/// A wall (surface 1) with a bore of radius 2 mm around (1, 2), whose own wall (surfaces 2 and 3,
/// a half each) goes 4 mm down from z = 3 mm. The outer rim of the wall: 6 mm around (2, 2).
client::surface_model bored_wall() {
  client::surface_update u;
  u.version_id = "a";
  u.surfaces = {{1, "wall"}, {2, "half"}, {3, "half"}};
  const auto add_ring = [&](double x, double y, double z, double radius) {
    for (std::uint32_t i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      u.vertices.push_back(static_cast<std::uint32_t>(u.vertices.size()));
      for (const double c : {x + radius * std::cos(angle), y + radius * std::sin(angle), z})
        u.positions.push_back(1e-3 * c);
    }
  };
  add_ring(1, 2, 3, 2);
  add_ring(2, 2, 3, 6);
  add_ring(1, 2, -1, 2);
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, surface_id surface) {
    u.facets.push_back(static_cast<std::uint32_t>(u.facets.size()));
    u.facet_vertices.insert(u.facet_vertices.end(), {a, b, c});
    u.facet_surfaces.push_back(surface);
  };
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t j = (i + 1) % corners;
    add(i, corners + i, corners + j, 1);
    add(i, corners + j, j, 1);
    const surface_id half = i < corners / 2 ? 2 : 3;
    add(i, j, 2 * corners + j, half);
    add(i, 2 * corners + j, 2 * corners + i, half);
  }
  client::surface_model made;
  EXPECT_TRUE(made.apply(u).has_value());
  return made;
}

TEST(PickWords, WhatIsNearAnEdgeIsTheEdgeAndTheWallElsewhere) {
  const auto part = bored_wall();
  const double reach = 1e-4;

  // The bore's rim is at (3, 2), the wall ends at (8, 2).
  EXPECT_EQ(pick_words(part, 1, {5e-3, 2e-3, 3e-3}, reach), "surface:1");
  EXPECT_EQ(pick_words(part, 1, {3.05e-3, 2.2e-3, 3e-3}, reach), "edge:1,2");
  EXPECT_EQ(pick_words(part, 1, {3.05e-3, 1.8e-3, 3e-3}, reach), "edge:1,3");
  EXPECT_EQ(pick_words(part, 2, {1e-3, 4e-3, 1e-3}, reach), "surface:2");
  // Where nothing lies behind an edge, there is the wall alone.
  EXPECT_EQ(pick_words(part, 1, {7.99e-3, 2.2e-3, 3e-3}, reach), "surface:1");
}

lens straight_from_above() {
  lens by;
  by.to_screen = [](const vec3& p) { return QPointF(1e4 * p.x, -1e4 * p.y); };
  by.ray = [](QPointF at) {
    return std::array{vec3{at.x() / 1e4, -at.y() / 1e4, 1}, vec3{at.x() / 1e4, -at.y() / 1e4, -1}};
  };
  return by;
}

bool sees_all(const snap_place&) {
  return true;
}

TEST(SnapPlaces, AreCentresOfWallsAndOfRoundEdges) {
  const auto places = snap_places(bored_wall());

  ASSERT_THAT(places, SizeIs(2));
  EXPECT_EQ(words_of(places[0]), "centre of surface 1");
  // Discs of 36 and 4 parts around 2 and 1: (36 * 2 - 4 * 1) / 32.
  EXPECT_NEAR(places[0].at.x, 2.125e-3, 1e-12);
  EXPECT_NEAR(places[0].normal.z, 1, 1e-12);
  EXPECT_EQ(words_of(places[1]), "centre of a round edge, Ø 4 mm");
  EXPECT_NEAR(norm(places[1].at - vec3{1e-3, 2e-3, 3e-3}), 0, 1e-12);
  EXPECT_THAT(places[1].surfaces, ElementsAre(1, 2, 3)) << "both halves of the rim";
  EXPECT_EQ(places[1].wall, 1);
}

TEST(SnapPlaces, ThePointerIsTakenWithinEightPixels) {
  const auto places = snap_places(bored_wall());
  const vec3 at{6e-3, 2.9e-3, 3e-3};

  const auto rim = snap(places, {4, -24}, straight_from_above(), at, 2, sees_all);
  ASSERT_TRUE(rim);
  EXPECT_EQ(rim->words, "centre of a round edge, Ø 4 mm");
  EXPECT_NEAR(norm(rim->at - vec3{1e-3, 2e-3, 3e-3}), 0, 1e-12);
  EXPECT_EQ(rim->wall, 1);
  const auto middle = snap(places, {17, -20}, straight_from_above(), at, 2, sees_all);
  ASSERT_TRUE(middle);
  EXPECT_EQ(middle->words, "centre of surface 1") << "the nearer of two";
  EXPECT_FALSE(snap(places, {1, -20}, straight_from_above(), at, 2, sees_all)) << "9 pixels off";
}

TEST(SnapPlaces, OrMovedOntoAMiddleLineOfItsWall) {
  const auto places = snap_places(bored_wall());
  const vec3 at{6e-3, 2.5e-3, 3e-3};  // 5 pixels above the wall's middle.

  const auto found = snap(places, {60, -25}, straight_from_above(), at, 1, sees_all);

  ASSERT_TRUE(found);
  EXPECT_NEAR(norm(found->at - vec3{6e-3, 2e-3, 3e-3}), 0, 1e-12);
  EXPECT_EQ(found->words, "on the middle line of surface 1");
  EXPECT_FALSE(snap(places, {60, -29}, straight_from_above(), {6e-3, 2.9e-3, 3e-3}, 1, sees_all));
  EXPECT_FALSE(snap(places, {10, -20}, straight_from_above(), {6e-3, 2.9e-3, 3e-3}, 1,
                    [](const snap_place&) { return false; }))
    << "what is not in sight takes nothing";
}

TEST(WallSpot, TheMiddleOfAWallIsOnIt) {
  const auto part = bored_wall();

  const auto spot = middle_of(part, 1);

  ASSERT_TRUE(spot);
  EXPECT_NEAR(spot->at.z, 3e-3, 1e-12);
  EXPECT_NEAR(spot->normal.z, 1, 1e-12);
  EXPECT_FALSE(middle_of(part, 7));
  EXPECT_NEAR(outward_at(part, {1e-3, 4.1e-3, 1e-3}, {2})->y, -1, 0.03) << "into the bore";
}

TEST(WallSpot, ABoreHasAnAxisAndABoxHasNone) {
  const auto bore = round_wall_of(bored_wall(), {2, 3});

  ASSERT_TRUE(bore);
  EXPECT_NEAR(norm(bore->middle - vec3{1e-3, 2e-3, 1e-3}), 0, 1e-12);
  EXPECT_NEAR(std::abs(bore->axis.z), 1, 1e-12);
  EXPECT_NEAR(bore->radius, 2e-3, 1e-12);
  EXPECT_NEAR(bore->half_length, 2e-3, 1e-12);
  EXPECT_FALSE(round_wall_of(bored_wall(), {1}));
}

std::vector<vec3> polygon(int sides, double turn, double height = 0) {
  std::vector<vec3> chain;
  for (int i = 0; i <= sides; ++i) {
    const double angle = turn * i / sides;
    chain.push_back({std::cos(angle), 2 + std::sin(angle), i == 1 ? height : 0});
  }
  return chain;
}

TEST(RoundEdge, ABoreOfSixEdgesIsRoundAndASquareIsNot) {
  constexpr double pi = std::numbers::pi;
  const auto bore = round_edge_of(polygon(6, 2 * pi));
  ASSERT_TRUE(bore);
  EXPECT_NEAR(norm(bore->middle - vec3{0, 2, 0}), 0, 1e-12);
  EXPECT_NEAR(bore->radius, 1, 1e-12);
  EXPECT_NEAR(std::abs(bore->axis.z), 1, 1e-12);
  EXPECT_TRUE(round_edge_of(polygon(6, pi / 2))) << "a quarter";

  EXPECT_FALSE(round_edge_of(polygon(4, 2 * pi))) << "a square";
  EXPECT_FALSE(round_edge_of(polygon(6, pi / 3))) << "60 degrees";
  EXPECT_FALSE(round_edge_of(polygon(6, 2 * pi, 0.05))) << "not flat";
  EXPECT_FALSE(round_edge_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}));
}

TEST(CircleFit, GoesThroughItsPointsAndKnowsALine) {
  const std::array<std::array<double, 2>, 3> round{{{4, 2}, {3, 3}, {2, 2}}};
  const auto circle = fit_circle(round);

  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->middle[0], 3, 1e-12);
  EXPECT_NEAR(circle->middle[1], 2, 1e-12);
  EXPECT_NEAR(circle->radius, 1, 1e-12);
  const std::array<std::array<double, 2>, 3> straight{{{0, 0}, {1, 1}, {2, 2}}};
  EXPECT_FALSE(fit_circle(straight));
}

TEST(HandlePose, StandsAtTheGivenPlaceOrInTheMiddleOfTheWall) {
  ops::operation_description d;
  d.selection.minimum = 0;
  ops::parameter_description at;
  at.id = "at";
  at.type = ops::parameter_type::point;
  at.unit = "m";
  ops::parameter_description axis;
  axis.id = "direction";
  axis.name = "Axis";
  axis.type = ops::parameter_type::direction;
  d.parameters = {at, axis};
  const auto plan = plan_of(d);
  const auto part = bored_wall();
  const auto pose = [&](const char* place, const char* way, std::vector<surface_id> picked) {
    return pose_of(plan, {{"at", std::string(place)}, {"direction", std::string(way)}}, picked,
                   part, {});
  };

  EXPECT_FALSE(pose("", "", {})) << "neither a place nor a wall";
  EXPECT_NEAR(pose("", "", {1})->frame.z.z, 1, 1e-12);
  const auto given = pose("0.005, 0.002, 0.003", "", {1});
  EXPECT_EQ(given->frame.at, (vec3{5e-3, 2e-3, 3e-3}));
  const auto either = pose("0.005, 0.002, 0.003", "0, 0.6, -0.8", {1});
  EXPECT_NEAR(either->frame.z.z, 0.8, 1e-12) << "into the material either way";
  EXPECT_NEAR(either->wall_normal.z, 1, 1e-12);
  EXPECT_FALSE(pose("1, two", "", {})) << "what is being typed is no place yet";
}

TEST(HandlePose, AWholePlaneThatIsGivenLeavesNothingToDrag) {
  ops::operation_description d;
  for (const auto& [id, type] : {std::pair{"at", ops::parameter_type::point},
                                 {"normal", ops::parameter_type::direction},
                                 {"plane", ops::parameter_type::plane}})
    d.parameters.push_back({id, id, "", type, "", {}, {}, {}, std::string()});
  const auto plan = plan_of(d);
  ASSERT_TRUE(plan.is_plane);
  EXPECT_EQ(plan.find("plane"), nullptr) << "a field only";

  EXPECT_TRUE(pose_of(plan, {{"plane", std::string()}}, {1}, bored_wall(), {}));
  for (const auto* given : {"0, 0, 0; 0, 0, 1", "surface:3"})
    EXPECT_FALSE(pose_of(plan, {{"plane", std::string(given)}}, {1}, bored_wall(), {})) << given;
}

}  // namespace
}  // namespace tedit::desktop
