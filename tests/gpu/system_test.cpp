// SPDX-License-Identifier: AGPL-3.0-or-later
// Each kernel of a Vulkan device against the native backend.
#include "fem/vulkan/backend.hpp"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "fem/native/backend.hpp"
#include "fem/solver.hpp"
#include "gpu/device.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"
#include "tests/gpu/bent_bar.hpp"
#include "tests/support/blocks.hpp"

namespace tedit::fem {
namespace {

/// Single precision: 24 bits, a few of them lost in sums over some dozen blocks.
constexpr double kFloatTolerance = 2e-5;

using test::bent_bar;
using test::expect_near_all;
using test::largest;
using test::wave;

class VulkanSystem : public ::testing::Test {
protected:
  void SetUp() override {
    if (list_vulkan_devices().empty())
      GTEST_SKIP() << "no Vulkan device on this machine";
    before_ = gpu::device::validation_messages();
    p_ = bent_bar();
    native_ = std::move(*make_native_backend()->assemble(p_, {}));
    device_ = open();
  }

  void TearDown() override { EXPECT_EQ(gpu::device::validation_messages(), before_); }

  std::unique_ptr<linear_system> open(const vulkan_settings& settings = {}) {
    // The backend may go: its device lives on in the system.
    auto made = (*open_vulkan("", settings))->assemble(p_, {});
    EXPECT_TRUE(made.has_value()) << (made ? "" : render(made.error()));
    return std::move(*made);
  }

