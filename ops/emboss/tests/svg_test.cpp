// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "ops/emboss/emboss.hpp"
#include "ops/shapes/outlines/svg_outlines.hpp"
#include "ops/shapes/outlines/svg_path.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/tool_edits.hpp"
#include "tests/support/tube.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

attachment picture(const std::string& body) {
  return {"logo.svg",
          R"(<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg">)" + body + "</svg>"};
}

/// Even-odd does not care about directions: all areas, holes by the caller.
double area_of(const outline& o) {
  double sum = 0;
  for (std::size_t i = 0; i < o.points.size(); ++i) {
    const auto& p = o.points[i];
    const auto& q = o.points[(i + 1) % o.points.size()];
    sum += p[0] * q[1] - q[0] * p[1];
  }
  return std::abs(sum) / 2;
}

TEST(SvgPath, EachCommandLeadsWhereItShould) {
  const std::pair<const char*, std::array<double, 2>> ends[] = {{"M 1 2 L 3 4", {3, 4}},
                                                                {"m 1 2 l 3 4", {4, 6}},
                                                                {"M1,2H5", {5, 2}},
                                                                {"M1,2h5", {6, 2}},
                                                                {"M1 2V5", {1, 5}},
                                                                {"M1 2v-5", {1, -3}},
                                                                {"M0 0C0 1 1 1 2 3", {2, 3}},
                                                                {"M1 1c0 1 1 1 2 3", {3, 4}},
                                                                {"M0 0S1 1 2 3", {2, 3}},
                                                                {"M0 0Q1 1 2 3", {2, 3}},
                                                                {"M0 0Q1 1 2 0T4 0", {4, 0}},
                                                                {"M0 0A1 1 0 0 1 2 0", {2, 0}},
                                                                {"M0 0a1 1 0 01 2 0", {2, 0}},
                                                                {"M.5.5 1.5-1e1", {1.5, -10}},
                                                                {"M 1 2 3 4 5 6", {5, 6}}};
  for (const auto& [text, end] : ends) {
    const auto outlines = svg_path(text);
    ASSERT_THAT(outlines, SizeIs(1)) << text;
    EXPECT_EQ(outlines[0].pieces.back().end, end) << text;
  }
}

TEST(SvgPath, AfterAMistakeNothingFollows) {
  EXPECT_THAT(svg_path("M 0 0 L 1 1 X 3 L 9 9")[0].pieces, SizeIs(1));
  EXPECT_THAT(svg_path("M 0 0 L 1"), SizeIs(1));
  EXPECT_THAT(svg_path("L nan nan"), SizeIs(0));
  EXPECT_THAT(svg_path(std::string(100000, 'M')), SizeIs(0));
}

TEST(SvgOutlines, TheLongerSideHasTheSizeAndYGoesUp) {
  // A triangle with its tip up on the screen: y is smaller there.
  const auto shape = svg_outlines(picture(R"(<polygon points="10,50 110,50 60,0"/>)"), 0.02, 0.001);

  ASSERT_TRUE(shape) << render(shape.error());
  ASSERT_THAT(shape->outlines, SizeIs(1));
  EXPECT_NEAR(area_of(shape->outlines[0]), 0.02 * 0.01 / 2, 1e-12);
  for (const auto& p : shape->outlines[0].points)
    if (std::abs(p[0]) < 1e-9) {
      EXPECT_NEAR(p[1], 0.005, 1e-9);
    }
}

TEST(SvgOutlines, ShapesHaveTheirAreas) {
  const double pi = std::numbers::pi;
  const std::pair<const char*, double> areas[] = {
    {R"(<circle cx="5" cy="5" r="4"/>)", pi / 4},
    {R"(<ellipse cx="5" cy="5" rx="4" ry="2"/>)", pi / 8},
    {R"(<rect x="1" y="1" width="8" height="4"/>)", 0.5},
    {R"(<rect width="8" height="8" rx="2"/>)", 1 - (4 - pi) / 16},
    {R"(<path d="M0 0 A 4 4 0 0 1 8 0 Z"/>)", pi / 8},
    {R"svg(<g transform="rotate(30) scale(3)"><g transform="translate(7 8)"><rect width="8" height="8" transform="rotate(-30)"/></g></g>)svg",
     1}};
  for (const auto& [body, area] : areas) {
    const auto shape = svg_outlines(picture(body), 1, 0.005);
    ASSERT_TRUE(shape) << body << ": " << render(shape.error());
    ASSERT_THAT(shape->outlines, SizeIs(1)) << body;
    EXPECT_NEAR(area_of(shape->outlines[0]), area, 5e-4) << body;  // Arcs as cubic curves.
  }
}

