// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include "actors/supervisor/pool.hpp"

namespace tedit::actors {

pool_numbers::pool_numbers(const std::string& role)
    : workers(metrics::level_of("tedit_workers", "Workers that are there, of this machine.",
                                {{"role", role}})),
      nodes(metrics::level_of("tedit_nodes", "Workers that joined from other machines.",
                              {{"role", role}})),
      running(metrics::level_of("tedit_jobs_running", "Jobs that workers have.", {{"role", role}})),
      waiting(
        metrics::level_of("tedit_jobs_waiting", "Jobs that wait for a worker.", {{"role", role}})),
      deaths(metrics::count_of("tedit_worker_deaths_total",
                               "Workers that died or lost their connection.", {{"role", role}})),
      retries(metrics::count_of("tedit_job_deaths_total",
                                "Jobs whose worker was gone before they were done.",
                                {{"role", role}})),
      restarts(metrics::count_of("tedit_worker_restarts_total",
                                 "Processes of workers that were started anew.", {{"role", role}})),
      done(metrics::times_of("tedit_job_seconds", "Jobs that were done, without their waiting.",
                             {{"role", role}})) {}

void pool_state::measure() const {
  const auto count = [&](auto wanted) {
    return static_cast<double>(std::ranges::count_if(children, wanted));
  };
  numbers->workers.set(count([](const child& c) { return c.is_there() && !c.is_remote(); }));
  numbers->nodes.set(count([](const child& c) { return c.is_there() && c.is_remote(); }));
  numbers->running.set(count([](const child& c) { return c.work.has_value(); }));
  numbers->waiting.set(static_cast<double>(waiting.size()));
  numbers->restarts.set(restarts);
}

worker_status pool_state::status() const {
  worker_status result;
  result.role = name_of(options.role);
  result.restarts = restarts;
  result.jobs = static_cast<std::uint32_t>(waiting.size());
  result.state = to_string(state());
  bool free_here = false;
  for (const auto& c : children) {
    if (c.worker && !c.is_remote())
      result.pid = c.worker_pid;
    result.jobs += c.work.has_value();
    const bool is_free = c.is_there() && !c.work;
    result.free_machines += is_free && c.is_remote();
    free_here = free_here || (is_free && !c.is_remote());
  }
  result.free_machines += free_here;
  result.detail = last_failure;
  result.nodes = nodes();
  return result;
}

}  // namespace tedit::actors
