// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/modeling/modeling.hpp"

#include "ops/services/host_services.hpp"
#include "protocol/operation_message.hpp"

namespace tedit::actors {

namespace {

using modeling_pointer = modeling_actor::stateful_pointer<modeling_state>;

caf::result<import_result> handle(modeling_pointer self, job_id job, const import_order& order) {
  auto cache = self->state.desk.cache;
  auto source = self->state.desk.pages_handle;
  return perform<import_result>(
    self, job, order.base, order.file,
    [=](const page_set& pages, const execution& run) -> expected<job_output<import_result>> {
      auto output = read_mesh(order, pages, run);
      if (output) {
        cache->put(*std::static_pointer_cast<const mesh_version>(output->keep));
        output->result.source = source;
      }
      return output;
    });
}

caf::result<edit_candidate> handle(modeling_pointer self, job_id job, const edit_order& order) {
  const auto needed = pages_of(order.version);
  if (!needed)
    return to_caf(needed.error());
  auto cache = self->state.desk.cache;
  auto source = self->state.desk.pages_handle;
  auto plugins = self->state.plugins;
  auto services = self->state.services;
  return perform<edit_candidate>(
    self, job, order.base, *needed,
    [=](const page_set& pages, const execution& run) -> expected<job_output<edit_candidate>> {
      auto output = apply_operation(*plugins, *services, order, pages, run);
      if (output) {
        cache->put(*std::static_pointer_cast<const mesh_version>(output->keep));
        output->result.source = source;
      }
      return output;
    });
}

caf::result<export_result> handle(modeling_pointer self, job_id job, const export_order& order) {
  auto needed = pages_of(order.version);
  if (!needed)
    return to_caf(needed.error());
  for (const auto& f : order.fields)
    needed->insert(needed->end(), f.pages.begin(), f.pages.end());
  auto cache = self->state.desk.cache;
  auto source = self->state.desk.pages_handle;
  return perform<export_result>(
    self, job, order.base, *needed,
    [=](const page_set& pages, const execution& run) -> expected<job_output<export_result>> {
      auto output = write_mesh(order, pages, run);
      if (output) {
        for (const auto& p : *std::static_pointer_cast<const std::vector<page_ptr>>(output->keep))
          cache->put(p);
        output->result.source = source;
      }
      return output;
    });
}

caf::result<select_result> handle(modeling_pointer self, job_id job, const select_order& order) {
  const auto needed = pages_of(order.version);
  if (!needed)
    return to_caf(needed.error());
  return perform<select_result>(
    self, job, order.base, *needed,
    [=](const page_set& pages, const execution& run) { return find_surfaces(order, pages, run); });
}

std::string describe(const ops::catalogue& plugins) {
  std::vector<std::pair<ops::operation_description, std::string>> operations;
  std::vector<std::pair<std::string, std::string>> refused;
  for (const auto& entry : plugins.entries())
    operations.emplace_back(entry.description, entry.plugin);
  for (const auto& row : plugins.refused())
    refused.emplace_back(row.file.string(), row.reason);
  return protocol::catalogue_to_json(operations, refused);
}

}  // namespace

modeling_actor::behavior_type make_modeling(modeling_actor::stateful_pointer<modeling_state> self,
                                            std::shared_ptr<page_cache> cache,
                                            page_store_actor pages,
                                            std::shared_ptr<const ops::catalogue> plugins,
                                            std::optional<process_usage> at_start) {
  self->state.desk = make_desk(self, "modeling", std::move(cache), std::move(pages));
  self->state.desk.at_start = std::move(at_start);
  self->state.plugins = std::move(plugins);
  self->state.services = ops::make_host_services();
  return {[=](job_id job, const import_order& order) { return handle(self, job, order); },
          [=](job_id job, const edit_order& order) { return handle(self, job, order); },
          [=](job_id job, const export_order& order) { return handle(self, job, order); },
          [=](job_id job, const select_order& order) { return handle(self, job, order); },
          [=](catalog_atom) { return describe(*self->state.plugins); },
          [=](cancel_atom, job_id job) { self->state.desk.cancel(job); },
          [=](status_atom) { return self->state.desk.status(); }};
}

}  // namespace tedit::actors
