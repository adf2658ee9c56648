// SPDX-License-Identifier: AGPL-3.0-or-later
// What an observer hears of a document, and what it cannot do.
#include "actors/node/observing.hpp"

#include "tests/states/session_fixture.hpp"

namespace tedit::actors {
namespace {

using std::chrono::seconds;

/// A connection that is cut once.
struct watched_line final : lifeline {
  std::optional<std::string> ended() override { return std::nullopt; }
  void cut() override { was_cut = true; }
  [[nodiscard]] std::string name() const override { return "node eye"; }
  bool was_cut = false;
};

/// An observer that answers when a test says so, or at once.
struct eye_state {
  std::vector<std::string> heard;
  std::vector<version_ref> versions;
  std::deque<caf::typed_response_promise<bool>> owed;
  bool slow = false;
  static inline const char* name = "eye";
};
using eye_pointer = caf::stateful_actor<eye_state>*;

caf::result<bool> hear(eye_pointer self, const std::string& what) {
  self->state.heard.push_back(what);
  if (!self->state.slow)
    return true;
  auto promise = self->make_response_promise<bool>();
  self->state.owed.push_back(promise);
  return promise;
}

caf::behavior make_eye(eye_pointer self, int /*number*/) {
  return {[=](const observed_version& e) {
            self->state.versions.push_back(e.version);
            return hear(self, e.cause + " " + std::to_string(e.number) + " of " + e.document);
          },
          [=](const observed_load_cases& e) {
            return hear(self, "loads " + std::to_string((*e.load_cases.get())->size()));
          },
          [=](const observed_result& e) {
            return hear(self, "result of " + (*e.outcome.get())->cases.front().load_case);
          },
          [=](const observed_name& e) { return hear(self, e.before + " is " + e.document); },
          [=](const observed_end& e) { return hear(self, "end of " + e.document); },
          [](const doing& that) { that.what(); }};
}

/// Knows one document.
caf::behavior make_desk(caf::event_based_actor*, const session_actor& session) {
  return {[=](list_atom) {
            document_list all;
            all.documents.push_back({"part"});
            return all;
          },
          [=](existing_atom, const std::string& name) -> caf::result<opened_document> {
            if (name != "part")
              return to_caf({ec::not_found, "there is no document " + name, "Name another", {}});
            return opened_document{name, caf::actor_cast<caf::actor>(session)};
          }};
}

class Observing : public Session {
protected:
  Observing() {
    desk_ = stage_.system().spawn(make_desk, session_);
    eye_ = stage_.system().spawn(make_eye, 0);
    seen_ = make_observing(stage_.system(), {caf::actor_cast<hub_actor>(desk_),
                                             caf::actor_cast<caf::actor>(pages_), "eye", line_});
  }
  ~Observing() override {
    for (const auto& one : {caf::actor_cast<caf::actor>(seen_), eye_, desk_})
      caf::anon_send_exit(one, caf::exit_reason::user_shutdown);
    pass(milliseconds(1));
  }

  answer<std::string> watch(const std::string& document) {
    const auto got = ask<std::string>(seen_, watch_atom::value, document, eye_);
    pass(milliseconds(5));
    return got;
  }
  eye_state& eye() {
    return dynamic_cast<caf::stateful_actor<eye_state>&>(
             *caf::actor_cast<caf::abstract_actor*>(eye_))
      .state;
  }
  /// Whether its server side is there still.
  bool is_there() {
    const auto got = ask<std::vector<std::string>>(seen_, names_atom::value);
    pass(milliseconds(5));
    return got.is_success();
  }

