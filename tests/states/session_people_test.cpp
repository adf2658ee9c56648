// SPDX-License-Identifier: AGPL-3.0-or-later
// Several people in one document: who is there, who did what, and edits that were made for a head
// that is no more. The part is one cube of six tets around the diagonal from vertex 0 to vertex 7:
// those at vertex 1 and those at vertex 6 are two each, and different ones.
#include "tests/states/session_fixture.hpp"

namespace tedit::actors {
namespace {

class People : public Session {
protected:
  People() { import_all(); }

  /// Ann moves vertex 1, while Bob looks at the version before that.
  void let_ann_edit() {
    seen_ = head();
    const auto got = edit_at(1, {"ann", {}, seen_});
    finish({"edit", "check", "commit"});
    ASSERT_TRUE(got.is_success());
  }
  [[nodiscard]] change_terms carried() const { return {"bob", {}, seen_, true}; }

  std::string seen_;
};

TEST_F(People, AnEditElsewhereIsCarriedOverToTheNewHead) {
  let_ann_edit();
  const auto got = edit_at(6, carried());
  EXPECT_EQ(helper().tasks.front().on, head()) << "it is made of the head";
  finish({"edit", "check", "commit"});

  ASSERT_TRUE(got.is_success()) << got.refusal().message;
  EXPECT_EQ(got.value().head.parent, 1U);
  ASSERT_EQ(got.value().report->notices.size(), 1U);
  EXPECT_THAT(got.value().report->notices.front(), HasSubstr("carried over from version 0"));
}

TEST_F(People, AnEditOfWhatWasChangedIsRefusedWithWhatCollided) {
  let_ann_edit();
  const auto before = head();
  const auto got = edit_at(1, carried());
  finish({"edit", "check"});

  EXPECT_EQ(got.refusal().code, ec::conflict);
  EXPECT_THAT(got.refusal().message, HasSubstr("\"ann\" made it the head with nudge"));
  EXPECT_THAT(got.refusal().message, HasSubstr("2 of the tets that the edit would change"));
  EXPECT_FALSE(got.refusal().remedy.empty());
  EXPECT_EQ(head(), before);
  EXPECT_THAT(tasks(), IsEmpty());
}

/// Vertex 1, at x = 1, is a corner of surface 2 (x = 1) and of none of surface 1 (x = 0).
TEST_F(People, AnEditOfASelectedWallThatWasChangedIsRefused) {
  let_ann_edit();
  const auto other = edit_at(6, carried(), {2});
  finish({"edit", "check"});
  EXPECT_EQ(other.refusal().code, ec::conflict);
  EXPECT_THAT(other.refusal().message, HasSubstr("surface 2 that the edit names was changed"));

  auto by_place = edit_by(.1, carried());
  by_place.wanted.parameters["vertex"] = 6.;
  by_place.wanted.parameters["at"] = std::string("1, 2, 3; surface:2");
  const auto placed = request<head_moved>(by_place);
  finish({"edit", "check"});
  EXPECT_THAT(placed.refusal().message, HasSubstr("surface 2 that the edit names was changed"));

  const auto same = edit_at(6, carried(), {1});
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(same.is_success());
}

TEST_F(People, WithoutBeingAskedForNothingIsCarriedOver) {
  let_ann_edit();
  EXPECT_EQ(edit_at(6, {"bob", {}, seen_}).refusal().code, ec::conflict);
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(People, AVersionThatIsNotThereIsAConflict) {
  let_ann_edit();
  EXPECT_EQ(edit_at(6, {"bob", {}, std::string(32, '0'), true}).refusal().code, ec::conflict);
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(People, AnEditOfTheHeadIsNotCarriedOver) {
  seen_ = head();
  const auto got = edit_at(6, carried());
  finish({"edit", "check", "commit"});
  ASSERT_TRUE(got.is_success());
  EXPECT_THAT(got.value().report->notices, IsEmpty());
}

TEST_F(People, AnEditFromBeforeAnUndoIsCarriedOver) {
  let_ann_edit();
  seen_ = head();
  const auto undone = move(move_kind::undo);
  finish({"commit"});
  ASSERT_TRUE(undone.is_success());

  const auto got = edit_at(6, carried());
  finish({"edit", "check", "commit"});
  ASSERT_TRUE(got.is_success()) << got.refusal().message;
  EXPECT_EQ(got.value().head.parent, 0U);
}

TEST_F(People, ARetryOfACarriedEditIsAnsweredAsItWas) {
  let_ann_edit();
  auto terms = carried();
  terms.edit_id = "e1";
  const auto first = edit_at(6, terms);
  finish({"edit", "check", "commit"});
  const auto again = edit_at(6, terms);

  ASSERT_TRUE(again.is_success());
  EXPECT_TRUE(again.value().repeated);
  EXPECT_EQ(again.value().head.number, first.value().head.number);
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(People, ARefusalOnTheNewHeadSaysThatItIsAnother) {
  let_ann_edit();
  const auto got = edit_at(6, carried());
  refuse("edit", {ec::surface_not_found, "there is no surface 9", "Select another", {}});

  EXPECT_EQ(got.refusal().code, ec::surface_not_found);
  EXPECT_THAT(got.refusal().message, HasSubstr("the edit was made for version 0"));
  EXPECT_EQ(got.refusal().remedy, "Select another");
}

TEST_F(People, AVersionSaysWhoMadeItAndWhen) {
  let_ann_edit();
  const auto& made = state().graph.nodes().at(1).info;
  EXPECT_EQ(made.made_by, "ann");
  EXPECT_EQ(made.made_at.size(), std::string("2026-11-23T08:45:00Z").size());
}

TEST_F(People, WhoComesAndGoesIsToldToTheOthersOnce) {
  const auto before = heard(mine_).participants.size();
  const auto late = listen("cleo");

  ASSERT_EQ(heard(mine_).participants.size(), before + 1);
  const auto came = heard(mine_).participants.back();
  EXPECT_EQ(came.who.name, "cleo");
  EXPECT_FALSE(came.gone);
  EXPECT_THAT(heard(late).participants, IsEmpty()) << "it knows that it is there";

  const auto again = ask<session_snapshot>(session_, attach_request{late, false, "cleo"});
  pass(milliseconds(1));
  EXPECT_EQ(heard(mine_).participants.size(), before + 1) << "it was there before";
  EXPECT_EQ(again.value().own_participant, came.who.id);
  ASSERT_EQ(again.value().participants.size(), 3U);
  EXPECT_EQ(again.value().participants.back().name, "cleo");

  caf::anon_send(session_, detach_atom::value, late);
  pass(milliseconds(1));
  ASSERT_EQ(heard(mine_).participants.size(), before + 2);
  EXPECT_TRUE(heard(mine_).participants.back().gone);
  EXPECT_EQ(heard(mine_).participants.back().who.id, came.who.id);
  EXPECT_THAT(heard(late).participants, IsEmpty());
}

TEST_F(People, AParticipantWhoseConnectionDiesIsGone) {
  const auto late = listen("cleo");
  simulation::cut_off(late);
  caf::anon_send_exit(late, caf::exit_reason::kill);
  pass(milliseconds(1));

  ASSERT_FALSE(heard(mine_).participants.empty());
  EXPECT_TRUE(heard(mine_).participants.back().gone);
}

TEST_F(People, WhoKeepsADocumentFromBeingDeletedIsNamed) {
  const auto late = listen("cleo");
  const auto refused = ask<acknowledged>(session_, delete_atom::value, mine_);
  pass(milliseconds(1));

  EXPECT_EQ(refused.refusal().code, ec::conflict);
  EXPECT_THAT(refused.refusal().message, HasSubstr("(2: one without a name, cleo)"));
}

}  // namespace
}  // namespace tedit::actors
