// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/optimizer/optimizer.hpp"

#include "edit/make_edit.hpp"

namespace tedit::actors {

namespace {

using optimizer_pointer = optimizer_actor::stateful_pointer<optimizer_state>;

caf::result<check_result> handle(optimizer_pointer self, job_id job, const check_order& order) {
  const auto candidate = pages_of(order.candidate.version);
  if (!candidate)
    return to_caf(candidate.error());
  return perform<check_result>(
    self, job, order.base, {order.before, *candidate},
    [=](const job_input& in, const execution& run) { return check(order, in, run); });
}

/// What a worker that ran a plugin says is out of range. Errors: `protocol_error`.
expected<void> check_range(const ops::edit_result& said) {
  if (said.improve < improvement::none || said.improve > improvement::thorough ||
      said.thorough.rounds < 0 || said.thorough.rounds > 100)
    return fail(ec::protocol_error, "there is no such improvement");
  return {};
}

}  // namespace

expected<job_output<check_result>> check(const check_order& order, const job_input& in,
                                         const execution& run) {
  const auto mesh = open_version(order.candidate.version, in.pages);
  if (!mesh)
    return fail(ec::postcondition_failed,
                "the operation made no readable version: " + mesh.error().message,
                "This is a defect of the operation: please report it");
  if (auto ok = check_range(order.candidate.said); !ok)
    return fail(ok.error());
  const auto wanted = order.wanted.get();
  const auto load_cases = order.load_cases.get();
  if (!wanted || !load_cases)
    return fail(wanted ? load_cases.error() : wanted.error());
  edit_candidate candidate{order.candidate.said, order.candidate.operation_ms};
  candidate.made.candidate = *mesh;
  auto done = order.draft ? draft_of(in.mesh, candidate, **wanted, **load_cases)
                          : check_candidate(in.mesh, candidate, **wanted, **load_cases, run);
  if (!done)
    return fail(done.error());
  job_output<check_result> output;
  output.result.version = make_ref(done->version);
  output.result.load_cases = wire_value(std::move(done->load_cases));
  output.result.report = wire_value(std::move(done->report));
  output.keep_pages(done->version);
  return output;
}

optimizer_actor::behavior_type make_optimizer(
  optimizer_actor::stateful_pointer<optimizer_state> self, std::shared_ptr<page_cache> cache,
  const page_store_actor& pages) {
  self->state.jobs = make_jobs(self, worker_role::optimizer, std::move(cache), pages);
  return {[=](job_id job, const check_order& order) { return handle(self, job, order); },
          [=](cancel_atom, job_id job) { self->state.jobs.cancel(job); },
          [=](status_atom) { return self->state.jobs.status(); }};
}

}  // namespace tedit::actors
