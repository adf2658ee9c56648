// SPDX-License-Identifier: AGPL-3.0-or-later
#include <spdlog/spdlog.h>

#include "actors/modeling/modeling.hpp"
#include "base/stopwatch.hpp"
#include "mesh/features/select.hpp"
#include "mesh/io/field_writer.hpp"
#include "mesh/io/import.hpp"
#include "mesh/io/msh_writer.hpp"
#include "mesh/io/stl_writer.hpp"
#include "ops/loader/operation_log.hpp"
#include "ops/sdk/most_that_works.hpp"
#include "protocol/operation_message.hpp"
#include "protocol/report.hpp"
#include "protocol/selection_message.hpp"

namespace tedit::actors {

namespace {

/// What the fields are worth, as `tedit solve` notes it.
std::vector<std::pair<std::string, std::string>> notes_of(const solve_outcome& outcome) {
  const auto& first = outcome.cases.front();
  const bool preview = outcome.envelope ? outcome.envelope->preview : first.preview;
  const char* quality = first.element_order < 2 ? "preview (linear tets)"
                        : preview               ? "preview (quadratic tets, stopped early)"
                                                : "final (quadratic tets)";
  std::vector<std::pair<std::string, std::string>> notes{{"quality", quality},
                                                         {"device", first.device}};
  if (!outcome.envelope)
    notes.emplace_back("load_case", first.load_case);
  else
    for (std::size_t c = 0; c < outcome.cases.size(); ++c)
      notes.emplace_back("case_" + std::to_string(c), outcome.cases[c].load_case);
  return notes;
}

expected<void> write_fields(std::string* to, const mesh_version& mesh, const export_order& order,
                            const page_set& pages) {
  std::vector<field> fields;
  for (const auto& ref : order.fields) {
    auto opened = open_field(ref, pages);
    if (!opened)
      return fail(opened.error());
    fields.push_back(std::move(*opened));
  }
  std::vector<std::pair<std::string, std::string>> notes{{"version_id", to_hex(mesh.id())}};
  if (!order.outcome.empty()) {
    const auto outcome = protocol::solve_outcome_from_json(order.outcome);
    if (!outcome)
      return fail(outcome.error());
    for (const auto& note : notes_of(*outcome))
      notes.push_back(note);
  }
  return write_vtu(to, mesh, fields, notes);
}

}  // namespace

expected<job_output<import_result>> read_mesh(const import_order& order, const page_set& pages,
                                              const execution& run) {
  run.report(0, "reading " + order.file_name);
  const stopwatch clock;
  const auto bytes = join(order.file, order.size, pages);
  if (!bytes)
    return fail(bytes.error());
  auto mesh = import_mesh_bytes(*bytes, order.length_unit);
  if (!mesh) {
    auto e = mesh.error();
    e.where = order.file_name + (e.where.empty() ? "" : ": " + e.where);
    return fail(std::move(e));
  }
  job_output<import_result> output;
  output.result.version = make_ref(*mesh->version);
  output.result.warnings = std::move(mesh->warnings);
  output.result.import_ms = clock.milliseconds();
  output.keep = mesh->version;
  return output;
}

expected<job_output<edit_candidate>> apply_operation(const ops::catalogue& plugins,
                                                     ops::services& services,
                                                     const edit_order& order, const page_set& pages,
                                                     const execution& run) {
  const stopwatch clock;
  const auto base = open_version(order.version, pages);
  if (!base)
    return fail(base.error());
  const auto parameters = protocol::parameters_from_json(order.parameters);
  if (!parameters)
    return fail(parameters.error());
  ops::context ctx;
  ctx.host = &services;
  ctx.run = run;
  ctx.search_s = order.find_most ? ops::refusal_search_s : 0;
  ctx.log =
    ops::operation_log(order.operation, [](const std::string& line) { spdlog::info("{}", line); });
  auto edit =
    ops::run_operation(plugins, order.operation, **base, {order.surfaces}, *parameters, ctx);
  if (!edit)
    return fail(edit.error());
  job_output<edit_candidate> output;
  auto& result = output.result;
  result.version = make_ref(*edit->candidate);
  const auto* first = reinterpret_cast<const char*>(edit->touched.data());
  result.touched.assign(first, first + edit->touched.size() * sizeof(tet_id));
  result.volume_change = edit->volume_change;
  result.improve = {static_cast<std::int32_t>(edit->improve),
                    edit->thorough.target,
                    edit->thorough.insert_below,
                    edit->thorough.harmonic,
                    edit->thorough.tolerance.absolute,
                    edit->thorough.tolerance.relative,
                    edit->thorough.rounds};
  result.surfaces_used = edit->surfaces_used;
  result.notices = edit->notices;
  for (const auto& f : edit->figures)
    result.figures.push_back({f.id, f.value, f.unit, f.help});
  result.quality_floor = edit->quality_floor;
  result.bodies_added = edit->bodies_added;
  result.operation_ms = clock.milliseconds();
  output.keep = edit->candidate;
  return output;
}

expected<job_output<select_result>> find_surfaces(const select_order& order, const page_set& pages,
                                                  const execution& run) {
  const auto mesh = open_version(order.version, pages);
  if (!mesh)
    return fail(mesh.error());
  const auto query = protocol::selection_query_from_json(order.query);
  if (!query)
    return fail(query.error());
  const auto features = select_surfaces(**mesh, *query, run);
  if (!features)
    return fail(features.error());
  job_output<select_result> output;
  output.result.features = protocol::to_json(*features);
  return output;
}

expected<job_output<export_result>> write_mesh(const export_order& order, const page_set& pages,
                                               const execution& run) {
  run.report(0, "writing " + order.format);
  const auto mesh = open_version(order.version, pages);
  if (!mesh)
    return fail(mesh.error());
  std::string bytes;
  expected<void> written =
    fail(ec::invalid_argument, "there is no file format \"" + order.format + "\"",
         "Take msh, stl or vtu");
  if (order.format == "msh")
    written = write_msh(&bytes, **mesh, order.length_unit);
  else if (order.format == "stl")
    written = write_stl(&bytes, **mesh, order.length_unit);
  else if (order.format == "vtu")
    written = write_fields(&bytes, **mesh, order, pages);
  if (!written)
    return fail(written.error());
  auto cut_up = std::make_shared<const std::vector<page_ptr>>(cut(bytes));
  job_output<export_result> output;
  output.result.size = bytes.size();
  for (const auto& p : *cut_up)
    output.result.pages.push_back(p->id());
  output.keep = cut_up;
  return output;
}

}  // namespace tedit::actors
