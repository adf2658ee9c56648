// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/node/worker.hpp"

#include <unistd.h>

#include <utility>

#include <caf/send.hpp>

#include "actors/errors.hpp"
#include "actors/modeling/modeling.hpp"
#include "actors/optimizer/optimizer.hpp"
#include "actors/solver/solver.hpp"
#include "base/logging/logging.hpp"
#include "fem/solver.hpp"
#include "sandbox/sandbox.hpp"

namespace tedit::actors {

namespace {

caf::actor spawn_role(membership& node, const worker_options& options) {
  auto& system = node.system();
  switch (options.role) {
    case worker_role::optimizer:
      return caf::actor_cast<caf::actor>(system.spawn(make_optimizer, node.cache(), node.pages()));
    case worker_role::solver:
      return caf::actor_cast<caf::actor>(system.spawn(make_solver, node.cache(), node.pages()));
    case worker_role::modeling:
      break;
  }
  auto plugins = std::make_shared<ops::catalogue>();
  plugins->load(options.plugins);
  for (const auto& refused : plugins->refused())
    logging::warn("plugin {}: {}", refused.file.string(), refused.reason);
  return caf::actor_cast<caf::actor>(
    system.spawn(make_modeling, node.cache(), node.pages(), plugins, usage_of_this_process()));
}

/// The devices that a solver finds here, the processor's own last.
std::string solving_devices() {
  std::string text;
  for (const auto& device : fem::list_devices())
    text += (text.empty() ? "" : ", ") + device.name;
  return text;
}

/// Says that the worker is there, to the pool that started it or to a server elsewhere.
expected<void> enlist(membership& node, const caf::actor& worker, const worker_options& options) {
  if (options.joins) {
    const auto device =
      options.role == worker_role::solver ? solving_devices() : std::string("processor");
    return enlist_at(
      node.self(), node.entrance(),
      {name_of(options.role), facts_of_this_machine(device, options.joins->version), worker});
  }
  expected<void> result;
  node.self()
    ->request(node.entrance(), std::chrono::seconds(10),
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
  auto joined = options.joins && options.link < 0 ? membership::join(*options.joins, stop)
                                                  : membership::join(unique_fd(options.link), stop);
  if (!joined)
    return fail(joined.error());
  auto& node = **joined;
  if (options.confined)
    if (auto ok = sandbox::confine_calls(); !ok)
      return ok;
  const auto worker = spawn_role(node, options);
  node.own(worker);
  if (const auto ok = enlist(node, worker, options); !ok)
    return fail(ok.error());
  bool leaving = false;
  while (!(stop.cancelled() && !options.joins)) {
    if (stop.cancelled() && !std::exchange(leaving, true)) {
      logging::info("leaving the server; work that has begun is ended first");
      node.self()->send(node.entrance(), retirement{"it is being stopped"});
    }
    if (!node.stays(std::chrono::seconds(1)))
      break;
  }
  // Work that still runs belongs to nobody any more; its threads must not keep the process.
  std::_Exit(0);
}

}  // namespace tedit::actors
