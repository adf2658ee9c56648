// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/client_actor.hpp"

#include <algorithm>
#include <atomic>

#include <google/protobuf/io/coded_stream.h>

#include "actors/errors.hpp"
#include "base/logging/logging.hpp"
#include "protocol/text_fields.hpp"

namespace tedit::gateway {

namespace {

constexpr int protobuf_depth = 32;
constexpr std::size_t most_requests = 64;

/// Bytes of any text in a request. Notes of versions have at most 4000 characters.
constexpr std::size_t longest_text = 16 * 1024;

bool parse(const std::string& bytes, v1::ClientMessage& message) {
  google::protobuf::io::CodedInputStream in(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                            static_cast<int>(bytes.size()));
  in.SetRecursionLimit(protobuf_depth);
  return message.ParseFromCodedStream(&in) && in.ConsumedEntireMessage();
}

void count_refusal(const std::string& code) {
  metrics::count_of("tedit_requests_refused_total", "Requests that were refused, by error code.",
                    {{"code", code}})
    .add();
}

}  // namespace

void client_state::start(client_pointer owner, std::shared_ptr<connection> peer,
                         gateway_parts with) {
  self = owner;
  to = std::move(peer);
  parts = std::move(with);
  bulk_out.emplace(to);
  upload_bytes = std::make_shared<upload_account>(parts.upload_bytes, parts.all_uploads);
}

void client_state::on_message(const std::string& bytes) {
  if (turned_away)
    return;
  v1::ClientMessage message;
  if (!parse(bytes, message)) {
    refuse(0, {ec::protocol_error,
               "this is no message of tedit.v1",
               "Use the schema of the server's version",
               {}});
    return to->close(1007, "no message of tedit.v1");
  }
  const auto id = message.request_id();
  if (!known) {
    if (message.has_hello())
      return hello(id, message.hello());
    refuse(id, {ec::protocol_error, "the first message must be Hello", {}, {}});
    return to->close(1008, "no Hello");
  }
  if (auto ok = check(message).and_then([&] { return may(message); }); !ok)
    return reject(id, ok.error());
  dispatch(id, message);
}

/// Errors: `protocol_error` for an id that cannot be, `invalid_argument` for a text that is too
/// long, `conflict` when too much is asked at once. Pieces of uploads take no place among the
/// requests, and what makes places free always has one.
expected<void> client_state::check(const v1::ClientMessage& message) const {
  if (const auto where = protocol::find_long_text(message, longest_text); !where.empty())
    return fail(ec::invalid_argument,
                "the text " + where + " has more than " + std::to_string(longest_text) + " bytes",
                "Shorten it");
  if (message.has_upload_chunk())
    return {};
  if (message.request_id() == 0)
    return fail(ec::protocol_error, "a request needs a request_id");
  if (requests.contains(message.request_id()))
    return fail(ec::protocol_error,
                "request_id " + std::to_string(message.request_id()) + " is in use",
                "Number requests without repeating yourself; the one that runs goes on");
  if (requests.size() >= most_requests && !message.has_cancel())
    return fail(ec::conflict, "too many requests at once (" + std::to_string(most_requests) + ")",
                "Wait for answers before asking more");
  return {};
}

void client_state::running_request::cancel() const {
  if (session)
    caf::anon_send(session, actors::cancel_atom::value, ticket);
  if (stop)
    stop->cancel();
}

void client_state::on_closed() {
  running_requests().add(-static_cast<double>(asked.size()));
  for (auto& [id, one] : asked)
    one.span.fail("the connection ended");
  asked.clear();
  // What runs for this client alone is ended; what it has committed stays.
  for (const auto& [id, request] : requests) {
    request.cancel();
    tracing::unbind(request.ticket);
  }
  for (const auto& [key, document] : documents)
    caf::anon_send(document.session, actors::detach_atom::value, caf::actor_cast<caf::actor>(self));
  self->quit();
}

metrics::gauge& running_requests() {
  static auto& one =
    metrics::level_of("tedit_requests_running", "Requests that are not answered yet.");
  return one;
}

void client_state::end(std::uint64_t id) {
  if (const auto request = requests.extract(id))
    tracing::unbind(request.mapped().ticket);
  if (const auto found = asked.extract(id)) {
    running_requests().add(-1);
    found.mapped().counted->note(std::chrono::steady_clock::now() - found.mapped().since);
  }
}

void client_state::note_failure(std::uint64_t id, const std::string& code) {
  if (const auto found = asked.find(id); found != asked.end())
    found->second.span.fail(code);
}

void client_state::answer(std::uint64_t id, v1::ServerMessage message) {
  if (message.has_error()) {
    count_refusal(message.error().code());
    note_failure(id, message.error().code());
  }
  end(id);
  message.set_request_id(id);
  send(*to, message);
}

void client_state::refuse(std::uint64_t id, const error& e) {
  note_failure(id, std::string(code_name(e.code)));
  end(id);
  reject(id, e);
}

void client_state::refuse(std::uint64_t id, const caf::error& e, const char* what) {
  v1::ServerMessage message;
  to_message(actors::from_caf(e, what), message.mutable_error());
  if (const auto other = actors::rival_in(e))
    to_message(*other, message.mutable_error()->mutable_conflict());
  answer(id, std::move(message));
}

void client_state::reject(std::uint64_t id, const error& e) {
  v1::ServerMessage message;
  message.set_request_id(id);
  to_message(e, message.mutable_error());
  count_refusal(message.error().code());
  send(*to, message);
}

client_state::documents_by_name::iterator client_state::look_up(const std::string& document) {
  const auto found = documents.find(document);
  if (found != documents.end())
    return found;
  return std::ranges::find_if(documents, [&](const auto& one) {
    return std::ranges::find(one.second.former, document) != one.second.former.end();
  });
}

void client_state::leave(documents_by_name::iterator document, const error& why) {
  if (const auto& section = document->second.next_section)
    refuse(section->id, why);
  end_preview(why, document->second.session);
  documents.erase(document);
}

client_state::open_document* client_state::find(std::uint64_t id, const std::string& document) {
  const auto found = look_up(document);
  if (found != documents.end() && found->second.deleting) {
    refuse(id, {ec::conflict,
                "the document " + found->first + " is being deleted",
                "Wait for the answer to that",
                {}});
    return nullptr;
  }
  if (found != documents.end())
    return &found->second;
  refuse(id, {ec::not_found,
              "the document \"" + document + "\" is not open in this connection",
              "Send OpenDocument first",
              {}});
  return nullptr;
}

std::uint64_t client_state::begin(std::uint64_t id, const actors::session_actor& session) {
  static std::atomic<std::uint64_t> last{0};
  const auto ticket = ++last;
  requests[id] = {ticket, session};
  if (const auto found = asked.find(id); found != asked.end())
    tracing::bind(ticket, found->second.span.here());
  return ticket;
}

// -- answers, and what follows them --------------------------------------------------------------

/// An answer that repeats an earlier one moves nothing: others may have gone on since.
void client_state::answer_head(std::uint64_t id, const actors::head_moved& moved) {
  if (const auto found = asked.find(id); found != asked.end())
    found->second.span.note("tedit.version", to_hex(moved.head.id));
  v1::ServerMessage message;
  to_message(moved, message.mutable_committed());
  answer(id, std::move(message));
  if (!moved.repeated)
    follow(moved);
}

void client_state::follow(const actors::head_moved& moved) {
  const auto found = look_up(moved.document);
  if (found == documents.end())
    return;
  found->second.head = moved.version;
  found->second.last_solved.reset();  // Versions of one content may have other loads.
  want_surface(moved.document, moved.version);
}

void client_state::want_surface(const std::string& document, const version_ptr& mesh) {
  auto& open = look_up(document)->second;
  if (!open.watch_surface || !mesh)
    return;
  const bool queued = open.wanted_surface != nullptr;
  open.wanted_surface = mesh;
  if (!queued)
    bulk_out->add([this, document]() -> std::optional<bulk> {
      const auto found = look_up(document);
      if (found == documents.end())
        return std::nullopt;
      const auto newest = std::exchange(found->second.wanted_surface, nullptr);
      return newest ? found->second.surface.update_to(found->first, newest) : std::nullopt;
    });
  bulk_out->pump();
}

void client_state::send_again(const std::string& document, const actors::solved& event,
                              std::uint64_t held) {
  const auto found = look_up(document);
  if (found == documents.end())
    return;
  auto& open = found->second;
  open.last_solved = event;
  if (!open.watch_fields || (held != 0 && event.number == held))
    return;
  const bool queued = open.wanted_fields.has_value();
  open.wanted_fields = event;
  open.next_field = 0;
  if (!queued)
    queue_field(document);
  bulk_out->pump();
}

void client_state::queue_field(const std::string& document) {
  bulk_out->add([this, document]() -> std::optional<bulk> {
    const auto still = look_up(document);
    if (still == documents.end() || !still->second.wanted_fields)
      return std::nullopt;
    auto& open = still->second;
    auto update = parts.fields->get(*open.wanted_fields, open.next_field++, open.watched);
    if (update && update->header.field_update().remaining() > 0)
      queue_field(document);
    else
      open.wanted_fields.reset();
    return update;
  });
}

// -- events: what is told to all but who asked
// -----------------------------------------------------

namespace {

void on_head(client_state& client, const actors::head_moved& event) {
  if (!client.documents.contains(event.document))
    return;
  v1::ServerMessage message;
  to_message(event, message.mutable_committed());
  send(*client.to, message);
  client.follow(event);
}

void on_load_cases(client_state& client, const actors::load_cases_changed& event) {
  const auto found = client.documents.find(event.document);
  if (found == client.documents.end())
    return;
  found->second.last_solved.reset();  // A section must not show the field of other loads.
  v1::ServerMessage message;
  to_message(event, message.mutable_load_cases_changed());
  send(*client.to, message);
}

void on_solved(client_state& client, const actors::solved& event) {
  const auto found = client.documents.find(event.document);
  if (found == client.documents.end())
    return;
  v1::ServerMessage message;
  to_message(event, message.mutable_solved());
  send(*client.to, message);
  client.send_again(event.document, event);
}

void on_note(client_state& client, const actors::solve_note& event) {
  if (!client.documents.contains(event.document))
    return;
  v1::ServerMessage message;
  to_message(event, message.mutable_solve_status());
  send(*client.to, message);
}

void on_progress(client_state& client, const actors::request_progress& event) {
  const auto found = std::ranges::find_if(
    client.requests, [&](const auto& row) { return row.second.ticket == event.ticket; });
  if (found == client.requests.end() || event.ticket == 0)
    return;
  v1::ServerMessage message;
  message.set_request_id(found->first);
  message.mutable_progress()->set_fraction(event.fraction);
  message.mutable_progress()->set_stage(event.stage);
  send(*client.to, message);
}

}  // namespace

caf::behavior make_client(client_pointer self, std::shared_ptr<connection> to,
                          gateway_parts parts) {
  auto& state = self->state;
  state.start(self, std::move(to), std::move(parts));
  caf::message_handler own{
    [&state](const std::string& bytes) {
      state.on_message(bytes);
      state.to->handled(bytes.size());
    },
    [&state](drained_atom) {
      state.bulk_out->pump();
      state.start_exports();
    },
    [&state](closed_atom) { state.on_closed(); },
    [&state](refused_atom, std::uint64_t id) { state.refuse_token(id); },
    [&state](access_atom) { state.look_at_access(); },
    [&state](const actors::head_moved& event) { on_head(state, event); },
    [&state](const actors::solved& event) { on_solved(state, event); },
    [&state](const actors::load_cases_changed& event) { on_load_cases(state, event); },
    [&state](const actors::solve_note& event) { on_note(state, event); },
    [&state](const actors::request_progress& event) { on_progress(state, event); }};
  return own.or_else(note_events(state)).or_else(section_events(state));
}

}  // namespace tedit::gateway
