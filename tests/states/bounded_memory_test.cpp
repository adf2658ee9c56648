// SPDX-License-Identifier: AGPL-3.0-or-later
// What is kept up to a budget.
#include "actors/session/bounded_memory.hpp"

#include <gtest/gtest.h>

namespace tedit::actors {
namespace {

result_memory::kept_ptr fields_of(std::size_t numbers) {
  auto fields = std::make_shared<std::vector<field>>(1);
  fields->front().values = paged_array<double>::from(std::vector<double>(numbers, 1.0));
  return fields;
}

result_memory::handle keep(const std::shared_ptr<result_memory>& memory, std::size_t numbers) {
  const auto fields = fields_of(numbers);
  return memory->keep(fields, bytes_of(*fields));
}

TEST(BoundedMemory, CountsWhatIsKeptAndGivesItBack) {
  const auto memory = std::make_shared<result_memory>(1000);
  auto first = keep(memory, 10);
  const auto second = keep(memory, 20);
  EXPECT_EQ(memory->used(), 240U);
  EXPECT_EQ(memory->find(first)->front().values.size(), 10U);
  first.reset();
  EXPECT_EQ(memory->used(), 160U);
}

TEST(BoundedMemory, ThoseUsedLongestAgoGiveWay) {
  const auto memory = std::make_shared<result_memory>(240);
  const auto first = keep(memory, 10);
  auto second = keep(memory, 10);
  const auto third = keep(memory, 10);
  EXPECT_TRUE(memory->find(first));  // Now the second is the oldest.
  const auto fourth = keep(memory, 10);
  EXPECT_TRUE(memory->has(first));
  EXPECT_FALSE(memory->has(second));
  EXPECT_FALSE(memory->find(second));
  EXPECT_TRUE(memory->has(third));
  EXPECT_TRUE(memory->has(fourth));
  EXPECT_EQ(memory->used(), 240U);
  second.reset();
  EXPECT_EQ(memory->used(), 240U);
}

TEST(BoundedMemory, TheNewestStaysHoweverLargeItIs) {
  const auto memory = std::make_shared<result_memory>(100);
  const auto small = keep(memory, 5);
  const auto large = keep(memory, 50);
  EXPECT_FALSE(memory->has(small));
  EXPECT_TRUE(memory->has(large));
  EXPECT_EQ(memory->used(), 400U);
}

TEST(BoundedMemory, WhoHoldsFieldsKeepsThemWhenTheyGiveWay) {
  const auto memory = std::make_shared<result_memory>(100);
  const auto place = keep(memory, 10);
  const auto held = memory->find(place);
  const auto other = keep(memory, 10);
  EXPECT_FALSE(memory->has(place));
  EXPECT_EQ(held->front().values.size(), 10U);
}

}  // namespace
}  // namespace tedit::actors
