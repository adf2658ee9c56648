// SPDX-License-Identifier: AGPL-3.0-or-later
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/config.hpp"
#include "cli/server_access.hpp"
#include "client/client.hpp"

namespace tedit::cli {

namespace {

struct status_options {
  std::string server = "ws://127.0.0.1:" + std::to_string(server_config().port) + "/v1";
  server_access access;
};

nlohmann::ordered_json to_json(const client::server_status& status) {
  using json = nlohmann::ordered_json;
  json workers = json::array();
  for (const auto& w : status.workers)
    workers.push_back({{"role", w.role},
                       {"state", w.state},
                       {"pid", w.pid},
                       {"restarts", w.restarts},
                       {"jobs", w.jobs},
                       {"detail", w.detail}});
  json nodes = json::array();
  for (const auto& n : status.nodes)
    nodes.push_back({{"name", n.name},
                     {"address", n.address},
                     {"role", n.role},
                     {"state", n.state},
                     {"device", n.device},
                     {"version", n.version},
                     {"threads", n.threads},
                     {"memory_bytes", n.memory_bytes},
                     {"connected_s", n.connected_s},
                     {"jobs_done", n.jobs_done}});
  json clients = json::array();
  for (const auto& c : status.clients)
    clients.push_back({{"user", c.user},
                       {"role", c.role},
                       {"client", c.client},
                       {"address", c.address},
                       {"connected_s", c.connected_s}});
  json memory = json::array();
  for (const auto& m : status.memory)
    memory.push_back({{"what", m.what}, {"bytes", m.bytes}, {"budget_bytes", m.budget_bytes}});
  return {{"documents", status.documents}, {"connections", status.connections},
          {"workers", std::move(workers)}, {"nodes", std::move(nodes)},
          {"clients", std::move(clients)}, {"memory", std::move(memory)}};
}

std::string mebibytes(std::uint64_t bytes) {
  return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20));
}

std::string describe(const client::server_status& status) {
  auto text = fmt::format("  documents open  {}\n  connections     {}\n", status.documents,
                          status.connections);
  for (const auto& w : status.workers) {
    const auto process = w.pid ? fmt::format(", process {}", w.pid) : std::string();
    text += fmt::format("  {:<15} {}{}, {} jobs", w.role, w.state, process, w.jobs);
    if (w.restarts > 0)
      text += fmt::format(", started anew {} times", w.restarts);
    text += (w.detail.empty() ? "" : ": " + w.detail) + "\n";
  }
  for (const auto& n : status.nodes)
    text +=
      fmt::format("  {:<15} {}, {} at {}: {}, TEdit {}, {} threads, {:.0f} GiB, {} jobs done\n",
                  "node " + n.name, n.state, n.role, n.address, n.device, n.version, n.threads,
                  static_cast<double>(n.memory_bytes) / (1 << 30), n.jobs_done);
  for (const auto& c : status.clients)
    text += fmt::format("  {:<15} {}, {} at {}, for {:.0f} s\n",
                        "client " + (c.user.empty() ? "(server's token)" : c.user), c.role,
                        c.client, c.address, c.connected_s);
  text += "  memory\n";
  for (const auto& m : status.memory)
    text += fmt::format("    {:<13} {}{}\n", m.what, mebibytes(m.bytes),
                        m.budget_bytes ? " of " + mebibytes(m.budget_bytes) : "");
  return text;
}

int run_status(const status_options& options, session& s) {
  auto how = reach_server(options.server, options.access);
  if (!how)
    return print_error(s, how.error());
  how->client_name = "tedit status " TEDIT_VERSION;
  const auto connected = client::client::connect(*how, {});
  if (!connected)
    return print_error(s, connected.error());
  const auto status = (*connected)->status();
  if (!status)
    return print_error(s, status.error());
  auto result = to_json(*status);
  result["server"] = options.server;
  print_result(s, result, options.server + "\n" + describe(*status));
  return 0;
}

}  // namespace

void add_status(CLI::App& app, action& chosen) {
  auto options = std::make_shared<status_options>();
  auto* command = app.add_subcommand(
    "status", "Say how a running server and its workers are, and what takes up its memory");
  command->add_option("--server", options->server, "The server (ws[s]://HOST:PORT/v1)")
    ->capture_default_str();
  add_access_options(*command, options->access);
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_status(*options, s); }; });
}

}  // namespace tedit::cli
