// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/gateway.hpp"

#include <atomic>

#include <spdlog/spdlog.h>
#include <caf/actor_system.hpp>
#include <nlohmann/json.hpp>

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

  void on_message(std::string bytes) override { caf::anon_send(client_, std::move(bytes)); }
  void on_drained() override { caf::anon_send(client_, drained_atom::value); }
  void on_closed(const std::string& reason) override {
    spdlog::info("client {}: gone: {}", peer_, reason);
    caf::anon_send(client_, closed_atom::value);
  }

private:
  caf::actor client_;
  std::string peer_;
  connection_count open_;
};

/// The worst of the roles: "ok" when all are ready, "starting", or "degraded".
health_report health_of(const std::string& server,
                        const std::vector<std::pair<std::string, std::string>>& roles) {
  nlohmann::ordered_json workers = nlohmann::ordered_json::object();
  bool degraded = false;
  bool starting = false;
  for (const auto& [role, state] : roles) {
    workers[role] = state;
    degraded = degraded || state == "degraded";
    starting = starting || state == "starting";
  }
  const char* status = degraded ? "degraded" : starting ? "starting" : "ok";
  return {
    !degraded,
    nlohmann::ordered_json{{"status", status}, {"server", server}, {"workers", workers}}.dump()};
}

}  // namespace

expected<std::unique_ptr<transport>> start_gateway(caf::actor_system& system,
                                                   transport_options options, gateway_parts parts) {
  options.health = [name = parts.server_name, roles = parts.roles] {
    return health_of(name, roles ? roles() : decltype(roles()){});
  };
  // Counted here, not asked of the transport: actors of clients may outlive it.
  const auto open = std::make_shared<std::atomic<std::size_t>>(0);
  parts.connections = [open] { return open->load(); };
  options.accept = [&system, parts, open](std::shared_ptr<connection> to) {
    const auto peer = to->peer();
    return std::make_unique<forwarder>(system.spawn(make_client, std::move(to), parts), peer, open);
  };
  return transport::start(std::move(options));
}

}  // namespace tedit::gateway
