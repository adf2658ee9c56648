// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/load_cases.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/native/backend.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/residual.hpp"

namespace tedit::fem {
namespace {

using ::testing::HasSubstr;

/// A steel bar along x, clamped at x = 0, pulled at the other end.
load_case bar_case(const std::string& name, vec3 force_n) {
  load_case loads;
  loads.name = name;
  loads.materials = {{"steel", 200e9, 0.3, 7850, 250e6, {}}};
  loads.constraints = {{{1}, fixed{}}};
  loads.loads = {{{2}, force{force_n}}};
  return loads;
}

version_ptr bar() {
  return test::box_mesh({6, 2, 2}, {3, 1, 1});
}

solve_settings to(double tolerance) {
  solve_settings settings;
  settings.tolerance = tolerance;
  return settings;
}

solved_cases solved(const mesh_version& mesh, const std::vector<load_case>& loads, int order,
                    double tolerance = 1e-10) {
  auto set = make_cases(mesh, loads, order);
  EXPECT_TRUE(set.has_value()) << (set ? "" : render(set.error()));
  if (!set)
    return {};
  auto result = solve_cases(*set, *make_native_backend(), to(tolerance), {});
  EXPECT_TRUE(result.has_value()) << (result ? "" : render(result.error()));
  return std::move(result).value_or(solved_cases{});
}

solution solved_alone(const mesh_version& mesh, const load_case& loads, int order,
                      double tolerance = 1e-10) {
  const auto p = make_problem(mesh, loads, order);
  EXPECT_TRUE(p.has_value());
  return solve(*p, *make_native_backend(), to(tolerance), {}).value_or(solution{});
}

double largest(const std::vector<double>& x) {
  double result = 0;
  for (const double v : x)
    result = std::max(result, std::abs(v));
  return result;
}

/// Every displacement of `a` within `relative` of the largest of `b`.
void expect_same(const solution& a, const solution& b, double relative) {
  ASSERT_EQ(a.displacement.size(), b.displacement.size());
  const double scale = largest(b.displacement);
  ASSERT_GT(scale, 0);
  for (std::size_t i = 0; i < a.displacement.size(); ++i)
    ASSERT_NEAR(a.displacement[i], b.displacement[i], relative * scale) << i;
}

class EveryOrder : public ::testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(LoadCases, EveryOrder, ::testing::Values(1, 2));

TEST_P(EveryOrder, UnitLoadsAddUp) {
  const auto result = solved(*bar(),
                             {bar_case("along", {1000, 0, 0}), bar_case("across", {0, 500, 0}),
                              bar_case("both", {1000, 500, 0})},
                             GetParam());

  ASSERT_EQ(result.cases.size(), 3u);
  const auto& both = result.cases[2].displacement;
  for (std::size_t i = 0; i < both.size(); ++i)
    EXPECT_NEAR(result.cases[0].displacement[i] + result.cases[1].displacement[i], both[i],
                1e-8 * largest(both));
  EXPECT_NEAR(result.cases[0].reaction_n.x, -1000, 1e-5);
  EXPECT_NEAR(result.cases[1].reaction_n.y, -500, 1e-5);
  EXPECT_NEAR(result.cases[1].applied_n.x, 0, 1e-9);
}

/// Every way to fill lanes of one, four and eight cases, and more than eight.
TEST_P(EveryOrder, AnyNumberOfCasesIsSolvedAsEachAlone) {
  const auto mesh = bar();
  std::vector<load_case> loads;
  for (int c = 0; c < 9; ++c) {
    const double angle = 0.6 * c;
    loads.push_back(bar_case(std::to_string(c), {(c + 1) * std::cos(angle), std::sin(angle), 1}));
  }
  std::vector<solution> alone;
  for (const auto& one : loads)
    alone.push_back(solved_alone(*mesh, one, GetParam()));

  for (const std::size_t count : {1, 2, 3, 5, 8, 9}) {
    const std::vector<load_case> some(loads.begin(), loads.begin() + static_cast<long>(count));
    const auto result = solved(*mesh, some, GetParam());
    ASSERT_EQ(result.cases.size(), count);
    for (std::size_t c = 0; c < count; ++c) {
      EXPECT_TRUE(result.cases[c].converged);
      expect_same(result.cases[c], alone[c], 1e-8);
      EXPECT_NEAR(result.cases[c].max_von_mises_pa, alone[c].max_von_mises_pa,
                  1e-7 * alone[c].max_von_mises_pa);
    }
  }
}

/// Lanes never meet: exchanging the neighbours changes no bit of a case.
TEST_P(EveryOrder, ACaseHasTheSameBitsBesideOthers) {
  const auto mesh = bar();
  const auto one = bar_case("one", {1, 2, 3});

  const auto first =
    solved(*mesh, {one, bar_case("a", {0, 0, 1}), bar_case("b", {1e6, 0, 0})}, GetParam());
  const auto second =
    solved(*mesh, {bar_case("c", {0, -7, 0}), bar_case("d", {1e-9, 0, 0}), one}, GetParam());

  EXPECT_EQ(first.cases[0].displacement, second.cases[2].displacement);
  EXPECT_EQ(first.cases[0].iterations, second.cases[2].iterations);
}

TEST_P(EveryOrder, RepeatsBitForBit) {
  const auto mesh = test::box_mesh({12, 12, 12}, {4, 1, 1});
  const std::vector<load_case> loads{bar_case("a", {0, 0, 1}), bar_case("b", {1, 0, 0}),
                                     bar_case("c", {0, 1, 1})};

  const auto first = solved(*mesh, loads, GetParam(), 1e-6);
  const auto second = solved(*mesh, loads, GetParam(), 1e-6);

  for (std::size_t c = 0; c < loads.size(); ++c)
    EXPECT_EQ(first.cases[c].displacement, second.cases[c].displacement);
  EXPECT_EQ(first.envelope.von_mises, second.envelope.von_mises);
}

TEST_P(EveryOrder, SupportsMayDiffer) {
  const auto mesh = bar();
  auto pulled_back = bar_case("other end", {0, 0, 0});
  pulled_back.constraints = {{{2}, fixed{}}};
  pulled_back.loads = {{{1}, force{{-1000, 0, 0}}}};
  auto rollers = bar_case("rollers", {1000, 0, 0});
  rollers.constraints = {{{1}, roller{}}, {{3}, roller{}}, {{5}, roller{}}};
  const std::vector<load_case> loads{bar_case("a", {1000, 0, 0}), pulled_back,
                                     bar_case("b", {0, 10, 0}), rollers};

  const auto result = solved(*mesh, loads, GetParam());

  for (std::size_t c = 0; c < loads.size(); ++c)
    expect_same(result.cases[c], solved_alone(*mesh, loads[c], GetParam()), 1e-8);
  // F L / (E A) on rollers.
  EXPECT_NEAR(result.cases[3].max_displacement_at.x, 3, 1e-12);
  EXPECT_NEAR(result.cases[3].compliance_j, 1000 * 1000 * 3 / 200e9, 1e-12);
  // Pulled at one end or at the other is the same, mirrored.
  EXPECT_NEAR(result.cases[0].reaction_n.x, -1000, 1e-5);
  EXPECT_NEAR(result.cases[1].reaction_n.x, 1000, 1e-5);
}

/// Displaced, idle, loaded: each case has its own number of iterations.
TEST_P(EveryOrder, EachCaseTakesItsOwnIterations) {
  const auto mesh = test::box_mesh({24, 3, 3}, {12, 1, 1});
  auto stretched = bar_case("stretched", {});
  stretched.loads.clear();
  stretched.constraints = {{{1}, fixed{}}, {{2}, prescribed_displacement{0, 0, 1e-3}}};
  auto loaded = stretched;
  loaded.name = "loaded";
  loaded.constraints = {{{1}, fixed{}}, {{2}, prescribed_displacement{0, 0, 0}}};
  loaded.loads = {{{4}, pressure{1e5}}};
  auto set = make_cases(*mesh, std::vector{stretched, loaded}, GetParam());
  ASSERT_TRUE(set.has_value());
  auto idle = set->cases[1];
  std::ranges::fill(idle.loads, 0.0);
  set->cases.insert(set->cases.begin() + 1, idle);

  const auto result = *solve_cases(*set, *make_native_backend(), to(1e-8), {});

  // Nothing moves where nothing pulls, beside others that are at work.
  EXPECT_EQ(result.cases[1].iterations, 0);
  EXPECT_EQ(largest(result.cases[1].displacement), 0);
  EXPECT_GT(result.cases[0].iterations, 0);
  EXPECT_NEAR(result.cases[0].max_displacement_m, 1e-3, 1e-9);
  for (const auto& [c, one] : {std::pair<std::size_t, load_case>{0, stretched}, {2, loaded}}) {
    const auto alone = solved_alone(*mesh, one, GetParam(), 1e-8);
    EXPECT_EQ(result.cases[c].iterations, alone.iterations);
    expect_same(result.cases[c], alone, 1e-6);
  }
}

/// A right-hand side that is a number only in name leaves its neighbours alone.
TEST(SolveMany, ACaseThatBreaksDownStaysInItsLanes) {
  const auto p = make_problem(*bar(), bar_case("a", {1, 0, 0}), 1);
  const auto device = make_native_backend();
  const auto system = device->assemble(*p, {});
  const std::vector<double> good = p->loads;
  const std::vector<double> bad(p->dofs(), std::nan(""));
  std::vector<double> x(p->dofs());
  std::vector<double> y(p->dofs());
  std::vector<double> lost(p->dofs());
  const std::vector<inner_case> without{{good, x, 1e-4}, {good, x, 1e-4}};
  const std::vector<inner_case> with{{bad, lost, 1e-4}, {good, y, 1e-4}};

  const auto clean = (*system)->solve_many(without, 100, {});
  const auto mixed = (*system)->solve_many(with, 100, {});

  ASSERT_TRUE(clean.has_value());
  ASSERT_TRUE(mixed.has_value());
  EXPECT_TRUE((*mixed)[0].broke_down);
  EXPECT_FALSE((*mixed)[1].broke_down);
  EXPECT_EQ((*mixed)[1].iterations, (*clean)[1].iterations);
  EXPECT_EQ(x, y);
}

/// Each case may want another reduction, and none gets less than it wants.
TEST(SolveMany, EveryCaseHasItsOwnEnd) {
  const auto p = make_problem(*test::box_mesh({24, 3, 3}, {12, 1, 1}), bar_case("a", {0, 0, 1}), 2);
  const auto device = make_native_backend();
  const auto system = device->assemble(*p, {});
  std::vector<double> x(p->dofs());
  std::vector<double> y(p->dofs());
  const std::vector<inner_case> cases{{p->loads, x, 1e-1}, {p->loads, y, 1e-4}};

  const auto results = (*system)->solve_many(cases, 1000, {});

  ASSERT_TRUE(results.has_value());
  EXPECT_LT((*results)[0].iterations, (*results)[1].iterations);
  EXPECT_LE((*results)[0].recurrence_reduction, 1e-1);
  EXPECT_LE((*results)[1].recurrence_reduction, 1e-4);
}

/// The residual that was asked for is the true one of what comes back, and not much less. (On a
/// slender bar single precision would not get there at once.)
TEST(SolveMany, EndsByTheResidual) {
  const auto p = make_problem(*test::box_mesh({8, 4, 4}, {2, 1, 1}), bar_case("a", {0, 0, 1}), 2);
  const auto device = make_native_backend();
  const auto system = device->assemble(*p, {});
  std::vector<double> x(p->dofs());
  std::vector<double> y(p->dofs());
  inner_case early{p->loads, x, 1e-7};
  early.residual_reduction = 1e-2;
  const std::vector<inner_case> cases{early, {p->loads, y, 1e-7}};

  const auto results = (*system)->solve_many(cases, 1000, {});

  ASSERT_TRUE(results.has_value());
  EXPECT_LT((*results)[0].iterations, (*results)[1].iterations);
  const double left = test::residual_share(*p, x);
  EXPECT_LE(left, 1.01e-2);
  EXPECT_GE(left, 1e-4);
}

// -- what is refused ---------------------------------------------------------------

TEST(LoadCases, ACaseThatIsNotHeldIsNamedBeforeAnythingIsSolved) {
  auto loose = bar_case("loose", {1, 0, 0});
  loose.constraints = {{{1}, roller{}}};

  const auto set = make_cases(*bar(), std::vector{bar_case("held", {1, 0, 0}), loose}, 1);

  ASSERT_FALSE(set.has_value());
  EXPECT_EQ(set.error().code, ec::under_constrained);
  EXPECT_THAT(set.error().message, HasSubstr("load case 'loose': the part is not held"));
}

TEST(LoadCases, TheFirstCaseIsNamedToo) {
  auto lost = bar_case("lost", {1, 0, 0});
  lost.loads = {{{77}, force{{1, 0, 0}}}};

  const auto set = make_cases(*bar(), std::vector{lost, bar_case("held", {1, 0, 0})}, 1);

  ASSERT_FALSE(set.has_value());
  EXPECT_EQ(set.error().code, ec::surface_not_found);
  EXPECT_THAT(set.error().message, HasSubstr("load case 'lost': "));
}

TEST(LoadCases, OtherMaterialsAreRefusedOtherNamesAreNot) {
  auto other = bar_case("soft", {1, 0, 0});
  other.materials[0].name = "the same steel";
  EXPECT_TRUE(make_cases(*bar(), std::vector{bar_case("a", {1, 0, 0}), other}, 1).has_value());

  other.materials[0].young_modulus_pa = 70e9;
  const auto set = make_cases(*bar(), std::vector{bar_case("a", {1, 0, 0}), other}, 1);

  ASSERT_FALSE(set.has_value());
  EXPECT_EQ(set.error().code, ec::invalid_material);
  EXPECT_THAT(set.error().message, HasSubstr("'soft' has other materials than 'a'"));
}

TEST(LoadCases, NoCaseAtAllIsRefused) {
  const auto set = make_cases(*bar(), {}, 1);

  ASSERT_FALSE(set.has_value());
  EXPECT_EQ(set.error().code, ec::invalid_argument);
}

TEST(LoadCases, ACaseThatDoesNotConvergeIsNamed) {
  auto set = make_cases(*bar(), std::vector{bar_case("a", {1, 0, 0}), bar_case("b", {0, 1, 0})}, 1);
  solve_settings settings = to(1e-12);
  settings.max_outer_rounds = 1;

  const auto result = solve_cases(*set, *make_native_backend(), settings, {});

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::not_converged);
  EXPECT_THAT(result.error().message, HasSubstr("load case 'a': "));
}

TEST(LoadCases, CancelIsObeyed) {
  auto set = make_cases(*bar(), std::vector{bar_case("a", {1, 0, 0}), bar_case("b", {0, 1, 0})}, 1);
  execution run;
  run.progress = [&](double, std::string_view stage) {
    if (stage == "recovering stresses")
      run.cancel.cancel();
  };

  const auto result = solve_cases(*set, *make_native_backend(), {}, run);

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::cancelled);
  // The set is as it was, and can be solved again.
  EXPECT_TRUE(solve_cases(*set, *make_native_backend(), {}, {}).has_value());
}

