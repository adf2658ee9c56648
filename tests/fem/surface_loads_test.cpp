// SPDX-License-Identifier: AGPL-3.0-or-later
// Loads that are given in all: their sums are exact in both orders, their fields those of
// textbooks.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/problem.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

using ::testing::HasSubstr;

load_case with_load(load item) {
  load_case loads;
  loads.materials = {{"steel", 210e9, 0.3, 7800, 0, {}}};
  loads.constraints = {{{1}, fixed{}}};
  loads.loads = {std::move(item)};
  return loads;
}

vec3 at_node(const problem& p, std::size_t n) {
  return {p.loads[3 * n], p.loads[3 * n + 1], p.loads[3 * n + 2]};
}

/// Resultant of all nodal forces, and their moment about a place.
struct resultant {
  vec3 force_n;
  vec3 moment_nm;
};

resultant sum_of(const problem& p, vec3 about) {
  resultant sum;
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    sum.force_n += at_node(p, n);
    sum.moment_nm += cross(p.nodes[n] - about, at_node(p, n));
  }
  return sum;
}

/// A bar whose end (surface 2) is no plane and whose triangles are all different.
version_ptr crooked_bar() {
  return test::box_mesh({3, 3, 2}, {0.3, 0.2, 0.1}, [](vec3 p) {
    return p + vec3{0.05 * p.y + 0.3 * p.y * p.z, 0.1 * p.x * p.z, 0.2 * p.x * p.y};
  });
}

problem problem_of(const version_ptr& mesh, load item, int order) {
  auto p = make_problem(*mesh, with_load(std::move(item)), order);
  EXPECT_TRUE(p.has_value()) << render(p.error());
  return p.value_or(problem{});
}

error refusal(load item) {
  const auto p = make_problem(*crooked_bar(), with_load(std::move(item)));
  EXPECT_FALSE(p.has_value());
  return p ? error{} : p.error();
}

class SurfaceLoads : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Orders, SurfaceLoads, ::testing::Values(1, 2));

TEST_P(SurfaceLoads, AMomentIsACoupleOfItsSize) {
  const vec3 wanted{7, -3, 11};

  const auto sum = sum_of(problem_of(crooked_bar(), {{2}, moment{wanted}}, GetParam()), {9, 9, 9});

  EXPECT_LT(norm(sum.force_n), 1e-11);
  EXPECT_LT(norm(sum.moment_nm - wanted), 1e-11);
}

TEST_P(SurfaceLoads, ARemoteForceActsAtItsPlace) {
  const remote_force lever{{30, -20, 10}, {0.4, 0.5, -0.6}, {1, 2, 3}};

  const auto sum = sum_of(problem_of(crooked_bar(), {{2, 4}, lever}, GetParam()), lever.at_m);

  EXPECT_LT(norm(sum.force_n - lever.total_n), 1e-11);
  EXPECT_LT(norm(sum.moment_nm - lever.moment_nm), 1e-11);
}

TEST_P(SurfaceLoads, ARemoteForceAtTheMiddleIsAForce) {
  const auto mesh = test::box_mesh({2, 2, 2}, {2, 1, 1});

  const auto far = problem_of(mesh, {{2}, remote_force{{1, 2, 3}, {2, 0.5, 0.5}}}, GetParam());
  const auto near = problem_of(mesh, {{2}, force{{1, 2, 3}}}, GetParam());

  for (std::size_t i = 0; i < near.loads.size(); ++i)
    EXPECT_NEAR(far.loads[i], near.loads[i], 1e-14);
}

TEST_P(SurfaceLoads, AForceAlongTheNormalPushesOnAFlatFace) {
  const auto mesh = test::box_mesh({2, 2, 2}, {2, 1, 1});

  const auto sum = sum_of(problem_of(mesh, {{2}, normal_force{50}}, GetParam()), {2, 0.5, 0.5});

  EXPECT_LT(norm(sum.force_n - vec3{-50, 0, 0}), 1e-12);
  EXPECT_LT(norm(sum.moment_nm), 1e-12);
}

/// Water of 1000 kg/m3 up to the upper edge of a wall 1 m wide and 1 m high: 4905 N, 2/3 m deep.
TEST_P(SurfaceLoads, APressureThatGrowsWithTheDepthActsAtTwoThirdsOfIt) {
  const auto mesh = test::box_mesh({2, 3, 2}, {2, 1, 1});
  const pressure water{0, {0, 0, -9810}, {0, 0, 1}};

  const auto sum = sum_of(problem_of(mesh, {{2}, water}, GetParam()), {2, 0.5, 1.0 / 3});

  EXPECT_LT(norm(sum.force_n - vec3{-4905, 0, 0}), 1e-9);
  EXPECT_LT(norm(sum.moment_nm), 1e-9);
}

/// 6 N m about y on a face of 1 m2: 72 Pa/m by Navier, so 36 Pa at the edges z = 0 and 1. On a
/// linear triangle with corners of 36, 36 and -36 Pa they are 3, 3 and 0 N.
TEST(SurfaceLoads, AMomentBendsByNaviersStress) {
  const auto p = problem_of(test::box_mesh({2, 1, 1}, {2, 1, 1}), {{2}, moment{{0, 6, 0}}}, 1);

  double above = 0;
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const auto f = at_node(p, n);
    EXPECT_LT(std::abs(f.y) + std::abs(f.z), 1e-14);
    if (p.nodes[n].x == 2) {
      EXPECT_NEAR(std::abs(f.x), 3, 1e-12);
      above += p.nodes[n].z == 1 ? f.x : 0;
    }
  }
  EXPECT_NEAR(above, 6, 1e-12);
}

