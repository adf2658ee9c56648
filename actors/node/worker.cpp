// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/node/worker.hpp"

#include <unistd.h>

#include <spdlog/spdlog.h>
#include <caf/actor_system.hpp>
#include <caf/scoped_actor.hpp>
#include <caf/send.hpp>

#include "actors/errors.hpp"
#include "actors/links/link.hpp"
#include "actors/modeling/modeling.hpp"
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

}  // namespace

expected<void> run_worker(const worker_options& options, const cancel_token& stop) {
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
  const auto enlister = join_link(system, unique_fd(options.link), stop);
  if (!enlister)
    return turned_away(enlister.error());
  caf::scoped_actor self(system);
  self->monitor(*enlister);
  // Without one of these the process would refuse all work; its pool starts another instead.
  self->monitor(worker);
  self->monitor(pages);
  std::optional<error> refused;
  self
    ->request(*enlister, std::chrono::seconds(10),
              enlistment{static_cast<std::int32_t>(getpid()), worker})
    .receive(
      [&](bool accepted) {
        if (!accepted)
          refused = error{ec::service_unavailable,
                          "the server turned this worker away",
                          "Workers are started by \"tedit serve\"",
                          {}};
      },
      [&](const caf::error& e) { refused = from_caf(e, "enlisting"); });
  if (refused)
    return turned_away(*refused);
  bool gone = false;
  while (!gone && !stop.cancelled())
    self->receive(
      [&](const caf::down_msg& down) {
        gone = true;
        if (down.source != enlister->address())
          spdlog::error("an actor of this worker ended: {}", caf::to_string(down.reason));
      },
      caf::after(std::chrono::seconds(1)) >> [] {});
  // Work that still runs belongs to nobody any more; its threads must not keep the process.
  std::_Exit(0);
}

}  // namespace tedit::actors
