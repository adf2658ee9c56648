// SPDX-License-Identifier: AGPL-3.0-or-later
// The multilevel solver on a Vulkan device against the native one, for both element orders.
#include <chrono>
#include <thread>

#include "fem/native/backend.hpp"
#include "fem/solver.hpp"
#include "tests/gpu/followed_system.hpp"

namespace tedit::fem {
namespace {

using test::bent_bar;
using test::expect_near_all;
using test::largest;
using test::wave;

/// Products keep 24 bits; a cycle is a few hundred of them in a row.
constexpr double kProductTolerance = 2e-6;
constexpr double kCycleTolerance = 1e-4;

/// z = B r by the native cycle with the hierarchy that the device has.
std::vector<double> native_cycle(const problem& p, const vulkan_settings& given,
                                 std::span<const double> r) {
  const auto settings = given.for_order(p.element_order);
  multilevel_setup setup(p, settings.multilevel);
  EXPECT_TRUE(test::prepare_native(p, setup).has_value());
  return test::native_cycle(p, settings, setup, r);
}

class VulkanMultilevel : public ::testing::TestWithParam<int> {
protected:
  void SetUp() override {
    if (list_vulkan_devices().empty())
      GTEST_SKIP() << "no Vulkan device on this machine";
    before_ = gpu::device::validation_messages();
    p_ = bent_bar(GetParam());
  }

  void TearDown() override { EXPECT_EQ(gpu::device::validation_messages(), before_); }

  static std::unique_ptr<vulkan::system> open(const problem& p,
                                              const vulkan_settings& settings = {}) {
    auto made = test::make_system(p, settings);
    EXPECT_TRUE(made.has_value()) << (made ? "" : render(made.error()));
    return std::move(*made);
  }

  void expect_cycle_as_native(const problem& p, const vulkan_settings& settings = {}) {
    const auto r = wave(p.dofs(), 0.9);
    std::vector<double> z(p.dofs());
    ASSERT_TRUE(open(p, settings)->precondition(r, z).has_value());
    expect_near_all(z, native_cycle(p, settings, r), kCycleTolerance);
  }

  void expect_solution_as_native(const problem& p) {
    const solve_settings exact{.tolerance = 1e-9};
    const auto expected_u = solve(p, *make_native_backend(), exact, {});
    const auto u = solve(p, **open_vulkan(""), exact, {});
    ASSERT_TRUE(expected_u.has_value()) << render(expected_u.error());
    ASSERT_TRUE(u.has_value()) << render(u.error());
    EXPECT_LE(u->true_relative_residual, 1e-9);
    EXPECT_LE(u->iterations, expected_u->iterations * 3 / 2 + 2);
    expect_near_all(u->displacement, expected_u->displacement, 1e-6);
    expect_near_all(u->von_mises, expected_u->von_mises, 1e-4);
  }

