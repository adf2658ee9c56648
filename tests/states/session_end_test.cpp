// SPDX-License-Identifier: AGPL-3.0-or-later
// A session whose document is copied or deleted: who keeps it, and that nobody is left waiting.
#include "tests/states/session_fixture.hpp"

namespace tedit::actors {
namespace {

class Deletion : public Session {
protected:
  answer<acknowledged> erase(const caf::actor& asker) {
    auto got = ask<acknowledged>(session_, delete_atom::value, asker);
    pass(milliseconds(1));
    return got;
  }
  void close(const caf::actor& who) {
    caf::anon_send(session_, detach_atom::value, who);
    pass(milliseconds(1));
  }
  /// Whether a deletion is refused as long as `what` is done, and the document goes on.
  void expect_kept() {
    const auto got = erase(mine_);
    EXPECT_EQ(got.refusal().code, ec::conflict);
    EXPECT_THAT(got.refusal().message, HasSubstr("worked with"));
    EXPECT_FALSE(got.refusal().remedy.empty());
    EXPECT_FALSE(state().ended);
  }
};

TEST_F(Deletion, OthersWhoHaveItOpenKeepADocument) {
  import_all();
  const auto refused = erase(mine_);
  EXPECT_EQ(refused.refusal().code, ec::conflict);
  EXPECT_THAT(refused.refusal().message,
              HasSubstr("part is open in other clients (1: one without a name)"));
  EXPECT_THAT(tasks(), IsEmpty());
  const auto edited = edit(.1);
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(edited.is_success()) << "it goes on";

  close(other_);
  const auto done = erase(mine_);
  EXPECT_FALSE(done.is_there()) << "it is not durable yet";
  finish({"delete"});
  EXPECT_TRUE(done.is_success());
  EXPECT_EQ(helper().closed, 1) << "its lock is free";
}

TEST_F(Deletion, WhoDoesNotHaveItOpenDeletesWhatNobodyHas) {
  import_all();
  close(other_);
  EXPECT_EQ(erase(other_).refusal().code, ec::conflict) << "mine is there";
  close(mine_);
  const auto done = erase(other_);
  finish({"delete"});
  EXPECT_TRUE(done.is_success());
}

TEST_F(Deletion, WhateverIsDoneWithItKeepsADocument) {
  close(other_);
  const auto imported = import();
  expect_kept();
  finish({"import", "commit"});
  EXPECT_TRUE(imported.is_success());

  const auto edited = edit(.1);
  expect_kept();
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(edited.is_success());

  const auto seen = preview(.2);
  expect_kept();
  finish({"edit", "check"});
  EXPECT_TRUE(seen.is_success());

  const auto file = request<exported>(export_request{++tickets_, mine_, {}, "msh", {}});
  expect_kept();
  refuse("file", {ec::io_error, "the disk is full", {}, {}});
  EXPECT_TRUE(file.is_there());

  const auto copy = ask<acknowledged>(session_, copy_atom::value, copy_order{"tail"});
  pass(milliseconds(1));
  expect_kept();
  finish({"copy"});
  EXPECT_TRUE(copy.is_success());

  const auto gone = erase(mine_);
  finish({"delete"});
  EXPECT_TRUE(gone.is_success());
}

TEST_F(Deletion, ASolveThatSomebodyWaitsForKeepsItAndOneThatGoesByItselfIsEnded) {
  import_all();
  close(other_);
  EXPECT_TRUE(set_load("pull", 100).is_success());
  const auto solving = solve(mine_);
  expect_kept();
  EXPECT_FALSE(solving.is_there());
  finish({"solve"});
  EXPECT_TRUE(solving.is_success());
  edit(.1);
  finish({"edit", "check", "commit"});
  ASSERT_THAT(tasks(), ElementsAre("solve")) << "of the new head, by itself";

  const auto gone = erase(mine_);
  EXPECT_EQ(helper().cancelled.size(), 1U);
  finish({"delete"});
  EXPECT_TRUE(gone.is_success());
  EXPECT_EQ(heard(mine_).solves.back().phase, solve_phase::cancelled);
}

TEST_F(Deletion, OneThatTheDiskRefusesGoesOn) {
  import_all();
  close(other_);
  const auto refused = erase(mine_);
  refuse("delete", {ec::io_error, "the folder may not be written", "Ask its owner", {}});
  EXPECT_EQ(refused.refusal().code, ec::io_error);
  EXPECT_EQ(refused.refusal().remedy, "Ask its owner");
  const auto edited = edit(.1);
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(edited.is_success());
  EXPECT_EQ(helper().closed, 0);
}

TEST_F(Deletion, WhoComesWhileItIsDeletedIsSentAway) {
  import_all();
  close(other_);
  const auto gone = erase(mine_);
  const auto late = ask<session_snapshot>(session_, attach_request{other_});
  pass(milliseconds(1));
  EXPECT_EQ(late.refusal().code, ec::service_unavailable) << "and asks the hub again";
  finish({"delete"});
  EXPECT_TRUE(gone.is_success());
}

TEST_F(Deletion, ACopyThatIsBeingWrittenKeepsASessionFromItsEnd) {
  import_all();
  close(mine_);
  close(other_);
  const auto copy = ask<acknowledged>(session_, copy_atom::value, copy_order{"tail"});
  pass(milliseconds(1));
  const auto early = ask<shared_remains>(session_, end_atom::value);
  pass(milliseconds(1));
  EXPECT_EQ(early.refusal().code, ec::conflict);
  refuse("copy", {ec::storage_error, "the disk is full", "Make room", {}});
  EXPECT_EQ(copy.refusal().code, ec::storage_error);
  const auto late = ask<shared_remains>(session_, end_atom::value);
  pass(milliseconds(1));
  EXPECT_TRUE(late.is_success());
}

TEST_F(Deletion, ItsStatusSaysWhoHasItOpenAndWhatItHolds) {
  const auto status = [&] {
    const auto got = ask<session_status>(session_, status_atom::value);
    pass(milliseconds(1));
    return got.value();
  };
  EXPECT_EQ(status().clients, 2U);
  EXPECT_EQ(status().versions, 0U);
  EXPECT_FALSE(status().head.has_value());
  import_all();
  edit(.1);
  finish({"edit", "check", "commit"});
  close(other_);
  EXPECT_EQ(status().clients, 1U);
  EXPECT_EQ(status().versions, 2U);
  EXPECT_EQ(status().head, 1U);
}

}  // namespace
}  // namespace tedit::actors
