// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/field_values.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tedit::desktop {
namespace {

constexpr auto von_mises = shown_field::von_mises;
constexpr auto displacement = shown_field::displacement;
constexpr auto principal_1 = field_named("principal_1");
constexpr auto principal_2 = field_named("principal_2");
constexpr auto principal_3 = field_named("principal_3");
constexpr auto max_shear = field_named("max_shear");
constexpr auto stress_yy = field_named("stress_yy");
constexpr auto stress_yz = field_named("stress_yz");
constexpr auto stress_zx = field_named("stress_zx");
constexpr auto relative_error = field_named("relative_error");

/// One vertex under a stress (xx, yy, zz, xy, yz, zx).
client::field_event stressed(std::vector<float> stress) {
  client::field_event field;
  field.vertices = {4};
  field.values["von_mises_pa"] = {0};
  field.values["displacement_m"] = {0, 0, 0};
  field.values["stress_pa"] = std::move(stress);
  return field;
}

TEST(Stress, ABarInTensionHasOnePrincipalStressAndHalfOfItAsShear) {
  const auto bar = stressed({0, 2e6F, 0, 0, 0, 0});

  EXPECT_FLOAT_EQ(value_in(bar, 0, principal_1), 2e6F);
  EXPECT_NEAR(value_in(bar, 0, principal_2), 0, 0.5);
  EXPECT_NEAR(value_in(bar, 0, principal_3), 0, 0.5);
  EXPECT_FLOAT_EQ(value_in(bar, 0, max_shear), 1e6F);
  EXPECT_EQ(value_in(bar, 0, stress_yy), 2e6F);
}

TEST(Stress, PureShearPullsAndPushesAlike) {
  const auto shaft = stressed({0, 0, 0, 0, 3, 0});

  EXPECT_FLOAT_EQ(value_in(shaft, 0, principal_1), 3);
  EXPECT_NEAR(value_in(shaft, 0, principal_2), 0, 1e-6);
  EXPECT_FLOAT_EQ(value_in(shaft, 0, principal_3), -3);
  EXPECT_FLOAT_EQ(value_in(shaft, 0, max_shear), 3);
  EXPECT_EQ(value_in(shaft, 0, stress_yz), 3);
  EXPECT_EQ(value_in(shaft, 0, stress_zx), 0);
}

TEST(Stress, PressureFromAllSidesHasNoShear) {
  const float under_water[] = {-5, -5, -5, 0, 0, 0};
  const float none[] = {0, 0, 0, 0, 0, 0};

  EXPECT_EQ(principal_values(under_water), (std::array<double, 3>{-5, -5, -5}));
  EXPECT_EQ(principal_values(none), (std::array<double, 3>{0, 0, 0}));
}

TEST(Stress, PrincipalValuesAreThoseOfAMatrixThatIsKnown) {
  // Eigenvalues of (2 1 0; 1 2 0; 0 0 5): 5, 3, 1.
  const float s[] = {2, 2, 5, 1, 0, 0};
  const auto p = principal_values(s);

  EXPECT_NEAR(p[0], 5, 1e-12);
  EXPECT_NEAR(p[1], 3, 1e-12);
  EXPECT_NEAR(p[2], 1, 1e-12);
}

TEST(Fields, WhatWasNotSentHasNoValue) {
  client::field_event bare;
  bare.vertices = {4};
  bare.values["von_mises_pa"] = {7};
  bare.values["displacement_m"] = {3, 4, 0};

  EXPECT_EQ(value_at(bare, 4, von_mises), 7);
  EXPECT_EQ(value_at(bare, 4, displacement), 5);
  for (const auto one :
       {principal_1, max_shear, stress_zx, shown_field::safety_factor, relative_error}) {
    EXPECT_TRUE(std::isnan(value_at(bare, 4, one)));
    EXPECT_FALSE(has(bare, one));
  }
  EXPECT_TRUE(has(bare, shown_field::displacement_z));
  EXPECT_EQ(needs(stress_zx), (std::set<std::string>{"stress_pa"}));
  EXPECT_TRUE(needs(shown_field::displacement_x).empty());
  EXPECT_TRUE(needs(shown_field::none).empty());
  EXPECT_EQ(needs(relative_error), (std::set<std::string>{"relative_error"}));
}

TEST(Fields, ASectionIsReadAsTheSurfaceIs) {
  client::section cut;
  cut.positions = {0, 0, 0};
  cut.values["stress_pa"] = {0, 0, -4, 0, 0, 0};
  cut.values["safety_factor"] = {0};  // Not known.

  EXPECT_FLOAT_EQ(value_in(cut, 0, principal_3), -4);
  EXPECT_TRUE(std::isnan(value_in(cut, 0, shown_field::safety_factor)));
}

}  // namespace
}  // namespace tedit::desktop
