// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/import_mesh_file.hpp"

#include <nlohmann/json.hpp>

#include "actors/cad/first_version.hpp"
#include "base/stopwatch.hpp"
#include "cli/deck_loads.hpp"
#include "cli/load_case_files.hpp"
#include "cli/mesh_report.hpp"
#include "cli/part_document.hpp"
#include "cli/part_input.hpp"
#include "fem/problem_parts.hpp"
#include "mesh/io/formats.hpp"

namespace tedit::cli {

namespace {

/// A deck brings its own, unless others are told.
expected<std::vector<fem::load_case>> cases_for(const mesh_import& wanted,
                                                const imported_mesh& mesh, session& s) {
  auto told = first_load_cases(wanted.load_cases, wanted.output);
  if (!told || !told->empty() || mesh.loads.empty() || !is_document(wanted.output))
    return told;
  auto found = load_case_of(mesh);
  if (!found)
    return fail(found.error());
  for (const auto& remark : found->remarks)
    notice(s, "note: " + remark);
  return std::vector{std::move(found->loads)};
}

expected<void> write_import(const mesh_import& wanted, const imported_mesh& mesh,
                            const std::vector<fem::load_case>& load_cases) {
  if (wanted.output.empty())
    return {};
  if (is_document(wanted.output))
    return actors::create_document(wanted.output, {.mesh = mesh.version,
                                                   .model = {},
                                                   .file_name = wanted.file.filename().string(),
                                                   .warnings = mesh.warnings,
                                                   .length_unit = mesh.length_unit,
                                                   .load_cases = load_cases});
  const auto format = output_format(wanted.output);
  if (!format)
    return fail(format.error());
  return write_as((*format)->name, wanted.output, *mesh.version,
                  {.length_unit = "mm", .title = wanted.file.stem().string()});
}

nlohmann::ordered_json to_json(const imported_mesh& mesh, const mesh_report& report,
                               const std::vector<fem::load_case>& load_cases, double total_ms) {
  auto json = to_json(*mesh.version, report);
  for (const auto* rows : {"surfaces", "regions"})
    for (auto& row : json[rows])
      row["colour"] = nullptr;
  json["length_unit"] = mesh.length_unit;
  json["load_cases"] = nlohmann::ordered_json::array();
  for (const auto& one : load_cases)
    json["load_cases"].push_back(one.name);
  json["warnings"] = mesh.warnings;
  json["timings_ms"] = {
    {"read", mesh.read_ms}, {"mesh", 0.0}, {"repair", 0.0}, {"total", total_ms}};
  return json;
}

std::string describe(const mesh_import& wanted, const imported_mesh& mesh,
                     const std::vector<fem::load_case>& load_cases) {
  std::string text = wanted.file.string() + ": " + std::to_string(mesh.version->tet_count()) +
                     " tets, " + std::to_string(mesh.version->surfaces().size()) +
                     " surfaces; load cases: " + names_of(load_cases) + "\n";
  if (!wanted.output.empty())
    text += wanted.output +
            (is_document(wanted.output) ? ": a document with the mesh\n" : ": the mesh\n");
  return text;
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& file) {
  const auto suffix = file.extension().string();
  const auto* format = suffix.empty() ? nullptr : format_of_suffix(suffix.substr(1));
  return format && format->reads;
}

expected<std::vector<fem::load_case>> first_load_cases(const std::vector<std::string>& files,
                                                       const std::string& output) {
  if (!files.empty() && !is_document(output))
    return fail(ec::usage, "--load-case goes into a document, and none is written",
                "Write one: -o PART.tedit");
  return read_load_cases(files);
}

expected<void> check_load_cases(const mesh_version& mesh,
                                const std::vector<fem::load_case>& load_cases) {
  for (const auto& one : load_cases)
    if (const auto ok = fem::check_surfaces(mesh, one); !ok) {
      auto why = ok.error();
      why.message = "load case \"" + one.name + "\": " + why.message;
      return fail(std::move(why));
    }
  return {};
}

int run_import_mesh(const mesh_import& wanted, session& s) {
  const stopwatch total;
  const auto mesh = import_mesh(wanted.file, wanted.length_unit);
  if (!mesh)
    return print_error(s, mesh.error());
  for (const auto& warning : mesh->warnings)
    notice(s, "note: " + warning);
  const auto load_cases = cases_for(wanted, *mesh, s);
  if (!load_cases)
    return print_error(s, load_cases.error());
  if (const auto ok = check_load_cases(*mesh->version, *load_cases); !ok)
    return print_error(s, ok.error());
  if (const auto written = write_import(wanted, *mesh, *load_cases); !written)
    return print_error(s, written.error());
  const auto json =
    to_json(*mesh, make_mesh_report(*mesh->version), *load_cases, total.milliseconds());
  print_result(s, json, describe(wanted, *mesh, *load_cases));
  return 0;
}

}  // namespace tedit::cli
