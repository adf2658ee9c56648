// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/node/server.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <caf/actor_system.hpp>
#include <caf/scoped_actor.hpp>

#include "actors/cad/cad_editor.hpp"
#include "actors/cad/part_importer.hpp"
#include "actors/gateway/gateway.hpp"
#include "actors/modeling/modeling.hpp"
#include "actors/node/hub.hpp"
#include "actors/node/nodes.hpp"
#include "actors/node/system_config.hpp"
#include "actors/optimizer/optimizer.hpp"
#include "actors/pages/page_store.hpp"
#include "actors/solver/solver.hpp"
#include "actors/store/documents_folder.hpp"
#include "actors/supervisor/case_spreading.hpp"
#include "actors/supervisor/pool.hpp"
#include "actors/supervisor/solver_choice.hpp"
#include "base/child_process.hpp"
#include "base/logging/logging.hpp"
#include "base/metrics.hpp"
#include "base/tracing/tracing.hpp"
#include "sandbox/sandbox.hpp"

namespace tedit {

namespace {

using namespace actors;

/// Pages kept beyond what documents hold: what workers are about to ask for.
constexpr std::size_t cache_bytes = std::size_t{64} << 20;

worker_set start_threads(caf::actor_system& system, const server_options& options,
                         const std::shared_ptr<page_cache>& cache, const page_store_actor& pages) {
  const auto which = options.safe_mode ? ops::plugin_source::built_in : ops::plugin_source::all;
  auto plugins = std::make_shared<ops::catalogue>();
  plugins->load(ops::find_plugins(which));
  return {system.spawn(make_modeling, cache, pages, plugins, std::nullopt),
          system.spawn(make_optimizer, cache, pages), system.spawn(make_solver, cache, pages)};
}

pool_options options_of(const server_options& options, worker_role role, unsigned workers,
                        std::chrono::milliseconds limit) {
  const auto program = options.program.empty() ? executable_folder() / "tedit" : options.program;
  pool_options result;
  result.role = role;
  result.health = std::make_shared<role_health>(role);
  result.command = {program.string(), "worker", "--role", name_of(role)};
  const bool plugins = facts_of(role).runs_plugins;
  if (!options.sandbox)
    result.command.emplace_back("--no-sandbox");
  if (options.safe_mode && plugins)
    result.command.emplace_back("--safe-mode");
  if (options.modeling_memory_mb > 0 && plugins)
    result.command.insert(result.command.end(),
                          {"--memory-mb", std::to_string(options.modeling_memory_mb)});
  result.quarantine_after = options.quarantine_after;
  result.operation_limit = options.edit_limit;
  result.workers = workers;
  result.retired_stay = options.retired_stay;
  result.job_limit = limit;
  return result;
}

using role_healths = std::vector<std::shared_ptr<role_health>>;

worker_set start_pools(caf::actor_system& system, const server_options& options,
                       role_healths& healths, const std::shared_ptr<page_cache>& cache,
                       const page_store_actor& pages) {
  const auto of = [&](worker_role role, unsigned workers, std::chrono::milliseconds limit) {
    auto result = options_of(options, role, workers, limit);
    healths.push_back(result.health);
    return result;
  };
  const auto own_kind = [options](caf::actor_system& with, const std::string& device) {
    auto result = options_of(options, worker_role::solver, 0, options.solve_limit);
    result.device = device;
    return make_solver_pool(with, std::move(result));
  };
  // In the order in which they are listed.
  auto modeling =
    make_modeling_pool(system, of(worker_role::modeling, options.modeling_workers,
                                  std::max(options.import_limit, options.edit_limit)));
  auto optimizer = make_optimizer_pool(
    system, of(worker_role::optimizer, options.optimizer_workers, options.edit_limit));
  auto solvers =
    make_solver_pool(system, of(worker_role::solver, options.solver_workers, options.solve_limit));
  if (!options.node_certificates.empty())
    solvers = make_case_spreading(system, solvers, pages, cache);
  return {modeling, optimizer, make_solver_choice(system, solvers, own_kind)};
}

cad_editor_actor start_cad_editor(caf::actor_system& system, const modeling_actor& modeling,
                                  unsigned jobs) {
  std::vector<job_thread_actor> threads;
  for (unsigned i = 0; i < jobs; ++i)
    threads.push_back(spawn_background_thread(system));
  return system.spawn(make_cad_editor, modeling, std::move(threads));
}

part_importer_actor start_part_importer(caf::actor_system& system, const server_options& options) {
  std::vector<job_thread_actor> threads;
  for (unsigned i = 0; i < options.import_jobs; ++i)
    threads.push_back(system.spawn<job_thread, caf::detached>());
  return system.spawn(make_part_importer, std::move(threads),
                      std::chrono::ceil<std::chrono::seconds>(options.import_limit));
}

std::vector<std::pair<std::string, std::string>> states_of(const role_healths& healths) {
  std::vector<std::pair<std::string, std::string>> result;
  for (const auto& h : healths)
    result.emplace_back(name_of(h->role), to_string(h->state()));
  return result;
}

/// How much is kept, and of how much.
void note_memory(const page_cache& pages, const version_memory& versions,
                 const result_memory& results, const gateway::upload_account& uploads) {
  const auto note = [](const char* what, std::uint64_t bytes, std::uint64_t budget) {
    metrics::level_of("tedit_kept_bytes", "Bytes that the server keeps, by kind.", {{"what", what}})
      .set(static_cast<double>(bytes));
    metrics::level_of("tedit_kept_budget_bytes", "The most of them; 0 where there is no bound.",
                      {{"what", what}})
      .set(static_cast<double>(budget));
  };
  const auto known = pages.usage();
  note("pages", known.known, 0);
  note("recent_pages", known.recent, known.budget);
  note("versions", versions.used(), versions.budget());
  note("results", results.used(), results.budget());
  note("uploads", uploads.used(), uploads.limit());
}

/// Whether only this machine reaches an address.
bool is_loopback(const std::string& address) {
  in_addr v4{};
  in6_addr v6{};
  if (inet_pton(AF_INET, address.c_str(), &v4) == 1)
    return (ntohl(v4.s_addr) >> 24) == IN_LOOPBACKNET;
  return address == "localhost" ||
         (inet_pton(AF_INET6, address.c_str(), &v6) == 1 && IN6_IS_ADDR_LOOPBACK(&v6));
}

/// Tokens and documents do not cross a network for everybody to read. Errors: `invalid_argument`.
expected<void> check_exposure(const server_options& options) {
  if (!options.certificates.empty() || options.unencrypted_behind_proxy ||
      is_loopback(options.address))
    return {};
  return fail(ec::invalid_argument,
              "clients of other machines would reach " + options.address +
                " without TLS, and whoever is in between could read their tokens",
              "Give a certificate (server.certificates in the configuration; \"tedit certs issue "
              "--role server\" makes one), or listen on 127.0.0.1");
}

/// Null when no worker of another machine may join.
expected<std::unique_ptr<node_entrance>> open_to_nodes(caf::actor_system& system,
                                                       const entrance_parts& parts,
                                                       const server_options& options) {
  if (options.node_certificates.empty())
    return nullptr;
  if (!options.worker_processes)
    return fail(ec::invalid_argument,
                "workers of other machines cannot join a server whose own run on its threads",
                "Leave out --in-process, or nodes.certificates in the configuration");
  return node_entrance::open(
    system, parts,
    {options.node_certificates, options.node_address, options.node_port, TEDIT_VERSION});
}

}  // namespace

struct server::impl {
  explicit impl(bool networked) : config(networked), system(config) {}

