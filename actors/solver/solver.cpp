// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/solver/solver.hpp"

#include <utility>

#include "base/stopwatch.hpp"
#include "fem/fields.hpp"
#include "protocol/convert.hpp"
#include "protocol/report.hpp"

namespace tedit::actors {

namespace {

using self_pointer = solver_actor::stateful_pointer<solver_state>;

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

caf::result<solve_result> handle(self_pointer self, job_id job, const solve_order& order) {
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

/// Fields and reports as others get them.
job_output<solve_result> package(const mesh_version& mesh, const fem::case_set& set,
                                 const fem::solved_cases& solved, bool interim, double total_ms) {
  auto fields = std::make_shared<const std::vector<field>>(fem::make_fields(mesh, set, solved));
  job_output<solve_result> output;
  output.result.outcome = protocol::to_json(make_outcome(mesh, set, solved, interim, total_ms));
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

}  // namespace

expected<job_output<solve_result>> solve(const solve_order& order, solver_bench& bench,
                                         const page_set& pages, const execution& run,
                                         const solve_listener& listener) {
  const stopwatch total;
  const auto mesh = open_version(order.version, pages);
  if (!mesh)
    return fail(mesh.error());
  const auto loads = read_cases(order.load_cases);
  if (!loads)
    return fail(loads.error());
  const auto device = open_device(bench, order.device);
  if (!device)
    return fail(device.error());
  fem::solve_settings settings;
  settings.tolerance = order.tolerance;
  settings.energy_tolerance = order.energy_tolerance;
  const auto finish = [&](const fem::solved_cases& solved, bool interim) {
    return package(**mesh, bench.session.last_set(), solved, interim, total.milliseconds());
  };
  bool shown = false;
  const auto frame = [&](const fem::cases_frame& now) {
    if (listener.on_frame)
      listener.on_frame(now);
    if (!listener.on_preview || !now.recover || std::exchange(shown, true))
      return;
    if (auto fields = now.recover()) {
      fem::solved_cases preview{std::move(*fields), {}};
      if (preview.cases.size() > 1)
        preview.envelope = fem::make_envelope(preview.cases);
      listener.on_preview(finish(preview, true));
    }
  };
  const auto done =
    bench.session.solve(*mesh, *loads, order.element_order, **device, settings, run, frame);
  if (!done)
    return fail(done.error());
  return finish(done->solved, false);
}

solver_actor::behavior_type make_solver(solver_actor::stateful_pointer<solver_state> self,
                                        std::shared_ptr<page_cache> cache, page_store_actor pages) {
  self->state.desk = make_desk(self, "solver", std::move(cache), std::move(pages));
  return {[=](job_id job, const solve_order& order) { return handle(self, job, order); },
          [=](cancel_atom, job_id job) { self->state.desk.cancel(job); },
          [=](status_atom) { return self->state.desk.status(); }};
}

}  // namespace tedit::actors
