// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <memory>
#include <optional>
#include <string>

#include "actors/supervisor/worker_processes.hpp"

namespace tedit::actors {

/// What ties a worker to its pool: its process on this machine, or a connection to another one.
class lifeline {
public:
  lifeline() = default;
  lifeline(const lifeline&) = delete;
  lifeline& operator=(const lifeline&) = delete;
  virtual ~lifeline() = default;

  /// How it ended; nothing while it lasts.
  [[nodiscard]] virtual std::optional<std::string> ended() = 0;

  /// Ends it: nothing that the worker says reaches anybody here any more.
  virtual void cut() = 0;

  /// For people: "process 4711", "node rack-2 (10.0.0.7)".
  [[nodiscard]] virtual std::string name() const = 0;
};

/// Of a process that a pool started.
[[nodiscard]] std::shared_ptr<lifeline> own_process(std::shared_ptr<worker_processes> of,
                                                    pid_t pid);

}  // namespace tedit::actors
