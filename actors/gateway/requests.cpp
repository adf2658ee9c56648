// SPDX-License-Identifier: AGPL-3.0-or-later
#include <set>

#include <spdlog/spdlog.h>

#include "actors/errors.hpp"
#include "actors/gateway/client_actor.hpp"
#include "actors/session/session.hpp"
#include "base/text.hpp"
#include "protocol/load_case_message.hpp"
#include "protocol/numbers.hpp"
#include "protocol/operation_message.hpp"
#include "protocol/selection_message.hpp"
#include "protocol/version.hpp"

namespace tedit::gateway {

namespace {

using namespace actors;

constexpr std::uint64_t max_client_message = std::uint64_t{16} << 20;

/// Bytes of a client's name that are kept.
constexpr std::size_t longest_client_name = 100;

std::string version_text(std::uint32_t major, std::uint32_t minor) {
  return std::to_string(major) + "." + std::to_string(minor);
}

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

}  // namespace

void client_state::hello(std::uint64_t id, const v1::Hello& body) {
  if (body.protocol_major() != protocol::major_version ||
      body.protocol_minor() != protocol::minor_version) {
    refuse(id, {ec::protocol_error,
                "the client speaks version " +
                  version_text(body.protocol_major(), body.protocol_minor()) +
                  " of the protocol, this server version " +
                  version_text(protocol::major_version, protocol::minor_version),
                "Use a client and a server of the same release",
                {}});
    return to->close(1008, "protocol version");
  }
  if (!parts.guard->admits(body.token()))
    return turn_away(id);
  known = true;
  to->authenticated();
  client_name = cut_text(body.client(), longest_client_name);
  spdlog::info("client {}: {}", to->peer(), client_name);
  v1::ServerMessage message;
  auto* welcome = message.mutable_welcome();
  welcome->set_protocol_major(protocol::major_version);
  welcome->set_protocol_minor(protocol::minor_version);
  welcome->set_server(parts.server_name);
  welcome->set_max_message_bytes(max_client_message);
  for (const auto& format : file_formats)
    to_message(format, welcome->add_formats());
  answer(id, std::move(message));
}

/// The answer waits, see `token_guard`.
void client_state::turn_away(std::uint64_t id) {
  turned_away = true;
  const auto peer = to->peer();
  const auto wait =
    parts.guard->turn_away(peer.substr(0, peer.rfind(':')), token_guard::clock::now());
  if (wait)
    self->delayed_send(self, *wait, refused_atom::value, id);
}

void client_state::refuse_token(std::uint64_t id) {
  refuse(id, {ec::invalid_argument,
              "the token is wrong",
              "Give the token that the server wrote when it started (tedit serve --help)",
              {}});
  to->close(1008, "wrong token");
}

template <class Body>
void client_state::move(std::uint64_t id, const Body& body, move_request request) {
  const auto* document = find(id, body.document());
  if (!document)
    return;
  begin(id, {});
  request.terms = terms_of(body);
  request.client = caf::actor_cast<caf::actor>(self);
  self->request(document->session, answer_limit, std::move(request))
    .then([=, this](const head_moved& moved) { answer_head(id, moved); },
          [=, this](const caf::error& e) { refuse(id, e, "moving the head"); });
}

void client_state::dispatch(std::uint64_t id, const v1::ClientMessage& message) {
  using body = v1::ClientMessage;
  if (auto ok = protocol::check_numbers(message, finite_number(), ec::invalid_argument); !ok)
    return refuse(id, ok.error());
  switch (message.body_case()) {
    case body::kListOperations:
      return list_operations(id);
    case body::kCancel:
      return cancel(id, message.cancel());
    case body::kGetStatus:
      return get_status(id);
    case body::kOpenDocument:
      return open(id, message.open_document());
    case body::kCloseDocument:
      return close(id, message.close_document());
    case body::kUploadChunk:
      return receive_upload(id, message.upload_chunk());
    case body::kAddDocument:
      return add_document(id, message.add_document());
    case body::kImportMesh:
      return import(id, message.import_mesh());
    case body::kSetLoadCase:
      return set_load_case(id, message.set_load_case());
    case body::kApplyEdit:
      return edit(id, message.apply_edit());
    case body::kPreviewEdit:
      return preview(id, message.preview_edit());
    case body::kUndo:
      return move(id, message.undo(), {move_kind::undo});
    case body::kRedo:
      return move(id, message.redo(), {move_kind::redo});
    case body::kGoToVersion:
      return move(id, message.go_to_version(),
                  {move_kind::go_to, message.go_to_version().number()});
    case body::kCutSection:
      return section(id, message.cut_section());
    case body::kCancelSolve:
      return cancel_solve(id, message.cancel_solve());
    case body::kRemoveLoadCase:
      return remove_load_case(id, message.remove_load_case());
    case body::kAnnotateVersion:
      return annotate(id, message.annotate_version());
    case body::kRenameDocument:
      return rename(id, message.rename_document());
    case body::kWatchFields:
      return watch(id, message.watch_fields());
    case body::kSolve:
      return solve(id, message.solve());
    case body::kExportFile:
      return export_file(id, message.export_file());
    case body::kSelectSurfaces:
      return select(id, message.select_surfaces());
    case body::kGetHistory:
      return history(id, message.get_history());
    case body::kGetSurface:
      return surface_of(id, message.get_surface());
    case body::kHello:
      return refuse(id, {ec::protocol_error, "Hello was said already", {}, {}});
    case body::BODY_NOT_SET:
      return refuse(id, {ec::protocol_error,
                         "this server does not know this request",
                         "Use a client of the server's release",
                         {}});
  }
}

void client_state::list_operations(std::uint64_t id) {
  begin(id, {});
  self->request(parts.hub, short_limit, catalog_atom::value)
    .then(
      [=, this](const shared_catalogue& said) {
        const auto all = said.get();
        if (!all)
          return refuse(id, all.error());
        v1::ServerMessage message;
        protocol::to_message(**all, message.mutable_catalogue());
        answer(id, std::move(message));
      },
      [=, this](const caf::error& e) { refuse(id, e, "listing the operations"); });
}

void client_state::get_status(std::uint64_t id) {
  begin(id, {});
  self->request(parts.hub, short_limit, status_atom::value)
    .then(
      [=, this](const server_status& status) {
        v1::ServerMessage message;
        to_message(status, message.mutable_server_status());
        message.mutable_server_status()->set_connections(
          static_cast<std::uint32_t>(parts.connections()));
        message.mutable_server_status()->set_wrong_tokens(parts.guard->turned_away());
        answer(id, std::move(message));
      },
      [=, this](const caf::error& e) { refuse(id, e, "asking for the status"); });
}

void client_state::cancel(std::uint64_t id, const v1::Cancel& body) {
  const auto found = requests.find(body.request_id());
  if (!drop_export(body.request_id()) && found != requests.end() && found->second.session)
    caf::anon_send(found->second.session, cancel_atom::value, found->second.ticket);
  v1::ServerMessage message;
  message.mutable_done();
  answer(id, std::move(message));
}

// -- documents -----------------------------------------------------------------------------------

void client_state::open(std::uint64_t id, const v1::OpenDocument& body) {
  begin(id, {});
  const bool surface = body.watch_surface();
  const bool fields = body.watch_fields();
  const auto failed = [=, this](const caf::error& e) { refuse(id, e, "opening the document"); };
  const auto attached = [=, this](const session_snapshot& snapshot, const session_actor& session) {
    auto& document = documents[snapshot.document];
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
    answer(id, std::move(message));
    want_surface(snapshot.document, snapshot.version);
  };
  self->request(parts.hub, std::chrono::minutes(10), body.name())
    .then(
      [=, this](const opened_document& opened) {
        const auto session = caf::actor_cast<session_actor>(opened.session);
        self->request(session, short_limit, attach_request{caf::actor_cast<caf::actor>(self)})
          .then([=](const session_snapshot& snapshot) { attached(snapshot, session); }, failed);
      },
      failed);
}

void client_state::close(std::uint64_t id, const v1::CloseDocument& body) {
  const auto* document = find(id, body.document());
  if (!document)
    return;
  if (const auto& waiting = document->next_section)
    refuse(waiting->id, {ec::cancelled, "the document was closed", {}, {}});
  end_preview({ec::cancelled, "the document was closed", {}, {}});
  caf::anon_send(document->session, detach_atom::value, caf::actor_cast<caf::actor>(self));
  documents.erase(look_up(body.document()));
  v1::ServerMessage message;
  message.mutable_done();
  answer(id, std::move(message));
}

void client_state::solve(std::uint64_t id, const v1::Solve& body) {
  const auto* document = find(id, body.document());
  if (!document)
    return;
  auto request = read_solve(body);
  if (!request)
    return refuse(id, request.error());
  request->ticket = begin(id, document->session);
  request->client = caf::actor_cast<caf::actor>(self);
  self->request(document->session, answer_limit, std::move(*request))
    .then(
      [=, this](const solved& done) {
        v1::ServerMessage message;
        to_message(done, message.mutable_solved());
        answer(id, std::move(message));
        send_again(done.document, done);
      },
      [=, this](const caf::error& e) { refuse(id, e, "the solve"); });
}

void client_state::select(std::uint64_t id, const v1::SelectSurfaces& body) {
  const auto* document = find(id, body.document());
  if (!document)
    return;
  const auto query = protocol::from_message(body);
  if (!query)
    return refuse(id, query.error());
  select_request request;
  request.ticket = begin(id, document->session);
  request.client = caf::actor_cast<caf::actor>(self);
  request.query = *query;
  self->request(document->session, answer_limit, std::move(request))
    .then(
      [=, this](const selected& found) {
        v1::ServerMessage message;
        auto* out = message.mutable_surfaces_selected();
        protocol::to_message(*found.features, out);
        out->set_document(found.document);
        out->set_version_id(found.version);
        answer(id, std::move(message));
      },
      [=, this](const caf::error& e) { refuse(id, e, "the selection"); });
}

void client_state::history(std::uint64_t id, const v1::GetHistory& body) {
  const auto* document = find(id, body.document());
  if (!document)
    return;
  begin(id, {});
  self->request(document->session, short_limit, history_request{body.reports()})
    .then(
      [=, this](const session_history& all) {
        v1::ServerMessage message;
        auto* out = message.mutable_history();
        out->set_document(all.document);
        out->set_head(all.head);
        for (const auto& info : all.versions)
          to_message(info, out->add_versions());
        for (std::size_t i = 0; i < all.reports.size(); ++i)
          add_report(all.reports[i], out->mutable_versions(static_cast<int>(i)));
        answer(id, std::move(message));
      },
      [=, this](const caf::error& e) { refuse(id, e, "asking for the history"); });
}

/// Whole surfaces wait for their turn among what is written, as differences do.
void client_state::surface_of(std::uint64_t id, const v1::GetSurface& body) {
  const auto* document = find(id, body.document());
  if (!document)
    return;
  begin(id, {});
  self->request(document->session, short_limit, version_request{body.number()})
    .then(
      [=, this](const session_version& version) {
        bulk_out->add([=, this]() -> std::optional<bulk> {
          if (!requests.contains(id))
            return std::nullopt;
          end(id);
          auto result = surface_stream::of_version(version);
          result.header.set_request_id(id);
          return result;
        });
        bulk_out->pump();
      },
      [=, this](const caf::error& e) { refuse(id, e, "asking for a surface"); });
}

}  // namespace tedit::gateway
