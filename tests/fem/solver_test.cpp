// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/solver.hpp"
#include "fem/recovery.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fem/native/backend.hpp"
#include "tests/fem/quadrature.hpp"

namespace tedit::fem {
namespace {

using test::patch_field;

load_case one_material(double e, double nu) {
  load_case loads;
  loads.materials = {{"test", e, nu, 1000, 0, {}}};
  return loads;
}

solution solved(const problem& p, double tolerance = 1e-10) {
  const auto device = make_native_backend();
  solve_settings settings;
  settings.tolerance = tolerance;
  auto result = solve(p, *device, settings, {});
  EXPECT_TRUE(result.has_value()) << (result ? "" : render(result.error()));
  return result.value_or(solution{});
}

/// A point of a unit box, moved inside so that no two tets are alike.
vec3 shaken(vec3 p) {
  const double s = 0.07 * std::sin(std::numbers::pi * p.x) * std::sin(std::numbers::pi * p.y) *
                   std::sin(std::numbers::pi * p.z);
  return p + s * vec3{std::sin(7 * p.y), std::cos(5 * p.z), std::sin(3 * p.x + 1)};
}

problem patch_problem() {
  auto loads = one_material(1e6, 0.25);
  loads.constraints = {{{1, 2, 3, 4, 5, 6}, fixed{}}};
  loads.loads = {{{2}, force{{1, 0, 0}}}};
  auto p = *make_problem(*test::box_mesh({4, 4, 4}, {1, 1, 1}, shaken), loads);
  std::ranges::fill(p.loads, 0.0);
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const auto u = patch_field(p.nodes[n]);
    if (p.filter[n][0] == 0) {
      p.prescribed[3 * n] = u.x;
      p.prescribed[3 * n + 1] = u.y;
      p.prescribed[3 * n + 2] = u.z;
    }
  }
  return p;
}

TEST(PatchTest, ConstantStrainIsExact) {
  const auto p = patch_problem();

  const auto result = solved(p, 1e-14);

  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const auto u = patch_field(p.nodes[n]);
    EXPECT_NEAR(result.displacement[3 * n], u.x, 1e-12 * 2e-3);
    EXPECT_NEAR(result.displacement[3 * n + 2], u.z, 1e-12 * 2e-3);
  }
  // E = 1e6, nu = .25, all strains 1e-3: normal stresses 2000, shear stresses 400 (engineering
  // strain 1e-3).
  for (std::size_t e = 0; e < p.element_count(); ++e)
    for (int c = 0; c < 6; ++c)
      EXPECT_NEAR(element_stress(p, result.displacement, e)[c], c < 3 ? 2000 : 400, 1e-7);
}

TEST(Solver, UniaxialTensionMatchesHooke) {
  auto loads = one_material(200e9, 0.3);
  loads.constraints = {{{1}, roller{}}, {{3}, roller{}}, {{5}, roller{}}};
  loads.loads = {{{2}, force{{1e6, 0, 0}}}};
  const auto p = make_problem(*test::box_mesh({6, 2, 2}, {3, 1, 1}), loads);
  ASSERT_TRUE(p.has_value());

  const auto result = solved(*p);

  // F L / (E A) = 1e6 * 3 / 200e9, lateral -nu F / (E A) per unit width.
  for (std::size_t n = 0; n < p->node_count(); ++n) {
    EXPECT_NEAR(result.displacement[3 * n], 5e-6 * p->nodes[n].x, 1e-13);
    EXPECT_NEAR(result.displacement[3 * n + 1], -1.5e-6 * p->nodes[n].y, 1e-13);
  }
  EXPECT_NEAR(result.max_von_mises_pa, 1e6, 1e-2);
  EXPECT_NEAR(result.reaction_n.x, -1e6, 1e-2);
  EXPECT_NEAR(result.compliance_j, 1e6 * 1.5e-5, 1e-8);
}

TEST(Solver, PrescribedDisplacementStretchesWithoutLoad) {
  auto loads = one_material(200e9, 0.3);
  loads.constraints = {{{1}, roller{}},
                       {{3}, roller{}},
                       {{5}, roller{}},
                       {{2}, prescribed_displacement{3e-3, {}, {}}}};
  const auto p = make_problem(*test::box_mesh({3, 1, 1}, {3, 1, 1}), loads);
  ASSERT_TRUE(p.has_value());

  const auto result = solved(*p);

  EXPECT_NEAR(result.max_von_mises_pa, 200e9 * 1e-3, 1);
}

TEST(Solver, RigidMotionGivesNoStress) {
  const auto p = patch_problem();
  const auto device = make_native_backend();
  const auto system = device->assemble(p, {});
  std::vector<double> u(p.dofs());
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const vec3 turned = vec3{5, -3, 2} + cross({0.1, 0.2, -0.3}, p.nodes[n]);
    u[3 * n] = turned.x;
    u[3 * n + 1] = turned.y;
    u[3 * n + 2] = turned.z;
  }
  std::vector<double> force(p.dofs());

  ASSERT_TRUE((*system)->multiply(u, force).has_value());

  // Forces of a stretch by as much would be about 1e6; single precision keeps 7 digits.
  for (const double f : force)
    EXPECT_NEAR(f, 0, 1);
  for (std::size_t e = 0; e < p.element_count(); ++e)
    for (const double s : element_stress(p, u, e))
      EXPECT_NEAR(s, 0, 1e-7);
}

