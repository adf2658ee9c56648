// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/solve_session.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "fem/native/backend.hpp"
#include "tests/support/edits.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

load_case cantilever(vec3 tip_n) {
  load_case loads;
  loads.materials = {{"steel", 210e9, 0.3, 7850, 0, {}}};
  loads.constraints = {{{1}, fixed{}}};
  loads.loads = {{{2}, force{tip_n}}};
  return loads;
}

solve_session::result value(expected<solve_session::result> result) {
  EXPECT_TRUE(result.has_value()) << (result ? "" : render(result.error()));
  return result ? std::move(*result) : solve_session::result{};
}

class SolveSession : public testing::Test {
protected:
  solve_session::result solve(const version_ptr& mesh, const load_case& loads) {
    return value(session_.solve(mesh, loads, 2, *device_, {}, {}));
  }

  /// The same without any history.
  solution fresh(const version_ptr& mesh, const load_case& loads) {
    return value(solve_session().solve(mesh, loads, 2, *device_, {}, {})).solution;
  }

  std::unique_ptr<backend> device_ = make_native_backend();
  solve_session session_;
  version_ptr bar_ = test::box_mesh({12, 3, 3}, {4, 1, 1});
};

TEST_F(SolveSession, NewLoadsDoNotAssembleAgain) {
  const auto first = solve(bar_, cantilever({0, 0, -1000}));
  const auto second = solve(bar_, cantilever({0, 500, 0}));

  EXPECT_TRUE(first.assembled);
  EXPECT_FALSE(second.assembled);
  EXPECT_NEAR(second.solution.compliance_j, fresh(bar_, cantilever({0, 500, 0})).compliance_j,
              1e-6 * second.solution.compliance_j);
}

TEST_F(SolveSession, NewConstraintsDoNotAssembleAgain) {
  auto turned = cantilever({0, 0, -1000});
  turned.constraints = {{{2}, fixed{}}, {{3}, roller{}}};
  turned.loads = {{{1}, force{{0, 0, -1000}}}};
  solve(bar_, cantilever({0, 0, -1000}));

  const auto second = solve(bar_, turned);

  EXPECT_FALSE(second.assembled);
  const auto expected = fresh(bar_, turned);
  EXPECT_NEAR(second.solution.compliance_j, expected.compliance_j, 1e-6 * expected.compliance_j);
  EXPECT_EQ(second.solution.surface_reactions.size(), expected.surface_reactions.size());
}

TEST_F(SolveSession, AnotherMaterialAssembles) {
  auto soft = cantilever({0, 0, -1000});
  soft.materials[0].young_modulus_pa = 70e9;
  const auto steel = solve(bar_, cantilever({0, 0, -1000}));

  const auto second = solve(bar_, soft);

  EXPECT_TRUE(second.assembled);
  EXPECT_NEAR(second.solution.compliance_j, 3 * steel.solution.compliance_j,
              1e-5 * second.solution.compliance_j);
}

TEST_F(SolveSession, TheSameAgainTakesNoIteration) {
  solve(bar_, cantilever({0, 0, -1000}));

  const auto second = solve(bar_, cantilever({0, 0, -2000}));

  // Twice the load: the last displacement, scaled, is the answer.
  EXPECT_EQ(second.solution.iterations, 0);
  EXPECT_TRUE(second.solution.converged);
}

TEST_F(SolveSession, RefusedLoadsLeaveTheSessionUsable) {
  auto wrong = cantilever({0, 0, -1000});
  wrong.loads = {{{99}, force{{0, 0, -1000}}}};
  solve(bar_, cantilever({0, 0, -1000}));

  const auto refused = session_.solve(bar_, wrong, 2, *device_, {}, {});
  const auto after = solve(bar_, cantilever({0, 500, 0}));

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::surface_not_found);
  EXPECT_TRUE(after.solution.converged);
}

TEST_F(SolveSession, AnotherMeshStartsFromTheOldField) {
  const auto loads = cantilever({0, 0, -1000});
  solve(bar_, loads);
  const auto moved = test::box_mesh({12, 3, 3}, {4, 1, 1}, [](vec3 p) {
    return p.x > 3 ? p + vec3{0, 0, 0.02 * (p.x - 3)} : p;
  });

  const auto warm = solve(moved, loads);
  const auto cold = fresh(moved, loads);

  EXPECT_TRUE(warm.assembled);
  EXPECT_LE(warm.solution.iterations, cold.iterations);
  EXPECT_NEAR(warm.solution.compliance_j, cold.compliance_j, 1e-6 * cold.compliance_j);
}

