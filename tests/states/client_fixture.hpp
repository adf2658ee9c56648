// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include "actors/gateway/client_actor.hpp"
#include "protocol/version.hpp"
#include "tests/simulation/client.hpp"
#include "tests/simulation/server.hpp"
#include "tests/simulation/workers.hpp"
#include "tests/states/fixture.hpp"

namespace tedit::gateway {

/// A request that a made-up session or hub answers when a test says so.
template <class Request, class Result>
struct open_request {
  Request wanted;
  caf::typed_response_promise<Result> promise;
};

/// A document's session, and the hub, in one.
struct server_state {
  std::deque<open_request<std::string, actors::opened_document>> openings;
  std::deque<open_request<actors::attach_request, actors::session_snapshot>> attachments;
  std::deque<open_request<actors::import_request, actors::head_moved>> imports;
  std::deque<open_request<actors::apply_request, actors::head_moved>> edits;
  std::deque<open_request<actors::preview_request, actors::previewed>> previews;
  std::deque<open_request<actors::export_request, actors::exported>> files;
  std::deque<open_request<actors::solve_request, actors::solved>> solves;
  std::deque<open_request<actors::version_request, actors::session_version>> versions;
  std::vector<std::uint64_t> cancelled;
  int detached = 0;
  static inline const char* name = "server";
};
using server_puppet = caf::stateful_actor<server_state>;

/// Keeps the request in its queue.
template <class Result, class Request>
caf::result<Result> keep(server_puppet* self, const Request& wanted,
                         std::deque<open_request<Request, Result>> server_state::*queue) {
  auto promise = self->make_response_promise<Result>();
  (self->state.*queue).push_back({wanted, promise});
  return promise;
}

/// `number` tells several apart.
inline caf::behavior make_server(server_puppet* self, int /*number*/) {
  using namespace actors;
  using state = server_state;
  return {[=](const std::string& wanted) { return keep(self, wanted, &state::openings); },
          [=](const attach_request& wanted) { return keep(self, wanted, &state::attachments); },
          [=](const import_request& wanted) { return keep(self, wanted, &state::imports); },
          [=](const apply_request& wanted) { return keep(self, wanted, &state::edits); },
          [=](const preview_request& wanted) { return keep(self, wanted, &state::previews); },
          [=](const export_request& wanted) { return keep(self, wanted, &state::files); },
          [=](const solve_request& wanted) { return keep(self, wanted, &state::solves); },
          [=](const version_request& wanted) { return keep(self, wanted, &state::versions); },
          [=](cancel_atom, std::uint64_t ticket) { self->state.cancelled.push_back(ticket); },
          [=](detach_atom, const caf::actor&) { ++self->state.detached; },
          [](const doing& that) { that.what(); }};
}

/// A line whose other end takes what it is given, or nothing, as a test says.
class quiet_line final : public connection {
public:
  void send(frame bytes) override {
    v1::ServerMessage message;
    EXPECT_TRUE(message.ParseFromString(*bytes));
    messages.push_back(std::move(message));
  }
  [[nodiscard]] std::size_t queued_bytes() const override { return queued; }
  void authenticated() override { ++welcomed; }
  void handled(std::size_t bytes) override { dealt_with += bytes; }
  void close(std::uint16_t code, std::string) override { closed_with = code; }
  [[nodiscard]] std::string peer() const override { return "127.0.0.1:40000"; }

  std::deque<v1::ServerMessage> messages;
  std::size_t queued = 0;
  std::size_t dealt_with = 0;
  int welcomed = 0;
  int closed_with = 0;
};

class Client : public actors::States {
protected:
  static constexpr std::size_t more_than_is_sent_ahead = std::size_t{4} << 20;

  Client() {
    server_ = stage_.system().spawn(make_server, 1);
    gateway_parts parts;
    parts.hub = caf::actor_cast<actors::hub_actor>(server_);
    parts.guard = std::make_shared<token_guard>("right");
    parts.upload_bytes = 1000;
    parts.all_uploads = all_uploads_;
    parts.connections = [] { return std::size_t{1}; };
    client_ = stage_.system().spawn(make_client, std::shared_ptr<connection>(line_), parts);
  }

  // Each holds the other where a question is left without an answer.
  ~Client() override {
    simulation::cut_off(client_);
    simulation::cut_off(server_);
  }

  /// Sends a request; its id.
  std::uint64_t send(v1::ClientMessage message, std::uint64_t id = 0) {
    message.set_request_id(id ? id : ++last_);
    caf::anon_send(client_, message.SerializeAsString());
    pass(simulation::milliseconds(1));
    return message.request_id();
  }

  std::uint64_t hello(const std::string& token = "right") {
    v1::ClientMessage message;
    message.mutable_hello()->set_protocol_major(protocol::major_version);
    message.mutable_hello()->set_protocol_minor(protocol::minor_version);
    message.mutable_hello()->set_client("a test");
    message.mutable_hello()->set_token(token);
    return send(std::move(message));
  }

  std::uint64_t ask_to_open(const std::string& name = "part") {
    v1::ClientMessage message;
    message.mutable_open_document()->set_name(name);
    message.mutable_open_document()->set_watch_surface(true);
    message.mutable_open_document()->set_watch_fields(true);
    return send(std::move(message));
  }

