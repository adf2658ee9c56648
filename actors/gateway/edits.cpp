// SPDX-License-Identifier: AGPL-3.0-or-later
// Edits, and what an edit would make.
#include <algorithm>

#include "actors/errors.hpp"
#include "actors/gateway/client_actor.hpp"
#include "actors/session/session.hpp"
#include "protocol/operation_message.hpp"

namespace tedit::gateway {

namespace {

using namespace actors;

constexpr int most_surfaces = 100'000;

/// Without ticket and client. Errors: `invalid_argument` for what becomes of loads and for too many
/// surfaces.
expected<apply_request> read_edit(const v1::ApplyEdit& body, change_terms terms) {
  if (body.surfaces_size() > most_surfaces)
    return fail(ec::invalid_argument,
                "an edit takes at most " + std::to_string(most_surfaces) + " surfaces, not " +
                  std::to_string(body.surfaces_size()),
                "Select fewer");
  auto wanted = protocol::from_message(body);
  if (!wanted)
    return fail(wanted.error());
  terms.carry_over = body.carry_over();
  return apply_request{0, {}, std::move(*wanted), std::move(terms)};
}

void edit(client_state& client, std::uint64_t id, const v1::ApplyEdit& body) {
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  auto request = read_edit(body, client.terms_of(body));
  if (!request)
    return client.refuse(id, request.error());
  request->ticket = client.begin(id, document->session);
  request->client = caf::actor_cast<caf::actor>(client.self);
  client.self->request(document->session, answer_limit, std::move(*request))
    .then([=, &client](const head_moved& moved) { client.answer_head(id, moved); },
          [=, &client](const caf::error& e) { client.refuse(id, e, "the edit"); });
}

/// Undo, redo or going to a version.
template <class Body>
void move_head(client_state& client, std::uint64_t id, const Body& body, move_request request) {
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  request.ticket = client.begin(id, {});
  request.terms = client.terms_of(body);
  request.client = caf::actor_cast<caf::actor>(client.self);
  client.self->request(document->session, answer_limit, std::move(request))
    .then([=, &client](const head_moved& moved) { client.answer_head(id, moved); },
          [=, &client](const caf::error& e) { client.refuse(id, e, "moving the head"); });
}

void undo(client_state& client, std::uint64_t id, const v1::Undo& body) {
  move_head(client, id, body, {move_kind::undo});
}

void redo(client_state& client, std::uint64_t id, const v1::Redo& body) {
  move_head(client, id, body, {move_kind::redo});
}

void go_to(client_state& client, std::uint64_t id, const v1::GoToVersion& body) {
  move_head(client, id, body, {move_kind::go_to, body.number()});
}

// -- previews ------------------------------------------------------------------------------------

/// The difference builds on the head's surface, which is on its way before it. When the head moves
/// before its turn comes, the client will hold another surface by then.
void send_preview(client_state& client, std::uint64_t id, const previewed& made) {
  const auto ticket = client.requests.at(id).ticket;
  client.bulk_out->add([=, &client]() -> std::optional<bulk> {
    const auto found = client.requests.find(id);
    if (found == client.requests.end() || found->second.ticket != ticket)
      return std::nullopt;
    const auto open = client.look_up(made.document);
    if (open == client.documents.end() || !open->second.head ||
        open->second.head->id() != made.base->id()) {
      client.refuse(id, {ec::superseded, "the document was changed meanwhile", {}, {}});
      return std::nullopt;
    }
    client.end(id);
    auto result = open->second.surface.preview(made);
    result.header.set_request_id(id);
    return result;
  });
  client.bulk_out->pump();
}

/// While a value is dragged many are asked for: the newest ends the one before, which is answered
/// at once. What the session still says about that is for nobody.
void preview(client_state& client, std::uint64_t id, const v1::PreviewEdit& body) {
  const auto* document = client.find(id, body.edit().document());
  if (!document)
    return;
  auto request = read_edit(body.edit(), client.terms_of(body.edit()));
  if (!request)
    return client.refuse(id, request.error());
  client.end_preview({ec::superseded, "another preview was asked for meanwhile", {}, {}});
  const auto ticket = client.begin(id, document->session);
  client.previewing = ticket;
  request->ticket = ticket;
  request->client = caf::actor_cast<caf::actor>(client.self);
  const auto waits = [=, &client] {
    const auto found = client.requests.find(id);
    return found != client.requests.end() && found->second.ticket == ticket;
  };
  client.self
    ->request(document->session, answer_limit,
              preview_request{std::move(*request), body.find_most(), body.draft()})
    .then(
      [=, &client](const previewed& made) {
        if (waits())
          send_preview(client, id, made);
      },
      [=, &client](const caf::error& e) {
        if (waits())
          client.refuse(id, e, "the preview");
      });
}

}  // namespace

/// By its ticket: the number of an answered request may be another's by now.
void client_state::end_preview(const error& why, const session_actor& of) {
  const auto found = std::ranges::find_if(
    requests, [&](const auto& row) { return row.second.ticket == previewing; });
  if (found == requests.end() || (of && found->second.session != of))
    return;
  caf::anon_send(found->second.session, cancel_atom::value, found->second.ticket);
  refuse(found->first, why);
}

request_rows edit_requests() {
  using message = v1::ClientMessage;
  return {row_of<&message::apply_edit, edit>(message::kApplyEdit),
          row_of<&message::preview_edit, preview>(message::kPreviewEdit),
          row_of<&message::undo, undo>(message::kUndo),
          row_of<&message::redo, redo>(message::kRedo),
          row_of<&message::go_to_version, go_to>(message::kGoToVersion)};
}

}  // namespace tedit::gateway
