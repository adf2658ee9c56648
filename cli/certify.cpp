// SPDX-License-Identifier: AGPL-3.0-or-later
// A part for who certifies it: decks of all load cases, what CalculiX makes of exactly these, our
// own fields, and how far both agree.
#include <cctype>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <set>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/hash.hpp"
#include "cli/command.hpp"
#include "cli/field_file.hpp"
#include "cli/part_input.hpp"
#include "cli/solver_options.hpp"
#include "decks/deck_file.hpp"
#include "mesh/io/file.hpp"
#include "protocol/convert.hpp"
#include "verification/agreement.hpp"

namespace tedit::cli {

namespace {

namespace fs = std::filesystem;

struct certify_options {
  part_input part;
  std::vector<std::string> load_cases;
  std::string output;
  std::string device = "auto";
  int order = 2;
};

/// Of our own solves: what CalculiX's seven digits can be compared with.
constexpr double solve_tolerance = 1e-9;

struct certified_part {
  version_ptr mesh;
  std::vector<fem::load_case> load_cases;
  std::optional<std::uint32_t> number;  ///< Of a document's version.
};

/// One load case by both programs.
struct checked_case {
  std::string name;
  std::string stem;  ///< Of its files.
  verification::agreement result;
  verification::stress_agreement stress;
  double most_displacement_m = 0;
  double our_ms = 0;
  double their_ms = 0;
  std::string program;

