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

}  // namespace

template <class Actor, class Request>
void client_state::carry_out(std::uint64_t id, const Actor& whom, Request request,
                             const char* what) {
  begin(id, {});
  self->request(whom, answer_limit, std::move(request))
    .then(
      [=, this](acknowledged) {
        v1::ServerMessage message;
        message.mutable_done();
        answer(id, std::move(message));
      },
      [=, this](const caf::error& e) { refuse(id, e, what); });
}

void client_state::set_load_case(std::uint64_t id, const v1::SetLoadCase& body) {
  const auto* document = find(id, body.document());
  if (!document)
    return;
  auto given = protocol::from_message(body.load_case());
  if (!given) {
    given.error().where = "load case";
    return refuse(id, given.error());
  }
  carry_out(id, document->session, load_case_request{std::move(*given), terms_of(body)},
            "setting the load case");
}

void client_state::remove_load_case(std::uint64_t id, const v1::RemoveLoadCase& body) {
  if (const auto* document = find(id, body.document()))
    carry_out(id, document->session, remove_case_request{body.load_case(), terms_of(body)},
              "removing the load case");
}

void client_state::cancel_solve(std::uint64_t id, const v1::CancelSolve& body) {
  if (const auto* document = find(id, body.document()))
    carry_out(id, document->session, end_solve_atom::value, "ending the solve");
}

void client_state::annotate(std::uint64_t id, const v1::AnnotateVersion& body) {
  if (const auto* document = find(id, body.document()))
    carry_out(
      id, document->session,
      annotate_request{body.number(), body.name(), body.note(), {client_name, body.edit_id(), {}}},
      "naming the version");
}

void client_state::rename(std::uint64_t id, const v1::RenameDocument& body) {
  if (const auto* document = find(id, body.document()))
    carry_out(id, parts.hub,
              rename_request{caf::actor_cast<caf::actor>(document->session), body.name()},
              "renaming the document");
}

// -- what is watched -----------------------------------------------------------------------------

void client_state::watch(std::uint64_t id, const v1::WatchFields& body) {
  auto* document = find(id, body.document());
  if (!document)
    return;
  const auto wanted = read_quantities(body);
  if (!wanted)
    return refuse(id, wanted.error());
  document->watched = *wanted;
  begin(id, {});
  self->request(document->session, short_limit, held_atom::value)
    .then(
      [=, this, of = body.document()](const held_result& held) {
        v1::ServerMessage message;
        if (!held.result && !held.solving)
          message.mutable_done()->set_note(
            "the server holds no field of the head; solve it to get one");
        else
          message.mutable_done();
        answer(id, std::move(message));
        if (held.result)
          send_again(of, *held.result);
      },
      [=, this](const caf::error& e) { refuse(id, e, "watching fields"); });
}

/// Queues the fields of a solve for those who watch them; also when they were sent before.
void client_state::send_again(const std::string& document, const solved& event) {
  const auto found = look_up(document);
  if (found == documents.end())
    return;
  auto& open = found->second;
  open.last_solved = event;
  if (!open.watch_fields)
    return;
  const bool queued = open.wanted_fields.has_value();
  open.wanted_fields = event;
  open.next_field = 0;
  if (!queued)
    queue_field(document);
  bulk_out->pump();
}

void client_state::on_annotated(const version_annotated& event) {
  if (!documents.contains(event.document))
    return;
  v1::ServerMessage message;
  auto* out = message.mutable_version_annotated();
  out->set_document(event.document);
  to_message(event.info, out->mutable_version());
  send(*to, message);
}

/// Whatever is sent after this has the new name.
void client_state::on_renamed(const document_renamed& event) {
  const auto found = documents.find(event.before);
  if (found == documents.end())
    return;
  auto node = documents.extract(found);
  node.key() = event.document;
  auto& open = node.mapped();
  open.former.push_front(event.before);
  if (open.former.size() > most_former)
    open.former.pop_back();
  if (open.wanted_fields)
    open.wanted_fields->document = event.document;
  documents.insert(std::move(node));
  v1::ServerMessage message;
  message.mutable_document_renamed()->set_document(event.document);
  message.mutable_document_renamed()->set_before(event.before);
  send(*to, message);
}

}  // namespace tedit::gateway
