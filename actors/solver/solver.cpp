// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/solver/solver.hpp"

#include <utility>

#include <spdlog/spdlog.h>

#include "base/stopwatch.hpp"
#include "fem/fields.hpp"
#include "protocol/convert.hpp"
#include "protocol/report.hpp"

namespace tedit::actors {

namespace {

using solver_pointer = solver_actor::stateful_pointer<solver_state>;

expected<fem::backend*> open_device(solver_bench& bench, const std::string& name) {
  auto& device = bench.devices[name];
  if (!device) {
    auto opened = fem::open_backend(name);
    if (!opened)
      return fail(opened.error());
    device = std::move(*opened);
  }
  return device.get();
}

caf::result<solve_result> handle(solver_pointer self, job_id job, const solve_order& order) {
  const auto needed = pages_of(order.version);
  if (!needed)
    return to_caf(needed.error());
  auto cache = self->state.desk.cache;
  auto source = self->state.desk.pages_handle;
  auto bench = self->state.bench;
  return perform<solve_result>(
    self, job, order.base, *needed,
    [=](const page_set& pages, const execution& run) -> expected<job_output<solve_result>> {
      auto kept = std::make_shared<std::vector<std::shared_ptr<const void>>>();
      // Others may fetch the pages until the result is forgotten.
      const auto publish = [&](job_output<solve_result>& output) {
        for (const auto& f : *std::static_pointer_cast<const std::vector<field>>(output.keep))
          for (const auto& p : f.values.pages())
            cache->put(p);
        output.result.source = source;
        kept->push_back(output.keep);
      };
      solve_listener listener;
      if (order.base.listener) {
        listener.on_frame = [&](const fem::cases_frame& frame) {
          caf::anon_send(order.base.listener,
                         job_frame{job, frame.iterations, frame.true_relative_residual});
        };
        listener.on_preview = [&](job_output<solve_result> preview) {
          publish(preview);
          caf::anon_send(order.base.listener, job_preview{job, std::move(preview.result)});
        };
      }
      auto output = solve(order, *bench, pages, run, listener);
      if (output) {
        publish(*output);
        output->keep = kept;
      }
      return output;
    });
}

/// What a report says beside the numbers.
struct report_facts {
  bool interim = false;
  double total_ms = 0;
  std::string notice;
};

/// Fields and reports as others get them; what is interim goes to surfaces only.
job_output<solve_result> package(const mesh_version& mesh, const fem::case_set& set,
                                 const fem::solved_cases& solved, report_facts facts) {
  const auto range = facts.interim ? fem::field_range::vertices : fem::field_range::all;
  auto fields =
    std::make_shared<const std::vector<field>>(fem::make_fields(mesh, set, solved, range));
  auto outcome = make_outcome(mesh, set, solved, facts.interim, facts.total_ms);
  for (auto& report : outcome.cases)
    report.notice = facts.notice;
  job_output<solve_result> output;
  output.result.outcome = protocol::to_json(outcome);
  for (const auto& f : *fields)
    output.result.fields.push_back(make_ref(f));
  output.keep = fields;
  return output;
}

expected<std::vector<fem::load_case>> read_cases(const std::vector<std::string>& texts) {
  std::vector<fem::load_case> cases;
  for (const auto& text : texts) {
    auto one = protocol::load_case_from_json(text, "load case");
    if (!one)
      return fail(one.error());
    cases.push_back(std::move(*one));
  }
  return cases;
}

/// One order, as far as it does not depend on the device.
struct solve_task {
  const solve_order& order;
  version_ptr mesh;
  std::vector<fem::load_case> loads;
  solver_bench& bench;
  const execution& run;
  const solve_listener& listener;
  stopwatch total;
};

expected<job_output<solve_result>> solve_on(const solve_task& task, const std::string& device_name,
                                            const std::string& notice) {
  const auto device = open_device(task.bench, device_name);
  if (!device)
    return fail(device.error());
  fem::solve_settings settings;
  settings.tolerance = task.order.tolerance;
  settings.energy_tolerance = task.order.energy_tolerance;
  const auto& chosen = (*device)->info().notice;
  const auto told = notice.empty() ? chosen : chosen.empty() ? notice : notice + "; " + chosen;
  const auto finish = [&](const fem::solved_cases& solved, bool interim) {
    return package(*task.mesh, task.bench.session.last_set(), solved,
                   {interim, task.total.milliseconds(), told});
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
  const auto done = task.bench.session.solve(task.mesh, task.loads, task.order.element_order,
                                             **device, settings, task.run, frame);
  if (!done)
    return fail(done.error());
  return finish(done->solved, false);
}

/// Nothing that stands on a lost device is used again.
void drop_device(solver_bench& bench, const std::string& name, const error& why) {
  spdlog::error("the device \"{}\" failed in a solve: {}", name, render(why));
  bench.session.forget();
  bench.devices.erase(name);
}

bool is_loss(const error& e) {
  return e.code == ec::device_lost || e.code == ec::device_unavailable;
}

}  // namespace

expected<job_output<solve_result>> solve(const solve_order& order, solver_bench& bench,
                                         const page_set& pages, const execution& run,
                                         const solve_listener& listener) {
  const auto mesh = open_version(order.version, pages);
  if (!mesh)
    return fail(mesh.error());
  auto loads = read_cases(order.load_cases);
  if (!loads)
    return fail(loads.error());
  const solve_task task{order, *mesh, std::move(*loads), bench, run, listener, {}};
  auto first = solve_on(task, order.device, {});
  if (first || first.error().code != ec::device_lost)
    return first;
  drop_device(bench, order.device, first.error());
  auto again = solve_on(task, order.device, "the device was lost once and opened again");
  if (again || !is_loss(again.error()))
    return again;
  drop_device(bench, order.device, again.error());
  return solve_on(task, "cpu", "the device was lost; the processor solved instead");
}

solver_actor::behavior_type make_solver(solver_actor::stateful_pointer<solver_state> self,
                                        std::shared_ptr<page_cache> cache, page_store_actor pages) {
  self->state.desk = make_desk(self, "solver", std::move(cache), std::move(pages));
  return {[=](job_id job, const solve_order& order) { return handle(self, job, order); },
          [=](cancel_atom, job_id job) { self->state.desk.cancel(job); },
          [=](status_atom) { return self->state.desk.status(); }};
}

}  // namespace tedit::actors
