// SPDX-License-Identifier: AGPL-3.0-or-later
// Kinds of parameters that are several numbers: axes, planes, polylines and lists.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "ops/loader/catalogue.hpp"

namespace tedit::ops {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

operation_description several() {
  operation_description d;
  d.id = "several";
  d.parameters = {
    {"axis", "", "Where.", parameter_type::axis, "m", {}, {}, {}, std::string("0, 0, 0; 0, 0, 1")},
    {"plane", "", "Where.", parameter_type::plane, "m", {}, {}, {}, std::string()},
    {"path", "", "Which way.", parameter_type::polyline, "m", 3.0, 5.0, {}, std::string()},
    {"angles", "", "How far.", parameter_type::list, "rad", -1.0, 1.0, {}, std::string()},
    {"widths", "", "How wide.", parameter_type::list, "m", 0.0, {}, {}, std::string("1, 2")},
  };
  return d;
}

std::string refusal(const char* id, const parameter_value& value) {
  const auto values = complete_parameters(several(), {{id, value}});
  EXPECT_FALSE(values.has_value()) << id;
  return values ? "" : render(values.error());
}

parameters accepted(const char* id, const parameter_value& value) {
  const auto values = complete_parameters(several(), {{id, value}});
  EXPECT_TRUE(values.has_value()) << render(values.error());
  return values.value_or(parameters{});
}

TEST(NumberTexts, AnAxisIsAPointInMetresAndAUnitDirection) {
  // Of (0, 3, 4) the length is 5; in millimetres only the point is a length.
  for (const char* text : {"10, 0, -5; 0, 3, 4", "10 0 -5 ; 0 3 4;", "10,0,-5,0,3,4"}) {
    const auto axis = axis_of(accepted("axis_mm", std::string(text)), "axis");

    ASSERT_TRUE(axis.has_value()) << text;
    EXPECT_LT(norm(axis->point - vec3{0.01, 0, -0.005}), 1e-17) << text;
    EXPECT_LT(norm(axis->direction - vec3{0, 0.6, 0.8}), 1e-15) << text;
  }
}

TEST(NumberTexts, APlaneMayBeLeftToTheOperationAndAnAxisWithADefaultMayNot) {
  const auto usual = accepted("plane", std::string(" "));

  EXPECT_EQ(axis_of(usual, "plane"), std::nullopt);
  EXPECT_EQ(axis_of(usual, "axis")->direction, (vec3{0, 0, 1}));
  EXPECT_TRUE(points_of(usual, "path").empty());
  EXPECT_TRUE(numbers_of(usual, "angles").empty());
  EXPECT_THAT(numbers_of(usual, "widths"), ElementsAre(1, 2));
  EXPECT_THAT(refusal("axis", std::string()), HasSubstr("it is a point and a direction"));
}

TEST(NumberTexts, APolylineIsItsPoints) {
  const auto path = points_of(accepted("path_mm", std::string("0,0,0; 1,0,0; 0,0,0")), "path");

  EXPECT_THAT(path, ElementsAre(vec3{}, vec3{1e-3, 0, 0}, vec3{}));
  EXPECT_THAT(refusal("path", std::string("0,0,0; 1,0,0")),
              HasSubstr("path: it has 2 points, and takes 3 to 5"));
  EXPECT_THAT(refusal("path", std::string("0 0 0 1 0 0 2 0 0 3 0 0 4 0 0 5 0 0")),
              HasSubstr("it has 6 points"));
  EXPECT_THAT(refusal("path", std::string("0,0,0; 1,0,0; 1,0,0")),
              HasSubstr("points 2 and 3 are the same"));
  EXPECT_THAT(refusal("path", std::string("0,0,0; 1,0; 2,0,0")),
              HasSubstr("points of three numbers each"));
}

TEST(NumberTexts, EachNumberOfAListIsInRange) {
  EXPECT_THAT(numbers_of(accepted("angles", std::string("0.5, -1; 1")), "angles"),
              ElementsAre(0.5, -1, 1));
  EXPECT_THAT(numbers_of(accepted("angles", 0.25), "angles"), ElementsAre(0.25));
  EXPECT_THAT(numbers_of(accepted("angles", std::int64_t{-1}), "angles"), ElementsAre(-1));
  EXPECT_THAT(numbers_of(accepted("widths_mm", std::string("1 20")), "widths"),
              ElementsAre(1e-3, 0.02));
  EXPECT_THAT(refusal("angles", std::string("0.5, 1.5")),
              HasSubstr("angles: number 2, 1.5, is out of range. Each takes -1 to 1 rad"));
  EXPECT_THAT(refusal("angles_mm", std::string("0.5")), HasSubstr("no parameter \"angles_mm\""));
  EXPECT_THAT(refusal("angles", true), HasSubstr("it is numbers, as"));
}

TEST(NumberTexts, WhatIsNoneIsRefused) {
  for (const char* text :
       {"0, 0, 0; 0, 0, 0", "0, 0, nan; 0, 0, 1", "0, 0, 0; 0, 0, inf", "0, 0, 1e31; 0, 0, 1",
        "0, 0, 0", "0, 0; 0, 0, 0, 1", ";0, 0, 0; 0, 0, 1", "0, 0, 0; 0, 0, 1; 0, 0, 1",
        "0, 0, 0; 0, 0, 1mm", "0, 0, 0; 0, 0, 0x1", "a; b", "0,0,0;;0,0,1"})
    for (const char* id : {"axis", "plane"})
      EXPECT_THAT(refusal(id, std::string(text)), HasSubstr(std::string("parameter ") + id))
        << text;
  EXPECT_THAT(refusal("plane", std::string("0, 0, 0; 0, 0, 0")),
              HasSubstr("its normal is 0, 0, 0"));
  EXPECT_THAT(refusal("axis", 1.0), HasSubstr("a point and a direction"));
}

TEST(NumberTexts, WhatIsTooLongIsRefusedAtOnce) {
  std::string most = "0";
  for (int i = 1; i < 10'000; ++i)
    most += ",1";

  EXPECT_EQ(numbers_of(accepted("angles", most), "angles").size(), 10'000u);
  EXPECT_THAT(refusal("angles", most + ",1"), HasSubstr("more than 10000 numbers"));
  EXPECT_THAT(refusal("angles", std::string(1 << 24, '1')), HasSubstr("angles"));
  std::string endless;
  for (int i = 0; i < 1'000'000; ++i)
    endless += "1 ";
  EXPECT_THAT(refusal("angles", endless), HasSubstr("it is numbers"));
}

TEST(NumberTexts, AnyFiniteNumbersComeBackAsTheyWere) {
  const auto number =
    rc::gen::map(rc::gen::pair(rc::gen::inRange(-1'000'000, 1'000'000), rc::gen::inRange(-25, 23)),
                 [](const auto& p) { return p.first * std::pow(10, p.second); });
  EXPECT_TRUE(rc::check("text of numbers", [&] {
    const auto numbers =
      *rc::gen::suchThat(rc::gen::container<std::vector<double>>(6, number), [](const auto& v) {
        return norm(vec3{v[3], v[4], v[5]}) > 0;
      });
    std::ostringstream text;
    text.precision(17);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      text << (i == 0 ? "" : i == 3 ? ";" : ",") << numbers[i];
    const auto once = complete_parameters(several(), {{"axis", text.str()}});
    RC_ASSERT(once.has_value());
    RC_ASSERT(numbers_of(*once, "axis") == numbers);
    RC_ASSERT(complete_parameters(several(), *once).value() == *once);
    RC_ASSERT(std::abs(norm(axis_of(*once, "axis")->direction) - 1) < 1e-15);
  }));
}

TEST(NumberTexts, AnyTextGetsAnAnswerAndNothingButFiniteNumbers) {
  EXPECT_TRUE(rc::check("any text", [] {
    const auto text = *rc::gen::container<std::string>(
      rc::gen::elementOf(std::string("0123456789.,; e+-nanif\n\t\xff")));
    for (const char* id : {"axis", "plane", "path", "angles", "widths"})
      if (const auto values = complete_parameters(several(), {{id, text}}))
        for (const double x : numbers_of(*values, id))
          RC_ASSERT(std::isfinite(x) && std::abs(x) <= 1e30);
  }));
}

}  // namespace
}  // namespace tedit::ops
