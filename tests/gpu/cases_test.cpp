// SPDX-License-Identifier: AGPL-3.0-or-later
// Several load cases at once on a Vulkan device, against one at a time and the native backend.
#include "fem/load_cases.hpp"
#include "fem/native/backend.hpp"
#include "tests/gpu/followed_system.hpp"
#include "tests/support/residual.hpp"

namespace tedit::fem {
namespace {

using test::bent_bar;
using test::expect_near_all;
using test::wave;

class VulkanCases : public ::testing::TestWithParam<int> {
protected:
  using fields = std::vector<std::vector<double>>;

  void SetUp() override {
    if (list_vulkan_devices().empty())
      GTEST_SKIP() << "no Vulkan device on this machine";
    before_ = gpu::device::validation_messages();
    p_ = bent_bar(GetParam());
  }

  void TearDown() override { EXPECT_EQ(gpu::device::validation_messages(), before_); }

  [[nodiscard]] std::unique_ptr<vulkan::system> open(const vulkan_settings& settings = {}) const {
    auto made = test::make_system(p_, settings);
    EXPECT_TRUE(made.has_value()) << (made ? "" : render(made.error()));
    return std::move(*made);
  }

  /// Loads of very different size and shape.
  [[nodiscard]] static std::vector<double> load(const problem& p, std::size_t c) {
    auto result = wave(p.dofs(), 0.3 + 0.17 * static_cast<double>(c));
    for (auto& value : result)
      value *= std::pow(10.0, static_cast<double>(c % 5) - 2);
    return result;
  }

  static std::vector<inner_result> solve(vulkan::system& system, const fields& right, fields& d,
                                         double reduction) {
    d.resize(right.size());
    std::vector<inner_case> cases;
    for (std::size_t c = 0; c < right.size(); ++c) {
      d[c].resize(right[c].size());
      cases.push_back({right[c], d[c], reduction});
    }
    auto results = system.solve_many(cases, 500, {});
    EXPECT_TRUE(results.has_value()) << (results ? "" : render(results.error()));
    return results ? *results : std::vector<inner_result>(right.size());
  }

  static fields loads_of(const problem& p, std::size_t count) {
    fields result;
    for (std::size_t c = 0; c < count; ++c)
      result.push_back(load(p, c));
    return result;
  }

  /// Each case of a batch as it comes out alone.
  void expect_as_alone(vulkan::system& together, vulkan::system& alone, const problem& p,
                       std::size_t count) {
    const auto right = loads_of(p, count);
    fields d;
    const auto results = solve(together, right, d, 1e-6);
    ASSERT_EQ(results.size(), count);
    for (std::size_t c = 0; c < count; ++c) {
      std::vector<double> own(p.dofs());
      const auto one = alone.solve({right[c], own, 1e-6}, 500, {});
      ASSERT_TRUE(one.has_value());
      EXPECT_FALSE(results[c].broke_down);
      EXPECT_LE(results[c].recurrence_reduction, 1.01e-6);
      EXPECT_NEAR(results[c].iterations, one->iterations, 1) << c << " of " << count;
      EXPECT_NEAR(results[c].gained, one->gained, 1e-4 * one->gained);
      ASSERT_NO_FATAL_FAILURE(expect_near_all(d[c], own, 1e-5)) << c << " of " << count;
    }
  }