  int before_ = 0;
  problem p_;
  std::unique_ptr<linear_system> native_;
  std::unique_ptr<linear_system> device_;
};

TEST_F(VulkanSystem, MultiplyIsEquivalentToNative) {
  const auto x = wave(p_.dofs(), 0.7);
  std::vector<double> expected_y(p_.dofs());
  std::vector<double> y(p_.dofs());

  ASSERT_TRUE(native_->multiply(x, expected_y).has_value());
  ASSERT_TRUE(device_->multiply(x, y).has_value());

  expect_near_all(y, expected_y, kFloatTolerance);
}

TEST_F(VulkanSystem, ATranslationGivesNoForceAtAll) {
  std::vector<double> x(p_.dofs(), 0.25);
  std::vector<double> y(p_.dofs(), 1);

  ASSERT_TRUE(device_->multiply(x, y).has_value());

  EXPECT_EQ(largest(y), 0);  // difference form: exactly zero
}

TEST_F(VulkanSystem, SolveIsEquivalentToNative) {
  const auto b = wave(p_.dofs(), 1.3);
  std::vector<double> expected_d(p_.dofs());
  std::vector<double> d(p_.dofs());

  const auto reference = native_->solve({b, expected_d, 1e-6}, 5000, {});
  const auto result = device_->solve({b, d, 1e-6}, 5000, {});

  ASSERT_TRUE(reference.has_value());
  ASSERT_TRUE(result.has_value());
  EXPECT_FALSE(result->broke_down);
  EXPECT_LE(result->recurrence_reduction, 1.01e-6);
  expect_near_all(d, expected_d, 1e-3);
}

TEST_F(VulkanSystem, HeldDirectionsStayAtZero) {
  const auto b = wave(p_.dofs(), 0.9);
  std::vector<double> d(p_.dofs());

  ASSERT_TRUE(device_->solve({b, d, 1e-4}, 5000, {}).has_value());

  for (std::size_t n = 0; n < p_.node_count(); ++n)
    if (p_.filter[n] == std::array<double, 6>{}) {
      EXPECT_EQ(d[3 * n], 0);
      EXPECT_EQ(d[3 * n + 1], 0);
      EXPECT_EQ(d[3 * n + 2], 0);
    }
}

TEST_F(VulkanSystem, RepeatsBitForBit) {
  const auto b = wave(p_.dofs(), 1.1);
  std::vector<double> first(p_.dofs());
  std::vector<double> second(p_.dofs());
  const auto again = open();

  ASSERT_TRUE(device_->solve({b, first, 1e-5}, 5000, {}).has_value());
  ASSERT_TRUE(again->solve({b, second, 1e-5}, 5000, {}).has_value());

  EXPECT_EQ(first, second);
}

TEST_F(VulkanSystem, AMatrixInManyBindingsGivesTheSame) {
  vulkan_settings small;
  small.most_bytes_per_binding = 40'000;  // about a dozen pieces
  const auto pieces = open(small);
  const auto x = wave(p_.dofs(), 0.7);
  std::vector<double> whole(p_.dofs());
  std::vector<double> cut(p_.dofs());

  ASSERT_TRUE(device_->multiply(x, whole).has_value());
  ASSERT_TRUE(pieces->multiply(x, cut).has_value());
  EXPECT_EQ(whole, cut);

  std::vector<double> d(p_.dofs());
  const auto result = pieces->solve({x, d, 1e-4}, 5000, {});
  ASSERT_TRUE(result.has_value());
  EXPECT_FALSE(result->broke_down);
}

TEST_F(VulkanSystem, CancelIsObeyed) {
  execution run;
  run.cancel.cancel();
  const auto b = wave(p_.dofs(), 1.1);
  std::vector<double> d(p_.dofs());

  const auto result = device_->solve({b, d, 1e-5}, 5000, run);

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::cancelled);
}

TEST_F(VulkanSystem, AnotherFilterNeedsNoNewMatrix) {
  std::vector<std::array<double, 6>> free(p_.node_count(), {1, 0, 0, 1, 0, 1});
  free[0] = free[1] = free[2] = {0, 0, 0, 0, 0, 0};
  const auto b = wave(p_.dofs(), 1.1);
  std::vector<double> d(p_.dofs());

  ASSERT_TRUE(device_->set_filter(free).has_value());
  ASSERT_TRUE(device_->solve({b, d, 1e-3}, 20000, {}).has_value());

  EXPECT_EQ(d[0], 0);
  EXPECT_EQ(d[8], 0);
  EXPECT_NE(d[9], 0);
}

/// 900 cubes that touch nowhere, each held below.
TEST(VulkanParts, TooManyPiecesIsSaidAndIsNoLackOfMemory) {
  if (list_vulkan_devices().empty())
    GTEST_SKIP() << "no Vulkan device on this machine";
  const auto mesh =
    tedit::test::blocks({59, 59, 1}, [](int x, int y, int) { return x % 2 == 0 && y % 2 == 0; });
  load_case loads;
  loads.materials = {{"steel", 210e9, 0.3, 7850, 0, {}}};
  loads.constraints = {{{5}, fixed{}}};
  loads.loads = {{{6}, pressure{1e5}}};
  const auto p = make_problem(*mesh, loads);
  ASSERT_TRUE(p.has_value()) << render(p.error());

  const auto refused = (*open_vulkan(""))->assemble(*p, {});

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::device_unavailable);
  EXPECT_NE(refused.error().message.find("too many separate pieces"), std::string::npos);
  EXPECT_TRUE(make_native_backend()->assemble(*p, {}).has_value());
}

TEST(VulkanParts, ARealPartWithSliversAgreesWithNative) {
  if (list_vulkan_devices().empty())
    GTEST_SKIP() << "no Vulkan device on this machine";
  const std::filesystem::path folder = TEDIT_TEST_DATA "/parts/bracket_4040";
  const auto mesh = import_mesh(folder / "bracket_4040.coarse.msh", "mm");
  const auto loads = protocol::load_case_from_file(folder / "load_case.json");
  const auto p = make_problem(*mesh->version, *loads);
  ASSERT_TRUE(p.has_value());

  const auto result = solve(*p, **open_vulkan(""), {}, {});

  ASSERT_TRUE(result.has_value()) << render(result.error());
  EXPECT_LE(result->true_relative_residual, 1e-6);
  EXPECT_NEAR(result->max_displacement_m, 5.0108e-5, 1e-9);  // reference.json
  EXPECT_NEAR(result->compliance_j, 7.41635e-3, 1e-8);
}

}  // namespace
}  // namespace tedit::fem
