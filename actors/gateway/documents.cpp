// SPDX-License-Identifier: AGPL-3.0-or-later
// Requests about one document that change nothing in it.
#include <set>

#include "actors/errors.hpp"
#include "actors/gateway/client_actor.hpp"
#include "actors/session/session.hpp"
#include "protocol/load_case_message.hpp"
#include "protocol/selection_message.hpp"

namespace tedit::gateway {

namespace {

using namespace actors;

/// Errors: `invalid_argument` when more than one field says which load cases, or one is named
/// twice.
expected<std::vector<std::string>> named_cases(const v1::Solve& body) {
  const int ways = (body.load_case().empty() ? 0 : 1) + (body.load_cases().empty() ? 0 : 1) +
                   (body.all_load_cases() ? 1 : 0);
  if (ways > 1)
    return fail(ec::invalid_argument,
                "only one of load_case, load_cases and all_load_cases may be given");
  std::vector<std::string> names(body.load_cases().begin(), body.load_cases().end());
  if (!body.load_case().empty())
    names.push_back(body.load_case());
  std::set<std::string> seen;
  for (const auto& name : names)
    if (!seen.insert(name).second)
      return fail(ec::invalid_argument, "the load case \"" + name + "\" is named twice",
                  "Name each load case once");
  return names;
}

/// Errors: `invalid_argument`.
expected<solve_request> read_solve(const v1::Solve& body) {
  solve_request request;
  auto names = named_cases(body);
  if (!names)
    return fail(names.error());
  request.load_cases = std::move(*names);
  request.all_load_cases = body.all_load_cases();
  if (body.tolerance() != 0)
    request.tolerance = body.tolerance();
  if (!(request.tolerance >= 1e-12 && request.tolerance <= 0.1))
    return fail(ec::invalid_argument, "the tolerance must lie between 1e-12 and 0.1");
  request.energy_tolerance = body.energy_tolerance();
  if (request.energy_tolerance != 0 &&
      !(request.energy_tolerance >= 1e-9 && request.energy_tolerance <= 0.5))
    return fail(ec::invalid_argument, "the energy tolerance must lie between 1e-9 and 0.5");
  if (body.element_order() > 2)
    return fail(ec::invalid_argument,
                "the element order must be 1 or 2, not " + std::to_string(body.element_order()));
  request.device = body.device();
  request.element_order = body.element_order() == 0 ? 2 : static_cast<int>(body.element_order());
  return request;
}

/// A large document is read as long as it takes.
constexpr std::chrono::minutes opening_limit{10};

/// What the client holds from an earlier connection is sent no second time: once that version is at
/// hand, the difference to it follows. Where it is not, or a new head was quicker, the whole does.
void resume_surface(client_state& client, const std::string& name, const std::string& held) {
  const auto& document = client.documents.at(name);
  const auto go_on = [=, &client, session = document.session](const version_ptr& mesh) {
    const auto found = client.look_up(name);
    if (found == client.documents.end() || found->second.session != session)
      return;
    if (mesh && found->second.surface.is_empty())
      found->second.surface.resume(mesh);
    client.want_surface(found->first, found->second.head);
  };
  if (document.head && held == to_hex(document.head->id()))
    return go_on(document.head);
  client.self->request(document.session, short_limit, version_request{0, held})
    .then([=](const session_version& version) { go_on(version.mesh); },
          [=](const caf::error&) { go_on(nullptr); });
}

/// A session that nobody has open may end while its name is on the way here: then the document is
/// asked for again.
void open_document(client_state& client, std::uint64_t id, const v1::OpenDocument& body,
                   int retries) {
  const bool surface = body.watch_surface();
  const bool fields = body.watch_fields();
  const auto held = surface ? body.held_version_id() : std::string();
  const auto failed = [=, &client](const caf::error& e) {
    client.refuse(id, e, "opening the document");
  };
  const auto gone = [=, &client](const caf::error& e) {
    if (retries >= most_retries || !worth_a_retry(from_caf(e, "")))
      return failed(e);
    open_document(client, id, body, retries + 1);
  };
  const auto attached = [=, &client](const session_snapshot& snapshot,
                                     const session_actor& session) {
    auto& document = client.documents[snapshot.document];
    document.session = session;
    document.watch_surface = surface;
    document.watch_fields = fields;
    document.watched = {};
    document.surface = {};
    document.head = snapshot.version;
    document.last_solved.reset();
    v1::ServerMessage message;
    auto* state = message.mutable_document_state();
    state->set_document(snapshot.document);
    if (snapshot.head) {
      to_message(*snapshot.head, state->mutable_head());
      add_report(snapshot.report, state->mutable_head());
    }
    state->set_can_undo(snapshot.can_undo);
    state->set_can_redo(snapshot.can_redo);
    protocol::to_messages(*snapshot.load_cases, state->mutable_load_cases());
    for (const auto& who : snapshot.participants)
      to_message(who, state->add_participants());
    state->set_participant(snapshot.own_participant);
    client.answer(id, std::move(message));
    if (held.empty() || !snapshot.version)
      client.want_surface(snapshot.document, snapshot.version);
    else
      resume_surface(client, snapshot.document, held);
  };
  const auto found = [=, &client](const opened_document& opened) {
    const auto session = caf::actor_cast<session_actor>(opened.session);
    client.self
      ->request(session, short_limit,
                attach_request{caf::actor_cast<caf::actor>(client.self), false, client.client_name})
      .then([=](const session_snapshot& snapshot) { attached(snapshot, session); }, gone);
  };
  // Who may only look begins no document.
  if (client.access.role == access_role::view)
    client.self->request(client.parts.hub, opening_limit, existing_atom::value, body.name())
      .then(found, failed);
  else
    client.self->request(client.parts.hub, opening_limit, body.name()).then(found, failed);
}

void open(client_state& client, std::uint64_t id, const v1::OpenDocument& body) {
  client.begin(id, {});
  open_document(client, id, body, 0);
}

void close(client_state& client, std::uint64_t id, const v1::CloseDocument& body) {
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  caf::anon_send(document->session, detach_atom::value, caf::actor_cast<caf::actor>(client.self));
  client.leave(client.look_up(body.document()), {ec::cancelled, "the document was closed", {}, {}});
  v1::ServerMessage message;
  message.mutable_done();
  client.answer(id, std::move(message));
}

void solve(client_state& client, std::uint64_t id, const v1::Solve& body) {
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  auto request = read_solve(body);
  if (!request)
    return client.refuse(id, request.error());
  request->ticket = client.begin(id, document->session);
  request->client = caf::actor_cast<caf::actor>(client.self);
  client.self->request(document->session, answer_limit, std::move(*request))
    .then(
      [=, &client, has = body.held_solve()](const solved& done) {
        v1::ServerMessage message;
        to_message(done, message.mutable_solved());
        client.answer(id, std::move(message));
        client.send_again(done.document, done, has);
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, "the solve"); });
}

void select(client_state& client, std::uint64_t id, const v1::SelectSurfaces& body) {
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  const auto query = protocol::from_message(body);
  if (!query)
    return client.refuse(id, query.error());
  select_request request;
  request.ticket = client.begin(id, document->session);
  request.client = caf::actor_cast<caf::actor>(client.self);
  request.query = *query;
  client.self->request(document->session, answer_limit, std::move(request))
    .then(
      [=, &client](const selected& found) {
        v1::ServerMessage message;
        auto* out = message.mutable_surfaces_selected();
        protocol::to_message(*found.features, out);
        out->set_document(found.document);
        out->set_version_id(found.version);
        client.answer(id, std::move(message));
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, "the selection"); });
}