  void stop() {
    if (stopped)
      return;
    stopped = true;
    if (door)
      door->stop();
    nodes.reset();
    // Pools and sessions hold each other's handles: all are told to end.
    caf::scoped_actor self(system);
    for (const auto& a : to_end)
      self->send_exit(a, caf::exit_reason::user_shutdown);
    self->wait_for(to_end);
  }

  system_config config;
  caf::actor_system system;
  std::unique_ptr<gateway::transport> door;
  std::unique_ptr<node_entrance> nodes;
  std::vector<caf::actor> to_end;
  std::string address;
  bool secure = false;
  bool stopped = false;
};

server::server(std::unique_ptr<impl> made) : impl_(std::move(made)) {}

server::~server() {
  impl_->stop();
}

std::uint16_t server::port() const {
  return impl_->door->port();
}

std::optional<std::uint16_t> server::node_port() const {
  return impl_->nodes ? std::optional(impl_->nodes->port()) : std::nullopt;
}

std::string server::url() const {
  const bool v6 = impl_->address.find(':') != std::string::npos;
  return std::string(impl_->secure ? "wss://" : "ws://") +
         (v6 ? "[" + impl_->address + "]" : impl_->address) + ":" + std::to_string(port()) + "/v1";
}

std::string server::fingerprint() const {
  return impl_->door->fingerprint();
}

void server::stop() {
  impl_->stop();
}

expected<std::unique_ptr<server>> server::start(const server_options& options) {
  if (options.token.empty())
    return fail(ec::invalid_argument, "a server needs a token");
  if (options.worker_processes && options.sandbox)
    if (auto can = sandbox::check(); !can)
      return fail(can.error());
  if (options.worker_processes && !options.sandbox)
    logging::warn("workers are not confined: plugins can do all that this user can");
  if (auto ok = check_exposure(options); !ok)
    return fail(ok.error());
  std::shared_ptr<gateway::user_book> users;
  if (!options.users.empty()) {
    auto opened = gateway::user_book::open(options.users);
    if (!opened)
      return fail(opened.error());
    users = *std::move(opened);
  }
  const auto ready = store::prepare_documents_folder(options.documents);
  if (!ready)
    return fail(ready.error());
  for (const auto& news : *ready)
    logging::warn("{}", news);
  if (!options.traces.empty())
    if (auto ok = tracing::start(options.traces, "tedit", TEDIT_VERSION); !ok)
      return fail(ok.error());
  auto made = std::make_unique<impl>(options.worker_processes);
  auto& system = made->system;
  auto cache = std::make_shared<page_cache>(cache_bytes);
  const auto pages = system.spawn(make_page_store, cache);
  role_healths healths;
  const auto workers = options.worker_processes
                         ? start_pools(system, options, healths, cache, pages)
                         : start_threads(system, options, cache, pages);
  const auto results = std::make_shared<result_memory>(options.result_bytes);
  const auto versions = std::make_shared<version_memory>(options.version_bytes);
  hub_parts shared{
    options.documents,       workers, pages,   cache, options.device, options.unused_limit,
    options.temporary_limit, results, versions};
  if (options.cad_jobs > 0)
    shared.cad = start_cad_editor(system, workers.modeling, options.cad_jobs);
  if (options.import_jobs > 0)
    shared.importer = start_part_importer(system, options);
  const auto hub = system.spawn(make_hub, shared);
  made->to_end = {caf::actor_cast<caf::actor>(hub), caf::actor_cast<caf::actor>(pages)};
  if (shared.cad)
    made->to_end.push_back(caf::actor_cast<caf::actor>(shared.cad));
  if (shared.importer)
    made->to_end.push_back(caf::actor_cast<caf::actor>(shared.importer));
  workers.for_each([&](worker_role, const auto& worker) {
    made->to_end.push_back(caf::actor_cast<caf::actor>(worker));
  });
  auto nodes = open_to_nodes(system, {workers, hub, caf::actor_cast<caf::actor>(pages)}, options);
  if (!nodes) {
    made->stop();
    return fail(nodes.error());
  }
  made->nodes = std::move(*nodes);
  made->address = options.address;
  made->secure = !options.certificates.empty();
  gateway::transport_options door;
  door.address = options.address;
  door.port = options.port;
  door.allowed_origins = options.allowed_origins;
  door.allowed_hosts = options.allowed_hosts;
  door.certificates = options.certificates;
  gateway::gateway_parts parts;
  parts.hub = hub;
  parts.guard = std::make_shared<gateway::token_guard>(options.token, std::move(users));
  parts.access_every = options.access_every;
  parts.server_name = "tedit " TEDIT_VERSION;
  parts.upload_bytes = options.upload_bytes;
  parts.all_uploads = std::make_shared<gateway::upload_account>(options.all_upload_bytes);
  parts.roles = [healths] { return states_of(healths); };
  parts.measure = [=, uploads = parts.all_uploads, nodes = made->nodes.get()] {
    note_memory(*cache, *versions, *results, *uploads);
    if (nodes)
      nodes->measure();
  };
  metrics::level_of("tedit_build_info", "1; the version is the label.",
                    {{"version", TEDIT_VERSION}})
    .set(1);
  auto opened = gateway::start_gateway(system, std::move(door), std::move(parts));
  if (!opened) {
    made->stop();
    return fail(opened.error());
  }
  made->door = std::move(*opened);
  return std::unique_ptr<server>(new server(std::move(made)));
}

}  // namespace tedit
