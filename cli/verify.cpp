// SPDX-License-Identifier: AGPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/child_process.hpp"
#include "cli/command.hpp"
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

/// Refusals that hold are counted, not listed: each is a sentence of its own.
std::string describe(const verification::suite_report& report) {
  std::vector<std::vector<std::string>> rows{
    {"case", "order", "tets", "quantity", "target", "computed", "error", "tolerance", "ms", ""}};
  std::size_t refused = 0;
  for (const auto& r : report.results) {
    if (r.kind == verification::comparison::refusal && r.passed) {
      ++refused;
      continue;
    }
    const auto t = verification::text_of(r);
    rows.push_back({r.name, std::to_string(r.element_order), std::to_string(r.elements), r.quantity,
                    t.target, t.computed, t.error, t.tolerance, pretty(r.milliseconds, 3),
                    r.passed ? "ok" : "FAIL"});
  }
  std::string text = format_table(rows);
  if (!report.convergence.empty())
    text += convergence_text(report);
  text += "\n  " + std::to_string(refused) + " checks with bad input: refused by name\n";
  for (const auto& item : report.left_out)
    text += "  left out: " + item.what + ": " + item.why + "\n";
  text += "  " + std::to_string(report.results.size() - report.failures()) + " of " +
          std::to_string(report.results.size()) + " figures hold on " + report.device + " (" +
          pretty(1e-3 * report.milliseconds, 3) + " s)\n";
  return text;
}

/// The part that was asked for, or the shipped plate when the program stands in its source tree.
expected<std::optional<verification::real_part>> read_part(const verify_options& options) {
  fs::path mesh = options.part;
  fs::path loads = options.load_case;
  if (mesh.empty()) {
    const fs::path plate = "examples/ctc01_plate";
    for (const fs::path& root : {fs::current_path(), executable_folder() / "../../.."})
      if (mesh.empty() && fs::exists(root / plate / "load_case.json")) {
        mesh = root / plate / "ctc01_plate.coarse.msh";
        loads = root / plate / "load_case.json";
      }
    if (mesh.empty())
      return std::nullopt;
  }
  const auto case_read = protocol::load_case_from_file(loads);
  if (!case_read)
    return fail(case_read.error());
  const auto imported = import_mesh(mesh, options.length_unit);
  if (!imported)
    return fail(imported.error());
  return verification::real_part{mesh.filename().string(), imported->version, *case_read};
}

expected<void> write_page(const verify_options& options, const verification::suite_report& report) {
  const fs::path page = options.output;
  auto picture = page;
  picture.replace_extension(".svg");
  const verification::page_facts facts{
    std::string("TEdit ") + TEDIT_VERSION,
    "build/release/bin/tedit verify --suite --device " + options.device + " -o " + options.output,
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
  const auto report =
    verification::run_suite(**device, *part ? &**part : nullptr, make_execution(s));
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
  command
    ->add_option("--device", options->device,
                 "cpu, lavapipe, auto (the fastest by a short trial) or part of a device's name")
    ->capture_default_str();
  command->add_option("-o,--output", options->output,
                      "Write a Markdown page here, and its picture beside it (.svg)");
  command->add_option("--part", options->part,
                      "Mesh for the invariance cases (default: examples/ctc01_plate)");
  command->add_option("--load-case", options->load_case, "Load case of --part (JSON)");
  command->add_option("--length-unit", options->length_unit, "Unit of the part's coordinates")
    ->capture_default_str();
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_verify(*options, s); }; });
}

}  // namespace tedit::cli
