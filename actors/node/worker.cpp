// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/node/worker.hpp"

#include <unistd.h>

#include <utility>

#include <spdlog/spdlog.h>
#include <caf/actor_system.hpp>
#include <caf/scoped_actor.hpp>
#include <caf/send.hpp>

#include "actors/errors.hpp"
#include "actors/links/dial.hpp"
#include "actors/links/link.hpp"
#include "actors/modeling/modeling.hpp"
#include "actors/node/remote.hpp"
#include "actors/node/system_config.hpp"
#include "actors/optimizer/optimizer.hpp"
#include "actors/pages/page_store.hpp"
#include "actors/solver/solver.hpp"

namespace tedit::actors {

namespace {

/// Pages of recent versions that stay in a worker, so that the next order moves only what is new.
constexpr std::size_t cache_bytes = std::size_t{768} << 20;

caf::actor spawn_role(caf::actor_system& system, const worker_options& options,
                      const std::shared_ptr<page_cache>& cache, const page_store_actor& pages) {
  switch (options.role) {
    case worker_role::optimizer:
      return caf::actor_cast<caf::actor>(system.spawn(make_optimizer, cache, pages));
    case worker_role::solver:
      return caf::actor_cast<caf::actor>(system.spawn(make_solver, cache, pages));
    case worker_role::modeling:
      break;
  }
  const auto which = options.safe_mode ? ops::plugin_source::built_in : ops::plugin_source::all;
  auto plugins = std::make_shared<const ops::catalogue>(ops::load_default_catalogue(which));
  for (const auto& refused : plugins->refused())
    spdlog::warn("plugin {}: {}", refused.file.string(), refused.reason);
  return caf::actor_cast<caf::actor>(
    system.spawn(make_modeling, cache, pages, plugins, usage_of_this_process()));
}

/// Says that the worker is there, to the pool that started it or to a server elsewhere.
expected<void> enlist(caf::scoped_actor& self, const caf::actor& enlister, const caf::actor& worker,
                      const worker_options& options) {
  if (options.joins)
    return enlist_at(
      self, enlister,
      {name_of(options.role), facts_of_this_machine(options.role, options.joins->version), worker});
  expected<void> result;
  self
    ->request(enlister, std::chrono::seconds(10),
              enlistment{static_cast<std::int32_t>(getpid()), worker})
    .receive(
      [&](bool accepted) {
        if (!accepted)
          result = fail(ec::service_unavailable, "the server turned this worker away",
                        "Workers are started by \"tedit serve\"");
      },
      [&](const caf::error& e) { result = fail(from_caf(e, "enlisting")); });
  return result;
}

}  // namespace

expected<void> run_worker(const worker_options& options, const cancel_token& stop) {
  std::unique_ptr<dial> connection;  // As long as the system that talks over it.
  unique_fd link(options.link);
  if (options.joins) {
    auto made =
      dial::connect({options.joins->certificates, options.joins->host, options.joins->port}, stop);
    if (!made)
      return fail(made.error());
    connection = std::move(*made);
    link = connection->take_link();
    spdlog::info("joined {} at {}:{}", connection->server().name, options.joins->host,
                 options.joins->port);
  }
  system_config config(true);
  caf::actor_system system(config);
  const auto cache = std::make_shared<page_cache>(cache_bytes);
  const auto pages = system.spawn(make_page_store, cache);
  const auto worker = spawn_role(system, options, cache, pages);
  // The system's end waits for all actors.
  const auto turned_away = [&](const error& why) {
    caf::anon_send_exit(worker, caf::exit_reason::user_shutdown);
    caf::anon_send_exit(pages, caf::exit_reason::user_shutdown);
    return fail(why);
  };
  const auto enlister = join_link(system, std::move(link), stop);
  if (!enlister)
    return turned_away(enlister.error());
  caf::scoped_actor self(system);
  self->monitor(*enlister);
  // Without one of these the process would refuse all work; its pool starts another instead.
  self->monitor(worker);
  self->monitor(pages);
  if (const auto ok = enlist(self, *enlister, worker, options); !ok)
    return turned_away(ok.error());
  bool gone = false;
  bool leaving = false;
  while (!gone && !(stop.cancelled() && !options.joins)) {
    if (stop.cancelled() && !std::exchange(leaving, true)) {
      spdlog::info("leaving the server; work that has begun is ended first");
      self->send(*enlister, retirement{"it is being stopped"});
    }
    self->receive(
      [&](const caf::down_msg& down) {
        gone = true;
        if (down.source != enlister->address())
          spdlog::error("an actor of this worker ended: {}", caf::to_string(down.reason));
      },
      caf::after(std::chrono::seconds(1)) >> [] {});
  }
  // Work that still runs belongs to nobody any more; its threads must not keep the process.
  std::_Exit(0);
}

}  // namespace tedit::actors
