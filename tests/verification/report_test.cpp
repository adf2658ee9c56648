// SPDX-License-Identifier: AGPL-3.0-or-later
// What the suite says about itself: failures, what was left out, page and picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fem/native/backend.hpp"
#include "verification/page.hpp"
#include "verification/plot.hpp"
#include "verification/suite.hpp"

namespace tedit::verification {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The CPU, but without quadratic tets: what devices in development look like.
class linear_only : public fem::backend {
public:
  [[nodiscard]] const fem::device_info& info() const override { return cpu_->info(); }

  [[nodiscard]] expected<std::unique_ptr<fem::linear_system>> assemble(
    const fem::problem& p, const execution& run) override {
    if (p.element_order != 1)
      return fail(ec::device_unavailable, "this device knows linear tets only");
    return cpu_->assemble(p, run);
  }

private:
  std::unique_ptr<fem::backend> cpu_ = fem::make_native_backend();
};

/// A device that fails at once.
class no_device : public linear_only {
public:
  [[nodiscard]] expected<std::unique_ptr<fem::linear_system>> assemble(const fem::problem&,
                                                                       const execution&) override {
    return fail(ec::device_lost, "the device fell silent");
  }
};

case_result figure(double target, double computed, double tolerance) {
  case_result r;
  r.name = "bar";
  r.quantity = "|u| at the end";
  r.target = target;
  r.computed = computed;
  r.relative_error = computed / target - 1;
  r.tolerance = tolerance;
  r.passed = std::abs(r.relative_error) <= tolerance;
  return r;
}

TEST(Report, OneFailureFailsTheSuite) {
  suite_report report;
  EXPECT_FALSE(report.passed()) << "nothing was verified";
  report.results = {figure(2, 2.01, 0.01)};
  EXPECT_TRUE(report.passed());
  report.results.push_back(figure(2, 2.03, 0.01));
  EXPECT_FALSE(report.passed());
  EXPECT_EQ(report.failures(), 1u);
}

TEST(Report, TextSaysHowFarOff) {
  const auto text = text_of(figure(2, 2.03, 0.01));

  EXPECT_EQ(text.target, "2");
  EXPECT_EQ(text.computed, "2.03");
  EXPECT_EQ(text.error, "+1.5 %");
  EXPECT_EQ(text.tolerance, "1 %");
}

TEST(Cases, AnUnknownOneIsNamed) {
  suite_report report;

  const auto ok = run_case({"no such case", 1}, *fem::make_native_backend(), nullptr, {}, report);

  ASSERT_FALSE(ok.has_value());
  EXPECT_EQ(ok.error().code, ec::not_found);
}

TEST(Cases, ASolverThatFailsIsAFailedFigure) {
  suite_report report;
  no_device device;

  const auto ok = run_case({"Cook's membrane", 1}, device, nullptr, {}, report);

  ASSERT_TRUE(ok.has_value());
  ASSERT_EQ(report.results.size(), 1u);
  EXPECT_FALSE(report.passed());
  EXPECT_THAT(report.results[0].quantity, HasSubstr("fell silent"));
}

TEST(Suite, SaysWhatItLeavesOut) {
  linear_only device;

  const auto report = run_suite(device, nullptr, {});

  ASSERT_TRUE(report.has_value());
  EXPECT_TRUE(report->passed());
  for (const auto& r : report->results)
    EXPECT_EQ(r.element_order, 1) << r.name;
  std::string text;
  for (const auto& item : report->left_out)
    text += item.what + ": " + item.why + "\n";
  EXPECT_THAT(text, HasSubstr("order 2: this device knows linear tets only"));
  EXPECT_THAT(text, HasSubstr("CalculiX: not asked for: add --calculix"));
  EXPECT_THAT(text, HasSubstr("real part (order 1): no real part was given"));
}

TEST(Suite, CancelIsObeyed) {
  execution run;
  run.cancel.cancel();

  const auto report = run_suite(*fem::make_native_backend(), nullptr, run);

  ASSERT_FALSE(report.has_value());
  EXPECT_EQ(report.error().code, ec::cancelled);
}

TEST(Page, ShowsFailuresAndEscapesBars) {
  suite_report report;
  report.results = {figure(2, 2.03, 0.01)};
  report.results.push_back(figure(2, 2, 0.01));
  report.results.back().name = side_by_side_case;
  report.left_out = {{"Cook", "no time"}};
  report.side_by_side = {{.part = "foot",
                          .element_order = 2,
                          .elements = 12,
                          .nodes = 34,
                          .displacement = 2e-7,
                          .reaction = 3e-9,
                          .surface_reaction = 4e-8,
                          .compliance = 5e-10,
                          .milliseconds = 600,
                          .other_milliseconds = 7000,
                          .program = "CalculiX 2.20"}};

  const auto page = markdown_page(report, {"TEdit", "tedit verify --suite", ""});

  EXPECT_THAT(page, HasSubstr("1 outside"));
  EXPECT_THAT(page, HasSubstr("| \\|u\\| at the end | 2 | 2.03 | +1.5 % | 1 % | **NO** |"));
  EXPECT_THAT(page, Not(HasSubstr(std::string("| ") + side_by_side_case)));
  EXPECT_THAT(page, HasSubstr("- Cook: no time"));
  EXPECT_THAT(page, HasSubstr("## Side by side with CalculiX 2.20\n"));
  EXPECT_THAT(page, HasSubstr("| foot | 2 | 12 | 34 | 2.0e-07 | 3.0e-09 | 4.0e-08 | 5.0e-10 | "
                              "0.6 | 7.0 |\n"));
  EXPECT_THAT(page, Not(HasSubstr("![")));
}

TEST(Plot, DrawsOneCurveForEachOrderAndNorm) {
  const std::vector<convergence_row> rows{{1, 6, 0.5, 0.2, 0.4, 0, 0},
                                          {1, 48, 0.25, 0.05, 0.2, 2, 1},
                                          {2, 6, 0.5, 0.02, 0.1, 0, 0},
                                          {2, 48, 0.25, 0.0025, 0.025, 3, 2}};

  const auto svg = convergence_svg(rows);

  const auto count = [&](const std::string& word) {
    std::size_t n = 0;
    for (auto at = svg.find(word); at != std::string::npos; at = svg.find(word, at + 1))
      ++n;
    return n;
  };
  EXPECT_EQ(count("<polyline"), 4u);
  EXPECT_EQ(count("<path"), 4u);
  EXPECT_EQ(count("<text"), count("</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_THAT(convergence_svg({}), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace tedit::verification
