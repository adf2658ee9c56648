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

expected<written_step> export_step_file(const step_options& options, const execution& run) {
  constexpr const char* begin_with_cad =
    "Begin with \"tedit import PART.step -o PART.tedit\", and edit that";
  if (!is_document(options.document))
    return fail(ec::usage, options.document + " is no document: a mesh has no CAD model",
                begin_with_cad);
  const auto part = read_part(options.document, options.version, run.part(0, 0.5));
  if (!part)
    return fail(part.error());
  if (!part->cad)
    return fail(ec::not_found, options.document + " has no CAD model: the part came from a mesh",
                begin_with_cad);
  if (!part->cad->model)
    return fail(ec::not_found,
                "the CAD model is older than version " + std::to_string(part->number) + ": " +
                  part->cad->reason,
                "Export an earlier version with --version, or the mesh (\"tedit doc export\")");
  const auto& model = *part->cad->model;
  if (auto written = cad::write_step(model, options.output, {}, run.part(0.5, 1)); !written)
    return fail(written.error());
  return written_step{part->number, model.facts.solids.size(), model.facts.faces.size(),
                      part->cad->deviation_m};
}

int run_export_step(const step_options& options, session& s) {
  const auto done = export_step_file(options, make_execution(s));
  if (!done)
    return print_error(s, done.error());
  print_result(s,
               {{"file", options.output},
                {"format", "step"},
                {"version", done->version},
                {"solids", done->solids},
                {"faces", done->faces},
                {"deviation_m", done->deviation_m}},
               options.output + ": " + std::to_string(done->solids) + " solids, " +
                 std::to_string(done->faces) + " faces, version " + std::to_string(done->version) +
                 "\n");
  return 0;
}

}  // namespace tedit::cli