/// Follows edits with one session, and solves each version anew beside it.
class FollowedEdits : public testing::TestWithParam<int> {
protected:
  void expect_follows(const version_ptr& next, const load_case& loads) {
    ASSERT_TRUE(next);
    const auto kept = value(session_.solve(next, loads, GetParam(), *device_, {}, {}));
    const auto fresh = value(solve_session().solve(next, loads, GetParam(), *device_, {}, {}));
    const auto& a = kept.solution;
    const auto& b = fresh.solution;
    EXPECT_FALSE(kept.assembled);
    EXPECT_GT(kept.renewed_rows, 0u);
    EXPECT_TRUE(a.converged);
    EXPECT_LE(a.iterations, b.iterations + 4);
    EXPECT_NEAR(a.compliance_j, b.compliance_j, 1e-5 * b.compliance_j);
    EXPECT_NEAR(a.max_displacement_m, b.max_displacement_m, 1e-5 * b.max_displacement_m);
    EXPECT_NEAR(a.max_von_mises_pa, b.max_von_mises_pa, 1e-4 * b.max_von_mises_pa);
    EXPECT_NEAR(a.strain_energy_j, b.strain_energy_j, 1e-5 * b.strain_energy_j);
    EXPECT_NEAR(a.relative_error, b.relative_error, 1e-4);
    EXPECT_NEAR(norm(a.reaction_n + a.applied_n), 0, 1e-5 * norm(a.applied_n));
    mesh_ = next;
  }

  std::unique_ptr<backend> device_ = make_native_backend();
  solve_session session_;
  version_ptr mesh_ = test::box_mesh({32, 8, 8}, {4, 1, 1});
};

INSTANTIATE_TEST_SUITE_P(Orders, FollowedEdits, testing::Values(1, 2));

TEST_P(FollowedEdits, CostTheirRowsAndGiveTheSameAnswer) {
  const auto loads = cantilever({0, 0, -1000});
  value(session_.solve(mesh_, loads, GetParam(), *device_, {}, {}));
  for (int round = 0; round < 3; ++round) {
    const double at = 0.7 + round;
    expect_follows(test::split(mesh_, [&](tet_id t) { return t % 2503 == 17u * round; }), loads);
    expect_follows(test::dig(
                     mesh_,
                     [&](vec3 x) {
                       return norm(x - vec3{at, .5, 1}) < 0.2;
                     },
                     7),
                   loads);
    expect_follows(test::move(mesh_,
                              [&](vec3 x) {
                                return norm(x - vec3{at, .5, .5}) < 0.2 ? x + vec3{0, .01, .01} : x;
                              }),
                   loads);
  }
}

TEST_P(FollowedEdits, SliversThatAnEditMakesAreClusteredTogether) {
  const auto loads = cantilever({0, 0, -1000});
  value(session_.solve(mesh_, loads, GetParam(), *device_, {}, {}));
  // A grid plane that nearly meets the next one: tets of 1/50 of their height, and back again.
  const auto squeeze = [](vec3 x) {
    return norm(x - vec3{2, .5, .5}) < 0.2 && std::abs(x.x - 2) < 1e-9 ? x + vec3{.1225, 0, 0} : x;
  };
  expect_follows(test::move(mesh_, squeeze), loads);
  expect_follows(test::move(mesh_,
                            [](vec3 x) {
                              return std::abs(x.x - 2.1225) < 1e-9 ? x - vec3{.1225, 0, 0} : x;
                            }),
                 loads);
}

TEST_P(FollowedEdits, OtherLoadsAndSupportsMayComeWithTheEdit) {
  value(session_.solve(mesh_, cantilever({0, 0, -1000}), GetParam(), *device_, {}, {}));
  auto turned = cantilever({0, 0, -1000});
  turned.constraints = {{{2}, fixed{}}, {{3}, roller{}}};
  turned.loads = {{{1}, force{{0, 0, -1000}}}};
  expect_follows(test::split(mesh_, [](tet_id t) { return t == 900; }), turned);
}

