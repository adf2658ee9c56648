// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/rounder_tool.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "ops/tools/tools.hpp"

namespace tedit::ops {
namespace {

using std::numbers::pi;

/// A rod of six sides and radius 1, 2 long, that says that it is a cylinder.
tool_surface hexagon() {
  auto tool = revolve(make_frame({0, 0, 2}, {0, 0, 1}),
                      {{0, 0, ""}, {1, 0, "top"}, {1, -2, "side"}, {0, -2, "end"}}, 6, 5);
  tool.geometries.resize(tool.names.size());
  for (std::size_t face = 0; face < tool.names.size(); ++face)
    if (tool.names[face] == "side")
      tool.geometries[face] = {surface_geometry::kind::cylinder, {0, 0, 0}, {0, 0, 1}, 1};
  return tool;
}

double volume_of(const tool_surface& tool) {
  double sum = 0;
  for (const auto& t : tool.triangles)
    sum += dot(tool.points[t[0]], cross(tool.points[t[1]], tool.points[t[2]])) / 6;
  return sum;
}

double prism(int sides) {
  return 2 * 0.5 * sides * std::sin(2 * pi / sides);
}

bool is_closed(const tool_surface& tool) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const auto& t : tool.triangles)
    for (int k = 0; k < 3; ++k) {
      ++sides[{t[k], t[(k + 1) % 3]}];
      --sides[{t[(k + 1) % 3], t[k]}];
    }
  return std::ranges::all_of(sides, [](const auto& one) { return one.second == 0; });
}

TEST(RounderTool, HalvesChordsUntilTheyAreNearTheirWall) {
  const auto tool = hexagon();
  ASSERT_NEAR(volume_of(tool), prism(6), 1e-12);

  // Chords of six sides are 1 - cos 30 degrees = .134 off it, of twelve .034, of 24 .0086.
  const auto twelve = with_shorter_chords(tool, 0.05);
  const auto more = with_shorter_chords(tool, 0.01);

  ASSERT_TRUE(twelve && more);
  EXPECT_TRUE(is_closed(*twelve) && is_closed(*more));
  EXPECT_EQ(twelve->faces.size(), twelve->triangles.size());
  EXPECT_NEAR(volume_of(*twelve), prism(12), 1e-12);
  EXPECT_NEAR(volume_of(*more), prism(24), 1e-12);
  for (const auto& p : more->points)
    if (const double r = std::hypot(p.x, p.y); r > 1e-9) {
      EXPECT_TRUE(p.z == 0 || p.z == 2 || std::abs(r - 1) < 1e-12) << r;
    }
}

TEST(RounderTool, LeavesWhatIsRoundEnoughOrSaysNothing) {
  auto tool = hexagon();
  EXPECT_FALSE(with_shorter_chords(tool, 0.14));
  tool.geometries.clear();
  EXPECT_FALSE(with_shorter_chords(tool, 0.01));
}

/// Its corners are on another wall: what it says is not so.
TEST(RounderTool, BelievesNothingThatItsCornersDoNotSay) {
  auto tool = hexagon();
  for (auto& geometry : tool.geometries)
    geometry.radius *= 1.1;
  EXPECT_FALSE(with_shorter_chords(tool, 0.01));
}

}  // namespace
}  // namespace tedit::ops
