// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "actors/solver/solver.hpp"
#include "actors/versions.hpp"
#include "fem/native/backend.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::actors {
namespace {

/// A device that is lost in every assembly.
class lost_device final : public fem::backend {
public:
  explicit lost_device(int& assemblies) : assemblies_(assemblies) {}

  const fem::device_info& info() const override { return info_; }

  expected<std::unique_ptr<fem::linear_system>> assemble(const fem::problem&,
                                                         const execution&) override {
    ++assemblies_;
    return fail(ec::device_lost, "the device hung");
  }

private:
  int& assemblies_;
  fem::device_info info_{"shaky", "discrete", "test", 0};
};

fem::load_case cantilever() {
  fem::load_case loads;
  loads.name = "bend";
  loads.materials = {{"steel", 210e9, 0.3, 7850, 0, {}}};
  loads.constraints = {{{1}, fem::fixed{}}};
  loads.loads = {{{2}, fem::force{{0, 0, -1000}}}};
  return loads;
}

class DeviceLoss : public ::testing::Test {
protected:
  version_ptr mesh_ = test::box_mesh({4, 1, 1}, {4, 1, 1});
  kept_systems systems_;
  int assemblies_ = 0;

  void SetUp() override { systems_.devices["shaky"] = std::make_unique<lost_device>(assemblies_); }

  expected<solve_outcome> solve_on(const std::string& device) {
    solve_order order;
    order.load_cases = wire_value(load_case_list{cantilever()});
    order.device = device;
    const auto output = solve(order, systems_, mesh_, {}, {});
    if (!output)
      return fail(output.error());
    return *output->result.outcome.get().value();
  }
};

TEST_F(DeviceLoss, TheProcessorSolvesInsteadAndTheReportSaysSo) {
  const auto lost = solve_on("shaky");
  const auto sound = solve_on("cpu");

  ASSERT_TRUE(lost && sound);
  EXPECT_EQ(assemblies_, 1);  // It cannot be opened again under this name.
  EXPECT_EQ(lost->cases.front().device, "cpu");
  EXPECT_EQ(lost->cases.front().notice, "the device was lost; the processor solved instead");
  const double compliance = sound->cases.front().compliance_j;
  EXPECT_NEAR(lost->cases.front().compliance_j, compliance, 1e-6 * compliance);
  EXPECT_EQ(sound->cases.front().notice, "");
}

TEST_F(DeviceLoss, ADeviceThatWasNeverThereIsAnError) {
  const auto result = solve_on("no such device");

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::device_unavailable);
}

}  // namespace
}  // namespace tedit::actors
