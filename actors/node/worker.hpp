// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "actors/node/membership.hpp"
#include "actors/worker_roles.hpp"
#include "base/error.hpp"
#include "base/execution.hpp"
#include "ops/loader/catalogue.hpp"

namespace tedit::actors {

struct worker_options {
  worker_role role = worker_role::modeling;
  /// The end of a link to its pool, or to the server that it joined; it is taken over. -1: it joins
  /// by itself.
  int link = -1;
  std::vector<ops::found_plugin> plugins;  ///< Modeling: those to load.
  /// What it reaches by name is bounded already; what it may ask of the system is before a plugin
  /// is loaded.
  bool confined = false;
  std::optional<join_place> joins;  ///< Nothing: its own pool started it.
};

/// Runs a worker until its pool is gone or `stop` is set; one that joined another machine's server
/// then ends the work that it has, as long as that takes, and lets others fetch its last result.
/// Errors: `service_unavailable` when the pool cannot be reached or turns the worker away, or the
/// process cannot be confined; of one that joins, those of `dial::connect` and `enlist_at`.
[[nodiscard]] expected<void> run_worker(const worker_options& options, const cancel_token& stop);

}  // namespace tedit::actors