TEST(Solver, MatrixAndElementsAgree) {
  const auto p = patch_problem();
  const auto device = make_native_backend();
  const auto system = device->assemble(p, {});
  std::vector<double> u(p.dofs());
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = std::sin(1.0 + 3.7 * static_cast<double>(i));
  std::vector<double> by_matrix(p.dofs());
  std::vector<double> minus(p.dofs());

  ASSERT_TRUE((*system)->multiply(u, by_matrix).has_value());
  residual(p, u, minus);  // loads are zero

  for (std::size_t i = 0; i < u.size(); ++i)
    EXPECT_NEAR(by_matrix[i], -minus[i], 2e-6 * 1e6);
}

TEST(Solver, RepeatsBitForBit) {
  auto loads = one_material(200e9, 0.3);
  loads.constraints = {{{1}, fixed{}}};
  loads.loads = {{{2}, force{{0, 0, -1}}}};
  const auto p = make_problem(*test::box_mesh({20, 14, 14}, {4, 1, 1}), loads);

  const auto first = solved(*p, 1e-6);
  const auto second = solved(*p, 1e-6);

  EXPECT_EQ(first.displacement, second.displacement);
  EXPECT_EQ(first.iterations, second.iterations);
}

TEST(Solver, LinearTetsApproachTheCantileverFromBelow) {
  double last = 0;
  for (const int n : {2, 4, 8}) {
    auto loads = one_material(210e3, 0.3);
    loads.constraints = {{{1}, fixed{}}};
    loads.loads = {{{2}, traction{{0, 0, 1000}}}};
    const auto p = make_problem(*test::box_mesh({10 * n, n, n}, {10, 1, 1}), loads);
    const auto tip = solved(*p, 1e-8).max_displacement_m;
    EXPECT_GT(tip, last);
    EXPECT_LT(tip, 19.2);  // Timoshenko: 19.193
    last = tip;
  }
  EXPECT_GT(last, 15);
}

TEST(Solver, ScalesAndShiftsDoNotChangeTheAnswer) {
  const auto compliance = [](double scale, vec3 shift) {
    auto loads = one_material(70e9, 0.33);
    loads.constraints = {{{1}, fixed{}}};
    loads.loads = {{{2}, force{{10, 20, 30}}}};
    const auto mesh =
      test::box_mesh({6, 3, 3}, {2, 1, 1}, [&](vec3 p) { return scale * p + shift; });
    return solved(*make_problem(*mesh, loads), 1e-9).compliance_j * scale;
  };
  const double reference = compliance(1, {});

  EXPECT_NEAR(compliance(1e-3, {}), reference, 1e-8 * reference);
  EXPECT_NEAR(compliance(1, {1e4, -1e4, 1e4}), reference, 1e-6 * reference);
}

TEST(Solver, CancelIsObeyed) {
  const auto p = patch_problem();
  execution run;
  run.cancel.cancel();

  const auto result = solve(p, *make_native_backend(), {}, run);

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::cancelled);
}

/// However they came into a problem: what is no finite number has no solution, least of all zero.
TEST(Solver, LoadsThatAreNoFiniteNumbersAreRefused) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e200}) {
    auto p = patch_problem();
    std::ranges::fill(p.prescribed, 0.0);
    const auto free = std::ranges::find(p.filter, std::array<double, 6>{1, 0, 0, 1, 0, 1});
    p.loads[3 * static_cast<std::size_t>(free - p.filter.begin()) + 2] = bad;

    const auto result = solve(p, *make_native_backend(), {}, {});

    ASSERT_FALSE(result.has_value()) << bad;
    EXPECT_EQ(result.error().code, ec::invalid_load);
  }
}

TEST(Solver, AResultThatSinglePrecisionCannotHoldIsRefused) {
  auto loads = one_material(1e-9, 0.3);
  loads.constraints = {{{1}, fixed{}}};
  loads.loads = {{{2}, force{{0, 0, 1e30}}}};
  const auto p = *make_problem(*test::box_mesh({4, 2, 2}, {1, 1, 1}), loads);

  const auto result = solve(p, *make_native_backend(), {}, {});

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::invalid_load);
  EXPECT_NE(result.error().message.find("beyond what a number can hold"), std::string::npos);
}

TEST(Devices, AnUnknownNameListsTheKnownOnes) {
  const auto device = open_backend("no such device");

  ASSERT_FALSE(device.has_value());
  EXPECT_EQ(device.error().code, ec::device_unavailable);
  EXPECT_NE(device.error().remedy.find("cpu"), std::string::npos);
}

}  // namespace
}  // namespace tedit::fem
