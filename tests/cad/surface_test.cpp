// SPDX-License-Identifier: AGPL-3.0-or-later
// The surface mesh between Gmsh's faces and its tets.
#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "cad/mesher/surface_mesh.hpp"

namespace tedit::cad {
namespace {

/// Every edge in two triangles, once each way.
bool is_closed(const surface_mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      ++edges[{t.v[i], t.v[(i + 1) % 3]}];
  return std::ranges::all_of(edges, [&](const auto& one) {
    const auto back = edges.find({one.first.second, one.first.first});
    return one.second == 1 && back != edges.end() && back->second == 1;
  });
}

double volume(const surface_mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += dot(mesh.points[t.v[0]], cross(mesh.points[t.v[1]], mesh.points[t.v[2]])) / 6;
  return sum;
}

/// A prism of height 1 over a polygon in the plane z = 0 (counter-clockwise): surface 1 below, 2
/// above, the sides from 3 on. Below and above are fans about corner 0.
surface_mesh prism(const std::vector<vec3>& polygon) {
  surface_mesh mesh;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  mesh.points = polygon;
  for (const auto& p : polygon)
    mesh.points.push_back(p + vec3{0, 0, 1});
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({{0, i + 1, i}, 1});
    mesh.triangles.push_back({{n, n + i, n + i + 1}, 2});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto next = (i + 1) % n;
    mesh.triangles.push_back({{i, next, n + next}, static_cast<int>(3 + i)});
    mesh.triangles.push_back({{i, n + next, n + i}, static_cast<int>(3 + i)});
  }
  return mesh;
}

TEST(CleanSurface, LeavesAGoodSurfaceAlone) {
  auto mesh = prism({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});

  const auto done = clean_surface(mesh, 0.05, 0.15);

  EXPECT_EQ(done.collapsed + done.flipped, 0U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_DOUBLE_EQ(volume(mesh), 1);
}

TEST(CleanSurface, TakesAwayAFaceThatIsNarrowerThanWhatMayGo) {
  // A square whose corner is cut off by 0.01: the side between is 0.014 wide.
  auto mesh = prism({{0, 0, 0}, {0.99, 0, 0}, {1, 0.01, 0}, {1, 1, 0}, {0, 1, 0}});
  ASSERT_TRUE(is_closed(mesh));

  const auto done = clean_surface(mesh, 0.05, 0.15);

  EXPECT_TRUE(is_closed(mesh));
  EXPECT_EQ(done.collapsed, 2U);  // Its edge below and its edge above.
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_EQ(std::ranges::count(mesh.triangles, 4, &surface_mesh::triangle::surface), 0);
  EXPECT_NEAR(volume(mesh), 1, 0.01);
  EXPECT_NEAR(done.moved, std::sqrt(2e-4), 1e-12);
}

TEST(CleanSurface, KeepsAFaceThatIsWiderThanWhatMayGo) {
  auto mesh = prism({{0, 0, 0}, {0.99, 0, 0}, {1, 0.01, 0}, {1, 1, 0}, {0, 1, 0}});

  EXPECT_EQ(clean_surface(mesh, 0.01, 0.15).collapsed, 0U);

  EXPECT_TRUE(is_closed(mesh));
  EXPECT_EQ(std::ranges::count(mesh.triangles, 4, &surface_mesh::triangle::surface), 2);
  EXPECT_NEAR(volume(mesh), 1 - 0.01 * 0.01 / 2, 1e-12);
}

TEST(CleanSurface, FlipsAFlatTriangleWithinAFace) {
  // A point of surface 1 just beside the diagonal that it should not have.
  auto mesh = prism({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  std::erase_if(mesh.triangles, [](const auto& t) { return t.surface == 1; });
  mesh.points.push_back({0.5, 0.49, 0});
  mesh.triangles.insert(mesh.triangles.end(),
                        {{{0, 2, 8}, 1}, {{2, 1, 8}, 1}, {{1, 0, 8}, 1}, {{0, 3, 2}, 1}});
  ASSERT_TRUE(is_closed(mesh));

  const auto done = clean_surface(mesh, 0.001, 0.15);

  EXPECT_EQ(done.flipped, 1U);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume(mesh), 1, 1e-12);
}

TEST(CleanSurface, DropsAFlatTriangleAtAnEdgeOfThePart) {
  // Surface 1 has a point 0.01 beside its edge with surface 3.
  auto mesh = prism({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  std::erase_if(mesh.triangles, [](const auto& t) { return t.surface == 1; });
  mesh.points.push_back({0.5, 0.01, 0});
  mesh.triangles.insert(mesh.triangles.end(),
                        {{{1, 0, 8}, 1}, {{0, 3, 8}, 1}, {{3, 2, 8}, 1}, {{2, 1, 8}, 1}});
  ASSERT_TRUE(is_closed(mesh));

  const auto done = clean_surface(mesh, 0.05, 0.15);

  EXPECT_EQ(done.flipped, 1U);
  EXPECT_NEAR(done.moved, 0.01, 1e-12);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_EQ(std::ranges::count(mesh.triangles, 1, &surface_mesh::triangle::surface), 3);
  EXPECT_EQ(std::ranges::count(mesh.triangles, 3, &surface_mesh::triangle::surface), 3);
}

TEST(CleanSurface, NeverPinchesOffAPart) {
  // A bar of 0.02 x 0.02 x 1 is all short edges: collapsing one would leave no volume.
  auto mesh = prism({{0, 0, 0}, {0.02, 0, 0}, {0.02, 0.02, 0}, {0, 0.02, 0}});

  const auto done = clean_surface(mesh, 0.05, 0.15);

  EXPECT_LE(done.moved, 0.05);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_GT(volume(mesh), 0);
}

}  // namespace
}  // namespace tedit::cad
