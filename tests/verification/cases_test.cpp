// SPDX-License-Identifier: AGPL-3.0-or-later
// Every case of the suite at its tolerance, on the CPU.
#include <filesystem>

#include <gtest/gtest.h>

#include "fem/native/backend.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"
#include "verification/suite.hpp"

namespace tedit::verification {
namespace {

const real_part& plate() {
  static const auto part = [] {
    const std::filesystem::path folder = TEDIT_EXAMPLES "/ctc01_plate";
    const auto mesh = import_mesh(folder / "ctc01_plate.coarse.msh", "mm");
    const auto loads = protocol::load_case_from_file(folder / "load_case.json");
    return real_part{"ctc01_plate", mesh ? mesh->version : nullptr,
                     loads ? *loads : fem::load_case{}};
  }();
  return part;
}

class Case : public ::testing::TestWithParam<case_id> {};

TEST_P(Case, MeetsItsTargets) {
  ASSERT_NE(plate().mesh, nullptr);
  const auto device = fem::make_native_backend();
  suite_report report;

  const auto ok = run_case(GetParam(), *device, &plate(), {}, report);

  ASSERT_TRUE(ok.has_value()) << render(ok.error());
  EXPECT_FALSE(report.results.empty());
  EXPECT_TRUE(report.left_out.empty());
  for (const auto& r : report.results) {
    const auto text = text_of(r);
    EXPECT_TRUE(r.passed) << r.quantity << ": target " << text.target << ", computed "
                          << text.computed << " " << text.error;
  }
}

std::string test_name(const ::testing::TestParamInfo<case_id>& info) {
  std::string name;
  for (const char c : info.param.name)
    if (std::isalnum(static_cast<unsigned char>(c)))
      name += c;
  return name + "OfOrder" + std::to_string(info.param.element_order);
}

/// Side by side with CalculiX has parts of its own: calculix_test.cpp.
std::vector<case_id> cases_of_our_own() {
  auto ids = list_cases();
  std::erase_if(ids, [](const case_id& id) { return id.name == side_by_side_case; });
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Suite, Case, ::testing::ValuesIn(cases_of_our_own()), test_name);

}  // namespace
}  // namespace tedit::verification
