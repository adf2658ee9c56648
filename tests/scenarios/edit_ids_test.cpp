// SPDX-License-Identifier: AGPL-3.0-or-later
// A change is made once however often it is asked for, and of the head that its client has seen.
#include "tests/scenarios/fixture.hpp"
#include "tests/support/raw_client.hpp"

namespace tedit::test {
namespace {

using client::change_terms;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

class EditIds : public ::testing::Test {
protected:
  void SetUp() override {
    user = connect_as("bench");
    value(user->open("part", false, false));
    base = value(user->import_file(plate_mesh, "mm", {}, {{}, "the-import"})).head;
  }

  std::unique_ptr<client::client> connect_as(const std::string& name) {
    client::connect_options line;
    line.url = server->url();
    line.token = test::server_token;
    line.client_name = name;
    line.timeout = patience;
    auto made = value(client::client::connect(line, {}));
    return made;
  }

  /// The same document through another connection.
  std::unique_ptr<client::client> other(const std::string& name) {
    auto made = connect_as(name);
    value(made->open("part", false, false));
    return made;
  }

  void restart() {
    user.reset();
    server.reset();
    server = test::start(options);
    user = other("bench");
  }

  /// Closes one of two holes.
  expected<client::committed> fill(client::client& who, const std::string& id,
                                   std::vector<surface_id> wall = {1, 2},
                                   const std::string& expected_version = {}) {
    return who.edit("fill_hole", wall, {}, {}, expected_version, {}, id);
  }

  std::size_t versions() { return value(user->get_history()).versions.size(); }
  std::uint32_t head() { return value(user->get_history()).head; }

