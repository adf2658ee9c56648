// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/legend.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "tests/desktop/colours.hpp"

namespace tedit::desktop {
namespace {

TEST(Legend, TakesTheRangeOfFiniteValuesOnly) {
  legend by;
  const float values[] = {3e6F, NAN, -1e6F, INFINITY};
  by.fit(values);

  EXPECT_DOUBLE_EQ(by.low, -1e6);
  EXPECT_DOUBLE_EQ(by.high, 3e6);
  EXPECT_DOUBLE_EQ(by.place(1e6), 0.5);
}

TEST(Legend, AUniformFieldGetsARangeAroundItsValue) {
  legend by;
  const float values[] = {5.0F, 5.0F};
  by.fit(values);

  EXPECT_LT(by.low, 5);
  EXPECT_GT(by.high, 5);
  EXPECT_NEAR(by.place(5), 0.5, 1e-6);
}

TEST(Legend, NoValuesAtAllLeaveAUsableRange) {
  legend by;
  by.fit({});

  EXPECT_LT(by.low, by.high);
}

TEST(Legend, ALockedRangeStaysAndCutsWhatIsOutside) {
  legend by;
  by.low = 0;
  by.high = 10;
  by.mode = range_mode::locked;
  const float values[] = {-5.0F, 50.0F};
  by.fit(values);

  EXPECT_DOUBLE_EQ(by.high, 10);
  EXPECT_DOUBLE_EQ(by.place(-5), 0);
  EXPECT_DOUBLE_EQ(by.place(50), 1);
}

TEST(Legend, LogarithmicPlacesDecadesEvenly) {
  legend by;
  by.low = 1;
  by.high = 100;
  by.logarithmic = true;

  EXPECT_NEAR(by.place(10), 0.5, 1e-12);
  EXPECT_EQ(by.ticks(7), (std::vector<double>{1, 5, 10, 50, 100}));
}

TEST(Legend, ALogarithmOfZeroAndBelowIsTheLowEnd) {
  legend by;
  by.low = 0;
  by.high = 100;
  by.logarithmic = true;

  EXPECT_DOUBLE_EQ(by.place(0), 0);
  EXPECT_DOUBLE_EQ(by.place(-3), 0);
  EXPECT_DOUBLE_EQ(by.place(100), 1);
}

TEST(Legend, TicksAreRoundInTheUnitThatIsShown) {
  legend by;  // von Mises: MPa.
  by.low = 0.1e6;
  by.high = 13.4e6;

  const auto ticks = by.ticks(4);

  ASSERT_EQ(ticks.size(), 2U);
  EXPECT_DOUBLE_EQ(ticks[0], 5e6);
  EXPECT_DOUBLE_EQ(ticks[1], 10e6);
}

TEST(Colours, ReachBothEndsAndGoNowhereElse) {
  for (const auto map : {colour_map::viridis, colour_map::cividis, colour_map::grey,
                         colour_map::coolwarm, colour_map::safety}) {
    EXPECT_EQ(colour(map, -1), colour(map, 0));
    EXPECT_EQ(colour(map, 2), colour(map, 1));
    EXPECT_NE(colour(map, 0), colour(map, 1));
    EXPECT_EQ(colour(map, NAN), colour(map, 0));
  }
}

TEST(Colours, PerceptualMapsGrowLighterAllTheWay) {
  for (const auto map : {colour_map::viridis, colour_map::cividis, colour_map::grey}) {
    double before = -1;
    for (int i = 0; i <= 50; ++i) {
      const auto c = colour(map, i / 50.0);
      const double lightness = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
      EXPECT_GT(lightness, before) << i;
      before = lightness;
    }
  }
}

TEST(Colours, TheDefaultMapGrowsLighterInEveryStepAndBeginsWhereAShadeCanBeRead) {
  double before = 35;
  for (int i = 0; i < 256; ++i) {
    const auto c = colour(legend{}.map, i / 255.0);
    const double lightness = lab_of({c[0], c[1], c[2]})[0];
    EXPECT_GT(lightness, before) << i;
    before = lightness;
  }
  EXPECT_GT(before, 90);
}

TEST(Legend, OneHotCornerDoesNotTakeTheColoursFromAllTheRest) {
  legend by;
  std::vector<float> values(1000);
  std::vector<float> areas(1000, 2e-6F);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>(i) * 1e3F;
  values[999] = 50e6F;

  by.fit(values, areas);
  EXPECT_NEAR(by.high, 990e3, 2e3);
  EXPECT_EQ(by.beyond, 50e6);

  // By area, not by the number of points: a fine mesh around the corner changes nothing.
  for (std::size_t i = 500; i < 1000; ++i)
    areas[i] = 1e-9F;
  by.fit(values, areas);
  EXPECT_NEAR(by.high, 495e3, 2e3);

  by.mode = range_mode::full;
  by.fit(values, areas);
  EXPECT_DOUBLE_EQ(by.high, 50e6);
  EXPECT_FALSE(by.beyond);
}

TEST(Legend, TheCapOfWhatHasASignIsTheSameBothWays) {
  legend by;
  by.field = field_named("principal_1");
  by.map = colour_map::coolwarm;
  std::vector<float> values(200, -2e6F);
  values[0] = 80e6F;
  const std::vector<float> areas(200, 1);

  by.fit(values, areas);

  EXPECT_DOUBLE_EQ(by.high, 2e6);
  EXPECT_DOUBLE_EQ(by.low, -2e6);
  EXPECT_EQ(by.beyond, 80e6);
}

TEST(Legend, AnUnloadedPartKeepsTheRangeOfThePlaceThatIsLoaded) {
  legend by;
  std::vector<float> values(1000, 0);
  values[7] = 3e6F;

  by.fit(values, std::vector<float>(1000, 1));

  EXPECT_DOUBLE_EQ(by.high, 3e6);
  EXPECT_FALSE(by.beyond);
}

TEST(Legend, BothEndsHaveTheirNumberRoundedByTheRange) {
  legend by;  // von Mises: MPa.
  by.low = 0.054;
  by.high = 7.1174e6;

  const auto labels = by.labels(7);

  ASSERT_GE(labels.size(), 4U);
  EXPECT_DOUBLE_EQ(labels.front(), by.low);
  EXPECT_DOUBLE_EQ(labels.back(), by.high);
  EXPECT_EQ(by.label(labels.front()), "0");
  EXPECT_EQ(by.label(labels.back()), "7.12");
  for (std::size_t i = 1; i < labels.size(); ++i)
    EXPECT_GT(by.place(labels[i]) - by.place(labels[i - 1]), 0.1) << "words that touch";
}

TEST(Legend, WithTheDivergingMapZeroIsInTheMiddle) {
  legend by;
  by.field = field_named("principal_1");
  by.map = colour_map::coolwarm;
  const float values[] = {-1e6F, 7e6F};
  by.fit(values);

  EXPECT_DOUBLE_EQ(by.low, -7e6);
  EXPECT_DOUBLE_EQ(by.high, 7e6);
  EXPECT_DOUBLE_EQ(by.place(0), 0.5);
}

TEST(Legend, SafetyIsReadByItsStepsWhateverTheValues) {
  legend by;
  by.field = shown_field::safety_factor;
  by.map = colour_map::safety;
  const float values[] = {0.4F, 1e6F};
  by.fit(values);

  const auto red = by.colour_at(by.place(0.2));
  EXPECT_EQ(by.colour_at(by.place(0.999)), red);
  EXPECT_NE(by.colour_at(by.place(1.001)), red);
  EXPECT_EQ(by.colour_at(by.place(20)), by.colour_at(by.place(1e6)));
  EXPECT_EQ(by.ticks(7), (std::vector<double>{1, 1.5, 2, 3, 5}));
  EXPECT_EQ(by.levels(), by.ticks(7));
  for (const double value : {0.5, 1.25, 4.0})
    EXPECT_DOUBLE_EQ(by.value(by.place(value)), value);
}

TEST(Legend, BothEndsOfTheSafetyStepsSayWhatTheirColourMeans) {
  legend by;
  by.field = shown_field::safety_factor;
  by.map = colour_map::safety;

  QStringList words;
  for (const double at : by.labels(7))
    words << by.label(at);

  // The bluest step begins at 5 and has no end.
  EXPECT_EQ(words, (QStringList{"0", "1", "1.5", "2", "3", "5", "5 or more"}));
  EXPECT_EQ(by.colour_at(by.place(6)), by.colour_at(by.place(1e6)));
}

TEST(Legend, BandsHaveOneColourEachAndTicksAtTheirEdges) {
  legend by;
  by.low = 0;
  by.high = 8e6;
  by.bands = 8;

  EXPECT_EQ(by.colour_at(0.01), by.colour_at(0.12));
  EXPECT_NE(by.colour_at(0.12), by.colour_at(0.13));
  EXPECT_EQ(by.colour_at(1), by.colour_at(0.9));
  EXPECT_EQ(by.levels(), (std::vector<double>{1e6, 2e6, 3e6, 4e6, 5e6, 6e6, 7e6}));
  EXPECT_EQ(by.ticks(7).size(), 9U);  // Both ends, too.
  by.bands = 0;
  EXPECT_EQ(by.levels().size(), 9U);
}

TEST(Legend, AnAutomaticRangeIsThatOfTheValuesAndNoOther) {
  legend one;
  legend other = one;
  one.low = 3;
  one.high = 7;

  EXPECT_TRUE(one.draws_like(other));
  EXPECT_TRUE(other.draws_like(one));
  other.map = colour_map::grey;
  EXPECT_FALSE(one.draws_like(other));
  other.map = one.map;
  other.mode = one.mode = range_mode::manual;
  EXPECT_FALSE(one.draws_like(other));
}

TEST(Fields, EachIsInOneGroupAndSaysWhatItIs) {
  std::set<shown_field> seen;
  for (const auto& group : field_groups())
    for (const auto field : group) {
      EXPECT_TRUE(seen.insert(field).second);
      EXPECT_FALSE(field_help(field).isEmpty());
    }
  EXPECT_EQ(seen.size(), std::size(fem::shown_quantities) + 2);
  EXPECT_EQ(field_value(field_named("relative_error"), 0.032), "3.2 %");
  EXPECT_EQ(field_value(shown_field::safety_factor, 1e6), "over 1000");
  EXPECT_EQ(field_value(field_named("principal_3"), -2e6), "-2 MPa");
  EXPECT_EQ(field_value(field_named("largest_strain"), 1.25e-3), QString::fromUtf8("1250 µm/m"));
}

TEST(Fields, IdsLeadBackToTheField) {
  for (const auto& group : field_groups())
    for (const auto field : group)
      EXPECT_EQ(field_from_id(field_id(field)), field);
  EXPECT_EQ(field_from_id("nonsense"), shown_field::none);
}

}  // namespace
}  // namespace tedit::desktop
