// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/export_step.hpp"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "cli/part_document.hpp"

namespace tedit::cli {

bool is_step(const std::string& file) {
  const auto suffix = std::filesystem::path(file).extension();
  return suffix == ".step" || suffix == ".stp";
}

int run_export_step(const step_options& options, session& s) {
  if (!is_document(options.document))
    return print_error(s, {ec::usage,
                           options.document + " is no document: a mesh has no CAD model",
                           "Begin with \"tedit import PART.step -o PART.tedit\", and edit that",
                           {}});
  const auto run = make_execution(s);
  const auto part = read_part(options.document, options.version, run.part(0, 0.5));
  if (!part)
    return print_error(s, part.error());
  if (!part->cad)
    return print_error(s, {ec::not_found,
                           options.document + " has no CAD model: the part came from a mesh",
                           "Begin with \"tedit import PART.step -o PART.tedit\", and edit that",
                           {}});
  if (!part->cad->model)
    return print_error(s, {ec::not_found,
                           "the CAD model is older than version " + std::to_string(part->number) +
                             ": " + part->cad->reason,
                           "Export an earlier version with --version, or the mesh "
                           "(\"tedit doc export\")",
                           {}});
  const auto& model = *part->cad->model;
  if (auto written = cad::write_step(model, options.output, {}, run.part(0.5, 1)); !written)
    return print_error(s, written.error());
  print_result(s,
               {{"file", options.output},
                {"format", "step"},
                {"version", part->number},
                {"solids", model.facts.solids.size()},
                {"faces", model.facts.faces.size()},
                {"deviation_m", part->cad->deviation_m}},
               options.output + ": " + std::to_string(model.facts.solids.size()) + " solids, " +
                 std::to_string(model.facts.faces.size()) + " faces, version " +
                 std::to_string(part->number) + "\n");
  return 0;
}

}  // namespace tedit::cli