TEST_P(FollowedEdits, APartCutThroughIsRefusedAndTheNextVersionSolved) {
  const auto loads = cantilever({0, 0, -1000});
  const auto thin = test::dig(
    mesh_, [](vec3 x) { return x.x > 2 && x.x < 2.125 && x.z > .125; }, 7);
  ASSERT_TRUE(thin);
  value(session_.solve(thin, loads, GetParam(), *device_, {}, {}));
  const auto cut = test::dig(
    thin, [](vec3 x) { return x.x > 2 && x.x < 2.125; }, 7);
  ASSERT_TRUE(cut);
  const auto refused = session_.solve(cut, loads, GetParam(), *device_, {}, {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::under_constrained);
  const auto after = value(session_.solve(thin, loads, GetParam(), *device_, {}, {}));
  EXPECT_TRUE(after.solution.converged);
  EXPECT_TRUE(after.assembled);
}

/// Several load cases: two with the same supports, one with others, as `solve_cases` answers them.
class FollowedCases : public testing::TestWithParam<int> {
protected:
  static load_case named(const std::string& name, load_case loads) {
    loads.name = name;
    loads.materials[0].yield_strength_pa = 250e6;
    return loads;
  }

  static load_case turned(const std::string& name) {
    auto loads = cantilever({});
    loads.constraints = {{{2}, fixed{}}, {{3}, roller{}}};
    loads.loads = {{{1}, force{{300, 0, -1000}}}};
    return named(name, loads);
  }

  static solve_settings exact() {
    solve_settings settings;
    settings.tolerance = 1e-9;
    return settings;
  }

  solve_session::cases_result solve(const version_ptr& mesh, const std::vector<load_case>& loads) {
    auto result = session_.solve(mesh, loads, GetParam(), *device_, exact(), {});
    EXPECT_TRUE(result.has_value()) << (result ? "" : render(result.error()));
    return result ? std::move(*result) : solve_session::cases_result{};
  }

  /// All values of `kept` against a solve without any history.
  void expect_as_cold(const version_ptr& mesh, const std::vector<load_case>& loads,
                      const solved_cases& kept) {
    auto set = make_cases(*mesh, loads, GetParam());
    ASSERT_TRUE(set.has_value());
    const auto cold = solve_cases(*set, *device_, exact(), {});
    ASSERT_TRUE(cold.has_value());
    ASSERT_EQ(kept.cases.size(), loads.size());
    for (std::size_t c = 0; c < loads.size(); ++c) {
      const auto& a = kept.cases[c];
      const auto& b = cold->cases[c];
      EXPECT_TRUE(a.converged);
      EXPECT_NEAR(a.compliance_j, b.compliance_j, 1e-7 * b.compliance_j) << c;
      EXPECT_NEAR(a.max_displacement_m, b.max_displacement_m, 1e-7 * b.max_displacement_m) << c;
      EXPECT_NEAR(a.max_von_mises_pa, b.max_von_mises_pa, 1e-6 * b.max_von_mises_pa) << c;
      EXPECT_NEAR(norm(a.reaction_n - b.reaction_n), 0, 1e-6 * norm(b.applied_n)) << c;
      EXPECT_EQ(a.surface_reactions.size(), b.surface_reactions.size()) << c;
    }
    if (loads.size() == 1)
      return;
    const auto& worst = kept.envelope;
    EXPECT_EQ(worst.max_von_mises.of, cold->envelope.max_von_mises.of);
    EXPECT_EQ(worst.max_von_mises.value, kept.cases[worst.max_von_mises.of].max_von_mises_pa);
    EXPECT_NEAR(worst.min_safety_factor.value, cold->envelope.min_safety_factor.value,
                1e-6 * cold->envelope.min_safety_factor.value);
  }

  std::unique_ptr<backend> device_ = make_native_backend();
  solve_session session_;
  version_ptr mesh_ = test::box_mesh({16, 4, 4}, {4, 1, 1});
  std::vector<load_case> loads_{named("down", cantilever({0, 0, -1000})), turned("turned"),
                                named("side", cantilever({0, 500, 0}))};
};

INSTANTIATE_TEST_SUITE_P(Orders, FollowedCases, testing::Values(1, 2));

TEST_P(FollowedCases, AreAllSolvedAgainAfterEachEdit) {
  expect_as_cold(mesh_, loads_, solve(mesh_, loads_).solved);
  // The edit reaches the surface that the one case holds and the others load.
  for (const double at : {0.1, 2.1}) {
    mesh_ = test::dig(
      mesh_,
      [&](vec3 x) {
        return norm(x - vec3{at, .5, 1}) < 0.3;
      },
      7);
    ASSERT_TRUE(mesh_);
    const auto kept = solve(mesh_, loads_);
    EXPECT_FALSE(kept.assembled);
    EXPECT_GT(kept.renewed_rows, 0u);
    expect_as_cold(mesh_, loads_, kept.solved);
  }
}

TEST_P(FollowedCases, ComeAndGoWithoutAssembling) {
  solve(mesh_, loads_);
  const std::vector<std::vector<load_case>> lists{
    {loads_[2]}, {loads_[1], loads_[0]}, {turned("new"), loads_[2], loads_[0]}};
  for (const auto& loads : lists) {
    const auto kept = solve(mesh_, loads);
    EXPECT_FALSE(kept.assembled);
    expect_as_cold(mesh_, loads, kept.solved);
    mesh_ = test::split(mesh_, [&](tet_id t) { return t == 100 * loads.size(); });
    const auto after = solve(mesh_, {loads_[1]});
    EXPECT_FALSE(after.assembled);
    expect_as_cold(mesh_, {loads_[1]}, after.solved);
  }
}

TEST_P(FollowedCases, EachStartsFromItsOwnDisplacement) {
  solve(mesh_, loads_);
  auto doubled = loads_;
  doubled[0].loads = {{{2}, force{{0, 0, -2000}}}};
  std::ranges::rotate(doubled, doubled.begin() + 1);

  const auto again = solve(mesh_, doubled);

  for (const auto& one : again.solved.cases)
    EXPECT_EQ(one.iterations, 0);
}

TEST_P(FollowedCases, AOneThatIsNotHeldAfterAnEditIsNamed) {
  solve(mesh_, loads_);
  auto loose = loads_;
  loose[1].constraints = {{{3}, roller{}}};
  const auto edited = test::split(mesh_, [](tet_id t) { return t == 500; });

  for (const auto& mesh : {mesh_, edited}) {
    const auto refused = session_.solve(mesh, loose, GetParam(), *device_, {}, {});
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ec::under_constrained);
    EXPECT_EQ(refused.error().message.rfind("load case 'turned': the part is not held", 0), 0u)
      << refused.error().message;
    expect_as_cold(mesh, loads_, solve(mesh, loads_).solved);
  }
}

