// SPDX-License-Identifier: AGPL-3.0-or-later
#include <utility>

#include <caf/stateful_actor.hpp>

#include "actors/solver/solve_output.hpp"
#include "base/stopwatch.hpp"
#include "fem/given_displacement.hpp"
#include "node/joined.hpp"

namespace tedit::node {

namespace {

using namespace actors;

struct own_solver_state {
  worker_jobs jobs;
  solver_offer offer;

  static inline const char* name = "own_solver";
};

using own_solver_pointer = solver_actor::stateful_pointer<own_solver_state>;

expected<fem::solved_cases> solve_all(fem::case_set& set, const solver_offer& offer,
                                      const execution& run) {
  const stopwatch clock;
  const fem::element_operator k(set.problem);
  fem::solved_cases solved;
  solved.assembly_ms = clock.milliseconds();
  for (std::size_t c = 0; c < set.cases.size(); ++c) {
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the solve was cancelled");
    set.stand(c);
    const stopwatch of_case;
    auto displacement = offer.solve(set.problem, run);
    if (!displacement)
      return fail(displacement.error());
    solved.solve_ms += of_case.milliseconds();
    const stopwatch recovering;
    auto one = fem::solution_of(set.problem, k, std::move(*displacement), offer.device);
    if (!one)
      return fail(one.error());
    solved.recovery_ms += recovering.milliseconds();
    solved.cases.push_back(std::move(*one));
  }
  if (solved.cases.size() > 1)
    solved.envelope = fem::make_envelope(solved.cases);
  return solved;
}

expected<job_output<solve_result>> solve_order_with(const solver_offer& offer,
                                                    const solve_order& order,
                                                    const version_ptr& mesh, const execution& run) {
  const stopwatch total;
  const auto loads = order.load_cases.get();
  if (!loads)
    return fail(loads.error());
  auto set = fem::make_cases(*mesh, **loads, order.element_order);
  if (!set)
    return fail(set.error());
  auto solved = solve_all(*set, offer, run);
  if (!solved)
    return fail(solved.error());
  return make_solve_output(*mesh, *set, *solved, {.total_ms = total.milliseconds()});
}

solver_actor::behavior_type own_solver(own_solver_pointer self, std::shared_ptr<page_cache> cache,
                                       const page_store_actor& pages, solver_offer offer) {
  self->state.jobs = make_jobs(self, worker_role::solver, std::move(cache), pages);
  self->state.offer = std::move(offer);
  return {[=](job_id job, const solve_order& order) {
            return perform<solve_result>(
              self, job, order.base, {order.version, {}},
              [order, offer = self->state.offer](const job_input& in, const execution& run) {
                return solve_order_with(offer, order, in.mesh, run);
              });
          },
          [=](cancel_atom, job_id job) { self->state.jobs.cancel(job); },
          [=](status_atom) { return self->state.jobs.status(); }};
}

}  // namespace

expected<void> serve_solver(const place& where, const solver_offer& offer,
                            const cancel_token& stop) {
  auto joined = join(where, stop);
  if (!joined)
    return unless_stopped(joined.error(), stop);
  auto& node = **joined;
  const auto worker =
    caf::actor_cast<caf::actor>(node.system().spawn(own_solver, node.cache(), node.pages(), offer));
  node.own(worker);
  auto facts = facts_of_this_machine(offer.device, TEDIT_VERSION);
  facts.own_device = offer.device;
  if (auto ok = enlist_at(node.self(), node.entrance(), {"solver", facts, worker}); !ok)
    return unless_stopped(ok.error(), stop);
  bool leaving = false;
  while (node.stays(std::chrono::milliseconds(200)))
    if (stop.cancelled() && !std::exchange(leaving, true))
      node.self()->send(node.entrance(), retirement{"it is being stopped"});
  return unless_stopped(gone(), stop);
}

}  // namespace tedit::node