  const std::vector<surface_id> second_hole{92, 93};
  scratch_folder folder;
  server_options options = options_for(folder, false);
  std::unique_ptr<tedit::server> server = test::start(options);
  std::unique_ptr<client::client> user;
  client::version_info base;
};

TEST_F(EditIds, ARetryOnAnotherConnectionIsAnsweredAndChangesNothing) {
  const auto first = value(fill(*user, "edit-1"));
  EXPECT_FALSE(first.repeated);
  const auto second = value(fill(*other("bench"), "edit-1"));
  EXPECT_TRUE(second.repeated);
  EXPECT_EQ(second.head.version_id, first.head.version_id);
  EXPECT_EQ(second.head.number, first.head.number);
  EXPECT_EQ(second.cause, "edit");
  ASSERT_TRUE(second.report && first.report);
  EXPECT_EQ(second.report->tets_added, first.report->tets_added);
  EXPECT_EQ(second.report->total_ms, first.report->total_ms);
  EXPECT_EQ(versions(), 2u);
  EXPECT_FALSE(value(fill(*user, "edit-2", second_hole)).repeated);
  EXPECT_EQ(versions(), 3u);
  // Also when the head is another by now.
  EXPECT_EQ(value(fill(*user, "edit-1")).head.number, 1u);
  EXPECT_EQ(head(), 2u);
}

TEST_F(EditIds, ARetryAfterTheServerWasStartedAnewChangesNothing) {
  const auto first = value(fill(*user, "edit-1"));
  value(user->undo({{}, "undo-1"}));
  restart();
  const auto again = value(fill(*user, "edit-1"));
  EXPECT_TRUE(again.repeated);
  EXPECT_EQ(again.head.version_id, first.head.version_id);
  EXPECT_EQ(again.report->tets_added, first.report->tets_added);
  EXPECT_TRUE(value(user->undo({{}, "undo-1"})).repeated);
  EXPECT_EQ(head(), 0u);
  EXPECT_EQ(versions(), 2u);
  const auto imported = value(user->import_file(plate_mesh, "mm", {}, {{}, "the-import"}));
  EXPECT_TRUE(imported.repeated);
  EXPECT_EQ(imported.head.version_id, base.version_id);
  EXPECT_EQ(versions(), 2u);
}

TEST_F(EditIds, EveryKindOfChangeIsMadeOnce) {
  value(fill(*user, "edit-1"));
  value(fill(*user, "edit-2", second_hole));
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(value(user->undo({{}, "undo-1"})).repeated, i == 1);
  EXPECT_EQ(head(), 1u);
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(value(user->redo({{}, "redo-1"})).repeated, i == 1);
  EXPECT_EQ(head(), 2u);
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(value(user->go_to(0, {{}, "go-1"})).repeated, i == 1);
  auto loads = value(protocol::load_case_from_file(plate_loads));
  value(user->set_load_case(loads, {{}, "loads-1"}));
  value(user->remove_load_case(loads.name, {{}, "remove-1"}));
  value(user->set_load_case(loads, {{}, "loads-1"}));  // Was made: it is not set again.
  EXPECT_TRUE(value(user->get_history()).versions.front().load_cases.empty());
  value(user->remove_load_case(loads.name, {{}, "remove-1"}));  // Not "there is no load case".
  value(user->annotate(0, "first", "", {{}, "name-1"}));
  value(user->annotate(0, "second", ""));
  value(user->annotate(0, "first", "", {{}, "name-1"}));
  EXPECT_EQ(value(user->get_history()).versions.front().name, "second");
}

TEST_F(EditIds, AnIdIsForOneChangeAlone) {
  value(fill(*user, "edit-1"));
  const auto other_edit = fill(*user, "edit-1", second_hole);
  ASSERT_FALSE(other_edit.has_value());
  EXPECT_EQ(other_edit.error().code, ec::conflict);
  EXPECT_THAT(other_edit.error().message, HasSubstr("edit-1"));
  EXPECT_EQ(user->undo({{}, "edit-1"}).error().code, ec::conflict);
  EXPECT_EQ(user->annotate(0, "x", "", {{}, "edit-1"}).error().code, ec::conflict);
  EXPECT_EQ(fill(*user, "two words").error().code, ec::invalid_argument);
  EXPECT_EQ(versions(), 2u);
}

TEST_F(EditIds, WhatWasRefusedMayBeAskedAgain) {
  EXPECT_FALSE(fill(*user, "edit-1", {999}).has_value());
  EXPECT_FALSE(value(fill(*user, "edit-1")).repeated);
}

// -- whose change -------------------------------------------------------------------------------

TEST_F(EditIds, AConflictSaysWhoseChangeItIs) {
  const auto anna = other("anna's bench");
  const auto made = value(fill(*anna, ""));
  for (const bool again : {false, true}) {
    if (again)
      restart();  // It is in the document.
    const auto refused = fill(*user, "", second_hole, base.version_id);
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ec::conflict);
    EXPECT_THAT(refused.error().message,
                AllOf(HasSubstr(made.head.version_id), HasSubstr("number 1"),
                      HasSubstr("\"anna's bench\" made it the head with fill_hole at 20")));
    const auto& rival = refused.error().rival;
    ASSERT_TRUE(rival);
    EXPECT_EQ(rival->version_id, made.head.version_id);
    EXPECT_EQ(rival->number, 1u);
    EXPECT_EQ(rival->client, "anna's bench");
    EXPECT_EQ(rival->cause, "edit");
    EXPECT_EQ(rival->operation, "fill_hole");
    EXPECT_THAT(rival->made_at, MatchesRegex("20[0-9-]+T[0-9:]+Z"));
    if (!again)
      value(anna->set_load_case(value(protocol::load_case_from_file(plate_loads))));
  }
}

TEST_F(EditIds, AConflictHasFields) {
  const auto anna = other("anna");
  const auto made = value(fill(*anna, ""));
  value(anna->undo());
  raw_client raw(server->url());
  ASSERT_TRUE(raw.hello(test::server_token).has_welcome());
  v1::ClientMessage open;
  open.mutable_open_document()->set_name("part");
  ASSERT_TRUE(raw.ask(open).has_document_state());
  v1::ClientMessage redo;
  redo.mutable_redo()->set_document("part");
  redo.mutable_redo()->set_expected_version(made.head.version_id);
  const auto refused = raw.ask(redo);
  ASSERT_TRUE(refused.error().has_conflict());
  const auto& conflict = refused.error().conflict();
  EXPECT_EQ(conflict.version_id(), base.version_id);
  EXPECT_EQ(conflict.number(), 0u);
  EXPECT_EQ(conflict.client(), "anna");
  EXPECT_EQ(conflict.cause(), "undo");
  EXPECT_EQ(conflict.operation(), "");
  EXPECT_THAT(conflict.made_at(), MatchesRegex("[0-9-]+T[0-9:]+Z"));
}

TEST_F(EditIds, EveryChangeOfTheHeadLooksAtTheExpectedVersion) {
  value(fill(*user, ""));
  const change_terms old{base.version_id, {}};
  const auto loads = value(protocol::load_case_from_file(plate_loads));
  EXPECT_EQ(user->undo(old).error().code, ec::conflict);
  EXPECT_EQ(user->redo(old).error().code, ec::conflict);
  EXPECT_EQ(user->go_to(0, old).error().code, ec::conflict);
  EXPECT_EQ(user->set_load_case(loads, old).error().code, ec::conflict);
  EXPECT_EQ(user->remove_load_case(loads.name, old).error().code, ec::conflict);
  EXPECT_EQ(user->import_file(plate_mesh, "mm", {}, old).error().code, ec::conflict);
  EXPECT_EQ(head(), 1u);
  const change_terms now{value(user->get_history()).versions.at(1).version_id, {}};
  value(user->set_load_case(loads, now));
  value(user->remove_load_case(loads.name, now));
  EXPECT_EQ(value(user->undo(now)).head.number, 0u);
}

}  // namespace
}  // namespace tedit::test