TEST_P(FollowedCases, OfOtherMaterialsAreRefusedAndTheSystemStays) {
  solve(mesh_, loads_);
  auto mixed = loads_;
  mixed[2].materials[0].young_modulus_pa = 70e9;

  const auto refused = session_.solve(mesh_, mixed, GetParam(), *device_, {}, {});

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::invalid_material);
  EXPECT_FALSE(solve(mesh_, loads_).assembled);
  EXPECT_FALSE(session_.solve(mesh_, std::vector<load_case>{}, 2, *device_, {}, {}).has_value());
}

TEST_P(FollowedCases, SurviveACancelAtAnyPoint) {
  const auto mesh = test::box_mesh({6, 2, 2}, {4, 1, 1});
  execution whole;
  ASSERT_TRUE(solve_session().solve(mesh, loads_, GetParam(), *device_, exact(), whole));
  for (std::uint64_t poll = 1; poll <= whole.cancel.polls(); poll += 1 + poll / 10) {
    execution run;
    run.cancel = cancel_token::at_poll(poll);
    const auto result = session_.solve(mesh, loads_, GetParam(), *device_, exact(), run);
    ASSERT_TRUE(result || result.error().code == ec::cancelled) << render(result.error());
  }
  expect_as_cold(mesh, loads_, solve(mesh, loads_).solved);
}

TEST_P(FollowedCases, OneOfThemIsSolvedAsItAlwaysWas) {
  const auto p = make_problem(*mesh_, loads_[1], GetParam());
  std::vector<int> rounds;
  const auto alone = fem::solve(
    *p, *device_, {}, {}, [&](const solve_frame& frame) { rounds.push_back(frame.iterations); });
  std::vector<int> kept_rounds;
  const auto count = [&](const solve_frame& frame) { kept_rounds.push_back(frame.iterations); };

  const auto kept = session_.solve(mesh_, loads_[1], GetParam(), *device_, {}, {}, count);

  ASSERT_TRUE(alone && kept);
  EXPECT_EQ(kept->solution.iterations, alone->iterations);
  EXPECT_EQ(kept_rounds, rounds);
  EXPECT_NEAR(kept->solution.compliance_j, alone->compliance_j, 1e-6 * alone->compliance_j);
}

TEST_P(FollowedCases, ShowAFirstFieldOfAllWhenTheyShareTheirSupports) {
  const std::vector<load_case> together{loads_[0], loads_[2]};
  std::vector<std::vector<solution>> seen;
  int rounds = 0;
  const auto look = [&](const cases_frame& frame) {
    ++rounds;
    if (frame.recover)
      if (auto now = frame.recover())
        seen.push_back(std::move(*now));
  };
  const auto last = session_.solve(mesh_, together, GetParam(), *device_, {}, {}, look);
  ASSERT_TRUE(last.has_value());
  ASSERT_FALSE(seen.empty());
  ASSERT_EQ(seen.front().size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    const auto& end = last->solved.cases[c];
    EXPECT_TRUE(seen.front()[c].preview());
    EXPECT_LT(seen.front()[c].iterations, end.iterations);
    EXPECT_NEAR(seen.front()[c].compliance_j, end.compliance_j, 1e-3 * end.compliance_j);
  }
  seen.clear();
  rounds = 0;
  ASSERT_TRUE(session_.solve(mesh_, loads_, GetParam(), *device_, exact(), {}, look).has_value());
  EXPECT_GT(rounds, 0);
  EXPECT_TRUE(seen.empty());
}

