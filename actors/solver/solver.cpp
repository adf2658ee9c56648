// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/solver/solver.hpp"

#include <utility>

#include "actors/solver/solve_output.hpp"
#include "actors/supervisor/job_estimate.hpp"
#include "actors/versions.hpp"
#include "base/logging/logging.hpp"
#include "base/memory.hpp"
#include "base/process_usage.hpp"
#include "base/stopwatch.hpp"

namespace tedit::actors {

namespace {

using solver_pointer = solver_actor::stateful_pointer<solver_state>;

expected<fem::backend*> open_device(kept_systems& systems, const std::string& name) {
  auto& device = systems.devices[name];
  if (!device) {
    auto opened = fem::open_backend(name);
    if (!opened)
      return fail(opened.error());
    device = std::move(*opened);
  }
  return device.get();
}

caf::result<solve_result> handle(solver_pointer self, job_id job, const solve_order& order) {
  return perform<solve_result>(
    self, job, order.base, {order.version, {}},
    [=, cache = self->state.jobs.cache, source = self->state.jobs.pages_handle,
     systems = self->state.systems](const job_input& in, const execution& run) {
      std::vector<page_ptr> shown;  // Others may fetch them until the result is forgotten.
      solve_listener listener;
      if (order.base.listener) {
        listener.on_frame = [&](const fem::cases_frame& frame) {
          caf::anon_send(order.base.listener,
                         job_frame{job, frame.iterations, frame.true_relative_residual});
        };
        listener.on_preview = [&](job_output<solve_result> preview) {
          for (const auto& p : preview.pages)
            cache->put(p);
          shown.insert(shown.end(), preview.pages.begin(), preview.pages.end());
          preview.result.source = source;
          caf::anon_send(order.base.listener, job_preview{job, std::move(preview.result)});
        };
      }
      auto output = solve(order, *systems, in.mesh, run, listener);
      if (output)
        output->pages.insert(output->pages.end(), shown.begin(), shown.end());
      return output;
    });
}

/// One order, as far as it does not depend on the device.
struct solve_task {
  const solve_order& order;
  version_ptr mesh;
  std::shared_ptr<const load_case_list> loads;
  kept_systems& systems;
  const execution& run;
  const solve_listener& listener;
  stopwatch total;
};

/// Refuses a solve for which there is not nearly memory enough before it makes its problem: what
/// this process holds goes for it, and the estimate may be a third too high. The backend looks
/// closer before it assembles.
expected<void> check_room(const solve_order& order, const fem::backend& device) {
  if (device.info().kind != "native")
    return {};
  auto room = available_memory();
  room.bytes += usage_of_this_process().resident_bytes;
  const auto least = static_cast<std::uint64_t>(estimate(order).memory_bytes * 2 / 3);
  const auto tets = static_cast<std::uint64_t>(tets_of(order.version));
  return check_memory(least, room, "the solve of " + std::to_string(tets) + " tets");
}

expected<job_output<solve_result>> solve_on(const solve_task& task, const std::string& device_name,
                                            const std::string& notice) {
  const auto device = open_device(task.systems, device_name);
  if (!device)
    return fail(device.error());
  if (auto ok = check_room(task.order, **device); !ok)
    return fail(ok.error());
  fem::solve_settings settings;
  settings.tolerance = task.order.tolerance;
  settings.energy_tolerance = task.order.energy_tolerance;
  const auto& chosen = (*device)->info().notice;
  const auto told = notice.empty() ? chosen : chosen.empty() ? notice : notice + "; " + chosen;
  const auto finish = [&](const fem::solved_cases& solved, bool interim) {
    return make_solve_output(*task.mesh, task.systems.session.last_set(), solved,
                             {interim, task.total.milliseconds(), told, task.order.of_several});
  };
  bool shown = false;
  const auto frame = [&](const fem::cases_frame& now) {
    if (task.listener.on_frame)
      task.listener.on_frame(now);
    if (!task.listener.on_preview || !now.recover || std::exchange(shown, true))
      return;
    if (auto fields = now.recover()) {
      fem::solved_cases preview{std::move(*fields), {}};
      if (preview.cases.size() > 1)
        preview.envelope = fem::make_envelope(preview.cases);
      task.listener.on_preview(finish(preview, true));
    }
  };
  const auto done = task.systems.session.solve(task.mesh, *task.loads, task.order.element_order,
                                               **device, settings, task.run, frame);
  if (!done)
    return fail(done.error());
  return finish(done->solved, false);
}

/// Nothing that stands on a lost device is used again.
void drop_device(kept_systems& systems, const std::string& name, const error& why) {
  logging::error("the device \"{}\" failed in a solve: {}", name, render(why));
  systems.session.forget();
  systems.devices.erase(name);
}

bool is_loss(const error& e) {
  return e.code == ec::device_lost || e.code == ec::device_unavailable;
}

}  // namespace

expected<job_output<solve_result>> solve(const solve_order& order, kept_systems& systems,
                                         const version_ptr& mesh, const execution& run,
                                         const solve_listener& listener) {
  const auto loads = order.load_cases.get();
  if (!loads)
    return fail(loads.error());
  const solve_task task{order, mesh, *loads, systems, run, listener, {}};
  auto first = solve_on(task, order.device, {});
  if (first || first.error().code != ec::device_lost)
    return first;
  drop_device(systems, order.device, first.error());
  auto again = solve_on(task, order.device, "the device was lost once and opened again");
  if (again || !is_loss(again.error()))
    return again;
  drop_device(systems, order.device, again.error());
  return solve_on(task, "cpu", "the device was lost; the processor solved instead");
}

solver_actor::behavior_type make_solver(solver_actor::stateful_pointer<solver_state> self,
                                        std::shared_ptr<page_cache> cache,
                                        const page_store_actor& pages) {
  self->state.jobs = make_jobs(self, worker_role::solver, std::move(cache), pages);
  return {[=](job_id job, const solve_order& order) { return handle(self, job, order); },
          [=](cancel_atom, job_id job) { self->state.jobs.cancel(job); },
          [=](status_atom) { return self->state.jobs.status(); }};
}

}  // namespace tedit::actors