// -- the envelope ------------------------------------------------------------------

TEST(Envelope, TakesTheWorstOfEachNode) {
  solution a;
  a.von_mises = {1, 5, 3};
  a.safety_factor = {100, 20, 0};
  a.max_von_mises_pa = 5;
  a.max_von_mises_at = {1, 0, 0};
  a.max_displacement_m = 0.25;
  a.max_displacement_at = {7, 0, 0};
  a.min_safety_factor = 20;
  a.min_safety_factor_at = {1, 0, 0};
  solution b;
  b.von_mises = {2, 4, 3};
  b.safety_factor = {50, 25, 0};
  b.max_von_mises_pa = 4;
  b.max_displacement_m = 0.3;
  b.max_displacement_at = {8, 0, 0};
  b.min_safety_factor = 25;
  solution c;
  c.von_mises = {0, 6, 1};
  c.safety_factor = {60, 10, 0};
  c.max_von_mises_pa = 6;
  c.max_von_mises_at = {2, 0, 0};
  c.min_safety_factor = 10;
  c.min_safety_factor_at = {2, 0, 0};

  const auto worst = make_envelope(std::vector{a, b, c});

  EXPECT_EQ(worst.von_mises, (std::vector<double>{2, 6, 3}));
  EXPECT_EQ(worst.von_mises_case, (std::vector<std::uint32_t>{1, 2, 0}));
  EXPECT_EQ(worst.safety_factor, (std::vector<double>{50, 10, 0}));
  EXPECT_EQ(worst.safety_factor_case, (std::vector<std::uint32_t>{1, 2, 0}));
  EXPECT_EQ(worst.max_von_mises.value, 6);
  EXPECT_EQ(worst.max_von_mises.of, 2u);
  EXPECT_EQ(worst.max_von_mises.at, (vec3{2, 0, 0}));
  EXPECT_EQ(worst.max_displacement.value, 0.3);
  EXPECT_EQ(worst.max_displacement.of, 1u);
  EXPECT_EQ(worst.max_displacement.at, (vec3{8, 0, 0}));
  EXPECT_EQ(worst.min_safety_factor.value, 10);
  EXPECT_EQ(worst.min_safety_factor.of, 2u);
}

