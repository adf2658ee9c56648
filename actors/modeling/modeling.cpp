// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/modeling/modeling.hpp"

#include "ops/services/host_services.hpp"

namespace tedit::actors {

namespace {

using modeling_pointer = modeling_actor::stateful_pointer<modeling_state>;

caf::result<import_result> handle(modeling_pointer self, job_id job, const import_order& order) {
  return perform<import_result>(
    self, job, order.base, {{}, order.file},
    [=](const job_input& in, const execution& run) { return read_mesh(order, in.pages, run); });
}

caf::result<operation_result> handle(modeling_pointer self, job_id job, const edit_order& order) {
  return perform<operation_result>(
    self, job, order.base, {order.version, {}},
    [=, plugins = self->state.plugins,
     services = order.draft ? self->state.draft_services : self->state.services](
      const job_input& in, const execution& run) {
      return apply_operation(*plugins, services, order, in.mesh, run);
    });
}

caf::result<export_result> handle(modeling_pointer self, job_id job, const export_order& order) {
  return perform<export_result>(
    self, job, order.base, {order.version, pages_of(order.fields)},
    [=](const job_input& in, const execution& run) { return write_mesh(order, in, run); });
}

caf::result<select_result> handle(modeling_pointer self, job_id job, const select_order& order) {
  return perform<select_result>(
    self, job, order.base, {order.version, {}},
    [=](const job_input& in, const execution& run) { return find_surfaces(order, in.mesh, run); });
}

operation_catalogue describe(const ops::catalogue& plugins) {
  operation_catalogue result;
  for (const auto& entry : plugins.entries())
    result.operations.push_back({entry.description, entry.plugin});
  for (const auto& row : plugins.refused())
    result.refused.push_back({row.file.string(), row.reason});
  return result;
}

}  // namespace

modeling_actor::behavior_type make_modeling(modeling_actor::stateful_pointer<modeling_state> self,
                                            std::shared_ptr<page_cache> cache,
                                            const page_store_actor& pages,
                                            std::shared_ptr<const ops::catalogue> plugins,
                                            std::optional<process_usage> at_start) {
  self->state.jobs = make_jobs(self, worker_role::modeling, std::move(cache), pages);
  self->state.jobs.at_start = at_start;
  self->state.plugins = std::move(plugins);
  self->state.services = ops::make_host_services();
  self->state.draft_services = ops::make_draft_services();
  return {
    [=](job_id job, const import_order& order) { return handle(self, job, order); },
    [=](job_id job, const edit_order& order) { return handle(self, job, order); },
    [=](job_id job, const export_order& order) { return handle(self, job, order); },
    [=](job_id job, const select_order& order) { return handle(self, job, order); },
    [=](catalog_atom) { return wire_value<operation_catalogue>(describe(*self->state.plugins)); },
    [=](cancel_atom, job_id job) { self->state.jobs.cancel(job); },
    [=](status_atom) { return self->state.jobs.status(); }};
}

}  // namespace tedit::actors
