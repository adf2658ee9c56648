// SPDX-License-Identifier: AGPL-3.0-or-later
// Solves of a session: who shares one, what ends one, and what follows a new head.
#include "tests/states/session_fixture.hpp"

namespace tedit::actors {
namespace {

std::vector<solve_phase> phases(const listener_state& heard) {
  std::vector<solve_phase> result;
  for (const auto& one : heard.solves)
    result.push_back(one.phase);
  return result;
}

class Solves : public Session {
protected:
  void SetUp() override {
    import_all();
    set_load("hanging", 5);
  }

  held_result ask_held() { return request<held_result>(watch_request{mine_, {}}).value(); }
};

TEST_F(Solves, WithoutALoadCaseThereIsNothingToSolve) {
  solve_request wanted;
  wanted.load_cases = {"standing"};
  const auto got = request<solved>(wanted);
  EXPECT_EQ(got.refusal().code, ec::not_found);
  EXPECT_THAT(got.refusal().message, HasSubstr("standing"));
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(Solves, TwoWhoAskTheSameShareOne) {
  const auto first = solve(mine_);
  const auto second = solve(other_);
  EXPECT_THAT(tasks(), ElementsAre("solve"));
  finish({"solve"});
  ASSERT_TRUE(first.is_success());
  ASSERT_TRUE(second.is_success());
  EXPECT_EQ(first.value().number, second.value().number);
  EXPECT_TRUE(heard(mine_).results.empty()) << "the answer says it";
}

TEST_F(Solves, AResultThatIsThereIsAnsweredAtOnce) {
  solve(mine_);
  finish({"solve"});
  const auto again = solve(mine_);
  EXPECT_TRUE(again.is_success());
  EXPECT_THAT(tasks(), IsEmpty());
  EXPECT_EQ(heard(other_).results.size(), 2U);
}

TEST_F(Solves, OneOfTwoLeavesAndTheOtherGetsTheResult) {
  const auto first = solve(mine_);
  const auto leaving = tickets_;
  const auto second = solve(other_);
  cancel(leaving);
  EXPECT_EQ(first.refusal().code, ec::cancelled);
  EXPECT_THAT(helper().cancelled, IsEmpty());
  finish({"solve"});
  EXPECT_TRUE(second.is_success());
}

TEST_F(Solves, TheLastOneWhoLeavesEndsItAndTheFollowing) {
  const auto got = solve(mine_);
  const auto job = helper().tasks.front().job;
  cancel(tickets_);
  EXPECT_EQ(got.refusal().code, ec::cancelled);
  EXPECT_THAT(helper().cancelled, ElementsAre(job));
  EXPECT_EQ(phases(heard(other_)).back(), solve_phase::cancelled);
  take("solve");
  edit(.1);
  finish({"edit", "check", "commit"});
  EXPECT_THAT(tasks(), IsEmpty()) << "the new head is not solved";
}

TEST_F(Solves, ANewHeadSupersedesAndIsSolvedByItself) {
  const auto got = solve(mine_);
  const auto late = take("solve");
  edit(.1);
  finish({"edit", "check", "commit"});
  EXPECT_EQ(got.refusal().code, ec::superseded);
  EXPECT_THAT(helper().cancelled, ElementsAre(late.job));
  ASSERT_THAT(tasks(), ElementsAre("solve"));
  EXPECT_EQ(helper().tasks.front().on, head());
  within(helper_, late.succeed);
  EXPECT_TRUE(heard(mine_).results.empty()) << "a late field of the version before";
  finish({"solve"});
  ASSERT_EQ(heard(mine_).results.size(), 1U);
  EXPECT_EQ(to_hex(heard(mine_).results[0].version->id()), head());
  EXPECT_EQ(got.count(), 1);
}

TEST_F(Solves, UndoShowsTheResultThatIsThere) {
  solve(mine_);
  finish({"solve"});
  edit(.1);
  finish({"edit", "check", "commit", "solve"});
  move(move_kind::undo);
  finish({"commit"});
  EXPECT_THAT(tasks(), IsEmpty());
  ASSERT_EQ(heard(mine_).results.size(), 2U);
  EXPECT_EQ(to_hex(heard(mine_).results.back().version->id()), head());
}

/// Others' results have taken the room.
TEST_F(Solves, AFieldThatHadToGiveWayIsSolvedAnew) {
  const auto fill = [&] {
    auto large = std::make_shared<std::vector<field>>(1);
    large->front().values = paged_array<double>::from(std::vector<double>(200));
    return session_results_->keep(large, bytes_of(*large));
  };
  solve(mine_);
  finish({"solve"});
  edit(.1);
  finish({"edit", "check", "commit", "solve"});
  const auto others = fill();
  EXPECT_FALSE(ask_held().result);
  move(move_kind::undo);
  finish({"commit"});
  EXPECT_THAT(tasks(), ElementsAre("solve"));
  finish({"solve"});
  EXPECT_EQ(to_hex(heard(mine_).results.back().version->id()), head());
  EXPECT_TRUE(ask_held().result);
}

TEST_F(Solves, AChangedLoadCaseIsSolvedAnew) {
  const auto got = solve(mine_);
  const auto late = take("solve");
  set_load("hanging", 6);
  EXPECT_TRUE(got.is_there());
  ASSERT_THAT(tasks(), ElementsAre("solve"));
  within(helper_, late.succeed);
  EXPECT_TRUE(heard(other_).results.empty()) << "a field of other loads";
  finish({"solve"});
  EXPECT_EQ(heard(other_).results.size(), 1U);
}

TEST_F(Solves, AnotherLoadCaseLeavesItAlone) {
  const auto got = solve(mine_);
  set_load("standing", 6);  // Its commit comes after the solve that waits.
  EXPECT_THAT(helper().cancelled, IsEmpty());
}

TEST_F(Solves, ARemovedLoadCaseEndsItsSolve) {
  const auto got = solve(mine_);
  const auto late = take("solve");
  request<acknowledged>(note_request{remove_load_case{"hanging"}, {}});
  finish({"commit"});
  EXPECT_TRUE(got.is_there());
  EXPECT_FALSE(got.is_success());
  EXPECT_THAT(helper().cancelled, ElementsAre(late.job));
  within(helper_, late.succeed);
  EXPECT_TRUE(heard(mine_).results.empty());
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(Solves, AFailureIsAnsweredToWhoAskedAndToldToOthers) {
  const auto got = solve(mine_);
  refuse("solve", {ec::under_constrained, "the part can move", "Hold it", {}});
  EXPECT_EQ(got.refusal().code, ec::under_constrained);
  EXPECT_EQ(got.refusal().remedy, "Hold it");
  EXPECT_EQ(phases(heard(other_)).back(), solve_phase::failed);
  EXPECT_THAT(heard(other_).solves.back().message, HasSubstr("Hold it"));
  EXPECT_EQ(phases(heard(mine_)).back(), solve_phase::started);
}

TEST_F(Solves, WhoeverEndsItEndsItForAll) {
  const auto got = solve(mine_);
  const auto ended = ask<acknowledged>(session_, end_solve_atom::value);
  pass(milliseconds(1));
  EXPECT_TRUE(ended.is_success());
  EXPECT_EQ(got.refusal().code, ec::cancelled);
  take("solve");
  edit(.1);
  finish({"edit", "check", "commit"});
  EXPECT_THAT(tasks(), ElementsAre("solve")) << "later heads are solved as before";
}

TEST_F(Solves, WhatIsHeldIsTheHeadsOwn) {
  solve(mine_);
  finish({"solve"});
  const auto there = ask<held_result>(session_, watch_request{mine_, {}});
  pass(milliseconds(1));
  ASSERT_TRUE(there.value().result.has_value());
  set_load("hanging", 7);
  const auto gone = ask<held_result>(session_, watch_request{mine_, {}});
  pass(milliseconds(1));
  EXPECT_FALSE(gone.value().result.has_value()) << "the old field would lie";
}

}  // namespace
}  // namespace tedit::actors
