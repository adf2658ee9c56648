// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "base/error.hpp"
#include "base/execution.hpp"

namespace tedit::actors {

struct worker_options {
  std::string role;  ///< "modeling", "optimizer" or "solver".
  std::string host;  ///< The pool that it serves.
  std::uint16_t port = 0;
  std::string ticket;      ///< What the pool gave the process to prove that it started it.
  bool safe_mode = false;  ///< Modeling: only the plugins that came with the program.
};

/// Runs a worker until its pool is gone or `stop` is set. Errors: `service_unavailable` when the
/// pool cannot be reached or turns the worker away, `invalid_argument` for an unknown role.
[[nodiscard]] expected<void> run_worker(const worker_options& options, const cancel_token& stop);

}  // namespace tedit::actors
