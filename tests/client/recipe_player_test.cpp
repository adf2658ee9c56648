// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/recipe_player.hpp"

namespace tedit::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Notes what it is asked; is ready when `ready` says so, fails at a kind.
class noting : public performer {
public:
  std::vector<std::string> done;
  std::string fails_at;
  std::string not_ready_for;  ///< "end" for the end.
  std::function<void()> meanwhile = [] {};

  expected<bool> is_ready_for(const recipe_step* next) override {
    if (fails_at == "readiness")
      return fail(ec::cancelled, "the solver was stopped");
    return (next ? kind_of(*next) : "end") != not_ready_for;
  }

  expected<void> perform(const recipe_step& step) override {
    if (kind_of(step) == fails_at)
      return fail(ec::surface_not_found, "no surface 7", "Name another");
    done.emplace_back(kind_of(step));
    meanwhile();
    return {};
  }
};

std::vector<recipe_step> four() {
  return {import_step{"a.msh"}, edit_step{}, undo_step{}, redo_step{}};
}

/// Until it is over; false where it never comes to an end.
expected<bool> play(recipe_player& player) {
  for (int i = 0; i < 100; ++i)
    if (auto more = player.advance(); !more || !*more)
      return more;
  return true;
}

TEST(RecipePlayer, TakesEachStepOnceInOrderAndTellsOfItBefore) {
  noting by;
  std::vector<std::string> told;
  recipe_player* playing = nullptr;
  recipe_player player(four(), by, [&] {
    told.push_back(kind_of(*playing->current()) + std::to_string(by.done.size()));
  });
  playing = &player;
  EXPECT_EQ(player.current(), nullptr);
  EXPECT_DOUBLE_EQ(player.fraction(), 0);

  EXPECT_EQ(play(player), false);
  EXPECT_THAT(by.done, ElementsAre("import", "edit", "undo", "redo"));
  EXPECT_THAT(told, ElementsAre("import0", "edit1", "undo2", "redo3"));
  EXPECT_DOUBLE_EQ(player.fraction(), 1);
  EXPECT_EQ(player.advance(), false);  // And nothing more.
  EXPECT_EQ(by.done.size(), 4U);
}

TEST(RecipePlayer, StopsAtTheFirstFailureAndNamesTheStep) {
  noting by;
  by.fails_at = "undo";
  recipe_player player(four(), by);

  const auto end = play(player);
  ASSERT_FALSE(end);
  EXPECT_EQ(end.error().code, ec::surface_not_found);
  EXPECT_EQ(end.error().message, "step 3 (undo): no surface 7");
  EXPECT_EQ(end.error().remedy, "Name another");
  EXPECT_THAT(by.done, ElementsAre("import", "edit"));
  by.fails_at.clear();
  const auto again = player.advance();
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().message, end.error().message);
  EXPECT_EQ(by.done.size(), 2U);
}

TEST(RecipePlayer, WaitsUntilItsPerformerIsReadyAlsoAtTheEnd) {
  noting by;
  by.not_ready_for = "undo";
  recipe_player player(four(), by);

  EXPECT_EQ(play(player), true);
  EXPECT_THAT(by.done, ElementsAre("import", "edit"));
  EXPECT_EQ(player.begun(), 2U);
  EXPECT_DOUBLE_EQ(player.fraction(), 0.4);
  by.not_ready_for = "end";
  EXPECT_EQ(play(player), true);
  EXPECT_EQ(by.done.size(), 4U);
  by.not_ready_for.clear();
  EXPECT_EQ(play(player), false);
}

TEST(RecipePlayer, AFailureWhileItWaitsIsThatOfTheStepBefore) {
  noting by;
  recipe_player player(four(), by);
  EXPECT_EQ(player.advance(), true);
  by.fails_at = "readiness";

  const auto end = player.advance();
  ASSERT_FALSE(end);
  EXPECT_EQ(end.error().message, "step 1 (import): the solver was stopped");
}

TEST(RecipePlayer, CanBeStoppedBetweenStepsAndWhileOneIsPerformed) {
  noting by;
  recipe_player before(four(), by);
  EXPECT_EQ(before.stop({ec::cancelled, "cancelled", {}, {}}).message, "cancelled");
  EXPECT_FALSE(before.advance());
  EXPECT_TRUE(by.done.empty());

  recipe_player during(four(), by);
  by.meanwhile = [&] {
    if (by.done.size() == 2)
      during.stop({ec::cancelled, "cancelled", {}, {}});
  };
  const auto end = play(during);
  ASSERT_FALSE(end);
  EXPECT_EQ(end.error().code, ec::cancelled);
  EXPECT_EQ(end.error().message, "step 2 (edit): cancelled");
  EXPECT_THAT(by.done, ElementsAre("import", "edit"));
}

}  // namespace
}  // namespace tedit::client