void history(client_state& client, std::uint64_t id, const v1::GetHistory& body) {
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  client.begin(id, {});
  client.self->request(document->session, short_limit, history_request{body.reports()})
    .then(
      [=, &client](const session_history& all) {
        v1::ServerMessage message;
        auto* out = message.mutable_history();
        out->set_document(all.document);
        out->set_head(all.head);
        for (const auto& info : all.versions)
          to_message(info, out->add_versions());
        for (std::size_t i = 0; i < all.reports.size(); ++i)
          add_report(all.reports[i], out->mutable_versions(static_cast<int>(i)));
        client.answer(id, std::move(message));
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, "asking for the history"); });
}

/// Whole surfaces wait for their turn among what is written, as differences do.
void surface_of(client_state& client, std::uint64_t id, const v1::GetSurface& body) {
  const auto* document = client.find(id, body.document());
  if (!document)
    return;
  client.begin(id, {});
  client.self->request(document->session, short_limit, version_request{body.number()})
    .then(
      [=, &client](const session_version& version) {
        client.bulk_out->add([=, &client]() -> std::optional<bulk> {
          if (!client.requests.contains(id))
            return std::nullopt;
          client.end(id);
          auto result = surface_stream::of_version(version);
          result.header.set_request_id(id);
          return result;
        });
        client.bulk_out->pump();
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, "asking for a surface"); });
}

}  // namespace

request_rows document_requests() {
  using message = v1::ClientMessage;
  return {row_of<&message::open_document, open>(message::kOpenDocument),
          row_of<&message::close_document, close>(message::kCloseDocument),
          row_of<&message::solve, solve>(message::kSolve),
          row_of<&message::select_surfaces, select>(message::kSelectSurfaces),
          row_of<&message::get_history, history>(message::kGetHistory),
          row_of<&message::get_surface, surface_of>(message::kGetSurface)};
}

}  // namespace tedit::gateway
