// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/gateway.hpp"

#include <atomic>

#include <caf/actor_system.hpp>
#include <nlohmann/json.hpp>

#include "base/logging/logging.hpp"
#include "base/metrics.hpp"
#include "protocol/descriptor_set.hpp"

namespace tedit::gateway {

namespace {

using connection_count = std::shared_ptr<std::atomic<std::size_t>>;

/// Hands what a connection receives to its actor. Nothing is decoded on the I/O thread.
class forwarder : public connection_handler {
public:
  forwarder(caf::actor client, std::string peer, connection_count open)
      : client_(std::move(client)), peer_(std::move(peer)), open_(std::move(open)) {
    ++*open_;
  }
  ~forwarder() override { --*open_; }

  void on_message(std::string bytes) override {
    static auto& messages =
      metrics::count_of("tedit_received_messages_total", "Messages of clients.");
    static auto& total = metrics::count_of("tedit_received_bytes_total", "Bytes of them.");
    messages.add();
    total.add(bytes.size());
    caf::anon_send(client_, std::move(bytes));
  }
  void on_drained() override { caf::anon_send(client_, drained_atom::value); }
  frame on_backlog(std::size_t waiting, std::size_t most, std::chrono::milliseconds rest) override {
    logging::info("client {}: does not take {} bytes", peer_, waiting);
    v1::ServerMessage message;
    auto* notice = message.mutable_backlog_notice();
    notice->set_waiting_bytes(waiting);
    notice->set_most_bytes(most);
    notice->set_closes_after_s(std::chrono::duration<double>(rest).count());
    return std::make_shared<const std::string>(message.SerializeAsString());
  }
  void on_closed(const std::string& reason) override {
    logging::info("client {}: gone: {}", peer_, reason);
    caf::anon_send(client_, closed_atom::value);
  }

private:
  caf::actor client_;
  std::string peer_;
  connection_count open_;
};

/// The worst of the roles: "ok" when all are ready, "starting", or "degraded". The server is well
/// unless it is degraded, and ready when all are.
page_answer health_of(const std::string& server,
                      const std::vector<std::pair<std::string, std::string>>& roles,
                      bool must_be_ready) {
  nlohmann::ordered_json workers = nlohmann::ordered_json::object();
  bool degraded = false;
  bool starting = false;
  for (const auto& [role, state] : roles) {
    workers[role] = state;
    degraded = degraded || state == "degraded";
    starting = starting || state == "starting";
  }
  const char* status = degraded ? "degraded" : starting ? "starting" : "ok";
  const bool fine = !degraded && !(must_be_ready && starting);
  return {
    fine ? 200U : 503U,
    nlohmann::ordered_json{{"status", status}, {"server", server}, {"workers", workers}}.dump()};
}

}  // namespace

page_answer metrics_for(const page_request& asked, const gateway_parts& parts) {
  const auto who = asked.local ? grant{} : parts.guard->admits(asked.bearer);
  if (!who || who->has_ended(seconds_now()))
    return {401, "Give a token of the server: Authorization: Bearer TOKEN\n", "text/plain"};
  metrics::note_process();
  metrics::level_of("tedit_connections", "Clients that are connected.")
    .set(static_cast<double>(parts.connections()));
  metrics::count_of("tedit_wrong_tokens_total", "Clients that were turned away for their token.")
    .set(parts.guard->turned_away());
  const auto roles = parts.roles ? parts.roles() : decltype(parts.roles()){};
  for (const auto& [role, state] : roles)
    metrics::level_of("tedit_role_ready", "1 when work of this kind can be done.", {{"role", role}})
      .set(state == "ready" ? 1 : 0);
  if (parts.measure)
    parts.measure();
  return {200, metrics::to_text(), "text/plain; version=0.0.4; charset=utf-8"};
}

expected<std::unique_ptr<transport>> start_gateway(caf::actor_system& system,
                                                   transport_options options, gateway_parts parts) {
  // Counted here, not asked of the transport: actors of clients may outlive it.
  const auto open = std::make_shared<std::atomic<std::size_t>>(0);
  parts.connections = [open] { return open->load(); };
  const auto health = [name = parts.server_name, roles = parts.roles](bool must_be_ready) {
    return health_of(name, roles ? roles() : decltype(roles()){}, must_be_ready);
  };
  options.pages["/healthz"] = [=](const page_request&) { return health(false); };
  options.pages["/readyz"] = [=](const page_request&) { return health(true); };
  options.pages["/metrics"] = [parts](const page_request& asked) {
    return metrics_for(asked, parts);
  };
  options.pages["/protocol.desc"] = [](const page_request&) {
    return page_answer{200, std::string(protocol::descriptor_set()), "application/x-protobuf"};
  };
  options.accept = [&system, parts, open](std::shared_ptr<connection> to) {
    static auto& total =
      metrics::count_of("tedit_connections_total", "Clients that have connected.");
    total.add();
    const auto peer = to->peer();
    return std::make_unique<forwarder>(system.spawn(make_client, std::move(to), parts), peer, open);
  };
  return transport::start(std::move(options));
}

}  // namespace tedit::gateway
