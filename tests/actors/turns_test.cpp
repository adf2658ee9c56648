// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/turns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedit::actors {
namespace {

using ::testing::ElementsAre;

constexpr std::uint64_t anna = 1, ben = 2, carl = 3;
constexpr std::uint64_t bracket = 11, plate = 12;

turn edit(std::uint64_t client, std::uint64_t document) {
  return {urgency::edit, client, document, false};
}

turn file(std::uint64_t client, std::uint64_t document) {
  return {urgency::file, client, document, false};
}

/// Whose jobs go, in their order, when nothing more comes.
std::vector<std::uint64_t> clients_in_turn(std::vector<turn> waiting) {
  turn_order turns;
  std::vector<std::uint64_t> result;
  while (!waiting.empty()) {
    const auto next = waiting.begin() + static_cast<std::ptrdiff_t>(turns.take(waiting));
    result.push_back(next->client);
    waiting.erase(next);
  }
  return result;
}

TEST(Turns, OneClientsJobsGoInTheOrderOfArrival) {
  turn_order turns;
  std::vector<turn> waiting(3, edit(anna, plate));
  EXPECT_EQ(turns.take(waiting), 0u);
  waiting.pop_back();
  EXPECT_EQ(turns.take(waiting), 0u);
}

TEST(Turns, ClientsTakeTurnsHoweverManyJobsOneHas) {
  std::vector<turn> waiting(4, edit(anna, plate));
  waiting.push_back(edit(ben, bracket));
  waiting.push_back(edit(carl, plate));
  waiting.push_back(edit(ben, bracket));
  EXPECT_THAT(clients_in_turn(waiting), ElementsAre(anna, ben, carl, anna, ben, anna, anna));
}

TEST(Turns, OneClientsDocumentsTakeTurns) {
  turn_order turns;
  std::vector<turn> waiting{edit(anna, plate), edit(anna, plate), edit(anna, bracket)};
  EXPECT_EQ(turns.take(waiting), 0u);
  waiting.erase(waiting.begin());
  EXPECT_EQ(turns.take(waiting), 1u);  // The bracket's.
}

TEST(Turns, AnEditGoesBeforeAllFilesOfOthers) {
  std::vector<turn> waiting(64, file(anna, plate));
  waiting.push_back(edit(ben, plate));
  EXPECT_EQ(turn_order().take(waiting), 64u);
}

TEST(Turns, FilesGoOnWhenOthersEditWithoutPause) {
  turn_order turns;
  const std::vector<turn> waiting{file(anna, plate), edit(ben, plate), edit(carl, bracket)};
  int files = 0;
  for (int i = 0; i < 100; ++i)
    files += waiting[turns.take(waiting)].what == urgency::file;
  EXPECT_EQ(files, 100 / (turn_order::others_between + 1));
}

TEST(Turns, PreviewsWaitForEditsAndGoBeforeFiles) {
  turn_order turns;
  std::vector<turn> waiting{
    file(anna, plate), {urgency::preview, ben, plate, false}, edit(carl, plate)};
  EXPECT_EQ(turns.take(waiting), 2u);
  waiting.pop_back();
  EXPECT_EQ(turns.take(waiting), 1u);
}

TEST(Turns, AJobWhoseWorkerDiedGoesFirst) {
  std::vector<turn> waiting{edit(anna, plate), file(ben, plate)};
  waiting[1].again = true;
  EXPECT_EQ(turn_order().take(waiting), 1u);
}

TEST(Turns, WhatFollowsADocumentByItselfIsNobodysTurn) {
  std::vector<turn> waiting{edit(anna, plate), edit(anna, plate), edit(0, bracket)};
  EXPECT_THAT(clients_in_turn(waiting), ElementsAre(anna, 0u, anna));
}

}  // namespace
}  // namespace tedit::actors
