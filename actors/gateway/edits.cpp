// SPDX-License-Identifier: AGPL-3.0-or-later
// Edits, and what an edit would make.
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
  return apply_request{0, {}, std::move(*wanted), std::move(terms)};
}

}  // namespace

void client_state::edit(std::uint64_t id, const v1::ApplyEdit& body) {
  const auto* document = find(id, body.document());
  if (!document)
    return;
  auto request = read_edit(body, terms_of(body));
  if (!request)
    return refuse(id, request.error());
  request->ticket = begin(id, document->session);
  request->client = caf::actor_cast<caf::actor>(self);
  self->request(document->session, answer_limit, std::move(*request))
    .then([=, this](const head_moved& moved) { answer_head(id, moved); },
          [=, this](const caf::error& e) { refuse(id, e, "the edit"); });
}

// -- previews ------------------------------------------------------------------------------------

void client_state::end_preview(const error& why) {
  const auto found = requests.find(previewing);
  if (found == requests.end())
    return;
  caf::anon_send(found->second.session, cancel_atom::value, found->second.ticket);
  refuse(previewing, why);
}

/// While a value is dragged many are asked for: the newest ends the one before, which is answered
/// at once. What the session still says about that is for nobody.
void client_state::preview(std::uint64_t id, const v1::PreviewEdit& body) {
  const auto* document = find(id, body.edit().document());
  if (!document)
    return;
  auto request = read_edit(body.edit(), terms_of(body.edit()));
  if (!request)
    return refuse(id, request.error());
  end_preview({ec::superseded, "another preview was asked for meanwhile", {}, {}});
  const auto ticket = begin(id, document->session);
  previewing = id;
  request->ticket = ticket;
  request->client = caf::actor_cast<caf::actor>(self);
  const auto waits = [=, this] {
    const auto found = requests.find(id);
    return found != requests.end() && found->second.ticket == ticket;
  };
  self
    ->request(document->session, answer_limit,
              preview_request{std::move(*request), body.find_most()})
    .then(
      [=, this](const previewed& made) {
        if (waits())
          send_preview(id, made);
      },
      [=, this](const caf::error& e) {
        if (waits())
          refuse(id, e, "the preview");
      });
}

/// The difference builds on the head's surface, which is on its way before it. When the head moves
/// before its turn comes, the client will hold another surface by then.
void client_state::send_preview(std::uint64_t id, const previewed& made) {
  const auto ticket = requests.at(id).ticket;
  bulk_out->add([=, this]() -> std::optional<bulk> {
    const auto found = requests.find(id);
    if (found == requests.end() || found->second.ticket != ticket)
      return std::nullopt;
    const auto open = look_up(made.document);
    if (open == documents.end() || !open->second.head ||
        open->second.head->id() != made.base->id()) {
      refuse(id, {ec::superseded, "the document was changed meanwhile", {}, {}});
      return std::nullopt;
    }
    end(id);
    auto result = open->second.surface.preview(made);
    result.header.set_request_id(id);
    return result;
  });
  bulk_out->pump();
}

}  // namespace tedit::gateway
