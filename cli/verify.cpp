// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/child_process.hpp"
#include "cli/command.hpp"
#include "cli/solver_options.hpp"
#include "fem/solver.hpp"
#include "mesh/io/file.hpp"
#include "mesh/io/import.hpp"
#include "protocol/convert.hpp"
#include "verification/page.hpp"
#include "verification/plot.hpp"
#include "verification/suite.hpp"

namespace tedit::cli {

namespace {

namespace fs = std::filesystem;

struct verify_options {
  bool suite = false;
  std::string device = "cpu";
  std::string output;
  std::string part;
  std::string load_case;
  bool calculix = false;
  std::string parts;
  std::string length_unit = "mm";
};

const char* kind_name(verification::comparison kind) {
  using enum verification::comparison;
  return kind == within     ? "within"
         : kind == at_most  ? "at_most"
         : kind == at_least ? "at_least"
                            : "refusal";
}

nlohmann::ordered_json to_json(const verification::case_result& r) {
  nlohmann::ordered_json row{{"name", r.name},
                             {"source", r.source},
                             {"element_order", r.element_order},
                             {"device", r.device},
                             {"elements", r.elements},
                             {"quantity", r.quantity},
                             {"kind", kind_name(r.kind)},
                             {"target", r.target},
                             {"computed", r.computed}};
  if (r.kind == verification::comparison::within) {
    row["relative_error"] = r.relative_error;
    row["tolerance"] = r.tolerance;
  }
  row["passed"] = r.passed;
  row["milliseconds"] = r.milliseconds;
  return row;
}

nlohmann::ordered_json to_json(const verification::suite_report& report) {
  using json = nlohmann::ordered_json;
  json results = json::array();
  for (const auto& r : report.results)
    results.push_back(to_json(r));
  json rows = json::array();
  for (const auto& r : report.convergence)
    rows.push_back({{"element_order", r.element_order},
                    {"elements", r.elements},
                    {"size", r.size},
                    {"l2_error", r.l2_error},
                    {"energy_error", r.energy_error},
                    {"l2_rate", r.l2_rate},
                    {"energy_rate", r.energy_rate}});
  json side_by_side = json::array();
  for (const auto& r : report.side_by_side)
    side_by_side.push_back({{"part", r.part},
                            {"program", r.program},
                            {"element_order", r.element_order},
                            {"elements", r.elements},
                            {"nodes", r.nodes},
                            {"displacement", r.displacement},
                            {"reaction", r.reaction},
                            {"surface_reaction", r.surface_reaction},
                            {"compliance", r.compliance},
                            {"milliseconds", r.milliseconds},
                            {"other_milliseconds", r.other_milliseconds}});
  json left_out = json::array();
  for (const auto& item : report.left_out)
    left_out.push_back({{"what", item.what}, {"why", item.why}});
  return {{"version", TEDIT_VERSION},
          {"device", report.device},
          {"passed", report.passed()},
          {"failures", report.failures()},
          {"milliseconds", report.milliseconds},
          {"results", results},
          {"convergence", rows},
          {"side_by_side", side_by_side},
          {"left_out", left_out}};
}

std::string convergence_text(const verification::suite_report& report) {
  std::vector<std::vector<std::string>> rows{
    {"manufactured solution", "order", "tets", "h", "L2 error", "rate", "energy error", "rate"}};
  const auto rate = [](double value) { return value == 0 ? "" : pretty(value, 3); };
  for (const auto& r : report.convergence)
    rows.push_back({"", std::to_string(r.element_order), std::to_string(r.elements),
                    pretty(r.size, 3), pretty(r.l2_error, 3), rate(r.l2_rate),
                    pretty(r.energy_error, 3), rate(r.energy_rate)});
  return "\n" + format_table(rows);
}

std::string side_by_side_text(const verification::suite_report& report) {
  std::vector<std::vector<std::string>> rows{{report.side_by_side.front().program, "order", "tets",
                                              "displacement", "total reaction", "surface reaction",
                                              "compliance", "s", "CalculiX s"}};
  for (const auto& r : report.side_by_side)
    rows.push_back({r.part, std::to_string(r.element_order), std::to_string(r.elements),
                    pretty(r.displacement, 2), pretty(r.reaction, 2), pretty(r.surface_reaction, 2),
                    pretty(r.compliance, 2), pretty(1e-3 * r.milliseconds, 2),
                    pretty(1e-3 * r.other_milliseconds, 2)});
  return "\n" + format_table(rows);
}

/// Refusals that hold are counted, not listed: each is a sentence of its own. What holds side by
/// side with CalculiX has a table of its own.
std::string describe(const verification::suite_report& report) {
  std::vector<std::vector<std::string>> rows{
    {"case", "order", "tets", "quantity", "target", "computed", "error", "tolerance", "ms", ""}};
  std::size_t refused = 0;
  for (const auto& r : report.results) {
    if (r.kind == verification::comparison::refusal && r.passed) {
      ++refused;
      continue;
    }
    if (r.name == verification::side_by_side_case && r.passed)
      continue;
    const auto t = verification::text_of(r);
    rows.push_back({r.name, std::to_string(r.element_order), std::to_string(r.elements), r.quantity,
                    t.target, t.computed, t.error, t.tolerance, pretty(r.milliseconds, 3),
                    r.passed ? "ok" : "FAIL"});
  }
  std::string text = format_table(rows);
  if (!report.convergence.empty())
    text += convergence_text(report);
  if (!report.side_by_side.empty())
    text += side_by_side_text(report);
  text += "\n  " + std::to_string(refused) + " checks with bad input: refused by name\n";
  for (const auto& item : report.left_out)
    text += "  left out: " + item.what + ": " + item.why + "\n";
  text += "  " + std::to_string(report.results.size() - report.failures()) + " of " +
          std::to_string(report.results.size()) + " figures hold on " + report.device + " (" +
          pretty(1e-3 * report.milliseconds, 3) + " s)\n";
  return text;
}

expected<verification::real_part> read_part(const fs::path& mesh, const fs::path& loads,
                                            const std::string& length_unit) {
  const auto case_read = protocol::load_case_from_file(loads);
  if (!case_read)
    return fail(case_read.error());
  const auto imported = import_mesh(mesh, length_unit);
  if (!imported)
    return fail(imported.error());
  return verification::real_part{mesh.filename().string(), imported->version, *case_read};
}

/// A folder of the source tree when the program stands in one or is run in one, else empty.
fs::path shipped(const fs::path& folder) {
  for (const fs::path& root : {fs::current_path(), executable_folder() / "../../.."})
    if (fs::exists(root / folder))
      return root / folder;
  return {};
}

/// The part that was asked for, or the shipped plate when there is one.
expected<std::optional<verification::real_part>> read_part(const verify_options& options) {
  if (!options.part.empty())
    return read_part(options.part, options.load_case, options.length_unit);
  const auto plate = shipped("examples/ctc01_plate");
  if (plate.empty())
    return std::nullopt;
  return read_part(plate / "ctc01_plate.coarse.msh", plate / "load_case.json", options.length_unit);
}

/// The parts to solve side by side with CalculiX, by name: NAME/NAME.coarse.msh with
/// NAME/load_case.json, in the folder that was asked for or the shipped one.
expected<std::vector<verification::real_part>> read_parts(const verify_options& options) {
  std::vector<verification::real_part> parts;
  const auto folder = options.parts.empty() ? shipped("tests/data/parts") : fs::path(options.parts);
  std::error_code code;
  std::vector<fs::path> names;
  for (const auto& entry : fs::directory_iterator(folder, code))
    if (fs::exists(entry.path() / "load_case.json"))
      names.push_back(entry.path());
  std::ranges::sort(names);
  for (const auto& name : names) {
    auto part = read_part(name / (name.filename().string() + ".coarse.msh"),
                          name / "load_case.json", options.length_unit);
    if (!part)
      return fail(part.error());
    part->name = name.filename().string();
    parts.push_back(std::move(*part));
  }
  if (parts.empty())
    return fail(ec::not_found,
                "there is no part to solve side by side in \"" + folder.string() + "\"",
                "Give --parts a folder that has NAME/NAME.coarse.msh and NAME/load_case.json");
  return parts;
}

expected<void> write_page(const verify_options& options, const verification::suite_report& report) {
  const fs::path page = options.output;
  auto picture = page;
  picture.replace_extension(".svg");
  const verification::page_facts facts{
    std::string("TEdit ") + TEDIT_VERSION,
    "build/release/bin/tedit verify --suite " + std::string(options.calculix ? "--calculix " : "") +
      "--device " + options.device + " -o " + options.output,
    report.convergence.empty() ? std::string() : picture.filename().string()};
  if (!report.convergence.empty())
    if (auto ok = write_file(
          picture,
          [&](std::ostream& out) { out << verification::convergence_svg(report.convergence); });
        !ok)
      return ok;
  return write_file(page,
                    [&](std::ostream& out) { out << verification::markdown_page(report, facts); });
}

int run_verify(const verify_options& options, session& s) {
  if (options.part.empty() != options.load_case.empty())
    return print_error(s, {ec::usage, "--part and --load-case belong together", "Give both", {}});
  const auto part = read_part(options);
  if (!part)
    return print_error(s, part.error());
  const auto device = fem::open_backend(options.device);
  if (!device)
    return print_error(s, device.error());
  if (const auto& told = (*device)->info().notice; !told.empty())
    notice(s, "note: " + told);
  expected<std::vector<verification::real_part>> parts;
  if (options.calculix)
    parts = read_parts(options);
  if (!parts)
    return print_error(s, parts.error());
  const auto report =
    verification::run_suite(**device, *part ? &**part : nullptr, make_execution(s), *parts);
  if (!report)
    return print_error(s, report.error());
  if (!options.output.empty())
    if (auto written = write_page(options, *report); !written)
      return print_error(s, written.error());
  print_result(s, to_json(*report), describe(*report));
  return report->passed() ? 0 : 1;
}

}  // namespace

void add_verify(CLI::App& app, action& chosen) {
  auto options = std::make_shared<verify_options>();
  auto* command =
    app.add_subcommand("verify", "Compare the solver with closed solutions and benchmarks");
  command->add_flag("--suite", options->suite, "Run all cases; exit status 1 when a figure is off")
    ->required();
  add_device_option(*command, options->device);
  command->add_option("-o,--output", options->output,
                      "Write a Markdown page here, and its picture beside it (.svg)");
  command->add_option("--part", options->part,
                      "Mesh for the invariance cases (default: examples/ctc01_plate)");
  command->add_option("--load-case", options->load_case, "Load case of --part (JSON)");
  auto* calculix =
    command->add_flag("--calculix", options->calculix,
                      "Also solve real parts side by side with CalculiX (the program "
                      "ccx, Debian package calculix-ccx): minutes");
  command
    ->add_option("--parts", options->parts,
                 "Folder of parts for --calculix, each NAME/NAME.coarse.msh and "
                 "NAME/load_case.json (default: tests/data/parts)")
    ->needs(calculix);
  command->add_option("--length-unit", options->length_unit, "Unit of the parts' coordinates")
    ->capture_default_str();
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_verify(*options, s); }; });
}

}  // namespace tedit::cli
