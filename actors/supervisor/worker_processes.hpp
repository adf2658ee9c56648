// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <caf/actor.hpp>
#include <caf/actor_system.hpp>

#include "base/error.hpp"

namespace tedit::actors {

/// The processes of workers, as a pool starts, asks after and ends them. Tests put others in the
/// place of the system's, whose workers live in the test itself.
class worker_processes {
public:
  worker_processes() = default;
  worker_processes(const worker_processes&) = delete;
  worker_processes& operator=(const worker_processes&) = delete;
  virtual ~worker_processes() = default;

  /// Starts a worker that enlists with `enlister`; only its process can talk to that.
  /// Errors: `service_unavailable`, `io_error`.
  [[nodiscard]] virtual expected<pid_t> start(caf::actor_system& system,
                                              const std::vector<std::string>& command,
                                              const caf::actor& enlister) = 0;

  /// How a process ended; nothing while it runs.
  [[nodiscard]] virtual std::optional<std::string> reap(pid_t pid) = 0;

  /// Ends a process and waits for its end.
  virtual void kill(pid_t pid) = 0;

  /// How many processes of this machine were ended because memory ran out.
  [[nodiscard]] virtual std::uint64_t memory_kills() const { return 0; }
};

/// Those of this machine, each at the other end of a link (actors/links/link.hpp).
[[nodiscard]] std::shared_ptr<worker_processes> system_processes();

}  // namespace tedit::actors
