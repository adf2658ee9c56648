// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/tools/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "ops/services/host_services.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

using std::numbers::pi;

class Sweep : public ::testing::Test {
protected:
  expected<tool_surface> along(const std::vector<vec3>& path, const profile& what, vec3 up = {},
                               double size = 0.1) {
    return sweep(path, what, up, size, "bead", *host_);
  }

  /// Each edge of two triangles, once in each direction.
  static void expect_closed(const tool_surface& tool) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : tool.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        ++edges[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    EXPECT_EQ(tool.faces.size(), tool.triangles.size());
    for (const auto face : tool.faces)
      EXPECT_LT(face, tool.names.size());
  }

  static double area_of_face(const tool_surface& tool, const std::string& name) {
    double sum = 0;
    for (std::size_t i = 0; i < tool.triangles.size(); ++i)
      if (tool.names[tool.faces[i]] == name) {
        const auto& t = tool.triangles[i];
        const auto& p = tool.points;
        sum += norm(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])) / 2;
      }
    return sum;
  }

  std::unique_ptr<services> host_ = make_host_services();
};

TEST_F(Sweep, OfAStraightPathIsAPrism) {
  const auto tool = along({{0, 0, 1}, {2, 0, 1}}, rectangle(0.4, 0.2), {0, 0, 1});
  ASSERT_TRUE(tool) << render(tool.error());

  expect_closed(*tool);
  EXPECT_NEAR(enclosed_volume(tool->points, tool->triangles), 0.4 * 0.2 * 2, 1e-12);
  EXPECT_NEAR(area_of_face(*tool, "bead start"), 0.08, 1e-12);
  EXPECT_NEAR(area_of_face(*tool, "bead end"), 0.08, 1e-12);
  box extent;
  for (const auto& p : tool->points)
    extent.add(p);
  EXPECT_LT(norm(extent.low - vec3{0, -0.2, 0.9}), 1e-12) << "its height goes up";
  EXPECT_LT(norm(extent.high - vec3{2, 0.2, 1.1}), 1e-12);
}

/// Whatever the corners: a profile around the path takes its area times the path's length.
TEST_F(Sweep, OfABentPathIsTheAreaTimesTheLength) {
  const std::vector<vec3> path{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1.5, 1.5, 0.7}, {1.5, 1.5, 2}};
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += norm(path[i] - path[i - 1]);
  for (const auto& what : {circle(0.2, 16), rectangle(0.3, 0.1), slot(0.3, 0.1, 16)}) {
    const auto straight = along({{}, {1, 0, 0}}, what);
    const auto tool = along(path, what);
    ASSERT_TRUE(tool) << render(tool.error());

    expect_closed(*tool);
    EXPECT_NEAR(enclosed_volume(tool->points, tool->triangles),
                length * enclosed_volume(straight->points, straight->triangles), 1e-12);
  }
}

/// A square frame: no ends, its walls go round. The mitres make four prisms of trapezia.
TEST_F(Sweep, OfAClosedPathHasNoEnds) {
  const auto tool =
    along({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}, rectangle(0.2, 0.2), {0, 0, 1});
  ASSERT_TRUE(tool) << render(tool.error());

  expect_closed(*tool);
  EXPECT_NEAR(enclosed_volume(tool->points, tool->triangles), (1.2 * 1.2 - 0.8 * 0.8) * 0.2, 1e-12);
  EXPECT_EQ(area_of_face(*tool, "bead start"), 0);
  double walls = 0;
  for (int i = 1; i <= 4; ++i)
    walls += area_of_face(*tool, "bead side " + std::to_string(i));
  EXPECT_NEAR(walls, 4 * 1.2 * 0.2 + 4 * 0.8 * 0.2 + 2 * (1.44 - 0.64), 1e-12);
}

/// A ring of 96 legs is a torus but for its facets: 2 pi^2 R r^2, with the polygons' own areas.
TEST_F(Sweep, AroundACircleIsATorus) {
  std::vector<vec3> path;
  constexpr int legs = 96;
  for (int i = 0; i < legs; ++i)
    path.push_back({std::cos(2 * pi * i / legs), std::sin(2 * pi * i / legs), 0});
  path.push_back(path.front());
  const auto tool = along(path, circle(0.4, 32), {0, 0, 1});
  ASSERT_TRUE(tool) << render(tool.error());

  expect_closed(*tool);
  const double perimeter = legs * 2 * std::sin(pi / legs);
  const double disc = 0.5 * 32 * std::sin(2 * pi / 32) * 0.04;
  EXPECT_NEAR(enclosed_volume(tool->points, tool->triangles), disc * perimeter, 1e-12);
  EXPECT_NEAR(disc * perimeter, 2 * pi * pi * 0.04, 0.01 * 2 * pi * pi * 0.04);
}

/// Round such a path the frame comes back turned; shared out, the tool is closed all the same.
TEST_F(Sweep, AClosedPathThroughSpaceClosesAlthoughItsFrameTurns) {
  const std::vector<vec3> path{{0, 0, 0}, {1, 0, 0.3}, {1, 1, -0.4}, {0, 1, 0.5}, {0, 0, 0}};
  const auto tool = along(path, rectangle(0.1, 0.1), {0, 0, 1}, 0.02);
  ASSERT_TRUE(tool) << render(tool.error());

  expect_closed(*tool);
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += norm(path[i] - path[i - 1]);
  EXPECT_NEAR(enclosed_volume(tool->points, tool->triangles), 0.01 * length, 0.02 * 0.01 * length);
}

TEST_F(Sweep, WhatCannotBeIsRefusedWithItsPoint) {
  const auto refusal = [&](const std::vector<vec3>& path, const profile& what) {
    const auto tool = along(path, what);
    EXPECT_FALSE(tool);
    return tool ? "" : tool.error().message;
  };
  const auto thin = circle(0.02, 16);

  EXPECT_THAT(refusal({{0, 0, 0}}, thin), HasSubstr("two points"));
  EXPECT_THAT(refusal({{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}}, thin),
              HasSubstr("point 2 the path turns back"));
  EXPECT_THAT(refusal({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, thin), HasSubstr("stands still"));
  EXPECT_THAT(refusal({{0, 0, 0}, {1, 0, 0}, {1, 0.1, 0}, {0, 0.1, 0}}, circle(0.4, 16)),
              HasSubstr("between its points 2 and 3 the path bends too narrowly"));
}

/// A groove of 0.1 x 0.1 on the top of a block, 0.6 m along x and 0.6 m along y.
TEST_F(Sweep, IsAToolThatTheBooleanTakes) {
  const auto block = test::box_mesh({8, 8, 4}, {1, 1, 0.5});
  const auto tool =
    along({{0.2, 0.2, 0.5}, {0.8, 0.2, 0.5}, {0.8, 0.8, 0.5}}, rectangle(0.1, 0.2), {0, 0, 1});
  ASSERT_TRUE(tool) << render(tool.error());

  const auto made = host_->boolean(block, *tool, {boolean_mode::cut, 0}, {});

  ASSERT_TRUE(made) << render(made.error());
  EXPECT_NEAR(made->volume_change, -0.1 * 0.1 * 1.2, 1e-12);
}

}  // namespace
}  // namespace tedit::ops
