// SPDX-License-Identifier: AGPL-3.0-or-later
// A session of a part that came from CAD: its edits are made on the CAD model, too, behind all
// else.
#include <nlohmann/json.hpp>

#include "actors/store/loading.hpp"
#include "tests/states/session_fixture.hpp"

namespace tedit::actors {
namespace {

constexpr auto pending = cad_status::pending;
constexpr auto same = cad_status::same;
constexpr auto mesh_only = cad_status::mesh_only;
constexpr auto failed = cad_status::failed;

/// Version 0 with its CAD model, and then edits, each of the one before, whose rows are not there.
stored_document part_with_model(std::uint32_t edits, bool logged = true) {
  stored_document stored;
  version_ptr mesh = simulation::imported_part(1);
  for (std::uint32_t n = 0; n <= edits; ++n) {
    graph_node node;
    node.info.number = n;
    node.info.operation = n == 0 ? "import" : "nudge";
    if (n == 0)
      node.info.cad = cad_state{same, {}, 0};
    else
      node.info.parent = n - 1;
    node.report = n == 0 ? nullptr : std::make_shared<const edit_report>();
    describe_mesh(node, mesh);
    stored.nodes.push_back(std::move(node));
    if (n > 0 && logged) {
      past_change made;
      made.time = utc_now();
      made.version = n;
      const nlohmann::json how{{"operation", "nudge"}, {"surfaces", {1}}};
      stored.log.push_back({n, "edit", made.to_details(how.dump())});
    }
    mesh = simulation::nudged(mesh, 0, .1 * (n + 1));
  }
  stored.head = edits;
  return stored;
}

class CadModel : public Session {
protected:
  explicit CadModel(const stored_document& stored = part_with_model(0))
      : Session(version_bytes, stored) {}