  std::shared_ptr<watched_line> line_ = std::make_shared<watched_line>();
  caf::actor desk_;
  caf::actor eye_;
  observation_actor seen_;
};

TEST_F(Observing, HearsEachVersionAndEachResultInOrder) {
  import_all();
  EXPECT_EQ(watch("part").value(), "part");
  EXPECT_THAT(eye().heard, ElementsAre("head 0 of part"));

  set_load("braking", 1000);
  solve(mine_);
  finish({"solve"});
  edit(0.1);
  finish({"edit", "check", "commit"});
  EXPECT_THAT(eye().heard,
              ElementsAre("head 0 of part", "loads 1", "result of braking", "edit 1 of part"));
  EXPECT_EQ(to_hex(eye().versions.back().id), head());
}

TEST_F(Observing, HearsTheResultThatIsThereAlready) {
  import_all();
  set_load("braking", 1000);
  solve(mine_);
  finish({"solve"});
  EXPECT_TRUE(watch("part").is_success());
  EXPECT_THAT(eye().heard, ElementsAre("head 0 of part", "result of braking"));
}

TEST_F(Observing, HearsTheNewNameOfADocument) {
  import_all();
  EXPECT_TRUE(watch("part").is_success());
  ask<document_renamed>(session_, rename_atom::value, std::string("plate"));
  pass(milliseconds(1));
  finish({"rename"});
  edit(0.1);
  finish({"edit", "check", "commit"});
  EXPECT_THAT(eye().heard, ElementsAre("head 0 of part", "part is plate", "edit 1 of plate"));
}

TEST_F(Observing, ADocumentThatIsNotThereIsNotMade) {
  const auto refused = watch("other").refusal();
  EXPECT_EQ(refused.code, ec::not_found);
  EXPECT_THAT(refused.message, HasSubstr("there is no document other"));
  const auto names = ask<std::vector<std::string>>(seen_, names_atom::value);
  pass(milliseconds(5));
  EXPECT_THAT(names.value(), ElementsAre("part"));
}

TEST_F(Observing, SixtyFourDocumentsAtMostAlsoWhenAllAreAskedForAtOnce) {
  import_all();
  std::vector<answer<std::string>> asked;
  for (int i = 0; i < 65; ++i)
    asked.push_back(ask<std::string>(seen_, watch_atom::value, std::string("part"), eye_));
  pass(milliseconds(5));

  std::size_t refused = 0;
  for (const auto& one : asked)
    refused += one.refusal().code == ec::invalid_argument;
  EXPECT_EQ(refused, 1u);
}

TEST_F(Observing, WhoIsSixtyFourEventsBehindIsCutOff) {
  import_all();
  EXPECT_TRUE(watch("part").is_success());
  eye().slow = true;
  for (std::size_t i = 0; i < most_unanswered; ++i)
    set_load("case", static_cast<double>(i + 1));
  EXPECT_FALSE(line_->was_cut);

  within(eye_, [this] { eye().owed.front().deliver(true); });
  set_load("case", 1000);
  EXPECT_FALSE(line_->was_cut);

  set_load("case", 2000);
  EXPECT_TRUE(line_->was_cut);
  EXPECT_FALSE(is_there());
}

TEST_F(Observing, WhoAnswersNothingForAMinuteIsCutOff) {
  import_all();
  eye().slow = true;
  EXPECT_TRUE(watch("part").is_success());
  pass(seconds(59));
  EXPECT_FALSE(line_->was_cut);
  pass(seconds(2));
  EXPECT_TRUE(line_->was_cut);
}

TEST_F(Observing, WhoWatchesNothingForHalfAMinuteIsCutOff) {
  pass(seconds(29));
  EXPECT_FALSE(line_->was_cut);
  pass(seconds(2));
  EXPECT_TRUE(line_->was_cut);
}

TEST_F(Observing, KeepsNobodyFromDeletingTheDocumentAndHearsOfIt) {
  import_all();
  EXPECT_TRUE(watch("part").is_success());
  const auto status = request<session_status>(status_atom::value);
  EXPECT_EQ(status.value().clients, 2u) << "without the observer";

  simulation::cut_off(other_);
  pass(milliseconds(1));
  const auto deleted = ask<acknowledged>(session_, delete_atom::value, mine_);
  pass(milliseconds(1));
  finish({"delete"});

  EXPECT_TRUE(deleted.is_success());
  EXPECT_EQ(eye().heard.back(), "end of part");
}

TEST_F(Observing, EndsWithItsObserver) {
  import_all();
  EXPECT_TRUE(watch("part").is_success());
  simulation::cut_off(eye_);
  pass(milliseconds(5));
  EXPECT_FALSE(is_there());
}

}  // namespace
}  // namespace tedit::actors
