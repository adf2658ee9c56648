// SPDX-License-Identifier: AGPL-3.0-or-later

#include "actors/modeling/modeling.hpp"
#include "base/logging/logging.hpp"
#include "base/stopwatch.hpp"
#include "decks/deck_file.hpp"
#include "edit/make_edit.hpp"
#include "mesh/features/select.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"

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

/// With the order's fields: a session names them for a format that keeps fields alone.
expected<file_terms> terms_of(const export_order& order, const page_set& pages) {
  file_terms terms{order.length_unit, {}, {{"version_id", to_hex(order.version.id)}}};
  for (const auto& ref : order.fields) {
    auto opened = open_field(ref, pages);
    if (!opened)
      return fail(opened.error());
    terms.fields.push_back(std::move(*opened));
  }
  if (!terms.fields.empty()) {
    const auto outcome = order.outcome.get();
    if (!outcome)
      return fail(outcome.error());
    for (const auto& note : notes_of(**outcome))
      terms.notes.push_back(note);
  }
  return terms;
}

}  // namespace

expected<job_output<import_result>> read_mesh(const import_order& order, const page_set& pages,
                                              const execution& run) {
  run.report(0, "reading " + order.file_name);
  const stopwatch clock;
  auto bytes = join(order.file, order.size, pages);
  if (!bytes)
    return fail(bytes.error());
  auto mesh = import_mesh_bytes(*std::move(bytes), order.length_unit);
  if (!mesh) {
    auto e = mesh.error();
    e.where = order.file_name + (e.where.empty() ? "" : ": " + e.where);
    return fail(std::move(e));
  }
  job_output<import_result> output;
  output.result.version = make_ref(mesh->version);
  output.result.warnings = std::move(mesh->warnings);
  output.result.import_ms = clock.milliseconds();
  output.keep_pages(mesh->version);
  return output;
}

expected<job_output<operation_result>> apply_operation(
  const ops::catalogue& plugins, const std::shared_ptr<ops::services>& services,
  const edit_order& order, const version_ptr& base, const execution& run) {
  const auto wanted = order.wanted.get();
  if (!wanted)
    return fail(wanted.error());
  const operation_place place{services, [](const std::string& line) { logging::info("{}", line); },
                              order.find_most};
  auto candidate = run_operation(plugins, base, **wanted, place, run);
  if (!candidate)
    return fail(candidate.error());
  const auto mesh = std::move(candidate->made.candidate);
  job_output<operation_result> output;
  output.result.version = make_ref(mesh);
  output.result.said = std::move(candidate->made);
  output.result.operation_ms = candidate->operation_ms;
  output.keep_pages(mesh);
  return output;
}

expected<job_output<select_result>> find_surfaces(const select_order& order,
                                                  const version_ptr& mesh, const execution& run) {
  const auto query = order.query.get();
  if (!query)
    return fail(query.error());
  auto features = select_surfaces(*mesh, **query, run);
  if (!features)
    return fail(features.error());
  job_output<select_result> output;
  output.result.features = wire_value(std::move(*features));
  return output;
}

expected<job_output<export_result>> write_mesh(const export_order& order, const job_input& in,
                                               const execution& run) {
  run.report(0, "writing " + order.format);
  const auto terms = terms_of(order, in.pages);
  if (!terms)
    return fail(terms.error());
  const auto loads = order.loads.get();
  if (!loads)
    return fail(loads.error());
  std::string bytes;
  const auto written =
    (*loads)->empty()
      ? write_as(order.format, &bytes, *in.mesh, *terms)
      : decks::write_deck(order.format, &bytes, *in.mesh, (*loads)->front(),
                          (*loads)->front().name + " on version " + to_hex(order.version.id));
  if (!written)
    return fail(written.error());
  job_output<export_result> output;
  output.result.size = bytes.size();
  output.pages = cut(bytes);
  for (const auto& p : output.pages)
    output.result.pages.push_back(p->id());
  return output;
}

}  // namespace tedit::actors
