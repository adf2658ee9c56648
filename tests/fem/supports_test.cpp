// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/native/backend.hpp"
#include "fem/solver.hpp"
#include "mesh/io/import.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

load_case pushed(std::vector<constraint> constraints) {
  load_case loads;
  loads.materials = {{"steel", 210e9, 0.3, 7800, 0, {}}};
  loads.constraints = std::move(constraints);
  loads.loads = {{{}, gravity{{3, 2, 1}}}};
  return loads;
}

/// Three quarters of a ring around z, inside on surface 3, from six facets of 45 degrees.
version_ptr ring() {
  constexpr double all = 1.5 * std::numbers::pi;
  return test::box_mesh({6, 2, 2}, {all, 1, 1}, [](vec3 p) {
    return vec3{(1 + p.y) * std::cos(-p.x), (1 + p.y) * std::sin(-p.x), p.z};
  });
}

/// A piece of a thick sphere, inside on surface 5.
version_ptr bowl(int cells) {
  return test::box_mesh({cells, cells, 2}, {1.2, 1.2, 1}, [](vec3 p) {
    const double a = p.x - 0.6;
    const double b = p.y - 0.6;
    return (1 + p.z) * vec3{std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
  });
}

std::string refusal(const version_ptr& mesh, const load_case& loads, int order,
                    std::uint32_t spare = 0) {
  const auto p = make_problem(*mesh, loads, order, spare);
  if (p)
    return "held";
  EXPECT_EQ(p.error().code, ec::under_constrained);
  return p.error().message;
}

TEST(Supports, ARoundWallOnRollersTurnsAndSlides) {
  for (const int order : {1, 2}) {
    const auto free = refusal(ring(), pushed({{{3}, roller{}}}), order);
    EXPECT_THAT(free, AllOf(HasSubstr("free are rotation about the axis (0, 0, 1) through"),
                            HasSubstr("translation along (0, 0, 1)")));
    const auto turns = refusal(ring(), pushed({{{3, 5}, roller{}}}), order);
    EXPECT_THAT(
      turns, AllOf(HasSubstr("rotation about the axis (0, 0, 1)"), Not(HasSubstr("translation"))));
    EXPECT_EQ(refusal(ring(), pushed({{{1, 3, 5}, roller{}}}), order), "held");
  }
}

TEST(Supports, AnyRoundWallIsKnownByItsFacets) {
  // No plane, cylinder or cone: normals are those of the facets, which a coarse mesh knows badly.
  for (const int cells : {3, 8})
    for (const int order : {1, 2}) {
      const auto free = refusal(bowl(cells), pushed({{{5}, roller{}}}), order);
      EXPECT_THAT(free, Not(HasSubstr("translation"))) << cells;
      EXPECT_EQ(std::ranges::count(free, ';'), 2) << free;  // Three rotations.
      EXPECT_EQ(refusal(bowl(cells), pushed({{{1, 3, 5}, roller{}}}), order), "held") << cells;
    }
}

TEST(Supports, NodesKeptSpareHoldNothing) {
  const auto bar = test::box_mesh({2, 1, 1}, {2, 1, 1});
  for (const int order : {1, 2})
    EXPECT_THAT(refusal(bar, pushed({{{3, 5}, roller{}}}), order, 100),
                HasSubstr("free are translation along (1, 0, 0)"));
}

TEST(Supports, ABearingCarriesNoTorque) {
  // Rollers on a bore of two halves and on the underside; another bore keeps the plate from
  // turning.
  const auto part = import_mesh(TEDIT_TEST_DATA "/parts/ctc01_plate/ctc01_plate.coarse.msh", "mm");
  ASSERT_TRUE(part.has_value());
  constexpr vec3 axis{-0.16, 0.045, 0};
  const auto cpu = make_native_backend();
  for (const int order : {1, 2}) {
    const auto p = make_problem(
      *part->version,
      pushed({{{1, 2, 98}, roller{}}, {{94}, prescribed_displacement{{}, 0.0, {}}}}), order);
    ASSERT_TRUE(p.has_value());
    solve_settings settings;
    settings.tolerance = 1e-9;
    const auto solved = solve(*p, *cpu, settings, {});
    ASSERT_TRUE(solved.has_value()) << solved.error().message;
    double torque = 0;
    double size = 0;
    for (const auto& h : p->holders)
      if (h.surface == 1 || h.surface == 2) {
        const vec3 r{solved->reactions[3 * h.node], solved->reactions[3 * h.node + 1], 0};
        const vec3 arm = p->nodes[h.node] - axis;
        torque += arm.x * r.y - arm.y * r.x;
        size += norm(r) * std::hypot(arm.x, arm.y);
      }
    EXPECT_GT(size, 1e-3);
    EXPECT_LE(std::abs(torque), 1e-6 * size) << order;
  }
}

TEST(Supports, ALoadThatTheyTakeWholeMovesNothing) {
  // A box that lies askew: its supports' normals are rounded, and what the filter leaves is noise.
  const vec3 a = normalized(vec3{1, 2, 2});
  const vec3 b = normalized(cross(vec3{0, 0, 1}, a));
  const vec3 c = cross(a, b);
  const auto askew =
    test::box_mesh({4, 2, 2}, {2, 1, 1}, [&](vec3 p) { return p.x * a + p.y * b + p.z * c; });
  auto loads = pushed({{{1, 3, 5}, roller{}}});
  loads.loads = {{{1}, force{-1000 * a}}};
  const auto cpu = make_native_backend();
  for (const int order : {1, 2}) {
    const auto p = make_problem(*askew, loads, order);
    ASSERT_TRUE(p.has_value());
    const auto solved = solve(*p, *cpu, {}, {});
    ASSERT_TRUE(solved.has_value());
    EXPECT_TRUE(solved->converged);
    EXPECT_EQ(solved->iterations, 0);
    EXPECT_EQ(solved->max_displacement_m, 0);
    EXPECT_NEAR(norm(solved->reaction_n - 1000 * a), 0, 1e-9);
  }
}

}  // namespace
}  // namespace tedit::fem
