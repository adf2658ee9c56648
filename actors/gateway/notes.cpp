// SPDX-License-Identifier: AGPL-3.0-or-later
// Requests that make no new version: load cases, names and notes, and what is watched.
#include "actors/errors.hpp"
#include "actors/gateway/client_actor.hpp"
#include "actors/session/session.hpp"
#include "base/text.hpp"
#include "protocol/load_case_message.hpp"

namespace tedit::gateway {

namespace {

using namespace actors;

/// Former names of a document that a request may have: those that its client has not heard of yet.
constexpr std::size_t most_former = 16;

/// Of a quantity's name, where it is told that there is none; bytes.
constexpr std::size_t longest_shown = 40;

/// Errors: `invalid_argument` for a quantity that this server does not know.
expected<watched_quantities> read_quantities(const v1::WatchFields& body) {
  for (const auto& one : body.quantities()) {
    const auto* array = fem::find_array(one);
    if (!array || array->sent == fem::array_sent::in_files)
      return fail(
        ec::invalid_argument,
        "there is no quantity \"" + std::string(cut_text(one, longest_shown)) + "\" to watch",
        "Ask for some of " + fem::arrays_on_request());
  }
  return watched_quantities(body.quantities().begin(), body.quantities().end());
}

template <class Actor, class Request>
void carry_out(client_state& client, std::uint64_t id, const Actor& whom, Request request,
               const char* what) {
  const auto ticket = client.begin(id, {});
  if constexpr (requires { request.ticket; }) {
    request.ticket = ticket;
    request.client = caf::actor_cast<caf::actor>(client.self);
  }
  client.self->request(whom, answer_limit, std::move(request))
    .then(
      [=, &client](acknowledged) {
        v1::ServerMessage message;
        message.mutable_done();
        client.answer(id, std::move(message));
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, what); });
}

void set_load_case(client_state& client, std::uint64_t id, const v1::SetLoadCase& body) {
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  auto given = protocol::from_message(body.load_case());
  if (!given) {
    given.error().where = "load case";
    return client.refuse(id, given.error());
  }
  carry_out(client, id, document->session,
            note_request{actors::set_load_case{std::move(*given)}, client.terms_of(body)},
            "setting the load case");
}

void remove_load_case(client_state& client, std::uint64_t id, const v1::RemoveLoadCase& body) {
  if (const auto* document = client.find(id, body.document()))
    carry_out(client, id, document->session,
              note_request{actors::remove_load_case{body.load_case()}, client.terms_of(body)},
              "removing the load case");
}

void cancel_solve(client_state& client, std::uint64_t id, const v1::CancelSolve& body) {
  if (const auto* document = client.find(id, body.document()))
    carry_out(client, id, document->session, end_solve_atom::value, "ending the solve");
}

void annotate(client_state& client, std::uint64_t id, const v1::AnnotateVersion& body) {
  if (const auto* document = client.find(id, body.document()))
    carry_out(client, id, document->session,
              note_request{annotate_version{body.number(), body.name(), body.note()},
                           {client.client_name, body.edit_id(), {}}},
              "naming the version");
}

constexpr const char* renaming = "renaming the document";

/// One that is not open here is opened for it, without being attached to: what lies beside its file
/// goes into that, and another program that has it keeps it.
void rename_unopened(client_state& client, std::uint64_t id, const v1::RenameDocument& body) {
  client.begin(id, {});
  client.self->request(client.parts.hub, answer_limit, existing_atom::value, body.document())
    .then(
      [=, &client, name = body.name()](const opened_document& found) {
        carry_out(client, id, client.parts.hub, rename_request{found.session, name, true},
                  renaming);
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, renaming); });
}

void rename(client_state& client, std::uint64_t id, const v1::RenameDocument& body) {
  if (client.look_up(body.document()) == client.documents.end())
    return rename_unopened(client, id, body);
  if (const auto* document = client.find(id, body.document()))
    carry_out(client, id, client.parts.hub,
              rename_request{caf::actor_cast<caf::actor>(document->session), body.name()},
              renaming);
}

// -- what is watched -----------------------------------------------------------------------------

void watch(client_state& client, std::uint64_t id, const v1::WatchFields& body) {
  auto* document = client.find(id, body.document());
  if (!document)
    return;
  const auto wanted = read_quantities(body);
  if (!wanted)
    return client.refuse(id, wanted.error());
  document->watched = *wanted;
  client.begin(id, {});
  const watch_request request{caf::actor_cast<caf::actor>(client.self), *wanted};
  client.self->request(document->session, answer_limit, request)
    .then(
      [=, &client, of = body.document(), has = body.held_solve()](const held_result& held) {
        v1::ServerMessage message;
        if (!held.result && !held.solving)
          message.mutable_done()->set_note(
            "the server holds no field of the head; solve it to get one");
        else
          message.mutable_done();
        client.answer(id, std::move(message));
        if (held.result)
          client.send_again(of, *held.result, has);
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, "watching fields"); });
}

void on_annotated(client_state& client, const version_annotated& event) {
  if (!client.documents.contains(event.document))
    return;
  v1::ServerMessage message;
  auto* out = message.mutable_version_annotated();
  out->set_document(event.document);
  to_message(event.info, out->mutable_version());
  send(*client.to, message);
}

void on_cad_known(client_state& client, const cad_known& event) {
  if (!client.documents.contains(event.document))
    return;
  v1::ServerMessage message;
  auto* out = message.mutable_cad_state_changed();
  out->set_document(event.document);
  to_message(event.info, out->mutable_version());
  send(*client.to, message);
}

void on_participant(client_state& client, const participant_changed& event) {
  if (!client.documents.contains(event.document))
    return;
  v1::ServerMessage message;
  auto* out = message.mutable_participant_changed();
  out->set_document(event.document);
  to_message(event.who, out->mutable_participant());
  out->set_gone(event.gone);
  send(*client.to, message);
}

/// Whatever is sent after this has the new name.
void on_renamed(client_state& client, const document_renamed& event) {
  const auto found = client.documents.find(event.before);
  if (found == client.documents.end())
    return;
  auto node = client.documents.extract(found);
  node.key() = event.document;
  auto& open = node.mapped();
  open.former.push_front(event.before);
  if (open.former.size() > most_former)
    open.former.pop_back();
  if (open.wanted_fields)
    open.wanted_fields->document = event.document;
  client.documents.insert(std::move(node));
  v1::ServerMessage message;
  message.mutable_document_renamed()->set_document(event.document);
  message.mutable_document_renamed()->set_before(event.before);
  send(*client.to, message);
}

}  // namespace

request_rows note_requests() {
  using message = v1::ClientMessage;
  return {row_of<&message::set_load_case, set_load_case>(message::kSetLoadCase),
          row_of<&message::remove_load_case, remove_load_case>(message::kRemoveLoadCase),
          row_of<&message::cancel_solve, cancel_solve>(message::kCancelSolve),
          row_of<&message::annotate_version, annotate>(message::kAnnotateVersion),
          row_of<&message::rename_document, rename>(message::kRenameDocument),
          row_of<&message::watch_fields, watch>(message::kWatchFields)};
}

caf::message_handler note_events(client_state& client) {
  return {[&client](const version_annotated& event) { on_annotated(client, event); },
          [&client](const cad_known& event) { on_cad_known(client, event); },
          [&client](const participant_changed& event) { on_participant(client, event); },
          [&client](const document_renamed& event) { on_renamed(client, event); }};
}

}  // namespace tedit::gateway
