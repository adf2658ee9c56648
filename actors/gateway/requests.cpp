// SPDX-License-Identifier: AGPL-3.0-or-later
#include <map>

#include "actors/errors.hpp"
#include "actors/gateway/client_actor.hpp"
#include "actors/session/session.hpp"
#include "base/logging/logging.hpp"
#include "base/metrics.hpp"
#include "base/text.hpp"
#include "protocol/numbers.hpp"
#include "protocol/operation_message.hpp"
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

using handler_map = std::map<v1::ClientMessage::BodyCase, decltype(request_row::handle)>;

const handler_map& handlers() {
  static const auto all = [] {
    handler_map result;
    for (const auto& rows :
         {server_requests(), compare_requests(), document_requests(), edit_requests(),
          export_requests(), library_requests(), note_requests(), print_requests(),
          section_requests(), upload_requests()})
      for (const auto& row : rows)
        result.emplace(row.kind, row.handle);
    return result;
  }();
  return all;
}

void list_operations(client_state& client, std::uint64_t id, const v1::ListOperations&) {
  client.begin(id, {});
  client.self->request(client.parts.hub, short_limit, catalog_atom::value)
    .then(
      [=, &client](const shared_catalogue& said) {
        const auto all = said.get();
        if (!all)
          return client.refuse(id, all.error());
        v1::ServerMessage message;
        protocol::to_message(**all, message.mutable_catalogue());
        client.answer(id, std::move(message));
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, "listing the operations"); });
}

/// Who works here, and where, is for those who keep the server.
void show_names(const client_state& client, v1::ServerStatus* status) {
  if (client.access.role != access_role::admin) {
    for (auto& node : *status->mutable_nodes()) {
      node.clear_name();
      node.clear_address();
    }
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  for (const auto& one : client.parts.clients->all()) {
    auto* out = status->add_clients();
    out->set_user(one.user);
    out->set_role(one.role);
    out->set_client(one.client);
    out->set_address(one.address);
    out->set_connected_s(std::chrono::duration<double>(now - one.since).count());
  }
}

void get_status(client_state& client, std::uint64_t id, const v1::GetStatus&) {
  client.begin(id, {});
  client.self->request(client.parts.hub, short_limit, status_atom::value)
    .then(
      [=, &client](const server_status& status) {
        v1::ServerMessage message;
        to_message(status, message.mutable_server_status());
        const auto& uploads = *client.parts.all_uploads;
        to_message(memory_use{"uploads", uploads.used(), uploads.limit()},
                   message.mutable_server_status()->add_memory());
        message.mutable_server_status()->set_connections(
          static_cast<std::uint32_t>(client.parts.connections()));
        message.mutable_server_status()->set_wrong_tokens(client.parts.guard->turned_away());
        show_names(client, message.mutable_server_status());
        client.answer(id, std::move(message));
      },
      [=, &client](const caf::error& e) { client.refuse(id, e, "asking for the status"); });
}

void cancel(client_state& client, std::uint64_t id, const v1::Cancel& body) {
  const auto found = client.requests.find(body.request_id());
  if (!client.drop_export(body.request_id()) && found != client.requests.end())
    found->second.cancel();
  v1::ServerMessage message;
  message.mutable_done();
  client.answer(id, std::move(message));
}

void second_hello(client_state& client, std::uint64_t id, const v1::Hello&) {
  client.refuse(id, {ec::protocol_error, "Hello was said already", {}, {}});
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
  const auto who = parts.guard->admits(body.token());
  if (!who)
    return turn_away(id);
  if (who->has_ended(seconds_now())) {
    refuse(id, token_ended(*who));
    return to->close(1008, "the token has ended");
  }
  admit(*who, std::string(cut_text(body.client(), longest_client_name)));
  v1::ServerMessage message;
  auto* welcome = message.mutable_welcome();
  welcome->set_protocol_major(protocol::major_version);
  welcome->set_protocol_minor(protocol::minor_version);
  welcome->set_server(parts.server_name);
  welcome->set_max_message_bytes(max_client_message);
  welcome->set_user(access.user);
  welcome->set_role(std::string(name_of(access.role)));
  for (const auto& format : file_formats)
    to_message(format, welcome->add_formats());
  for (const auto& array : fem::result_arrays)
    to_message(array, welcome->add_results());
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

void client_state::note_begin(std::uint64_t id, const v1::ClientMessage& message) {
  const auto* kind = message.GetReflection()->GetOneofFieldDescriptor(
    message, message.GetDescriptor()->FindOneofByName("body"));
  auto& counted = metrics::times_of(
    "tedit_request_seconds", "From a request to its answer, by kind.", {{"kind", kind->name()}});
  const auto [at, is_new] = asked.try_emplace(id);
  if (!is_new)
    return;
  running_requests().add(1);
  at->second.counted = &counted;
  at->second.span = tracing::begin_request(kind->name(), message.traceparent());
  at->second.span.note("tedit.request_id", static_cast<std::int64_t>(id));
  const auto& body = message.GetReflection()->GetMessage(message, kind);
  const auto* document = body.GetDescriptor()->FindFieldByName("document");
  if (document && tracing::is_on())
    at->second.span.note("tedit.document", body.GetReflection()->GetString(body, document));
}

void client_state::dispatch(std::uint64_t id, const v1::ClientMessage& message) {
  if (auto ok = protocol::check_numbers(message, finite_number(), ec::invalid_argument); !ok)
    return refuse(id, ok.error());
  const auto found = handlers().find(message.body_case());
  if (found == handlers().end())
    return refuse(id, {ec::protocol_error,
                       "this server does not know this request",
                       "Use a client of the server's release",
                       {}});
  if (!message.has_upload_chunk())  // Which is not answered.
    note_begin(id, message);
  found->second(*this, id, message);
}

request_rows server_requests() {
  using message = v1::ClientMessage;
  return {row_of<&message::hello, second_hello>(message::kHello),
          row_of<&message::list_operations, list_operations>(message::kListOperations),
          row_of<&message::get_status, get_status>(message::kGetStatus),
          row_of<&message::cancel, cancel>(message::kCancel)};
}

}  // namespace tedit::gateway
