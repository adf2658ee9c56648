// SPDX-License-Identifier: AGPL-3.0-or-later
#include <chrono>
#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/stopwatch.hpp"
#include "cli/command.hpp"
#include "cli/parameters.hpp"
#include "cli/part_document.hpp"
#include "cli/reports.hpp"
#include "edit/make_edit.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"
#include "sandbox/sandbox.hpp"

namespace tedit::cli {

namespace {

struct edit_options {
  std::string mesh;
  edit_request request;
  std::vector<std::string> pairs;
  std::string load_case;
  std::string loads = "drop";
  std::string output;
  std::string length_unit = "mm";
  double time_limit_s = 120;
};

/// An edit that changes more of the part than this is pointed out.
constexpr double large_share = 0.1;

/// Of the part's volume: below zero where material goes.
double changed_share(const mesh_version& base, const edit_report& report) {
  return report.volume_change / total_volume(base);
}

void warn_of_large_change(double share, session& s) {
  if (std::abs(share) > large_share)
    notice(s, "WARNING: the edit " + std::string(share < 0 ? "takes off " : "adds ") +
                pretty(100 * std::abs(share), 3) + " % of the part");
}

/// A process of its own, because plugins may crash or hang.
operation_place place_of(const edit_options& options, const session& s) {
  operation_place place;
  place.child.emplace().time =
    std::chrono::milliseconds(static_cast<std::int64_t>(1000 * options.time_limit_s));
  place.log = [&s](const std::string& line) { notice(s, line); };
  return place;
}

/// What is edited: a mesh, or the current version of a document.
struct edited_part {
  version_ptr mesh;
  std::vector<fem::load_case> load_cases;
  std::optional<cad_state> cad;
};

expected<edited_part> read_edited(const edit_options& options, session& s) {
  edited_part part;
  if (is_document(options.mesh)) {
    auto found = read_part(options.mesh, {}, make_execution(s));
    if (!found)
      return fail(found.error());
    return edited_part{std::move(found->mesh), std::move(found->load_cases), std::move(found->cad)};
  }
  auto imported = import_mesh(options.mesh, options.length_unit);
  if (!imported)
    return fail(imported.error());
  for (const auto& warning : imported->warnings)
    notice(s, "note: " + warning);
  return edited_part{std::move(imported->version), {}, {}};
}

/// The edit on the CAD model of the part, where it has one.
struct cad_outcome {
  cad_state state;
  std::string how;
  double ms = 0;
};

expected<std::optional<cad_outcome>> edit_model(const ops::catalogue& plugins,
                                                const edited_part& part, const edit_request& wanted,
                                                const checked_edit& made, session& s) {
  if (!part.cad)
    return std::nullopt;
  if (!part.cad->model)
    return cad_outcome{*part.cad, "", 0};
  const auto offered = plugins.find(wanted.operation);
  auto replayed = cad::replay_edit(
    {*part.cad->model, (*offered)->description, part.mesh, made.version, wanted, made.report},
    make_execution(s));
  if (!replayed)
    return fail(replayed.error());
  cad_outcome outcome{{}, replayed->verdict.how, replayed->ms};
  outcome.state.reason = replayed->verdict.reason;
  outcome.state.deviation_m = 1e-3 * replayed->verdict.deviation_mm;
  if (replayed->verdict.is_same)
    outcome.state.model = std::move(replayed->model);
  return outcome;
}

nlohmann::ordered_json cad_json(const cad_outcome& outcome) {
  return {{"status", outcome.state.model ? "same" : "mesh_only"},
          {"reason", outcome.state.reason},
          {"how", outcome.how},
          {"deviation_m", outcome.state.deviation_m},
          {"ms", outcome.ms}};
}

std::string cad_text(const cad_outcome& outcome) {
  if (!outcome.state.model)
    return "  CAD model         in the mesh only: " + outcome.state.reason + "\n";
  return "  CAD model         the same (" + outcome.how + "), new vertices within " +
         pretty(1e3 * outcome.state.deviation_m, 2) + " mm of it\n";
}

expected<void> write_edited(const edit_options& options, const edit_request& wanted,
                            const checked_edit& made, const std::optional<cad_outcome>& cad) {
  if (!is_document(options.output)) {
    const auto format = output_format(options.output);
    return format.and_then([&](const file_format* row) {
      return write_as(row->name, options.output, *made.version,
                      {.length_unit = options.length_unit});
    });
  }
  if (!is_document(options.mesh))
    return fail(ec::usage, "a document is made of a document, not of " + options.mesh,
                "Make one with \"tedit import PART.step -o PART.tedit\", or write a mesh");
  return copy_with_edit(options.mesh, options.output,
                        {wanted, &made, cad ? std::optional(cad->state) : std::nullopt});
}

/// Usage errors are told before anything is computed.
expected<void> check_output(const edit_options& options) {
  if (options.output.empty() || (is_document(options.output) && is_document(options.mesh)))
    return {};
  if (is_document(options.output))
    return write_edited(options, {}, {}, {});
  return output_format(options.output).map([](const file_format*) {});
}

int run_edit(const edit_options& options, session& s) {
  stopwatch clock;
  if (const auto can = check_output(options); !can)
    return print_error(s, can.error());
  auto request = options.request;
  auto parameters = parse_parameters(options.pairs);
  if (!parameters)
    return print_error(s, parameters.error());
  request.parameters = std::move(*parameters);
  const auto policy = fem::policy_from_name(options.loads);
  if (!policy)
    return print_error(s, policy.error());
  request.loads.policy = *policy;
  auto part = read_edited(options, s);
  if (!part)
    return print_error(s, part.error());
  auto& load_cases = part->load_cases;
  if (!options.load_case.empty()) {
    auto loads = protocol::load_case_from_file(options.load_case);
    if (!loads)
      return print_error(s, loads.error());
    load_cases.push_back(std::move(*loads));
  }
  const double import_ms = clock.restart();
  if (const auto can = sandbox::check(); !can && !sandbox::is_switched_off())
    notice(s, "note: " + render(can.error()));
  const auto plugins = ops::load_catalogue_for(request.operation);
  if (const auto offered = plugins.find(request.operation)) {
    auto filled = with_files((*offered)->description, std::move(request.parameters));
    if (!filled)
      return print_error(s, filled.error());
    request.parameters = std::move(*filled);
  }
  const auto outcome =
    make_edit(plugins, part->mesh, request, load_cases, place_of(options, s), make_execution(s));
  if (!outcome)
    return print_error(s, outcome.error());
  const auto cad = edit_model(plugins, *part, request, *outcome, s);
  if (!cad)
    return print_error(s, cad.error());
  clock.restart();
  if (!options.output.empty())
    if (auto written = write_edited(options, request, *outcome, *cad); !written)
      return print_error(s, written.error());
  auto json = to_json(outcome->report);
  json["timings_ms"]["import"] = import_ms;
  json["timings_ms"]["export"] = clock.milliseconds();
  if (*cad)
    json["cad"] = cad_json(**cad);
  print_result(s, json, describe(outcome->report) + (*cad ? cad_text(**cad) : ""));
  warn_of_large_change(changed_share(*part->mesh, outcome->report), s);
  return 0;
}

}  // namespace

void add_edit(CLI::App& app, action& chosen) {
  auto options = std::make_shared<edit_options>();
  auto* command = app.add_subcommand("edit", "Apply one operation to a mesh");
  command->add_option("mesh", options->mesh, read_formats_text() + "; or a document (.tedit)")
    ->required();
  command->add_option("--op", options->request.operation, "The operation; \"tedit ops\" lists them")
    ->required();
  command->add_option("--surfaces", options->request.surfaces, "Surface ids, separated by commas")
    ->delimiter(',');
  command->add_option("--param", options->pairs,
                      "A parameter as NAME=VALUE, a length also as NAME_mm=VALUE, a file as "
                      "NAME=PATH; may be repeated");
  command->add_option("--load-case", options->load_case,
                      "Say what the edit does to this load case (JSON)");
  command
    ->add_option("--loads", options->loads,
                 "What becomes of loads and supports whose surface goes: drop, move (to the "
                 "surfaces that take its place, with their total) or refuse the edit")
    ->check(CLI::IsMember({"drop", "move", "refuse"}))
    ->capture_default_str();
  command->add_flag("--keep-traction", options->request.loads.keep_traction,
                    "A traction or pressure that moves keeps its Pa, not its N");
  command->add_option("-o,--output", options->output,
                      "Write the new mesh: " + written_formats_text() +
                        "; of a document also the document with the edit (.tedit)");
  command->add_option("--length-unit", options->length_unit, "Unit of coordinates in both files")
    ->capture_default_str();
  command
    ->add_option("--time-limit", options->time_limit_s,
                 "Seconds after which the operation is given up; 0 for no limit")
    ->capture_default_str()
    ->check(CLI::Range(0.0, 604800.0));
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_edit(*options, s); }; });
}

}  // namespace tedit::cli
