// SPDX-License-Identifier: AGPL-3.0-or-later
// A session that has room for one version beside its head.
#include "tests/states/session_fixture.hpp"

namespace tedit::actors {
namespace {

class Meshes : public Session {
protected:
  Meshes() : Session(1) {}

  /// Versions 0 to 3; 3 is the head, 2 is at hand.
  void SetUp() override {
    import_all();
    for (const double by : {.1, .2, .3}) {
      edit(by);
      finish({"edit", "check", "commit"});
    }
    ASSERT_EQ(state().graph.nodes().size(), 4U);
  }

  [[nodiscard]] std::string id_of(std::uint32_t number) {
    return to_hex(state().graph.nodes()[number].info.id);
  }
};

TEST_F(Meshes, OnlyTheHeadAndTheLastOneUsedAreHeld) {
  for (std::uint32_t number = 0; number < 3; ++number)
    EXPECT_EQ(state().graph.nodes()[number].mesh, nullptr) << number;
  EXPECT_EQ(to_hex(state().graph.nodes()[3].mesh->id()), id_of(3));
  EXPECT_EQ(state().mesh_at_hand(0), nullptr);
  EXPECT_EQ(state().mesh_at_hand(1), nullptr);
  EXPECT_NE(state().mesh_at_hand(2), nullptr);
}

TEST_F(Meshes, UndoToTheOneAtHandReadsNothing) {
  const auto moved = move(move_kind::undo);
  EXPECT_THAT(tasks(), ElementsAre("commit"));
  finish({"commit"});
  EXPECT_EQ(to_hex(moved.value().version->id()), id_of(2));
  EXPECT_NE(state().mesh_at_hand(3), nullptr) << "a redo finds it";
}

TEST_F(Meshes, OneThatWasLeftLongAgoIsReadAndBecomesTheHead) {
  const auto moved = move(move_kind::go_to, 0);
  EXPECT_THAT(tasks(), ElementsAre("load"));
  EXPECT_EQ(head(), id_of(3)) << "not before it is there";
  finish({"load", "commit"});

  EXPECT_EQ(head(), id_of(0));
  EXPECT_EQ(to_hex(moved.value().version->id()), id_of(0));
  EXPECT_EQ(to_hex(heard(other_).heads.back().version->id()), id_of(0));
  EXPECT_EQ(to_hex(state().graph.head()->mesh->id()), id_of(0));
  const auto again = edit(.4);
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(again.is_success()) << "it is worked on as any other";
}

TEST_F(Meshes, AnEditIsCancelledWhileTheVersionThatItWasMadeForIsRead) {
  const auto before = head();
  const auto got = edit(.4, {"ann", {}, id_of(0), true});
  EXPECT_THAT(tasks(), ElementsAre("load"));
  cancel(tickets_);
  finish({"load"});

  EXPECT_EQ(got.refusal().code, ec::cancelled);
  EXPECT_EQ(head(), before);
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(Meshes, OneThatCannotBeReadIsRefusedAndTheHeadStays) {
  const auto moved = move(move_kind::go_to, 0);
  const auto next = edit(.4);
  refuse("load", {ec::storage_error, "the document is damaged: page 17", "Restore it", {}});

  EXPECT_EQ(moved.refusal().code, ec::storage_error);
  EXPECT_THAT(moved.refusal().message, HasSubstr("page 17"));
  EXPECT_EQ(head(), id_of(3));
  finish({"edit", "check", "commit"});
  EXPECT_TRUE(next.is_success()) << "who waited has its turn";
}

TEST_F(Meshes, ASurfaceOfAnOldVersionIsReadForWhoAsks) {
  const auto first = request<session_version>(version_request{1});
  const auto second = request<session_version>(version_request{1});
  EXPECT_THAT(tasks(), ElementsAre("load", "load"));
  finish({"load", "load"});
  EXPECT_EQ(to_hex(first.value().mesh->id()), id_of(1));
  EXPECT_EQ(to_hex(second.value().mesh->id()), id_of(1));

  const auto third = request<session_version>(version_request{1});
  EXPECT_TRUE(third.is_success()) << "now it is at hand";
  EXPECT_EQ(head(), id_of(3));
}

TEST_F(Meshes, AFileOfAnOldVersionIsWritten) {
  const auto file = request<exported>(export_request{++tickets_, mine_, id_of(0), "msh", {}});
  EXPECT_THAT(tasks(), ElementsAre("load"));
  finish({"load"});
  EXPECT_EQ(take("file").on, id_of(0));
}

TEST_F(Meshes, TwoOldVersionsAreCompared) {
  const auto made = request<compared>(comparison_request{++tickets_, 0, 1, {}});
  finish({"load", "load", "compare"});
  ASSERT_TRUE(made.is_success()) << render(made.refusal());
  EXPECT_EQ(made.value().before, 0U);
  EXPECT_EQ(made.value().after, 1U);
}

TEST_F(Meshes, AComparisonOfOneThatCannotBeReadIsRefusedAndTheNextRuns) {
  const auto bad = request<compared>(comparison_request{++tickets_, 0, 3, {}});
  const auto good = request<compared>(comparison_request{++tickets_, 2, 3, {}});
  refuse("load", {ec::storage_error, "the document is damaged", {}, {}});
  EXPECT_EQ(bad.refusal().code, ec::storage_error);
  finish({"compare"});
  EXPECT_TRUE(good.is_success());
}

TEST_F(Meshes, TheFieldOfAnOldVersionComesWithItsMesh) {
  set_load("hanging", 5);
  solve(mine_);
  finish({"solve"});
  for (const double by : {.4, .5}) {
    edit(by);
    finish({"edit", "check", "commit"});
  }
  while (!tasks().empty())
    take(tasks().front());  // The solves that followed.
  move(move_kind::go_to, 3);
  finish({"load", "commit"});

  const auto& shown = heard(other_).results.back();
  ASSERT_NE(shown.version, nullptr);
  EXPECT_EQ(to_hex(shown.version->id()), id_of(3));
}

TEST_F(Meshes, ASessionThatReadsDoesNotEnd) {
  request<session_version>(version_request{1});
  for (const auto& one : {mine_, other_})
    caf::anon_send(session_, detach_atom::value, one);
  pass(milliseconds(500'000));
  EXPECT_EQ(end_asked_, 0);
  finish({"load"});
  pass(milliseconds(200'000));
  EXPECT_GT(end_asked_, 0);
}

}  // namespace
}  // namespace tedit::actors
