// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/typed_quantity.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tedit::desktop {
namespace {

TEST(TypedNumber, IsReadAsPeopleWriteIt) {
  EXPECT_EQ(read_number("12.5"), 12.5);
  EXPECT_EQ(read_number(" 12,5 "), 12.5);
  EXPECT_EQ(read_number("\u22123e-3"), -3e-3);
  EXPECT_EQ(read_number("+.5"), 0.5);
  EXPECT_EQ(read_number("1/4"), 0.25);
  EXPECT_EQ(read_number("-1 1/2"), -1.5);
  for (const auto* none : {"12 mm", "inf", "nan", "", "-", "1e", "1,000.5", "1/0", "0x10", "1e400"})
    EXPECT_FALSE(read_number(none)) << none;
}

TEST(TypedQuantity, WithoutAUnitIsInTheOneThatIsShown) {
  EXPECT_DOUBLE_EQ(*read_quantity("5", "m"), 5e-3);
  EXPECT_DOUBLE_EQ(*read_quantity("0,4", "Pa"), 0.4e6);
  EXPECT_DOUBLE_EQ(*read_quantity("90", "rad"), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(*read_quantity("5", "N"), 5);
  EXPECT_DOUBLE_EQ(*read_quantity("0.3", ""), 0.3);
}

TEST(TypedQuantity, TakesTheUnitsOfItsKind) {
  EXPECT_DOUBLE_EQ(*read_quantity("5 kN", "N"), 5000);
  EXPECT_DOUBLE_EQ(*read_quantity("-2kN", "N"), -2000);
  EXPECT_DOUBLE_EQ(*read_quantity("1 lbf", "N"), 4.4482216152605);
  EXPECT_DOUBLE_EQ(*read_quantity("1/4 in", "m"), 0.00635);
  EXPECT_DOUBLE_EQ(*read_quantity("1 1/2\"", "m"), 0.0381);
  EXPECT_DOUBLE_EQ(*read_quantity("2 m", "m"), 2);
  EXPECT_DOUBLE_EQ(*read_quantity("30 µm", "m"), 30e-6);
  EXPECT_DOUBLE_EQ(*read_quantity("210 GPa", "Pa"), 210e9);
  EXPECT_DOUBLE_EQ(*read_quantity("2 N/mm²", "Pa"), 2e6);
  EXPECT_DOUBLE_EQ(*read_quantity("1 bar", "Pa"), 1e5);
  EXPECT_NEAR(*read_quantity("1 psi", "Pa"), 6894.757, 1e-3);
  EXPECT_DOUBLE_EQ(*read_quantity("3 Nm", "N m"), 3);
  EXPECT_DOUBLE_EQ(*read_quantity("3 N·mm", "N m"), 3e-3);
  EXPECT_DOUBLE_EQ(*read_quantity("1 g", "m/s2"), 9.80665);
  EXPECT_DOUBLE_EQ(*read_quantity("7,85 g/cm³", "kg/m3"), 7850);
  EXPECT_DOUBLE_EQ(*read_quantity("45°", "rad"), std::numbers::pi / 4);
}

TEST(TypedQuantity, RefusesTheUnitsOfOthers) {
  EXPECT_FALSE(read_quantity("5 kN", "m"));
  EXPECT_FALSE(read_quantity("5 mm", "Pa"));
  EXPECT_FALSE(read_quantity("5 mpa", "Pa"));  // Milli and mega must not be guessed.
  EXPECT_FALSE(read_quantity("5 mm", ""));
  EXPECT_FALSE(read_quantity("mm", "m"));
}

TEST(TypedQuantity, SaysWhichUnitsItTakes) {
  EXPECT_EQ(other_units("m"), QString::fromUtf8("µm, cm, m, in, ft"));
  EXPECT_EQ(other_units("N m"), "N mm, kN m");
  EXPECT_EQ(other_units(""), "");
}

}  // namespace
}  // namespace tedit::desktop