TEST(CarryOver, KeepsWhatIsTheSameAndFillsWhatIsNew) {
  const auto loads = cantilever({0, 0, -1000});
  const auto from = *make_problem(*test::box_mesh({4, 2, 2}, {4, 1, 1}), loads, 2);
  const auto to = *make_problem(*test::box_mesh({4, 2, 2}, {4, 1, 1},
                                                [](vec3 p) {
                                                  return p.x > 3.5 ? p + vec3{1, 0, 0} : p;
                                                }),
                                loads, 2);
  std::vector<double> u(from.dofs());
  for (std::size_t n = 0; n < from.node_count(); ++n)
    u[3 * n] = 1 + from.nodes[n].x;

  const auto carried = carry_over(from, u, to);

  for (std::size_t n = 0; n < to.node_count(); ++n) {
    if (to.nodes[n].x <= 3)
      EXPECT_DOUBLE_EQ(carried[3 * n], 1 + to.nodes[n].x);
    else  // Moved points: the mean of neighbours at x = 3.
      EXPECT_NEAR(carried[3 * n], 4, 1e-12);
  }
}

TEST(Frames, ComeBeforeTheEndWithAFieldNearIt) {
  const auto p =
    *make_problem(*test::box_mesh({20, 5, 5}, {4, 1, 1}), cantilever({0, 0, -1000}), 2);
  const auto device = make_native_backend();
  std::vector<solution> seen;

  const auto last = solve(p, *device, {}, {}, [&](const solve_frame& frame) {
    if (auto now = frame.recover())
      seen.push_back(std::move(*now));
  });

  ASSERT_TRUE(last.has_value());
  ASSERT_FALSE(seen.empty());
  EXPECT_TRUE(seen.front().preview());
  EXPECT_FALSE(last->preview());
  EXPECT_LE(seen.front().energy_error, 1e-2);
  // Energy error squared is the relative error of the compliance.
  EXPECT_NEAR(seen.front().compliance_j, last->compliance_j, 1e-3 * last->compliance_j);
}

TEST(EnergyTolerance, EndsEarlyAndSaysSo) {
  const auto p =
    *make_problem(*test::box_mesh({20, 5, 5}, {4, 1, 1}), cantilever({0, 0, -1000}), 2);
  const auto device = make_native_backend();
  solve_settings rough;
  rough.energy_tolerance = 1e-3;

  const auto quick = solve(p, *device, rough, {});
  const auto exact = solve(p, *device, {}, {});

  ASSERT_TRUE(quick && exact);
  EXPECT_FALSE(quick->converged);
  EXPECT_LT(quick->iterations, exact->iterations);
  EXPECT_NEAR(quick->compliance_j, exact->compliance_j, 1e-5 * exact->compliance_j);
}

/// The first field after other loads starts near the old one, with an error that r.Br hardly sees.
TEST(EnergyTolerance, HoldsFromAWarmStart) {
  const auto mesh = test::box_mesh({40, 4, 4}, {10, 1, 1});
  const auto device = make_native_backend();
  solve_session session;
  solve_settings rough;
  rough.energy_tolerance = 1e-2;
  auto other = cantilever({0, 0, -1000});
  other.loads.push_back({{2}, force{{0, 30, 0}}});
  ASSERT_TRUE(session.solve(mesh, cantilever({0, 0, -1000}), 2, *device, {}, {}).has_value());

  const auto quick = session.solve(mesh, other, 2, *device, rough, {});
  const auto exact = session.solve(mesh, other, 2, *device, {}, {});

  ASSERT_TRUE(quick && exact);
  EXPECT_FALSE(quick->solution.converged);
  const auto& u = exact->solution.displacement;
  auto error = quick->solution.displacement;
  for (std::size_t i = 0; i < error.size(); ++i)
    error[i] -= u[i];
  const auto energy = [&](const std::vector<double>& x) {
    std::vector<double> kx(x.size());
    element_operator(session.last_problem()).apply(x, kx);
    return std::sqrt(std::inner_product(x.begin(), x.end(), kx.begin(), 0.0));
  };
  EXPECT_LE(energy(error), 1e-2 * energy(u));
  EXPECT_GE(quick->solution.energy_error * energy(u), energy(error));
}

}  // namespace
}  // namespace tedit::fem