  [[nodiscard]] bool agrees() const {
    constexpr verification::agreement_limits limits;
    return result.displacement <= limits.displacement && result.reaction <= limits.reaction &&
           result.surface_reaction <= limits.reaction && result.compliance <= limits.compliance &&
           stress.same_means <= limits.stress;
  }
};

expected<certified_part> read_certified(const certify_options& options, session& s) {
  auto part = read_input(options.part, s);
  if (!part)
    return fail(part.error());
  auto load_cases = cases_of(options.part, *part, options.load_cases);
  if (!load_cases)
    return fail(load_cases.error());
  return certified_part{std::move(part->mesh.version), std::move(*load_cases), part->number};
}

/// A name for files from that of a load case: letters, digits, "-" and "_" stay.
std::string stem_of(const std::string& name, std::set<std::string>& taken) {
  constexpr std::size_t longest = 40;
  std::string stem;
  for (const char c : name.substr(0, longest))
    stem += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ? c : '_';
  if (stem.find_first_not_of('_') == std::string::npos)
    stem = "load_case";
  auto result = stem;
  for (int number = 2; !taken.insert(result).second; ++number)
    result = stem + "_" + std::to_string(number);
  return result;
}

/// A folder that is new or has nothing in it: nothing is written over.
expected<void> make_folder(const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code)
    return fail(ec::io_error,
                "the folder " + folder.string() + " cannot be made: " + code.message(),
                "Name one where you may write");
  if (!fs::is_empty(folder, code) || code)
    return fail(ec::conflict, "there is something in the folder " + folder.string() + " already",
                "Name a new one: a certificate is not written over another");
  return {};
}

expected<std::vector<checked_case>> check_cases(const certify_options& options,
                                                const certified_part& part, const fs::path& program,
                                                session& s) {
  auto set = fem::make_cases(*part.mesh, part.load_cases, options.order);
  if (!set)
    return fail(set.error());
  const auto device = fem::open_backend(options.device);
  if (!device)
    return fail(device.error());
  fem::solve_settings settings;
  settings.tolerance = solve_tolerance;
  notice(s, "solving");
  const auto ours = fem::solve_cases(*set, **device, settings, make_execution(s));
  if (!ours)
    return fail(ours.error());
  const fs::path folder = options.output;
  const auto fields = folder / "tedit.vtu";
  const auto written = ours->cases.size() == 1
                         ? write_field(fields, *part.mesh, set->problem, ours->cases.front())
                         : write_field(fields, *part.mesh, *set, *ours);
  if (!written)
    return fail(written.error());
  std::vector<checked_case> result;
  std::set<std::string> taken{"tedit", "certificate"};
  for (std::size_t c = 0; c < ours->cases.size(); ++c) {
    set->stand(c);
    const auto& loads = part.load_cases[c];
    checked_case one{loads.name, stem_of(loads.name, taken)};
    const auto job =
      decks::make_deck_job(*part.mesh, set->problem, loads,
                           loads.name + " on " + fs::path(options.part.file).filename().string());
    if (const auto deck =
          decks::write_calculix(folder / (one.stem + ".inp"), job, fem::calculix_solver::spooles);
        !deck)
      return fail(deck.error());
    notice(s, "CalculiX solves \"" + loads.name + "\"");
    const auto theirs =
      verification::run_calculix(program, folder, one.stem, set->problem, make_execution(s));
    if (!theirs)
      return fail(theirs.error());
    one.result = verification::compare_solutions(set->problem, ours->cases[c], *theirs);
    one.stress = verification::compare_stress(set->problem, ours->cases[c], *theirs);
    one.most_displacement_m = ours->cases[c].max_displacement_m;
    one.our_ms = ours->cases[c].solve_ms;
    one.their_ms = theirs->milliseconds;
    one.program = theirs->program;
    result.push_back(std::move(one));
  }
  return result;
}

nlohmann::ordered_json to_json(const checked_case& c) {
  const auto at = c.stress.own_means_at;
  return {{"name", c.name},
          {"deck", c.stem + ".inp"},
          {"results", {c.stem + ".dat", c.stem + ".frd"}},
          {"agrees", c.agrees()},
          {"displacement", c.result.displacement},
          {"reaction", c.result.reaction},
          {"surface_reaction", c.result.surface_reaction},
          {"compliance", c.result.compliance},
          {"compliance_j", c.result.compliance_j},
          {"stress", c.stress.same_means},
          {"stress_as_shown", c.stress.own_means},
          {"stress_as_shown_median", c.stress.own_means_median},
          {"stress_as_shown_at_m", {at.x, at.y, at.z}},
          {"max_von_mises_pa", c.stress.most_ours_pa},
          {"calculix_max_von_mises_pa", c.stress.most_theirs_pa},
          {"max_displacement_m", c.most_displacement_m},
          {"milliseconds", c.our_ms},
          {"calculix_milliseconds", c.their_ms}};
}

nlohmann::ordered_json to_json(const certify_options& options, const certified_part& part,
                               const std::vector<checked_case>& cases) {
  constexpr verification::agreement_limits limits;
  auto rows = nlohmann::ordered_json::array();
  for (const auto& c : cases)
    rows.push_back(to_json(c));
  nlohmann::ordered_json json{{"part", options.part.file}, {"version_id", to_hex(part.mesh->id())}};
  if (part.number)
    json["version"] = *part.number;
  json["tedit"] = TEDIT_VERSION;
  json["program"] = cases.front().program;
  json["element_order"] = options.order;
  json["tets"] = part.mesh->tet_count();
  json["agrees"] = std::ranges::all_of(cases, &checked_case::agrees);
  json["limits"] = {{"displacement", limits.displacement},
                    {"reaction", limits.reaction},
                    {"compliance", limits.compliance},
                    {"stress", limits.stress}};
  json["fields"] = "tedit.vtu";
  json["load_cases"] = rows;
  return json;
}

std::string describe(const certify_options& options, const certified_part& part,
                     const std::vector<checked_case>& cases) {
  std::string text = options.part.file;
  if (part.number)
    text += ", version " + std::to_string(*part.number);
  text += " (" + to_hex(part.mesh->id()).substr(0, 8) + "), " +
          std::to_string(part.mesh->tet_count()) +
          (options.order == 2 ? " quadratic tets" : " linear tets") + ", beside " +
          cases.front().program + "\n";
  std::vector<std::vector<std::string>> rows{{"load case", "displacement", "reactions",
                                              "compliance", "stress", "largest MPa", "CalculiX MPa",
                                              ""}};
  for (const auto& c : cases)
    rows.push_back({c.name, pretty(c.result.displacement, 2),
                    pretty(std::max(c.result.reaction, c.result.surface_reaction), 2),
                    pretty(c.result.compliance, 2), pretty(c.stress.same_means, 2),
                    pretty(1e-6 * c.stress.most_ours_pa), pretty(1e-6 * c.stress.most_theirs_pa),
                    c.agrees() ? "agrees" : "DIFFERS"});
  text += format_table(rows);
  text +=
    "  Differences are relative to the largest displacement, the sum of reactions, and the largest "
    "stress.\n  Stress is compared with means at nodes taken alike; as each program shows it, "
    "TEdit's by the\n  elements' volume, half of the nodes differ by less than " +
    pretty(1e2 * cases.front().stress.own_means_median, 2) + " % and one by " +
    pretty(1e2 * cases.front().stress.own_means, 2) + " %.\n  decks and results  " +
    options.output + "\n";
  return text;
}

int run_certify(const certify_options& options, session& s) {
  const auto program = verification::find_calculix();
  if (program.empty())
    return print_error(s, {ec::service_unavailable,
                           "the program ccx is not installed",
                           "apt-get install " + std::string(verification::calculix_package),
                           {}});
  const auto part = read_certified(options, s);
  if (!part)
    return print_error(s, part.error());
  if (const auto made = make_folder(options.output); !made)
    return print_error(s, made.error());
  const auto cases = check_cases(options, *part, program, s);
  if (!cases)
    return print_error(s, cases.error());
  const auto json = to_json(options, *part, *cases);
  const auto text = describe(options, *part, *cases);
  const auto written = write_file(fs::path(options.output) / "certificate.json",
                                  [&](std::ostream& out) { out << json.dump(2) << "\n"; });
  if (!written)
    return print_error(s, written.error());
  print_result(s, json, text);
  return json["agrees"].get<bool>() ? 0 : 1;
}

}  // namespace

void add_certify(CLI::App& app, action& chosen) {
  auto options = std::make_shared<certify_options>();
  auto* command = app.add_subcommand(
    "certify", "Have CalculiX solve a part's load cases, too, and say how far both agree");
  add_part_options(*command, options->part);
  command->add_option("--load-case", options->load_cases, load_case_help)->allow_extra_args(false);
  command
    ->add_option("-o,--output", options->output,
                 "A new folder for decks, CalculiX's results, our fields and the certificate")
    ->required();
  add_device_option(*command, options->device);
  command->add_option("--order", options->order, "2: quadratic tets (C3D10); 1: linear tets (C3D4)")
    ->check(CLI::IsMember({1, 2}))
    ->capture_default_str();
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_certify(*options, s); }; });
}

}  // namespace tedit::cli
