// SPDX-License-Identifier: AGPL-3.0-or-later
// One answer or one event for each client and fact, never both; and what only files need stays
// where it was made until one is written.
#include <csignal>

#include "tests/scenarios/fixture.hpp"
#include "tests/support/raw_client.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

class SaidOnce : public ::testing::Test {
protected:
  scratch_folder folder;
  std::unique_ptr<tedit::server> host = start(options_for(folder, true));
  std::unique_ptr<client::client> owner = connect(host->url());
  raw_client asker{host->url()};
  raw_client watcher{host->url()};

  void SetUp() override {
    value(owner->open("plate", false, false));
    value(owner->import_file(plate_mesh, "mm", {}));
    value(owner->set_load_case(value(protocol::load_case_from_file(plate_loads))));
    for (auto* one : {&asker, &watcher}) {
      ASSERT_TRUE(one->hello(server_token).has_welcome());
      v1::ClientMessage open;
      open.mutable_open_document()->set_name("plate");
      open.mutable_open_document()->set_watch_fields(true);
      ASSERT_TRUE(one->ask(open).has_document_state());
    }
  }

  /// Waits for the last field of a solve, and so for all that was sent before it.
  static v1::FieldUpdate last_field(raw_client& of, std::uint64_t solve) {
    return of
      .wait([=](const v1::ServerMessage& m) {
        return m.has_field_update() && m.field_update().solve() == solve &&
               !m.field_update().report().interim() && m.field_update().remaining() == 0;
      })
      .field_update();
  }

  static bool is_final(const v1::ServerMessage& m) {
    return m.has_solved() && !m.solved().report().interim();
  }
};

TEST_F(SaidOnce, AnEditAnswersWhoAskedAndIsAnEventForTheOther) {
  v1::ClientMessage edit;
  edit.mutable_apply_edit()->set_document("plate");
  edit.mutable_apply_edit()->set_operation("fill_hole");
  edit.mutable_apply_edit()->add_surfaces(1);
  edit.mutable_apply_edit()->add_surfaces(2);

  const auto answer = asker.ask(edit);
  const auto event = watcher.wait([](const auto& m) { return m.has_committed(); });

  ASSERT_TRUE(answer.has_committed());
  EXPECT_EQ(event.request_id(), 0u);
  EXPECT_EQ(event.committed().head().version_id(), answer.committed().head().version_id());
  EXPECT_EQ(event.committed().report().surface_map_size(),
            answer.committed().report().surface_map_size());
  v1::ClientMessage status;
  status.mutable_get_status();  // What was sent before it has come.
  ASSERT_TRUE(asker.ask(status).has_server_status());
  EXPECT_FALSE(asker.has([](const auto& m) { return m.has_committed(); }));
}

TEST_F(SaidOnce, ASolveDoesTooAndItsFieldsHaveItsNumber) {
  v1::ClientMessage solve;
  solve.mutable_solve()->set_document("plate");
  solve.mutable_solve()->set_element_order(1);

  const auto answer = asker.ask(solve);
  const auto event = watcher.wait(is_final);

  ASSERT_TRUE(answer.has_solved());
  EXPECT_NE(answer.solved().solve(), 0u);
  EXPECT_EQ(event.request_id(), 0u);
  EXPECT_EQ(event.solved().solve(), answer.solved().solve());
  for (auto* one : {&asker, &watcher})
    EXPECT_EQ(last_field(*one, answer.solved().solve()).report().iterations(),
              answer.solved().report().iterations());
  EXPECT_FALSE(asker.has(is_final));
}

/// The file's bytes, without the residual's last digits: a solve that is done once more starts from
/// the displacement of the first.
std::string names_in(const std::vector<char>& vtu) {
  const std::string text(vtu.begin(), vtu.end());
  std::string names;
  for (auto at = text.find("Name=\""); at != std::string::npos; at = text.find("Name=\"", at + 1))
    names += text.substr(at + 6, text.find('"', at + 6) - at - 6) + " ";
  return names;
}

TEST_F(SaidOnce, AFileHasAllFieldsAlsoWhenTheWorkerThatSolvedIsGone) {
  value(owner->solve({.device = "cpu", .element_order = 1}, {}));
  const auto at_hand = names_in(value(owner->export_file("vtu", "", "", {})));
  EXPECT_THAT(at_hand, HasSubstr("element_stress_pa"));
  EXPECT_THAT(at_hand, HasSubstr("strain"));

  for (const auto& worker : value(owner->status()).workers)
    if (worker.role == "solver") {
      ASSERT_EQ(::kill(static_cast<pid_t>(worker.pid), SIGKILL), 0);
    }

  EXPECT_EQ(names_in(value(owner->export_file("vtu", "", "", {}))), at_hand);
}

}  // namespace
}  // namespace tedit::test
