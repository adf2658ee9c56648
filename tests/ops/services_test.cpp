// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/services/host_services.hpp"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "ops/mesher/mesher.hpp"
#include "ops/mesher/tets_exchange.hpp"

namespace tedit::ops {
namespace {

double area_of(const planar_filling& filling) {
  double area = 0;
  for (const auto& t : filling.triangles) {
    const auto& a = filling.points[t[0]];
    const auto& b = filling.points[t[1]];
    const auto& c = filling.points[t[2]];
    area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  }
  return area;
}

TEST(Triangulate, FillsASquareWithoutNewPointsWhenNoneAreWanted) {
  const planar_polygon square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2, 3}}};

  const auto filling = triangulate_polygon(square, 0);

  ASSERT_TRUE(filling.has_value());
  EXPECT_EQ(filling->triangles.size(), 2u);
  EXPECT_DOUBLE_EQ(area_of(*filling), 1);
}

TEST(Triangulate, NestedLoopsGiveARing) {
  const planar_polygon ring{{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}},
                            {{0, 1, 2, 3}, {4, 7, 6, 5}}};

  const auto filling = triangulate_polygon(ring, 0);

  ASSERT_TRUE(filling.has_value());
  EXPECT_DOUBLE_EQ(area_of(*filling), 8);
}

TEST(Triangulate, PointsStayAwayFromTheLoopAndKeepTheArea) {
  planar_polygon circle;
  for (std::uint32_t i = 0; i < 24; ++i) {
    circle.points.push_back({std::cos(i * M_PI / 12), std::sin(i * M_PI / 12)});
    if (i == 0)
      circle.loops.emplace_back();
    circle.loops[0].push_back(i);
  }

  const auto filling = triangulate_polygon(circle, 0.26);

  ASSERT_TRUE(filling.has_value());
  EXPECT_GT(filling->points.size(), 24u + 20);
  EXPECT_NEAR(area_of(*filling), 12 * std::sin(M_PI / 12), 1e-12);
}

TEST(Triangulate, ACrossedLoopIsRefused) {
  const planar_polygon bow{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {{0, 1, 2, 3}}};

  const auto filling = triangulate_polygon(bow, 0);

  ASSERT_FALSE(filling.has_value());
  EXPECT_EQ(filling.error().code, ec::mesher_failed);
}

closed_surface cube(double size) {
  closed_surface shell;
  for (int i = 0; i < 8; ++i)
    shell.points.push_back({size * (i & 1), size * ((i >> 1) & 1), size * ((i >> 2) & 1)});
  shell.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return shell;
}

TEST(Tetrahedralise, FillsACubeExactlyAtAnyScale) {
  setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
  for (const double size : {1e-6, 1.0, 1e4}) {
    const auto filling = tetrahedralise_surface(cube(size), {});
    ASSERT_TRUE(filling.has_value()) << render(filling.error());
    double volume = 0;
    for (const auto& t : filling->tets) {
      const auto& p = filling->points;
      volume += dot(p[t[1]] - p[t[0]], cross(p[t[2]] - p[t[0]], p[t[3]] - p[t[0]])) / 6;
    }
    EXPECT_NEAR(volume / (size * size * size), 1, 1e-12);
  }
}

TEST(Tetrahedralise, AnOpenSurfaceIsRefusedAndNothingHangs) {
  setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
  auto open = cube(1);
  open.triangles.pop_back();

  const auto filling = tetrahedralise_surface(open, {});

  ASSERT_FALSE(filling.has_value());
  EXPECT_TRUE(filling.error().code == ec::mesher_failed || filling.error().code == ec::timeout);
}

TEST(Tetrahedralise, WhatTheMesherMadeOfItIsToldInTheEditsWords) {
  closed_surface scrap{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};

  const auto filling = tetrahedralise_surface(scrap, {});

  ASSERT_FALSE(filling.has_value());
  EXPECT_EQ(filling.error().message,
            "no tets fit between the walls there (a closed surface has at least four triangles)");
}

TEST(Tetrahedralise, TheMesherEndsItselfOnceItHasComputedForSoLong) {
  // Two cones of 4,000 triangles each: TetGen computes for more than 8 s.
  constexpr std::uint32_t ring = 4000;
  std::vector<vec3> points{{0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i < ring; ++i) {
    points.push_back({std::cos(2 * M_PI * i / ring), std::sin(2 * M_PI * i / ring), 0});
    triangles.push_back({2 + i, 2 + (i + 1) % ring, 0});
    triangles.push_back({2 + (i + 1) % ring, 2 + i, 1});
  }
  exchange_header header;
  header.points = static_cast<std::uint32_t>(points.size());
  header.cells = static_cast<std::uint32_t>(triangles.size());
  header.most_ms = 4;
  std::vector<char> question;
  const auto add = [&](const auto* values, std::size_t count) {
    const auto* bytes = reinterpret_cast<const char*>(values);
    question.insert(question.end(), bytes, bytes + count * sizeof(*values));
  };
  add(&header, 1);
  add(points.data(), points.size());
  add(triangles.data(), triangles.size());
  setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);

  const auto answer =
    run_child({mesher_program().string()}, question, mesher_limits(most_meshing_time), {});

  ASSERT_FALSE(answer.has_value());
  EXPECT_EQ(answer.error().code, ec::timeout);
  EXPECT_EQ(answer.error().message, "tedit-mesher found no end in the time that it may compute");
}

TEST(Triangulate, APolygonWithoutAreaIsRefused) {
  const planar_polygon line{{{0, 0}, {1, 0}, {2, 0}, {1.5, 0}}, {{0, 1, 2, 3}}};
  const planar_polygon twice{{{0, 0}, {1, 0}, {1, 1}, {1, 0}}, {{0, 1, 2, 3}}};

  for (const auto& polygon : {line, twice}) {
    const auto refused = triangulate_polygon(polygon, 0.5);

    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ec::mesher_failed);
  }
}

}  // namespace
}  // namespace tedit::ops
