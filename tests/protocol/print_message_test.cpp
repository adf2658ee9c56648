// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/print_message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tedit/v1/print.pb.h"

namespace tedit::protocol {
namespace {

using ::testing::HasSubstr;

/// Each number another one: what is put into the wrong place shows.
print_findings full_findings() {
  print_findings all;
  all.volume = 1.5;
  all.area = 2.5;
  all.extent = {{1, 2, 3}, {4, 5, 6}};
  all.bodies = 7;
  all.closed_voids = 8;
  all.open_edges = 9;
  all.hinge_edges = 10;
  all.crossing_facets = 11;
  all.thin = {{{-3, 4}, 12, 0.25, 1e-3, {7, 8, 9}}};
  all.thin_area = 0.5;
  all.overhangs = {{{5}, 13, 0.75, 1.25, {10, 11, 12}}, {{6}, 1, 0.125, 1, {}}};
  all.overhang_area = 0.875;
  all.plate_area = 3.5;
  return all;
}

v1::PrintChecked sent(const print_settings& settings, const print_findings& found) {
  v1::PrintChecked message;
  to_message(settings, found, &message);
  v1::PrintChecked arrived;
  EXPECT_TRUE(arrived.ParseFromString(message.SerializeAsString()));
  return arrived;
}

TEST(PrintMessage, AllOfItSurvivesTheWire) {
  const auto message = sent({{1, 2, -2}, 3e-3, 0.5}, full_findings());

  EXPECT_EQ(findings_from(message), full_findings());
  EXPECT_EQ(settings_from(message), (print_settings{{1, 2, -2}, 3e-3, 0.5}));
  EXPECT_EQ(message.thin_places(), 1U);
  EXPECT_EQ(message.overhanging_places(), 2U);
}

TEST(PrintMessage, OnlyTheLargestPlacesAreSentAndAllAreCounted) {
  auto all = full_findings();
  all.thin.resize(most_print_places + 5, {{1}, 1, 0.1, 1e-4, {}});
  const auto message = sent({}, all);

  EXPECT_EQ(message.thin_size(), 1000);
  EXPECT_EQ(message.thin_places(), 1005U);
  EXPECT_EQ(message.thin(0).area_m2(), 0.25);
}

TEST(PrintMessage, WhatIsNotSaidIsUpwardsAndFortyFiveDegreesWithoutThinWalls) {
  EXPECT_EQ(*read_print_settings({}), (print_settings{{0, 0, 1}, 0, 45 * degree}));
  v1::CheckPrint request;
  request.set_overhang_rad(0);
  EXPECT_EQ(read_print_settings(request)->lean, 0) << "an upright wall is an angle, too";
  write_print_settings({{-1, 0, 2}, 2e-3, 0.25}, &request);
  EXPECT_EQ(*read_print_settings(request), (print_settings{{-1, 0, 2}, 2e-3, 0.25}));
}

TEST(PrintMessage, NumbersOutOfRangeAreRefusedByName) {
  const auto refusal = [](const print_settings& settings) {
    v1::CheckPrint request;
    write_print_settings(settings, &request);
    const auto read = read_print_settings(request);
    EXPECT_FALSE(read.has_value());
    if (read)
      return std::string();
    EXPECT_EQ(read.error().code, ec::invalid_argument);
    return read.error().message;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal({{0, 0, 1}, -1, 0.5}), HasSubstr("check_print.thinner_than_m is -1"));
  EXPECT_THAT(refusal({{0, 0, 1}, 1001, 0.5}), HasSubstr("check_print.thinner_than_m is 1001"));
  EXPECT_THAT(refusal({{0, 0, 1}, nan, 0.5}), HasSubstr("check_print.thinner_than_m is nan"));
  EXPECT_THAT(refusal({{0, 0, 1}, 0, 1.58}), HasSubstr("check_print.overhang_rad is 1.58"));
  EXPECT_THAT(refusal({{0, 0, 1}, 0, -0.1}), HasSubstr("check_print.overhang_rad"));
  EXPECT_THAT(refusal({{0, 2e6, 1}, 0, 0.5}), HasSubstr("check_print.direction.y is 2e+06"));
  EXPECT_THAT(refusal({{0, 0, 0}, 0, 0.5}), HasSubstr("the build direction has no length"));
}

}  // namespace
}  // namespace tedit::protocol