  /// Makes an edit; it is answered.
  void edit_all(double by) {
    const auto got = edit(by);
    finish({"edit", "check", "commit"});
    ASSERT_TRUE(got.is_success());
  }
  /// What a version says of itself: in the history.
  std::optional<cad_state> state_of_version(std::uint32_t number) {
    return request<session_history>(history_request{}).value().versions.at(number).cad;
  }
  cad_status status_of_version(std::uint32_t number) {
    const auto state = state_of_version(number);
    EXPECT_TRUE(state.has_value()) << number;
    return state ? state->status : failed;
  }
  /// The numbers of versions of which somebody was told.
  static std::vector<std::uint32_t> told(const caf::actor& who) {
    std::vector<std::uint32_t> numbers;
    for (const auto& one : heard(who).cad)
      numbers.push_back(one.number);
    return numbers;
  }
  /// The rows of the change that was asked for last.
  std::vector<store::cad_row> last_rows() { return helper().changes.back()->cad; }
  void close(const caf::actor& who) {
    caf::anon_send(session_, detach_atom::value, who);
    pass(milliseconds(1));
  }
};

TEST_F(CadModel, AnEditIsMadeOnItOnceItIsAnsweredAndAllAreToldOnceThatIsDurable) {
  const auto edited = edit(.1);
  finish({"edit", "check"});
  EXPECT_THAT(tasks(), ElementsAre("commit")) << "of the edit, and nothing else";
  EXPECT_TRUE(last_rows().empty());
  finish({"commit"});
  ASSERT_TRUE(edited.is_success());
  EXPECT_EQ(edited.value().head.cad, (cad_state{pending, {}, 0}));
  EXPECT_EQ(heard(other_).heads.back().head.cad, (cad_state{pending, {}, 0}));

  EXPECT_THAT(tasks(), ElementsAre("model"));
  EXPECT_THAT(helper().models, ElementsAre(0U)) << "of the version before";
  finish({"model"});
  ASSERT_THAT(tasks(), ElementsAre("cad"));
  EXPECT_EQ(helper().tasks.front().on, head());
  finish({"cad"});
  ASSERT_THAT(tasks(), ElementsAre("commit"));
  ASSERT_EQ(last_rows().size(), 1U);
  EXPECT_EQ(last_rows().front().number, 1U);
  EXPECT_EQ(last_rows().front().status, "same");
  EXPECT_THAT(helper().changes.back()->what, IsEmpty()) << "nothing that a person did";
  EXPECT_EQ(status_of_version(1), pending) << "it is not durable yet";
  EXPECT_THAT(told(mine_), IsEmpty());
  finish({"commit"});

  EXPECT_EQ(state_of_version(1), (cad_state{same, {}, 2e-9}));
  EXPECT_THAT(told(mine_), ElementsAre(1U));
  EXPECT_THAT(told(other_), ElementsAre(1U));
  EXPECT_EQ(heard(other_).cad.back().cad, (cad_state{same, {}, 2e-9}));
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(CadModel, EditsAreMadeOneAfterTheOtherEachOnTheModelBefore) {
  edit_all(.1);
  edit_all(.2);
  EXPECT_THAT(tasks(), ElementsAre("model"));
  finish({"model", "cad", "commit"});
  EXPECT_THAT(told(mine_), ElementsAre(1U));
  EXPECT_EQ(status_of_version(2), pending);
  EXPECT_THAT(helper().models, ElementsAre(0U, 1U));
  finish({"model", "cad", "commit"});
  EXPECT_THAT(told(mine_), ElementsAre(1U, 2U));
  EXPECT_EQ(status_of_version(2), same);
}

TEST_F(CadModel, WhatFollowsAnEditInTheMeshOnlyIsSoAtOnceAndNamesIt) {
  helper().mesh_only = "no way was right";
  edit_all(.1);
  finish({"model", "cad", "commit"});
  EXPECT_EQ(state_of_version(1), (cad_state{mesh_only, "no way was right", 0}));
  for (const std::uint32_t number : {2U, 3U}) {
    edit_all(.1 * number);
    ASSERT_THAT(tasks(), ElementsAre("commit")) << "without work";
    EXPECT_EQ(last_rows().front().status, "mesh_only");
    finish({"commit"});
    EXPECT_EQ(state_of_version(number),
              (cad_state{mesh_only, "version 1 (nudge) is in the mesh only: no way was right", 0}));
  }
  // Beside it the model goes on.
  EXPECT_TRUE([&] {
    const auto got = move(move_kind::go_to, 0);
    finish({"commit"});
    return got.is_success();
  }());
  edit_all(.7);
  finish({"model", "cad", "commit"});
  EXPECT_EQ(status_of_version(4), same);
  EXPECT_THAT(told(mine_), ElementsAre(1U, 2U, 3U, 4U));
}

TEST_F(CadModel, NoChangeAndNoPreviewWaitsForIt) {
  edit_all(.1);
  finish({"model"});
  ASSERT_THAT(tasks(), ElementsAre("cad"));
  const auto seen = preview(.2);
  finish({"edit", "check"});
  EXPECT_TRUE(seen.is_success());
  const auto undone = move(move_kind::undo);
  finish({"commit"});
  EXPECT_TRUE(undone.is_success());
  EXPECT_TRUE(set_load("pull", 100).is_success());
  const auto solving = solve(mine_);
  finish({"solve"});
  EXPECT_TRUE(solving.is_success());
  edit_all(.3);
  EXPECT_EQ(status_of_version(1), pending);
  EXPECT_EQ(status_of_version(2), pending);
}

TEST_F(CadModel, ItsCommitIsBetweenTwoCommandsAndNotBeforeOneThatRuns) {
  edit_all(.1);
  finish({"model"});
  const auto next = edit(.2);
  finish({"cad"});
  EXPECT_THAT(tasks(), ElementsAre("edit")) << "its commit would wait for that of the model";
  finish({"edit", "check"});
  EXPECT_THAT(tasks(), ElementsAre("commit"));
  EXPECT_TRUE(last_rows().empty()) << "the edit's";
  finish({"commit"});
  EXPECT_TRUE(next.is_success());
  EXPECT_THAT(tasks(), ElementsAre("commit"));
  EXPECT_EQ(last_rows().size(), 1U);
  finish({"commit"});
  EXPECT_THAT(told(mine_), ElementsAre(1U));
}

TEST_F(CadModel, ADocumentThatIsClosedEndsItsWork) {
  edit_all(.1);
  finish({"model"});
  const auto job = helper().tasks.front().job;
  close(mine_);
  close(other_);
  const auto ended = ask<shared_remains>(session_, end_atom::value);
  pass(milliseconds(1));
  EXPECT_TRUE(ended.is_success());
  EXPECT_THAT(helper().cancelled, ElementsAre(job));
  EXPECT_EQ(helper().closed, 1);
}

TEST_F(CadModel, ARowThatIsBeingWrittenKeepsASessionFromItsEnd) {
  edit_all(.1);
  finish({"model", "cad"});
  close(mine_);
  close(other_);
  const auto early = ask<shared_remains>(session_, end_atom::value);
  pass(milliseconds(1));
  EXPECT_EQ(early.refusal().code, ec::conflict);
  finish({"commit"});
  const auto late = ask<shared_remains>(session_, end_atom::value);
  pass(milliseconds(1));
  EXPECT_TRUE(late.is_success());
  EXPECT_THAT(helper().cancelled, IsEmpty());
}

TEST_F(CadModel, ItKeepsNobodyFromDeletingADocumentAndGoesOnWhenThatFails) {
  edit_all(.1);
  finish({"model"});
  close(other_);
  const auto first = take("cad").job;
  const auto gone = ask<acknowledged>(session_, delete_atom::value, mine_);
  pass(milliseconds(1));
  EXPECT_THAT(helper().cancelled, ElementsAre(first));
  refuse("delete", {ec::io_error, "the folder may not be written", "Ask its owner", {}});
  EXPECT_EQ(gone.refusal().code, ec::io_error);
  finish({"model", "cad", "commit"});
  EXPECT_EQ(status_of_version(1), same);
}

TEST_F(CadModel, WhatTheSystemRefusesIsToldAsSuchAndNotTriedAgain) {
  edit_all(.1);
  edit_all(.2);
  const auto rows = helper().changes.size();
  finish({"model"});
  refuse("cad", {ec::service_unavailable, "there is no CAD editor", "Install it", {}});
  EXPECT_THAT(tasks(), IsEmpty());
  EXPECT_EQ(helper().changes.size(), rows) << "nothing of it is kept";
  EXPECT_THAT(told(mine_), ElementsAre(1U, 2U));
  EXPECT_EQ(state_of_version(1), (cad_state{failed, "there is no CAD editor. Install it", 0}));
  EXPECT_EQ(status_of_version(2), failed);
  edit_all(.3);
  EXPECT_THAT(tasks(), IsEmpty());
  EXPECT_EQ(heard(mine_).heads.size(), 0U) << "who asked is answered";
  EXPECT_EQ(heard(other_).heads.back().head.cad->status, failed);
  EXPECT_THAT(told(other_), ElementsAre(1U, 2U)) << "the third one said so from the beginning";
}

TEST_F(CadModel, ADiskThatIsFullFailsItAndNotTheEdits) {
  edit_all(.1);
  finish({"model", "cad"});
  refuse("commit", {ec::storage_error, "the disk is full", "Make room", {}});
  EXPECT_EQ(state_of_version(1), (cad_state{failed, "the disk is full. Make room", 0}));
  edit_all(.2);
}

TEST_F(CadModel, AnotherMeshThatIsImportedOverItHasNone) {
  import_all();
  EXPECT_FALSE(state_of_version(1).has_value());
  edit_all(.1);
  EXPECT_FALSE(state_of_version(2).has_value());
  EXPECT_THAT(tasks(), IsEmpty());
}

/// Edits that were made before the document was closed, two of them without a row.
class CadModelOfBefore : public CadModel {
protected:
  explicit CadModelOfBefore(const stored_document& stored = part_with_model(2))
      : CadModel(stored) {}
};

TEST_F(CadModelOfBefore, IsGoneOnWithFromWhereItWasLeft) {
  EXPECT_EQ(status_of_version(0), same);
  EXPECT_EQ(status_of_version(1), pending);
  EXPECT_EQ(status_of_version(2), pending);
  finish({"model", "load", "load"});
  ASSERT_THAT(tasks(), ElementsAre("cad"));
  finish({"cad", "commit", "model", "cad", "commit"});
  EXPECT_THAT(helper().models, ElementsAre(0U, 1U));
  EXPECT_THAT(told(mine_), ElementsAre(1U, 2U));
  EXPECT_EQ(status_of_version(2), same);
}

class CadModelWithoutLog : public CadModelOfBefore {
protected:
  CadModelWithoutLog() : CadModelOfBefore(part_with_model(1, false)) {}
};

TEST_F(CadModelWithoutLog, AnEditOfAnOlderServerIsInTheMeshOnly) {
  ASSERT_THAT(tasks(), ElementsAre("commit"));
  finish({"commit"});
  EXPECT_EQ(state_of_version(1),
            (cad_state{mesh_only, "the document does not say how it was made", 0}));
}

TEST_F(Session, APartFromAMeshHasNoCadModel) {
  import_all();
  const auto edited = edit(.1);
  finish({"edit", "check", "commit"});
  EXPECT_FALSE(edited.value().head.cad.has_value());
  EXPECT_THAT(tasks(), IsEmpty());
}

}  // namespace
}  // namespace tedit::actors
