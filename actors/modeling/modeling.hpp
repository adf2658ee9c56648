// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/worker/worker_jobs.hpp"
#include "ops/loader/catalogue.hpp"

namespace tedit::actors {

struct modeling_state {
  worker_jobs jobs;
  std::shared_ptr<const ops::catalogue> plugins;
  std::shared_ptr<ops::services> services;
  std::shared_ptr<ops::services> draft_services;  ///< For orders that are drafts.

  static inline const char* name = "modeling";
};

/// Reads and writes files and runs operations, one after the other. `at_start`: see `worker_jobs`.
modeling_actor::behavior_type make_modeling(modeling_actor::stateful_pointer<modeling_state> self,
                                            std::shared_ptr<page_cache> cache,
                                            const page_store_actor& pages,
                                            std::shared_ptr<const ops::catalogue> plugins,
                                            std::optional<process_usage> at_start);

// -- the jobs, without actors -----------------------------------------------------------------

[[nodiscard]] expected<job_output<import_result>> read_mesh(const import_order& order,
                                                            const page_set& pages,
                                                            const execution& run);

[[nodiscard]] expected<job_output<operation_result>> apply_operation(
  const ops::catalogue& plugins, const std::shared_ptr<ops::services>& services,
  const edit_order& order, const version_ptr& base, const execution& run);

[[nodiscard]] expected<job_output<export_result>> write_mesh(const export_order& order,
                                                             const job_input& in,
                                                             const execution& run);

/// Answers a question about surfaces. Errors: those of `select_surfaces`.
[[nodiscard]] expected<job_output<select_result>> find_surfaces(const select_order& order,
                                                                const version_ptr& mesh,
                                                                const execution& run);

}  // namespace tedit::actors
