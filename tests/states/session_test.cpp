// SPDX-License-Identifier: AGPL-3.0-or-later
// A session whose workers and store do what a test says: the order of changes, and what is told.
#include "tests/states/session_fixture.hpp"

namespace tedit::actors {
namespace {

TEST_F(Session, AnEmptyDocumentSaysWhatIsMissing) {
  for (const auto& refusal :
       {edit(1).refusal(), preview(1).refusal(), solve(mine_).refusal(),
        request<exported>(export_request{1, mine_, {}, "msh", {}}).refusal()}) {
    EXPECT_EQ(refusal.code, ec::conflict) << refusal.message;
    EXPECT_THAT(refusal.remedy, HasSubstr("mport"));
  }
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(Session, AnEditIsAnsweredToItsClientAndToldToOthersOnceItIsDurable) {
  import_all();
  const auto got = edit(.1);
  finish({"edit", "check"});
  EXPECT_FALSE(got.is_there()) << "it is not on the disk yet";
  EXPECT_EQ(heard(other_).heads.size(), 1U);
  finish({"commit"});
  ASSERT_TRUE(got.is_success());
  EXPECT_EQ(got.value().cause, "edit");
  EXPECT_EQ(got.value().head.number, 1U);
  EXPECT_EQ(got.value().head.parent, 0U);
  EXPECT_EQ(got.value().report->operation, "nudge");
  EXPECT_TRUE(got.value().can_undo);
  ASSERT_EQ(heard(other_).heads.size(), 2U);
  EXPECT_EQ(heard(other_).heads.back().head.number, 1U);
  EXPECT_EQ(heard(mine_).heads.size(), 0U) << "the answer says it";
}

TEST_F(Session, EditsAreMadeOneAfterTheOtherEachOfTheHeadBefore) {
  import_all();
  const auto first = edit(.1);
  const auto second = edit(.2);
  EXPECT_THAT(tasks(), ElementsAre("edit"));
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(first.is_success());
  EXPECT_THAT(tasks(), ElementsAre("edit"));
  EXPECT_EQ(helper().tasks.front().on, to_hex(first.value().head.id));
  finish({"edit", "check", "commit"});
  EXPECT_EQ(second.value().head.parent, 1U);
}

TEST_F(Session, WhoWaitsForOtherChangesIsToldHowManyAfterAWhile) {
  import_all();
  const auto first = edit(.1);
  const auto second = edit(.2);
  const auto third = edit(.3);
  const auto last = tickets_;
  pass(milliseconds(390));
  EXPECT_THAT(heard(mine_).progress, IsEmpty()) << "what is quick needs no words";
  pass(milliseconds(20));
  ASSERT_EQ(heard(mine_).progress.size(), 2U);
  EXPECT_EQ(heard(mine_).progress[0].ticket, last - 1);
  EXPECT_EQ(heard(mine_).progress[0].stage, "waiting for 1 change of this document before it");
  EXPECT_EQ(heard(mine_).progress[1].ticket, last);
  EXPECT_EQ(heard(mine_).progress[1].stage, "waiting for 2 changes of this document before it");

  finish({"edit", "check", "commit"});
  EXPECT_TRUE(first.is_success());
  pass(milliseconds(1000));
  ASSERT_EQ(heard(mine_).progress.size(), 3U);
  EXPECT_EQ(heard(mine_).progress[2].ticket, last);
  EXPECT_EQ(heard(mine_).progress[2].stage, "waiting for 1 change of this document before it");
  finish({"edit", "check", "commit", "edit", "check", "commit"});
  pass(milliseconds(5000));
  EXPECT_EQ(heard(mine_).progress.size(), 3U);
  EXPECT_TRUE(second.is_success() && third.is_success());
}

TEST_F(Session, GivesAVersionByItsId) {
  import_all();
  const auto imported = head();
  const auto got = edit(.1);
  finish({"edit", "check", "commit"});
  ASSERT_TRUE(got.is_success());
  const auto before = request<session_version>(version_request{0, imported});
  EXPECT_EQ(before.value().number, 0U);
  EXPECT_EQ(to_hex(before.value().mesh->id()), imported);
  EXPECT_EQ(request<session_version>(version_request{7, head()}).value().number, 1U);
  const auto none = request<session_version>(version_request{0, std::string(32, 'a')});
  EXPECT_EQ(none.refusal().code, ec::not_found);
  EXPECT_THAT(none.refusal().message, HasSubstr("no version aaaa"));
}

/// The worker that made it may die before it is checked, and no budget is large enough for all.
TEST_F(Session, ACandidatesPagesAreHeldUntilItIsChecked) {
  import_all();
  const auto got = edit(.1);
  version_ptr candidate = simulation::nudged(state().graph.head()->mesh, 0, .1);
  finish({"edit"});
  helper().versions.erase(to_hex(candidate->id()));
  const auto ids = candidate->pages().page_ids();
  candidate.reset();
  for (const auto& id : ids)
    EXPECT_TRUE(cache_->find(id)) << to_hex(id);
}

TEST_F(Session, AnEditThatWaitsIsCancelledWithoutHavingBegun) {
  import_all();
  const auto first = edit(.1);
  const auto second = edit(.2);
  cancel(tickets_);
  EXPECT_EQ(second.refusal().code, ec::cancelled);
  EXPECT_FALSE(first.is_there());
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(first.is_success());
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(Session, AnEditThatRunsIsCancelledInItsWorkerAndChangesNothing) {
  import_all();
  const auto before = head();
  const auto got = edit(.1);
  const auto job = helper().tasks.front().job;
  cancel(tickets_);
  EXPECT_THAT(helper().cancelled, ElementsAre(job));
  finish({"edit"});  // It was done before it heard of that.
  EXPECT_EQ(got.refusal().code, ec::cancelled);
  EXPECT_EQ(head(), before);
  EXPECT_THAT(tasks(), IsEmpty());
  const auto next = edit(.2);
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(next.is_success());
}

TEST_F(Session, AnEditOfAnotherHeadIsAConflictThatNamesItsRival) {
  import_all();
  const auto seen = head();
  const auto first = edit(.1, {"ann", {}, seen});
  const auto second = edit(.2, {"bob", {}, seen});
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(first.is_success());
  EXPECT_EQ(second.refusal().code, ec::conflict);
  EXPECT_THAT(second.refusal().message, HasSubstr("\"ann\" made it the head with nudge"));
  EXPECT_FALSE(second.refusal().remedy.empty());
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(Session, ARetryOfAnEditIsMadeOnce) {
  import_all();
  const auto first = edit(.1, {"ann", "e1", {}});
  const auto again = edit(.1, {"ann", "e1", {}});
  finish({"edit", "check", "commit"});
  ASSERT_TRUE(again.is_success());
  EXPECT_TRUE(again.value().repeated);
  EXPECT_FALSE(first.value().repeated);
  EXPECT_EQ(again.value().head.id, first.value().head.id);
  EXPECT_EQ(state().graph.nodes().size(), 2U);
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(Session, AnEditIdIsForOneRequestOnly) {
  import_all();
  const auto first = edit(.1, {"ann", "e1", {}});
  const auto other = edit(.2, {"ann", "e1", {}});
  finish({"edit", "check", "commit"});
  EXPECT_EQ(other.refusal().code, ec::conflict);
  EXPECT_THAT(other.refusal().message, HasSubstr("e1"));
}

TEST_F(Session, WhatTheDiskRefusesIsNotTheHeadAndIsToldToNobodyElse) {
  import_all();
  const auto before = head();
  const auto got = edit(.1, {"ann", "e1", {}});
  finish({"edit", "check"});
  refuse("commit", {ec::storage_error, "the disk is full", "Make room", {}});
  EXPECT_EQ(got.refusal().code, ec::storage_error);
  EXPECT_EQ(got.refusal().remedy, "Make room");
  EXPECT_EQ(head(), before);
  EXPECT_EQ(heard(other_).heads.size(), 1U);
  const auto again = edit(.1, {"ann", "e1", {}});
  finish({"edit", "check", "commit"});
  ASSERT_TRUE(again.is_success());
  EXPECT_FALSE(again.value().repeated) << "it was not made before";
  EXPECT_EQ(again.value().head.number, 1U);
}

TEST_F(Session, WorkIsTriedAgainWhenItsPagesAreGoneAndNotForEver) {
  import_all();
  const auto got = edit(.1);
  finish({"edit"});
  int tried = 1;
  while (!got.is_there() && tried < 10) {
    refuse("check", {ec::not_found, "page 0 is not here any more", {}, {}});
    if (got.is_there())
      break;
    finish({"edit"});
    ++tried;
  }
  EXPECT_TRUE(got.is_there());
  EXPECT_GT(tried, 1);
  EXPECT_LT(tried, 5);
  const auto next = edit(.2);
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(next.is_success());
}

TEST_F(Session, ARefusalOfTheOperationIsNotTriedAgain) {
  import_all();
  const auto got = edit(.1);
  refuse("edit", {ec::invalid_argument, "surface 7 is not there", "Name another", {}});
  EXPECT_EQ(got.refusal().code, ec::invalid_argument);
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(Session, UndoAndRedoMoveTheHeadAndAreToldToOthers) {
  import_all();
  edit(.1);
  finish({"edit", "check", "commit"});
  const auto undone = move(move_kind::undo);
  finish({"commit"});
  EXPECT_EQ(undone.value().head.number, 0U);
  EXPECT_TRUE(undone.value().can_redo);
  EXPECT_EQ(heard(other_).heads.back().cause, "undo");
  const auto redone = move(move_kind::redo);
  finish({"commit"});
  EXPECT_EQ(redone.value().head.number, 1U);
  EXPECT_EQ(move(move_kind::redo).refusal().code, ec::conflict);
  EXPECT_EQ(move(move_kind::go_to, 9).refusal().code, ec::not_found);
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(Session, AMoveThatIsNotDurableIsNone) {
  import_all();
  edit(.1);
  finish({"edit", "check", "commit"});
  const auto undone = move(move_kind::undo);
  refuse("commit", {ec::storage_error, "the disk is full", "Make room", {}});
  EXPECT_EQ(undone.refusal().code, ec::storage_error);
  EXPECT_EQ(state().graph.head()->info.number, 1U);
  EXPECT_FALSE(state().graph.can_redo());
}

TEST_F(Session, WhatWasPreviewedIsNotMadeAgain) {
  import_all();
  const auto shown = preview(.1);
  finish({"edit", "check"});
  ASSERT_TRUE(shown.is_success());
  EXPECT_EQ(state().graph.nodes().size(), 1U);
  const auto got = edit(.1);
  EXPECT_THAT(tasks(), ElementsAre("commit"));
  finish({"commit"});
  EXPECT_EQ(got.value().head.id, shown.value().version->id());
}

TEST_F(Session, APreviewIsEndedByAChangeAndItsLateResultIsNobodys) {
  import_all();
  const auto shown = preview(.1);
  const auto late = take("edit");
  const auto got = edit(.2);
  EXPECT_EQ(shown.refusal().code, ec::superseded);
  within(helper_, late.succeed);
  EXPECT_EQ(shown.count(), 1);
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(got.is_success());
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(Session, APreviewOfAnotherHeadServesNoEdit) {
  import_all();
  preview(.1);
  finish({"edit", "check"});
  set_load("hanging", 5);
  edit(.1);
  EXPECT_THAT(tasks(), ElementsAre("edit")) << "its load cases would be those of before";
}

TEST_F(Session, WhileTheDocumentChangesAPreviewIsRefusedAtOnce) {
  import_all();
  edit(.1);
  const auto shown = preview(.2);
  EXPECT_EQ(shown.refusal().code, ec::superseded);
  EXPECT_FALSE(shown.refusal().remedy.empty());
}

TEST_F(Session, WhoDetachesOrDiesHearsNoMore) {
  import_all();
  caf::anon_send(session_, detach_atom::value, other_);
  const auto third = listen();
  simulation::cut_off(third);
  pass(milliseconds(1));
  EXPECT_EQ(state().subscribers.size(), 1U);
  edit(.1);
  finish({"edit", "check", "commit"});
  EXPECT_EQ(heard(other_).heads.size(), 1U);
}

// -- its end -----------------------------------------------------------------------------------

TEST_F(Session, IsOfferedToTheHubWhenNobodyHasItOpenForAWhile) {
  import_all();
  pass(milliseconds(200'000));
  EXPECT_EQ(end_asked_, 0) << "two have it open";
  for (const auto& one : {mine_, other_})
    caf::anon_send(session_, detach_atom::value, one);
  pass(milliseconds(119'000));
  EXPECT_EQ(end_asked_, 0);
  pass(milliseconds(2'000));
  EXPECT_EQ(end_asked_, 1);
}

TEST_F(Session, DoesNotEndWhileSomethingIsDoneForIt) {
  import_all();
  const auto got = edit(.1);
  for (const auto& one : {mine_, other_})
    caf::anon_send(session_, detach_atom::value, one);
  pass(milliseconds(130'000));
  EXPECT_EQ(end_asked_, 0);
  const auto early = ask<shared_remains>(session_, end_atom::value);
  pass(milliseconds(1));
  EXPECT_EQ(early.refusal().code, ec::conflict);
  EXPECT_EQ(helper().closed, 0);
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(got.is_success());
  pass(milliseconds(121'000));
  EXPECT_EQ(end_asked_, 1);
}

TEST_F(Session, AnEndedOneLetsNobodyInAndLeavesItsResults) {
  import_all();
  set_load("hanging", 5);
  solve(mine_);
  finish({"solve"});
  for (const auto& one : {mine_, other_})
    caf::anon_send(session_, detach_atom::value, one);
  pass(milliseconds(1));
  const auto remains = ask<shared_remains>(session_, end_atom::value);
  pass(milliseconds(1));
  const auto late = ask<session_snapshot>(session_, attach_request{mine_});
  pass(milliseconds(10));
  ASSERT_TRUE(remains.is_success());
  EXPECT_EQ(remains.value()->results.size(), 1U);
  EXPECT_TRUE(remains.value()->followed.has_value());
  EXPECT_EQ(helper().closed, 1);
  EXPECT_FALSE(late.is_success());
  EXPECT_TRUE(late.is_there());
}

}  // namespace
}  // namespace tedit::actors