/// Half a ring, from -90 to 90 degrees, whose bore of 10 mm (surface 3) lies on z.
version_ptr half_ring(int around) {
  return test::box_mesh({around, 2, 2}, {1, 1, 1}, [](vec3 p) {
    const double angle = std::numbers::pi * (p.x - 0.5);
    const double r = 0.01 * (1 + p.y);
    return vec3{r * std::cos(angle), r * std::sin(angle), 0.01 * p.z};
  });
}

load_case on_half_ring(load item) {
  auto loads = with_load(std::move(item));
  loads.constraints = {{{4}, fixed{}}};
  return loads;
}

TEST_P(SurfaceLoads, APinPressesWithItsWholeForceAndPullsNowhere) {
  for (const vec3 wanted : {vec3{100, 0, 0}, vec3{60, 40, 0}}) {
    const auto p =
      *make_problem(*half_ring(24), on_half_ring({{3}, bearing_force{wanted}}), GetParam());

    const auto sum = sum_of(p, {});
    EXPECT_LT(norm(sum.force_n - wanted), 1e-11);
    for (std::size_t n = 0; n < p.node_count(); ++n) {
      const vec3 outward{p.nodes[n].x, p.nodes[n].y, 0};
      EXPECT_GE(dot(at_node(p, n), outward), -1e-3 * norm(wanted) * norm(outward)) << n;
    }
  }
}

/// p0 = 2 F / (pi R h) where the wall faces the pin.
TEST(SurfaceLoads, APinsPressureFallsWithTheCosine) {
  constexpr int around = 64;
  const auto p =
    *make_problem(*half_ring(around), on_half_ring({{3}, bearing_force{{100, 0, 0}}}), 1);

  const double step = std::numbers::pi / around;
  const double full = 100 * 2 / std::numbers::pi * step;  // N on one column of cells at 0 degrees.
  for (const int column : {8, 20, 32, 44}) {
    const double angle = std::numbers::pi * (1.0 * column / around - 0.5);
    double carried = 0;
    for (std::size_t n = 0; n < p.node_count(); ++n)
      if (std::abs(std::atan2(p.nodes[n].y, p.nodes[n].x) - angle) < 1e-9)
        carried += norm(at_node(p, n));
    EXPECT_NEAR(carried, full * std::cos(angle), 2e-3 * full) << column;
  }
}

TEST(SurfaceLoads, APinDoesNotPullItsBoreAlong) {
  const auto away = make_problem(*half_ring(8), on_half_ring({{3}, bearing_force{{-100, 0, 0}}}));
  const auto along = make_problem(*half_ring(8), on_half_ring({{3}, bearing_force{{100, 0, 50}}}));

  ASSERT_FALSE(away.has_value());
  EXPECT_EQ(away.error().code, ec::invalid_load);
  EXPECT_THAT(away.error().message, HasSubstr("load 0 presses on no wall"));
  ASSERT_FALSE(along.has_value());
  EXPECT_THAT(along.error().message, HasSubstr("load 0 has 50 N along the bore"));
}

TEST(SurfaceLoads, EachNumberIsChecked) {
  constexpr std::array<double vec3::*, 3> components{&vec3::x, &vec3::y, &vec3::z};
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e31}) {
    EXPECT_THAT(refusal({{2}, normal_force{bad}}).message, HasSubstr("load 0 is "));
    for (std::size_t c = 0; c < components.size(); ++c) {
      vec3 value;
      value.*components[c] = bad;
      const auto letter = std::string(1, "xyz"[c]) + " is ";
      const vec3 sound{1, 1, 1};
      for (const load& item :
           {load{{2}, moment{value}}, load{{2}, bearing_force{value}},
            load{{2}, remote_force{value, sound}}, load{{2}, remote_force{sound, value}},
            load{{2}, remote_force{sound, sound, value}}, load{{2}, pressure{1, value, sound}},
            load{{2}, pressure{1, sound, value}}}) {
        const auto refused = refusal(item);
        EXPECT_EQ(refused.code, ec::invalid_load);
        EXPECT_THAT(refused.message, HasSubstr(letter)) << bad;
      }
    }
  }
}

TEST(SurfaceLoads, WhatSmallAreasMakeOfLargeNumbersIsRefused) {
  for (const load& item :
       {load{{2}, moment{{0, 1e30, 0}}}, load{{2}, remote_force{{1e30, 0, 0}, {0, 1e30, 0}}},
        load{{2}, pressure{1, {0, 0, 1e30}, {0, 0, -1e30}}}}) {
    const auto refused = refusal(item);
    EXPECT_EQ(refused.code, ec::invalid_load);
    EXPECT_THAT(refused.message, HasSubstr("load 0 on its area is "));
  }
}

TEST(SurfaceLoads, TheyNeedASurface) {
  for (const load& item :
       {load{{}, moment{{0, 1, 0}}}, load{{}, normal_force{1}}, load{{}, bearing_force{{1, 0, 0}}},
        load{{}, remote_force{{1, 0, 0}, {}}}})
    EXPECT_THAT(refusal(item).message, HasSubstr("load 0 acts on no surface"));
}

}  // namespace
}  // namespace tedit::fem