TEST(SvgOutlines, WhatIsNotFilledIsLeftOut) {
  const auto shape = svg_outlines(
    picture(
      R"(<defs><rect width="99" height="99"/></defs><g fill="none"><rect width="50" height="9"/>
      <rect width="4" height="4" fill="red"/></g><rect width="50" height="9" style="fill: none"/>
      <rect width="50" height="9" display="none"/><text>A</text>)"),
    1, 0.1);

  ASSERT_TRUE(shape) << render(shape.error());
  EXPECT_THAT(shape->outlines, SizeIs(1));
}

TEST(SvgOutlines, WhatIsNoPictureIsSaid) {
  const auto said = [](const attachment& file) {
    return svg_outlines(file, 0.01, 0.001).error().message;
  };
  EXPECT_THAT(said({"a.svg", "hello"}), HasSubstr("is no SVG picture"));
  EXPECT_THAT(said({"a.svg", "<html/>"}), HasSubstr("is no SVG picture"));
  EXPECT_THAT(said(picture("")), HasSubstr("has no filled shape"));
  EXPECT_THAT(said(picture(R"(<path d="M0 0 L1e308 1e308 L-1e308 1"/>)")),
              HasSubstr("has no filled shape"));
  EXPECT_THAT(svg_outlines(picture(R"(<circle r="1"/>)"), 1, 1e-5).error().message,
              HasSubstr("too many curves"));
  std::string deep;
  for (int i = 0; i < 10000; ++i)
    deep += "<g>";
  EXPECT_FALSE(svg_outlines(picture(deep), 0.01, 0.001));
}

class Logo : public test::tool_edits {
protected:
  static outline_file logo(const std::string& body) {
    return *outline_file::read(picture(body), 1);
  }

  version_ptr plate_ = test::box_mesh({10, 10, 2}, {1, 1, 0.2});
};

TEST_F(Logo, ARingIsRaisedWithItsHole) {
  emboss_text what;
  what.logo = logo(R"(<path d="M0 0H8V8H0Z M2 2H6V6H2Z"/>)");
  what.letter_height = 0.4;
  what.height = 0.05;
  what.up = {0, 1, 0};

  const auto result = emboss(plate_, {{0.5, 0.5, 0.2}, {0, 0, 1}, 0.1}, what, {6}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  expect_good(plate_, *result);
  EXPECT_NEAR(result->volume_change, 0.05 * (0.4 * 0.4 - 0.2 * 0.2), 1e-12);
}

/// A rectangle that follows a pin or a bore is a piece of a ring, up to the height of the arcs over
/// the wall's 64 edges.
TEST_F(Logo, AroundACylinderItIsAPieceOfARing) {
  const test::tube shape{.sides = 64, .rings = 8, .layers = 8};
  const auto tube = test::tube_mesh(shape);
  for (const bool bore : {false, true}) {
    const double r = bore ? shape.inner : shape.outer;
    emboss_text what;
    what.logo = logo(R"(<rect width="8" height="4"/>)");
    what.letter_height = r / 2;  // Along the circle: half a radian.
    what.height = 0.1 * r;
    what.up = {0, 0, 1};
    const placement where{{r, 0, 0.5}, {bore ? -1.0 : 1.0, 0, 0}, 0.13 * r};

    const auto result = emboss(tube, where, what, {bore ? 1 : 2}, ctx_);

    ASSERT_TRUE(result) << render(result.error());
    expect_good(tube, *result);
    const double low = bore ? 0.9 * r : r;
    const double high = bore ? r : 1.1 * r;
    const double ring = 0.5 * 0.5 * (high * high - low * low) * (r / 4);
    EXPECT_NEAR(result->volume_change, ring, 0.03 * ring) << (bore ? "bore" : "pin");
  }
}

TEST_F(Logo, OrItStandsStraightOnIt) {
  const test::tube shape{.sides = 64, .rings = 8, .layers = 8};
  const auto tube = test::tube_mesh(shape);
  emboss_text what;
  what.logo = logo(R"(<rect width="8" height="4"/>)");
  what.letter_height = 1;
  what.height = 0.1;
  what.up = {0, 0, 1};
  what.wraps = false;

  const auto result = emboss(tube, {{2, 0, 0.5}, {1, 0, 0}, 0.25}, what, {2}, ctx_);

  ASSERT_TRUE(result) << render(result.error());
  // Its top is flat: as high as 0.1 over the place, more beside it.
  double furthest = 0;
  for (vertex_id v = 0; v < result->candidate->vertex_slots(); ++v)
    if (result->candidate->is_live_vertex(v))
      furthest = std::max(furthest, result->candidate->position(v).x);
  EXPECT_NEAR(furthest, 2.1, 1e-9);
}

}  // namespace
}  // namespace tedit::ops
