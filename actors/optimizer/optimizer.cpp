// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/optimizer/optimizer.hpp"

#include "actors/optimizer/finish.hpp"
#include "protocol/convert.hpp"

namespace tedit::actors {

namespace {

using optimizer_pointer = optimizer_actor::stateful_pointer<optimizer_state>;

caf::result<finish_result> handle(optimizer_pointer self, job_id job, const finish_order& order) {
  auto needed = pages_of(order.before);
  const auto more = pages_of(order.candidate.version);
  if (!needed || !more)
    return to_caf(needed ? more.error() : needed.error());
  needed->insert(needed->end(), more->begin(), more->end());
  auto cache = self->state.desk.cache;
  auto source = self->state.desk.pages_handle;
  return perform<finish_result>(
    self, job, order.base, *needed,
    [=](const page_set& pages, const execution& run) -> expected<job_output<finish_result>> {
      auto output = finish(order, pages, run);
      if (output) {
        cache->put(*std::static_pointer_cast<const mesh_version>(output->keep));
        output->result.source = source;
      }
      return output;
    });
}

expected<edit_claim> claim_of(const edit_candidate& candidate) {
  if (candidate.touched.size() % sizeof(tet_id) != 0)
    return fail(ec::protocol_error, "the list of touched tets is cut off");
  edit_claim claim;
  claim.volume_change = candidate.volume_change;
  claim.quality_floor = candidate.quality_floor;
  claim.bodies_added = candidate.bodies_added;
  claim.touched.resize(candidate.touched.size() / sizeof(tet_id));
  std::memcpy(claim.touched.data(), candidate.touched.data(), candidate.touched.size());
  return claim;
}

expected<improve_request> request_of(const improve_order& order) {
  if (order.how < 0 || order.how > static_cast<int>(improvement::thorough) || order.rounds < 0 ||
      order.rounds > 100)
    return fail(ec::protocol_error, "there is no such improvement");
  thorough_settings settings;
  settings.target = order.target;
  settings.insert_below = order.insert_below;
  settings.harmonic = order.harmonic;
  settings.tolerance = {order.absolute_tolerance, order.relative_tolerance};
  settings.rounds = order.rounds;
  return improve_request(static_cast<improvement>(order.how), settings);
}

}  // namespace

expected<job_output<finish_result>> finish(const finish_order& order, const page_set& pages,
                                           const execution& run) {
  const auto base = open_version(order.before, pages);
  if (!base)
    return fail(base.error());
  const auto candidate = open_version(order.candidate.version, pages);
  if (!candidate)
    return fail(ec::postcondition_failed,
                "the operation made no readable version: " + candidate.error().message,
                "This is a defect of the operation: please report it");
  const auto claim = claim_of(order.candidate);
  if (!claim)
    return fail(claim.error());
  const auto wanted = request_of(order.candidate.improve);
  if (!wanted)
    return fail(wanted.error());
  if (order.load_policy < 0 || order.load_policy > static_cast<int>(fem::load_policy::refuse))
    return fail(ec::protocol_error, "there is no such policy for loads");
  const fem::carry_settings settings{static_cast<fem::load_policy>(order.load_policy),
                                     order.keep_traction};
  std::vector<fem::load_case> load_cases;
  for (const auto& text : order.load_cases) {
    auto loads = protocol::load_case_from_json(text, "load case");
    if (!loads)
      return fail(loads.error());
    load_cases.push_back(std::move(*loads));
  }
  auto done = finish_candidate(*base, *candidate, *claim, *wanted, load_cases, settings, run);
  if (!done)
    return fail(done.error());
  done->report.surfaces_used = order.candidate.surfaces_used;
  done->report.notices = order.candidate.notices;
  for (const auto& f : order.candidate.figures)
    done->report.figures.push_back({f.id, f.value, f.unit, f.help});
  done->report.operation_ms = order.candidate.operation_ms;
  job_output<finish_result> output;
  output.result.version = make_ref(*done->version);
  for (const auto& loads : done->load_cases)
    output.result.load_cases.push_back(protocol::load_case_to_json(loads));
  output.result.report = protocol::to_json(done->report);
  output.keep = done->version;
  return output;
}

optimizer_actor::behavior_type make_optimizer(
  optimizer_actor::stateful_pointer<optimizer_state> self, std::shared_ptr<page_cache> cache,
  page_store_actor pages) {
  self->state.desk = make_desk(self, "optimizer", std::move(cache), std::move(pages));
  return {[=](job_id job, const finish_order& order) { return handle(self, job, order); },
          [=](cancel_atom, job_id job) { self->state.desk.cancel(job); },
          [=](status_atom) { return self->state.desk.status(); }};
}

}  // namespace tedit::actors
