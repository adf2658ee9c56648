// SPDX-License-Identifier: AGPL-3.0-or-later
// One client's actor between a connection and a session that are made up.
#include "actors/gateway/client_actor.hpp"

#include <cmath>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <caf/actor_system.hpp>

#include "actors/node/system_config.hpp"
#include "protocol/version.hpp"

namespace tedit::gateway {
namespace {

using ::testing::HasSubstr;

/// Keeps what the actor sends.
class kept_connection final : public connection {
public:
  void send(frame bytes) override {
    v1::ServerMessage message;
    EXPECT_TRUE(message.ParseFromString(*bytes));
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
    more_.notify_all();
  }
  [[nodiscard]] std::size_t queued_bytes() const override { return 0; }
  void authenticated() override {}
  void handled(std::size_t) override {}
  void close(std::uint16_t, std::string) override {}
  [[nodiscard]] std::string peer() const override { return "test"; }

  /// The next message; one without a body when none comes.
  v1::ServerMessage next() {
    std::unique_lock lock(mutex_);
    if (!more_.wait_for(lock, std::chrono::seconds(30), [&] { return !messages_.empty(); }))
      return {};
    auto message = std::move(messages_.front());
    messages_.pop_front();
    return message;
  }

private:
  std::mutex mutex_;
  std::condition_variable more_;
  std::deque<v1::ServerMessage> messages_;
};

/// Actors are made of functions with arguments: CAF 0.17 dereferences a null pointer without.
/// A document whose session answers every selection with `features`.
/// Previews are never done.
caf::behavior session_of(caf::event_based_actor* self,
                         const std::shared_ptr<const std::vector<found_feature>>& features) {
  return {[](const actors::attach_request&) {
            actors::session_snapshot snapshot;
            snapshot.document = "part";
            return snapshot;
          },
          [=](const actors::preview_request&) { return self->make_response_promise(); },
          [=](const actors::select_request&) {
            return actors::selected{"part", std::string(32, 'a'), features};
          },
          [](actors::detach_atom, const caf::actor&) {}};
}

// A request without a row would be answered as one that the server does not know.
TEST(RequestRows, EveryRequestHasOneHandler) {
  std::multiset<int> handled;
  for (const auto& rows : {server_requests(), compare_requests(), document_requests(),
                           edit_requests(), export_requests(), library_requests(), note_requests(),
                           print_requests(), section_requests(), upload_requests()})
    for (const auto& row : rows)
      handled.insert(row.kind);
  const auto* bodies = v1::ClientMessage::descriptor()->FindOneofByName("body");
  ASSERT_NE(bodies, nullptr);
  for (int i = 0; i < bodies->field_count(); ++i)
    EXPECT_EQ(handled.count(bodies->field(i)->number()), 1U) << bodies->field(i)->name();
}

/// What the hub is asked to delete, and its answers as a test gives them; the copies that it makes
/// for as long as they are not cancelled.
struct asked_deletions {
  std::mutex mutex;
  std::vector<std::pair<actors::delete_request, caf::response_promise>> all;
  std::vector<cancel_token> copies;
};

using made_up_hub = caf::stateful_actor<std::shared_ptr<asked_deletions>>;

/// Knows that document alone.
caf::behavior hub_of(made_up_hub* self, const caf::actor& session,
                     const std::shared_ptr<asked_deletions>& deletions) {
  return {
    [=](const std::string& name) {
      return actors::opened_document{name, session};
    },
    [=](actors::list_atom) {
      actors::document_list list;
      list.documents = {{"part", 4096, 86'400, true, 2, 3, 1}, {"unborn", 0, 0, true, 1, 0, {}}};
      return list;
    },
    [=](const actors::copy_request& wanted) {
      const std::lock_guard lock(deletions->mutex);
      deletions->copies.push_back(wanted.stop);
      return self->make_response_promise();
    },
    [=](const actors::delete_request& wanted) {
      const std::lock_guard lock(deletions->mutex);
      deletions->all.emplace_back(wanted, self->make_response_promise());
    }};
}

class ClientActor : public ::testing::Test {
protected:
  ~ClientActor() override { caf::anon_send(client_, closed_atom::value); }

  /// Says hello and opens the document.
  void open(const std::vector<found_feature>& found = {}) {
    const auto features = std::make_shared<const std::vector<found_feature>>(found);
    const auto hub = system_.spawn(hub_of, system_.spawn(session_of, features), deletions_);
    gateway_parts parts;
    parts.hub = caf::actor_cast<actors::hub_actor>(hub);
    parts.guard = std::make_shared<token_guard>("");
    parts.all_uploads = std::make_shared<upload_account>(1 << 20);
    client_ = system_.spawn(make_client, std::shared_ptr<connection>(peer_), parts);
    v1::ClientMessage hello;
    hello.mutable_hello()->set_protocol_major(protocol::major_version);
    hello.mutable_hello()->set_protocol_minor(protocol::minor_version);
    const auto answer = ask(std::move(hello));
    ASSERT_TRUE(answer.has_welcome());
    welcome_ = answer.welcome();
    v1::ClientMessage opening;
    opening.mutable_open_document()->set_name("part");
    ASSERT_TRUE(ask(std::move(opening)).has_document_state());
  }

  v1::ServerMessage ask(v1::ClientMessage message) {
    message.set_request_id(++last_);
    caf::anon_send(client_, message.SerializeAsString());
    auto answer = peer_->next();
    EXPECT_EQ(answer.request_id(), last_);
    return answer;
  }

  v1::ServerMessage select(const std::string& document = "part") {
    v1::ClientMessage message;
    message.mutable_select_surfaces()->set_document(document);
    message.mutable_select_surfaces()->set_kind(v1::SelectSurfaces::HOLES);
    return ask(std::move(message));
  }

  /// Whether it comes to be, on another thread.
  static bool comes(const std::function<bool()>& what) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (!what() && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return what();
  }

  std::uint64_t start_deletion(const std::string& name) {
    v1::ClientMessage message;
    message.set_request_id(++last_);
    message.mutable_delete_document()->set_document(name);
    caf::anon_send(client_, message.SerializeAsString());
    return last_;
  }

  /// The hub's answer to the deletion that it was asked for, once it was.
  template <class Answer>
  void answer_deletion(const Answer& answer) {
    EXPECT_TRUE(comes([&] {
      const std::lock_guard lock(deletions_->mutex);
      return !deletions_->all.empty();
    }))
      << "nothing was to be deleted";
    const std::lock_guard lock(deletions_->mutex);
    for (auto& [wanted, promise] : deletions_->all)
      promise.deliver(answer);
    deletions_->all.clear();
  }

  std::shared_ptr<asked_deletions> deletions_ = std::make_shared<asked_deletions>();
  actors::system_config config_{false};
  caf::actor_system system_{config_};
  std::shared_ptr<kept_connection> peer_ = std::make_shared<kept_connection>();
  caf::actor client_;
  v1::Welcome welcome_;
  std::uint64_t last_ = 0;
};

TEST_F(ClientActor, IsToldWhichResultsThereAre) {
  open();
  EXPECT_EQ(welcome_.protocol_major(), protocol::major_version);
  EXPECT_EQ(welcome_.protocol_minor(), protocol::minor_version);
  std::map<std::string, v1::ResultArray> told;
  for (const auto& one : welcome_.results())
    told[one.name()] = one;
  ASSERT_EQ(told.size(), std::size(fem::result_arrays));
  EXPECT_EQ(told["displacement_m"].unit(), "m");
  EXPECT_EQ(told["displacement_m"].components(), 3U);
  EXPECT_EQ(told["displacement_m"].sent(), v1::ResultArray::ALWAYS);
  EXPECT_EQ(told["stress_pa"].sent(), v1::ResultArray::ON_REQUEST);
  EXPECT_EQ(told["reaction_n"].sent(), v1::ResultArray::IN_FILES);
  EXPECT_EQ(told["reaction_n"].place(), v1::ResultArray::VERTICES);
  EXPECT_EQ(told["element_stress_pa"].place(), v1::ResultArray::TETS);
  EXPECT_TRUE(told["safety_factor"].needs_yield());
  EXPECT_FALSE(told["von_mises_pa"].needs_yield());
}

TEST_F(ClientActor, ASelectionsAnswerIsHandedOn) {
  found_feature hole;
  hole.surfaces = {7};
  open({hole});

  const auto answer = select();

  ASSERT_TRUE(answer.has_surfaces_selected()) << answer.error().message();
  ASSERT_EQ(answer.surfaces_selected().features_size(), 1);
  EXPECT_EQ(answer.surfaces_selected().features(0).surfaces(0), 7);
}

/// 64 may run at once.
TEST_F(ClientActor, AnsweredAndRefusedRequestsTakeNoPlaceAmongThoseThatRun) {
  open();
  for (int i = 0; i < 65; ++i)
    ASSERT_TRUE(select().has_surfaces_selected()) << "the request after " << i << " answers";
  for (int i = 0; i < 65; ++i)
    ASSERT_EQ(select("other").error().code(), "not_found") << "after " << i << " refusals";
  EXPECT_TRUE(select().has_surfaces_selected());
}

/// As a form that is dragged asks for them.
TEST_F(ClientActor, APreviewThatAnotherFollowsTakesNoPlaceAnyMore) {
  open();
  for (int i = 0; i < 70; ++i) {
    v1::ClientMessage message;
    message.set_request_id(++last_);
    auto* edit = message.mutable_preview_edit()->mutable_edit();
    edit->set_document("part");
    edit->set_operation("thicken");
    edit->add_surfaces(4);
    caf::anon_send(client_, message.SerializeAsString());
    if (i == 0)
      continue;
    const auto ended = peer_->next();
    ASSERT_EQ(ended.request_id(), last_ - 1);
    ASSERT_EQ(ended.error().code(), "superseded") << ended.error().message();
  }
  EXPECT_TRUE(select().has_surfaces_selected());
}

TEST_F(ClientActor, TheListOfDocumentsHasTimesAsTextAndLeavesOutWhatIsNotKnown) {
  open();
  v1::ClientMessage message;
  message.mutable_list_documents();
  const auto list = ask(std::move(message)).document_list();
  ASSERT_EQ(list.documents_size(), 2);
  EXPECT_EQ(list.documents(0).name(), "part");
  EXPECT_EQ(list.documents(0).bytes(), 4096U);
  EXPECT_EQ(list.documents(0).changed_at(), "1970-01-02T00:00:00Z");
  EXPECT_TRUE(list.documents(0).open());
  EXPECT_EQ(list.documents(0).clients(), 2U);
  EXPECT_EQ(list.documents(0).versions(), 3U);
  EXPECT_EQ(list.documents(0).head(), 1U);
  EXPECT_EQ(list.documents(1).changed_at(), "");
  EXPECT_TRUE(list.documents(1).has_versions());
  EXPECT_FALSE(list.documents(1).has_head());
}

// A request that reached the session behind its deletion would wait for ever.
TEST_F(ClientActor, WhileADocumentIsBeingDeletedNothingIsAskedOfIt) {
  open();
  const auto deletion = start_deletion("part");
  auto answer = select();
  EXPECT_EQ(answer.error().code(), "conflict");
  EXPECT_THAT(answer.error().message(), HasSubstr("is being deleted"));

  answer_deletion(actors::deleted_document{"part"});
  answer = peer_->next();
  EXPECT_EQ(answer.request_id(), deletion);
  EXPECT_EQ(answer.document_deleted().document(), "part");
  EXPECT_EQ(select().error().code(), "not_found");
}

TEST_F(ClientActor, ADocumentWhoseDeletionIsRefusedGoesOn) {
  open();
  const auto deletion = start_deletion("part");
  answer_deletion(actors::to_caf({ec::conflict, "somebody has it open", "Ask them", {}}));
  const auto answer = peer_->next();
  EXPECT_EQ(answer.request_id(), deletion);
  EXPECT_EQ(answer.error().code(), "conflict");
  EXPECT_EQ(answer.error().remedy(), "Ask them");
  EXPECT_TRUE(select().has_surfaces_selected());
}

TEST_F(ClientActor, ACopyIsCancelledByItsRequestAndByTheEndOfTheConnection) {
  open();
  const auto start_copy = [&](const char* name) {
    v1::ClientMessage message;
    message.set_request_id(++last_);
    message.mutable_copy_document()->set_document("part");
    message.mutable_copy_document()->set_name(name);
    caf::anon_send(client_, message.SerializeAsString());
    return last_;
  };
  const auto first = start_copy("first");
  start_copy("second");
  v1::ClientMessage stop;
  stop.mutable_cancel()->set_request_id(first);
  ASSERT_TRUE(ask(std::move(stop)).has_done());
  const auto copies = [&] {
    const std::lock_guard lock(deletions_->mutex);
    return deletions_->copies;
  };
  ASSERT_TRUE(comes([&] { return copies().size() == 2; }));
  EXPECT_TRUE(copies()[0].cancelled());
  EXPECT_FALSE(copies()[1].cancelled());

  caf::anon_send(client_, closed_atom::value);

  EXPECT_TRUE(comes([&] { return copies()[1].cancelled(); }));
}

/// Whatever the request, and before anything else looks at it.
TEST_F(ClientActor, ANumberThatIsNoneIsRefusedWithItsField) {
  open();
  std::vector<std::pair<v1::ClientMessage, std::string>> requests(5);
  requests[0].first.mutable_cut_section()->mutable_normal()->set_z(std::nan(""));
  requests[0].second = "cut_section.normal.z is nan";
  requests[1].first.mutable_select_surfaces()->set_max_diameter_m(HUGE_VAL);
  requests[1].second = "select_surfaces.max_diameter_m is inf";
  requests[2].first.mutable_solve()->set_energy_tolerance(std::nan(""));
  requests[2].second = "solve.energy_tolerance is nan";
  auto& edit = *requests[3].first.mutable_preview_edit()->mutable_edit();
  (*edit.mutable_parameters())["depth"].set_real(-HUGE_VAL);
  requests[3].second = "preview_edit.edit.parameters[depth].value.real is -inf";
  auto* load = requests[4].first.mutable_set_load_case()->mutable_load_case()->add_loads();
  load->mutable_force()->mutable_total_n()->set_z(std::nan(""));
  requests[4].second = "set_load_case.load_case.loads[0].force.total_n.z is nan";

  for (const auto& [request, words] : requests) {
    const auto answer = ask(request);
    ASSERT_TRUE(answer.has_error()) << words;
    EXPECT_EQ(answer.error().code(), "invalid_argument");
    EXPECT_EQ(answer.error().message(), words);
  }
}

}  // namespace
}  // namespace tedit::gateway