/// Two loads, one twice the other: everything is the larger one's, by exactly a half.
TEST(Envelope, OfABarIsTheLargerLoads) {
  const auto result =
    solved(*bar(), {bar_case("small", {1e6, 0, 0}), bar_case("large", {2e6, 0, 0})}, 2);

  const auto& worst = result.envelope;
  EXPECT_EQ(worst.von_mises, result.cases[1].von_mises);
  EXPECT_EQ(worst.von_mises_case, std::vector<std::uint32_t>(worst.von_mises.size(), 1));
  EXPECT_EQ(worst.safety_factor, result.cases[1].safety_factor);
  EXPECT_EQ(worst.min_safety_factor.of, 1u);
  EXPECT_NEAR(result.cases[0].min_safety_factor, 2 * worst.min_safety_factor.value, 1e-6);
}

// -- real parts --------------------------------------------------------------------

class RealParts : public ::testing::TestWithParam<std::tuple<const char*, int>> {};

INSTANTIATE_TEST_SUITE_P(LoadCases, RealParts,
                         ::testing::Combine(::testing::Values("ctc01_plate", "fork_thin"),
                                            ::testing::Values(1, 2)));

/// Every load of the part's own case turned and doubled.
load_case turned(load_case loads) {
  loads.name = "turned";
  for (auto& one : loads.loads) {
    if (auto* f = std::get_if<force>(&one.kind))
      f->total_n = {2 * f->total_n.y, 2 * f->total_n.z, 2 * f->total_n.x};
    else if (auto* p = std::get_if<pressure>(&one.kind))
      p->pa *= -2;
    else if (auto* t = std::get_if<traction>(&one.kind))
      t->pa = {2 * t->pa.y, 2 * t->pa.z, 2 * t->pa.x};
    else if (auto* g = std::get_if<gravity>(&one.kind))
      g->m_s2 = {2 * g->m_s2.y, 2 * g->m_s2.z, 2 * g->m_s2.x};
  }
  return loads;
}

