// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/surface_search.hpp"

#include <gtest/gtest.h>

namespace tedit::desktop {
namespace {

using what = surface_search::what;

void expect_bores(const char* words, double low_mm, double high_mm) {
  const auto got = read_search(QString::fromUtf8(words));
  EXPECT_EQ(got.kind, what::bores) << words;
  EXPECT_NEAR(1e3 * got.low, low_mm, 1e-9) << words;
  if (high_mm < 1e9)
    EXPECT_NEAR(1e3 * got.high, high_mm, 1e-9) << words;
  else
    EXPECT_GT(got.high, 1e9) << words;
}

TEST(SurfaceSearch, FindsBoresByTheirDiameter) {
  expect_bores("bores", 0, 1e300);
  expect_bores("Bores 8 to 12 mm", 8, 12);
  expect_bores("holes 12-8", 8, 12);
  expect_bores("bores 1/4 to 1/2 in", 6.35, 12.7);
  expect_bores("bores 1 cm to 12", 10, 120);
  expect_bores("hole over 20", 20, 1e300);
  expect_bores("bores < 6,5 mm", 0, 6.5);
  expect_bores("bore 10", 9.8, 10.2);
  expect_bores("Bohrungen 8 bis 12 mm", 8, 12);
  expect_bores("L\u00f6cher ab 3", 3, 1e300);
}

TEST(SurfaceSearch, WhatItDoesNotUnderstandIsAName) {
  for (const auto* words : {"bores of steel", "bore -3", "cover", "12", "hole 8 kN", ""}) {
    const auto got = read_search(words);
    EXPECT_EQ(got.kind, what::named) << words;
    EXPECT_EQ(got.name, words);
  }
}

TEST(SurfaceSearch, KnowsWhatBelongsToTheSelection) {
  EXPECT_EQ(read_search("Equal").kind, what::equal);
  EXPECT_EQ(read_search("smooth").kind, what::smooth);
  EXPECT_EQ(read_search("neighbours ").kind, what::neighbours);
  EXPECT_EQ(read_search("gleiche").kind, what::equal);
}

TEST(SurfaceSearch, EqualSurfacesHaveTheSameArea) {
  std::map<surface_id, client::surface_row> rows;
  for (const auto& [id, area] : {std::pair{1, 1.0}, {2, 1.004}, {3, 1.006}, {4, 2.0}, {5, 2.0}})
    rows[id] = {id, "", 1, area};

  EXPECT_EQ(equal_surfaces(rows, {1}), (std::vector<surface_id>{1, 2}));
  EXPECT_EQ(equal_surfaces(rows, {1, 4}), (std::vector<surface_id>{1, 2, 4, 5}));
  EXPECT_TRUE(equal_surfaces(rows, {}).empty());
}

}  // namespace
}  // namespace tedit::desktop
