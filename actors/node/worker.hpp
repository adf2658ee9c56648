// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/worker_roles.hpp"
#include "base/error.hpp"
#include "base/execution.hpp"

namespace tedit::actors {

struct worker_options {
  worker_role role = worker_role::modeling;
  int link = -1;           ///< The end of a link to its pool; it is taken over.
  bool safe_mode = false;  ///< Modeling: only the plugins that came with the program.
};

/// Runs a worker until its pool is gone or `stop` is set. Errors: `service_unavailable` when the
/// pool cannot be reached or turns the worker away.
[[nodiscard]] expected<void> run_worker(const worker_options& options, const cancel_token& stop);

}  // namespace tedit::actors