TEST_P(RealParts, ManyEqualOneByOne) {
  const auto [name, order] = GetParam();
  const auto folder = std::filesystem::path(TEDIT_TEST_DATA "/parts") / name;
  const auto mesh = import_mesh(folder / (std::string(name) + ".coarse.msh"), "mm");
  const auto own = protocol::load_case_from_file(folder / "load_case.json");
  ASSERT_TRUE(mesh.has_value());
  ASSERT_TRUE(own.has_value());
  const std::vector<load_case> loads{*own, turned(*own)};

  const auto result = solved(*mesh->version, loads, order, 1e-9);

  ASSERT_EQ(result.cases.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    const auto alone = solved_alone(*mesh->version, loads[c], order, 1e-9);
    expect_same(result.cases[c], alone, 1e-6);
    EXPECT_NEAR(result.cases[c].compliance_j, alone.compliance_j, 1e-7 * alone.compliance_j);
    EXPECT_NEAR(result.cases[c].iterations, alone.iterations, 2);
  }
}

TEST(Conditions, BringTheWarningsOfTheirLoadCaseEachOnce) {
  auto loads = bar_case("warned", {1, 0, 0});
  loads.constraints.front().warning = "look at the support";
  loads.loads.front().warning = "look at the load";
  loads.loads.push_back(loads.loads.front());

  const auto set = make_cases(*bar(), std::array{loads});

  ASSERT_TRUE(set.has_value()) << render(set.error());
  EXPECT_EQ(set->cases.front().warnings,
            (std::vector<std::string>{"look at the support", "look at the load"}));
}

}  // namespace
}  // namespace tedit::fem
