// SPDX-License-Identifier: AGPL-3.0-or-later
// Fields that are kept up to a budget.
#include "actors/session/result_memory.hpp"

#include <gtest/gtest.h>

namespace tedit::actors {
namespace {

result_memory::fields_ptr fields_of(std::size_t numbers) {
  auto fields = std::make_shared<std::vector<field>>(1);
  fields->front().values = paged_array<double>::from(std::vector<double>(numbers, 1.0));
  return fields;
}

TEST(ResultMemory, CountsWhatIsKeptAndGivesItBack) {
  const auto memory = std::make_shared<result_memory>(1000);
  auto first = memory->keep(fields_of(10));
  const auto second = memory->keep(fields_of(20));
  EXPECT_EQ(memory->used(), 240U);
  EXPECT_EQ(memory->find(first)->front().values.size(), 10U);
  first.reset();
  EXPECT_EQ(memory->used(), 160U);
}

TEST(ResultMemory, ThoseUsedLongestAgoGiveWay) {
  const auto memory = std::make_shared<result_memory>(240);
  const auto first = memory->keep(fields_of(10));
  auto second = memory->keep(fields_of(10));
  const auto third = memory->keep(fields_of(10));
  EXPECT_TRUE(memory->find(first));  // Now the second is the oldest.
  const auto fourth = memory->keep(fields_of(10));
  EXPECT_TRUE(memory->has(first));
  EXPECT_FALSE(memory->has(second));
  EXPECT_FALSE(memory->find(second));
  EXPECT_TRUE(memory->has(third));
  EXPECT_TRUE(memory->has(fourth));
  EXPECT_EQ(memory->used(), 240U);
  second.reset();
  EXPECT_EQ(memory->used(), 240U);
}

TEST(ResultMemory, TheNewestStaysHoweverLargeItIs) {
  const auto memory = std::make_shared<result_memory>(100);
  const auto small = memory->keep(fields_of(5));
  const auto large = memory->keep(fields_of(50));
  EXPECT_FALSE(memory->has(small));
  EXPECT_TRUE(memory->has(large));
  EXPECT_EQ(memory->used(), 400U);
}

TEST(ResultMemory, WhoHoldsFieldsKeepsThemWhenTheyGiveWay) {
  const auto memory = std::make_shared<result_memory>(100);
  const auto place = memory->keep(fields_of(10));
  const auto held = memory->find(place);
  const auto other = memory->keep(fields_of(10));
  EXPECT_FALSE(memory->has(place));
  EXPECT_EQ(held->front().values.size(), 10U);
}

}  // namespace
}  // namespace tedit::actors