  int before_ = 0;
  problem p_;
};

INSTANTIATE_TEST_SUITE_P(Orders, VulkanMultilevel, ::testing::Values(1, 2));

/// Small enough bindings for about a dozen pieces of everything that can be cut, and three rigid
/// levels.
vulkan_settings small_pieces() {
  vulkan_settings result;
  result.most_bytes_per_binding = 40'000;
  result.multilevel.coarsest = 2;
  return result;
}

TEST_P(VulkanMultilevel, MultiplyIsEquivalentToNative) {
  const auto native = std::move(*make_native_backend()->assemble(p_, {}));
  const auto x = wave(p_.dofs(), 0.7);
  std::vector<double> expected_y(p_.dofs());
  std::vector<double> y(p_.dofs());

  ASSERT_TRUE(native->multiply(x, expected_y).has_value());
  ASSERT_TRUE(open(p_)->multiply(x, y).has_value());

  expect_near_all(y, expected_y, kProductTolerance);
}

TEST_P(VulkanMultilevel, ATranslationGivesNoForceAtAll) {
  const std::vector<double> x(p_.dofs(), 0.25);
  std::vector<double> y(p_.dofs(), 1);

  ASSERT_TRUE(open(p_)->multiply(x, y).has_value());

  EXPECT_EQ(largest(y), 0);  // difference form: exactly zero
}

TEST_P(VulkanMultilevel, OneCycleIsEquivalentToNative) {
  expect_cycle_as_native(p_);
}

TEST_P(VulkanMultilevel, OneCycleInManyPiecesAndLevelsIsEquivalentToNative) {
  expect_cycle_as_native(p_, small_pieces());
}

TEST_P(VulkanMultilevel, OperandsFromStorageOrFromTexelsGiveTheSameBits) {
  const auto b = wave(p_.dofs(), 1.1);
  std::vector<double> storage(p_.dofs());
  std::vector<double> texels(p_.dofs());

  ASSERT_TRUE(open(p_, {.texels = false})->solve({b, storage, 1e-5}, 500, {}).has_value());
  ASSERT_TRUE(open(p_, {.texels = true})->solve({b, texels, 1e-5}, 500, {}).has_value());

  EXPECT_EQ(storage, texels);
}

TEST_P(VulkanMultilevel, OtherDegreesAndAPlainCycleAreEquivalentToNative) {
  vulkan_settings settings;
  settings.multilevel.coarsest = 8;
  settings.cycle = {.quadratic_degree = 1, .node_degree = 1, .rigid_degree = 3, .repeats = 1};
  settings.corner_degree = 1;

  expect_cycle_as_native(p_, settings);
}

TEST_P(VulkanMultilevel, AllNodesHeldButOneIsEquivalentToNative) {
  const std::size_t free = p_.corner_count / 2;
  p_.filter.assign(p_.node_count(), {});
  p_.filter[free] = {1, 0, 0, 1, 0, 1};

  expect_cycle_as_native(p_);
}

TEST_P(VulkanMultilevel, AllNodesHeldIsNoWork) {
  p_.filter.assign(p_.node_count(), {});
  const auto system = open(p_);
  std::vector<double> d(p_.dofs(), 1);

  const auto result = system->solve({wave(p_.dofs(), 0.9), d, 1e-4}, 100, {});

  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->iterations, 0);
  EXPECT_EQ(largest(d), 0);
}

/// What a device's subgroup size decides: nothing but the shapes of groups and slices.
TEST_P(VulkanMultilevel, AnySizeOfGroupsAndSlicesIsEquivalentToNative) {
  const auto native = std::move(*make_native_backend()->assemble(p_, {}));
  const auto x = wave(p_.dofs(), 0.7);
  std::vector<double> expected_y(p_.dofs());
  std::vector<double> y(p_.dofs());
  ASSERT_TRUE(native->multiply(x, expected_y).has_value());
  const auto r = wave(p_.dofs(), 0.9);
  std::vector<double> z(p_.dofs());
  const auto most = gpu::device::open("").value()->limits().workgroup_size;
  // Small groups, then those of devices with subgroups of 4, 32 and 64, then more than the
  // usual 64.
  for (const auto& [group, slice] : {std::pair(8u, 1u), std::pair(64u, 4u), std::pair(64u, 32u),
                                     std::pair(64u, 64u), std::pair(128u, 16u)}) {
    if (group > most)
      continue;
    SCOPED_TRACE(std::to_string(group) + "/" + std::to_string(slice));
    vulkan_settings settings;
    settings.group_size = group;
    settings.slice_rows = slice;
    const auto system = open(p_, settings);
    ASSERT_TRUE(system->multiply(x, y).has_value());
    expect_near_all(y, expected_y, kProductTolerance);
    ASSERT_TRUE(system->precondition(r, z).has_value());
    expect_near_all(z, native_cycle(p_, settings, r), kCycleTolerance);
  }
}

TEST_P(VulkanMultilevel, SizesThatCannotBeAreRefused) {
  const auto on = gpu::device::open("").value();
  for (const auto& [group, slice] :
       {std::pair(48u, 8u), std::pair(64u, 12u), std::pair(32u, 64u), std::pair(1u << 20, 8u)}) {
    vulkan_settings settings;
    settings.group_size = group;
    settings.slice_rows = slice;
    const auto made = test::make_system(p_, settings, on);
    ASSERT_FALSE(made.has_value());
    EXPECT_EQ(made.error().code, ec::invalid_argument);
  }
}

TEST_P(VulkanMultilevel, SolutionIsEquivalentToNative) {
  expect_solution_as_native(p_);
}

TEST_P(VulkanMultilevel, AMatrixInManyPiecesGivesTheSame) {
  const auto x = wave(p_.dofs(), 0.7);
  std::vector<double> whole(p_.dofs());
  std::vector<double> cut(p_.dofs());
  const auto pieces = open(p_, small_pieces());

  ASSERT_TRUE(open(p_)->multiply(x, whole).has_value());
  ASSERT_TRUE(pieces->multiply(x, cut).has_value());
  expect_near_all(cut, whole, kProductTolerance);

  std::vector<double> d(p_.dofs());
  const auto result = pieces->solve({x, d, 1e-4}, 200, {});
  ASSERT_TRUE(result.has_value());
  EXPECT_FALSE(result->broke_down);
  EXPECT_LE(result->recurrence_reduction, 1.01e-4);
}

TEST_P(VulkanMultilevel, RepeatsBitForBit) {
  const auto b = wave(p_.dofs(), 1.1);
  std::vector<double> first(p_.dofs());
  std::vector<double> second(p_.dofs());
  std::vector<double> third(p_.dofs());
  const auto system = open(p_);

  ASSERT_TRUE(system->solve({b, first, 1e-5}, 500, {}).has_value());
  ASSERT_TRUE(system->solve({b, second, 1e-5}, 500, {}).has_value());
  ASSERT_TRUE(open(p_)->solve({b, third, 1e-5}, 500, {}).has_value());

  EXPECT_EQ(first, second);
  EXPECT_EQ(first, third);
}

TEST_P(VulkanMultilevel, AnyCutIntoSubmissionsGivesTheSameBits) {
  const auto b = wave(p_.dofs(), 1.1);
  std::vector<double> whole(p_.dofs());
  ASSERT_TRUE(open(p_, {.rows_per_part = 1u << 30})->solve({b, whole, 1e-5}, 500, {}).has_value());
  for (const std::uint32_t rows : {1u, 1000u, 10'000u}) {
    std::vector<double> cut(p_.dofs());
    ASSERT_TRUE(open(p_, {.rows_per_part = rows})->solve({b, cut, 1e-5}, 500, {}).has_value());
    EXPECT_EQ(cut, whole) << rows;
  }
}

TEST_P(VulkanMultilevel, ACancelAtAnyCheckLeavesTheSystemUsable) {
  const auto system = open(p_);
  const auto b = wave(p_.dofs(), 1.1);
  std::vector<double> expected_d(p_.dofs());
  std::vector<double> d(p_.dofs());
  execution whole;
  ASSERT_TRUE(system->solve({b, expected_d, 1e-5}, 500, whole).has_value());
  const auto last = whole.cancel.polls();
  ASSERT_GE(last, 5);
  for (std::uint64_t poll = 1; poll <= last; poll += 1 + poll / 4) {
    execution run;
    run.cancel = cancel_token::at_poll(poll);
    const auto result = system->solve({b, d, 1e-5}, 500, run);
    // Submissions follow measured times, and with them the number of checks.
    if (result) {
      EXPECT_LT(run.cancel.polls(), poll);
      EXPECT_GT(poll, 3);
    } else {
      EXPECT_EQ(result.error().code, ec::cancelled);
    }
  }
  ASSERT_TRUE(system->solve({b, d, 1e-5}, 500, {}).has_value());
  EXPECT_EQ(d, expected_d);
}

TEST_P(VulkanMultilevel, IterationsAreBounded) {
  std::vector<double> d(p_.dofs());

  const auto result = open(p_)->solve({wave(p_.dofs(), 1.1), d, 1e-30}, 3, {});

  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->iterations, 3);
}

TEST_P(VulkanMultilevel, CancelIsObeyedWhileItRuns) {
  const auto system = open(p_);
  const auto b = wave(p_.dofs(), 1.1);
  std::vector<double> d(p_.dofs());
  execution run;
  std::jthread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    run.cancel.cancel();
  });

  // Never done: nothing ever falls by so much before it is cancelled or breaks down.
  for (;;) {
    const auto result = system->solve({b, d, 1e-30}, 1'000'000, run);
    if (result)
      continue;
    EXPECT_EQ(result.error().code, ec::cancelled);
    break;
  }
}

TEST_P(VulkanMultilevel, ATooSmallEigenvalueBreaksDownOnce) {
  vulkan_settings settings;
  settings.multilevel.lambda_safety = 0.15F;
  const auto system = open(p_, settings);
  const auto b = wave(p_.dofs(), 1.1);
  std::vector<double> d(p_.dofs());

  const auto first = system->solve({b, d, 1e-4}, 500, {});
  ASSERT_TRUE(first.has_value());
  EXPECT_TRUE(first->broke_down);

  // The bound on nodes holds at once; the rigid levels may need a few raises.
  for (int raise = 0; raise < 6; ++raise)
    if (const auto again = system->solve({b, d, 1e-4}, 500, {}); again && !again->broke_down)
      return;
  FAIL() << "still not positive definite";
}

TEST_P(VulkanMultilevel, AnotherFilterGivesTheSameBytes) {
  const auto system = open(p_);
  const auto before = system->device_bytes();

  ASSERT_TRUE(system->set_filter(p_.filter).has_value());

  EXPECT_EQ(system->device_bytes(), before);
}

}  // namespace
}  // namespace tedit::fem