  int before_ = 0;
  problem p_;
};

INSTANTIATE_TEST_SUITE_P(Orders, VulkanCases, ::testing::Values(1, 2));

TEST_P(VulkanCases, OfAnyNumberAreEachAsAlone) {
  const auto together = open();
  const auto alone = open();
  for (const std::size_t count : {2u, 3u, 8u, 4u, 1u, 11u})
    ASSERT_NO_FATAL_FAILURE(expect_as_alone(*together, *alone, p_, count));
}

TEST_P(VulkanCases, InManyPiecesToo) {
  const auto together = open(test::in_pieces());
  const auto alone = open(test::in_pieces());
  expect_as_alone(*together, *alone, p_, 5);
}

TEST_P(VulkanCases, RepeatBitForBitAndLeaveASingleSolveItsBits) {
  const auto system = open();
  const auto right = loads_of(p_, 8);
  std::vector<double> before(p_.dofs());
  std::vector<double> after(p_.dofs());
  fields first;
  fields second;
  fields fresh;

  ASSERT_TRUE(system->solve({right[0], before, 1e-5}, 500, {}).has_value());
  solve(*system, right, first, 1e-5);
  solve(*system, right, second, 1e-5);
  ASSERT_TRUE(system->solve({right[0], after, 1e-5}, 500, {}).has_value());
  solve(*open(), right, fresh, 1e-5);

  EXPECT_EQ(first, second);
  EXPECT_EQ(first, fresh);
  EXPECT_EQ(before, after);
}

TEST_P(VulkanCases, HaveTheirOwnEnds) {
  const auto system = open();
  const auto right = load(p_, 0);
  const std::vector<double> nothing(p_.dofs());
  const std::vector<double> lost(p_.dofs(), std::nan(""));
  fields d(5, std::vector<double>(p_.dofs(), 1));
  std::vector<double> alone(p_.dofs());
  const inner_case by_energy{right, d[2], 1e-6, 0, 1e-2};
  const std::vector<inner_case> cases{
    {right, d[0], 1e-1}, {right, d[1], 1e-5}, by_energy, {nothing, d[3]}, {lost, d[4]}};

  const auto results = system->solve_many(cases, 500, {});
  const auto one = system->solve({right, alone, 1e-5}, 500, {});

  ASSERT_TRUE(results && one);
  EXPECT_LT((*results)[0].iterations, (*results)[1].iterations);
  EXPECT_LT((*results)[2].iterations, (*results)[1].iterations);
  EXPECT_LE((*results)[0].recurrence_reduction, 1.01e-1);
  EXPECT_LE((*results)[2].energy, 1.01e-2 * std::sqrt((*results)[2].gained));
  EXPECT_EQ((*results)[3].iterations, 0);
  EXPECT_EQ(test::largest(d[3]), 0);
  EXPECT_FALSE((*results)[3].broke_down);
  EXPECT_TRUE((*results)[4].broke_down);
  EXPECT_FALSE((*results)[1].broke_down);
  expect_near_all(d[1], alone, 1e-4);
}

TEST_P(VulkanCases, EndByTheResidual) {
  const auto system = open();
  const std::vector<double> right(p_.loads.begin(), p_.loads.end());
  fields d(2, std::vector<double>(p_.dofs()));
  inner_case early{right, d[0], 1e-6};
  early.residual_reduction = 1e-2;
  const std::vector<inner_case> cases{early, {right, d[1], 1e-6}};

  const auto results = system->solve_many(cases, 500, {});

  ASSERT_TRUE(results);
  EXPECT_LT((*results)[0].iterations, (*results)[1].iterations);
  const double left = tedit::test::residual_share(p_, d[0]);
  EXPECT_LE(left, 1.01e-2);
  EXPECT_GE(left, 1e-4);
}

TEST_P(VulkanCases, FollowAnEdit) {
  const auto loads = test::held_at_one_end();
  test::followed_system one(tedit::test::box_mesh({16, 6, 6}, {4, 1.5, 1.5}), loads, GetParam(),
                            {});
  const auto right = loads_of(one.current(), 4);
  fields d;
  solve(one.system(), right, d, 1e-5);
  ASSERT_NO_FATAL_FAILURE(
    one.follow(tedit::test::split(one.mesh(), [](tet_id t) { return t % 801 == 17; })));

  expect_as_alone(one.system(), *one.fresh(), one.current(), 4);
}

/// Also while the kernels for so many cases are made.
TEST_P(VulkanCases, ACancelAtAnyCheckLeavesTheSystemUsable) {
  const auto right = loads_of(p_, 4);
  fields wanted;
  solve(*open(), right, wanted, 1e-5);
  const auto system = open();
  fields d(4, std::vector<double>(p_.dofs()));
  std::vector<inner_case> cases;
  for (std::size_t c = 0; c < right.size(); ++c)
    cases.push_back({right[c], d[c], 1e-5});
  bool cancelled = true;
  std::uint64_t poll = 1;
  for (; cancelled; poll += 1 + poll / 4) {
    execution run;
    run.cancel = cancel_token::at_poll(poll);
    const auto result = system->solve_many(cases, 500, run);
    cancelled = !result;
    ASSERT_TRUE(result || result.error().code == ec::cancelled) << render(result.error());
  }
  EXPECT_GT(poll, 5);
  solve(*system, right, d, 1e-5);
  EXPECT_EQ(d, wanted);
}

/// From the loads to the stresses, eight cases with the same supports.
TEST_P(VulkanCases, AreSolvedAsNatively) {
  case_set set;
  for (std::size_t c = 0; c < 8; ++c)
    set.cases.push_back(
      {"case " + std::to_string(c), {}, load(p_, c), p_.filter, p_.prescribed, p_.holders});
  set.problem = p_;
  auto same = set;
  const solve_settings exact{.tolerance = 1e-9};

  const auto native = solve_cases(same, *make_native_backend(), exact, {});
  const auto device = solve_cases(set, **open_vulkan(""), exact, {});

  ASSERT_TRUE(native.has_value()) << render(native.error());
  ASSERT_TRUE(device.has_value()) << render(device.error());
  for (std::size_t c = 0; c < 8; ++c) {
    EXPECT_LE(device->cases[c].true_relative_residual, 1e-9);
    expect_near_all(device->cases[c].displacement, native->cases[c].displacement, 1e-6);
    expect_near_all(device->cases[c].von_mises, native->cases[c].von_mises, 1e-4);
  }
}

}  // namespace
}  // namespace tedit::fem
