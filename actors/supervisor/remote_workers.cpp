// SPDX-License-Identifier: AGPL-3.0-or-later
// Workers that come by themselves from other machines, beside those that the pool starts
// (docs/decisions/0038).
#include <algorithm>

#include "actors/supervisor/pool.hpp"
#include "base/logging/logging.hpp"

namespace tedit::actors {

bool pool_state::welcome(const remote_worker& guest) {
  if (stopped || !guest.worker || !guest.line || guest.line->ended())
    return false;
  child c;
  c.number = ++started;
  c.line = guest.line;
  c.started = now();
  c.worker = guest.worker;
  c.node = guest.node;
  self->monitor(c.worker);
  logging::info("{} worker: {} joined: {}", name_of(options.role), c.line->name(),
                guest.node.device);
  children.push_back(std::move(c));
  degraded = false;
  wake();
  serve_new(children.back());
  return true;
}

std::vector<node_status> pool_state::nodes() const {
  std::vector<node_status> result;
  for (const auto& c : children) {
    if (!c.is_remote())
      continue;
    node_status one;
    one.name = c.node.name;
    one.address = c.node.address;
    one.role = name_of(options.role);
    one.device = c.node.device;
    one.version = c.node.version;
    one.threads = c.node.threads;
    one.memory_bytes = c.node.memory_bytes;
    one.connected_s = std::chrono::duration<double>(now() - c.started).count();
    one.state = c.lost ? "lost" : c.retired ? "leaving" : c.work ? "working" : "idle";
    one.jobs_done = c.jobs_done;
    result.push_back(std::move(one));
  }
  return result;
}

}  // namespace tedit::actors
