// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/emboss/emboss.hpp"

#include <gmock/gmock.h>

#include "ops/tools/text/text_outlines.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

double outlined_area(const profile& p) {
  double twice = 0;
  for (const auto& o : p.outlines)
    for (std::size_t i = 0; i < o.points.size(); ++i) {
      const auto& a = o.points[i];
      const auto& b = o.points[(i + 1) % o.points.size()];
      twice += a[0] * b[1] - a[1] * b[0];
    }
  return 0.5 * std::abs(twice);
}

class Emboss : public test::tool_edits {
protected:
  expected<edit_result> written(const std::string& text, double height) {
    return emboss(plate_, {{0.5, 0.5, 0.2}, {0, 0, 1}, 0.1}, {text, "sans", 0.2, height, {0, 1, 0}},
                  {}, ctx_);
  }

  /// The area of the letters, holes off: TrueType's holes run the other way round.
  static double letters(const std::string& text) {
    return outlined_area(*text_outlines(text, *font_file("sans"), 0.2, 0.025));
  }

  version_ptr plate_ = test::box_mesh({10, 10, 2}, {1, 1, 0.2});
};

TEST_F(Emboss, LettersStandOutOfTheWall) {
  const auto result = written("Ab8", 0.03);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, 0.03 * letters("Ab8"), 1e-12);
}

TEST_F(Emboss, OrAreSunkIntoIt) {
  const auto result = written("HO", -0.04);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, -0.04 * letters("HO"), 1e-12);
}

TEST_F(Emboss, CapitalsAreAsHighAsAsked) {
  const auto outlines = text_outlines("H", *font_file("sans"), 0.2, 0.1);

  ASSERT_TRUE(outlines) << render(outlines.error());
  double high = 0;
  for (const auto& p : outlines->outlines.front().points)
    high = std::max(high, p[1]);
  EXPECT_NEAR(high, 0.1, 1e-12);
}

TEST_F(Emboss, TextsThatAreNoneAreTold) {
  EXPECT_THAT(written("", 0.03).error().message, HasSubstr("no text"));
  EXPECT_THAT(written("   ", 0.03).error().message, HasSubstr("no text"));
  EXPECT_THAT(written("A", 0).error().message, HasSubstr("no height"));
  EXPECT_THAT(written("\xff\xfe", 0.03).error().message, HasSubstr("UTF-8"));
  EXPECT_THAT(written("\xc3", 0.03).error().message, HasSubstr("UTF-8"));
  EXPECT_EQ(written("\x01", 0.03).error().code, ec::invalid_parameter);
}

}  // namespace
}  // namespace tedit::ops
