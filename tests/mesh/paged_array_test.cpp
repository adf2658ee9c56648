// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/paged_array.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace tedit {
namespace {

using numbers = paged_array<std::uint32_t>;

std::vector<std::uint32_t> counting(std::size_t n) {
  std::vector<std::uint32_t> values(n);
  std::iota(values.begin(), values.end(), 0u);
  return values;
}

TEST(PagedArray, HoldsItsItemsInPagesOf64KiB) {
  const auto values = counting(40000);

  const auto array = numbers::from(values);

  EXPECT_EQ(numbers::items_per_page, 16384u);
  EXPECT_EQ(array.pages().size(), 3u);
  EXPECT_EQ(array.to_vector(), values);
  EXPECT_EQ(array[16384], 16384u);
}

TEST(PagedArray, AChangedCopySharesTheOtherPages) {
  const auto before = numbers::from(counting(40000));
  paged_array_builder<std::uint32_t> builder(before);

  builder.write(20000) = 7;
  const auto after = builder.freeze();

  EXPECT_EQ(before[20000], 20000u);
  EXPECT_EQ(after[20000], 7u);
  EXPECT_EQ(after.pages()[0], before.pages()[0]);
  EXPECT_NE(after.pages()[1], before.pages()[1]);
  EXPECT_EQ(after.pages()[2], before.pages()[2]);
}

TEST(PagedArray, WritingTheSameValueKeepsThePagesIdentity) {
  const auto before = numbers::from(counting(100));
  paged_array_builder<std::uint32_t> builder(before);

  builder.write(5) = 5;

  EXPECT_EQ(builder.freeze().pages()[0]->id(), before.pages()[0]->id());
}

TEST(PagedArray, GrowsAndStaysUsableAfterFreeze) {
  paged_array_builder<std::uint32_t> builder(numbers::from(counting(16384)));

  builder.push_back(1);
  const auto first = builder.freeze();
  builder.write(16384) = 2;
  builder.push_back(3);
  const auto second = builder.freeze();

  EXPECT_EQ(first.size(), 16385u);
  EXPECT_EQ(first[16384], 1u);
  EXPECT_EQ(second[16384], 2u);
  EXPECT_EQ(second[16385], 3u);
}

TEST(PagedArray, PagesOfTheWrongSizeAreRefused) {
  const auto array = numbers::from(counting(20000));

  EXPECT_TRUE(numbers::from_pages(array.pages(), 20000).has_value());
  EXPECT_FALSE(numbers::from_pages(array.pages(), 20001).has_value());
  EXPECT_FALSE(numbers::from_pages(array.pages(), 40000).has_value());
  EXPECT_FALSE(numbers::from_pages({nullptr}, 5).has_value());
}

}  // namespace
}  // namespace tedit