  /// Answers the hub's question and the session's; the document has `mesh`, or nothing yet.
  void let_open(const std::string& name, const version_ptr& mesh, const caf::actor& session) {
    within_server([&] {
      take(server().openings).promise.deliver(actors::opened_document{name, session});
    });
    within(session, [&] {
      actors::session_snapshot snapshot;
      snapshot.document = name;
      snapshot.version = mesh;
      take(simulation::state_of<server_state>(session).attachments).promise.deliver(snapshot);
    });
    pass(simulation::milliseconds(1));
  }

  /// Has said hello and opened the document; what was sent for that is read.
  void open(const std::string& name = "part", const version_ptr& mesh = nullptr,
            caf::actor session = {}) {
    if (line_->welcomed == 0)
      hello();
    const auto id = ask_to_open(name);
    let_open(name, mesh, session ? session : server_);
    ASSERT_TRUE(answer_to(id).has_document_state());
    line_->messages.clear();
  }

  std::uint64_t edit(const std::string& document = "part", std::uint64_t id = 0) {
    v1::ClientMessage message;
    message.mutable_apply_edit()->set_document(document);
    message.mutable_apply_edit()->set_operation("nudge");
    return send(std::move(message), id);
  }
  std::uint64_t preview(const std::string& document = "part", std::uint64_t id = 0) {
    v1::ClientMessage message;
    message.mutable_preview_edit()->mutable_edit()->set_document(document);
    message.mutable_preview_edit()->mutable_edit()->set_operation("nudge");
    return send(std::move(message), id);
  }
  std::uint64_t export_file() {
    v1::ClientMessage message;
    message.mutable_export_file()->set_document("part");
    message.mutable_export_file()->set_format("msh");
    return send(std::move(message));
  }
  std::uint64_t surface_of(std::uint32_t number) {
    v1::ClientMessage message;
    message.mutable_get_surface()->set_document("part");
    message.mutable_get_surface()->set_number(number);
    return send(std::move(message));
  }
  std::uint64_t cancel(std::uint64_t id) {
    v1::ClientMessage message;
    message.mutable_cancel()->set_request_id(id);
    return send(std::move(message));
  }
  std::uint64_t close(const std::string& document) {
    v1::ClientMessage message;
    message.mutable_close_document()->set_document(document);
    return send(std::move(message));
  }
  void upload(std::uint64_t number, std::uint64_t offset, std::size_t bytes) {
    v1::ClientMessage message;
    message.mutable_upload_chunk()->set_upload(number);
    message.mutable_upload_chunk()->set_offset(offset);
    message.mutable_upload_chunk()->set_data(std::string(bytes, 'x'));
    send(std::move(message));
  }
  std::uint64_t import(std::uint64_t upload, std::size_t size,
                       const std::string& document = "part") {
    v1::ClientMessage message;
    message.mutable_import_mesh()->set_document(document);
    message.mutable_import_mesh()->set_upload(upload);
    message.mutable_import_mesh()->set_size(size);
    return send(std::move(message));
  }

  /// All that was sent with this id, streams' pieces not.
  std::vector<v1::ServerMessage> answers_to(std::uint64_t id) {
    std::vector<v1::ServerMessage> found;
    std::ranges::copy_if(line_->messages, std::back_inserter(found),
                         [&](const auto& one) { return one.request_id() == id; });
    return found;
  }
  /// The one answer; an empty message, and a failure, when there is none or more than one.
  v1::ServerMessage answer_to(std::uint64_t id) {
    const auto all = answers_to(id);
    EXPECT_EQ(all.size(), 1U) << "answers to request " << id;
    return all.size() == 1 ? all.front() : v1::ServerMessage();
  }
  template <class Has>
  std::size_t count(const Has& has) {
    return static_cast<std::size_t>(std::ranges::count_if(line_->messages, has));
  }
  std::size_t surfaces_sent() {
    return count([](const auto& one) { return one.has_surface_update(); });
  }

  /// The line takes everything again.
  void drain() {
    line_->queued = 0;
    caf::anon_send(client_, drained_atom::value);
    pass(simulation::milliseconds(1));
  }

  template <class Task>
  static Task take(std::deque<Task>& tasks) {
    if (tasks.empty())
      throw std::logic_error("nobody asked for that");
    auto first = std::move(tasks.front());
    tasks.pop_front();
    return first;
  }

  actors::head_moved moved_to(const version_ptr& mesh, const std::string& document = "part") {
    actors::head_moved moved;
    moved.document = document;
    moved.head.id = mesh->id();
    moved.version = mesh;
    moved.cause = "edit";
    moved.report = std::make_shared<const edit_report>();
    return moved;
  }

  template <class Event>
  void tell(const Event& event) {
    caf::anon_send(client_, event);
    pass(simulation::milliseconds(1));
  }

  void within_server(std::function<void()> what) {
    within(server_, std::move(what));
    pass(simulation::milliseconds(1));
  }
  server_state& server() { return simulation::state_of<server_state>(server_); }
  client_state& state() { return simulation::state_of<client_state>(client_); }

  std::shared_ptr<quiet_line> line_ = std::make_shared<quiet_line>();
  std::shared_ptr<upload_account> all_uploads_ = std::make_shared<upload_account>(1500);
  caf::actor server_, client_;
  std::uint64_t last_ = 0;
  version_ptr first_ = simulation::imported_part(1);
  version_ptr second_ = simulation::nudged(first_, 0, .1);
  version_ptr third_ = simulation::nudged(first_, 1, .1);
};

}  // namespace tedit::gateway
