// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/compare_report.hpp"
#include "cli/part_document.hpp"
#include "cli/part_input.hpp"
#include "cli/server_access.hpp"
#include "cli/server_comparison.hpp"
#include "cli/solver_options.hpp"
#include "compare/compare_fields.hpp"
#include "compare/compare_versions.hpp"
#include "fem/fields.hpp"
#include "fem/solver.hpp"
#include "mesh/formats.hpp"
#include "mesh/io/file.hpp"

namespace tedit::cli {

namespace {

namespace fs = std::filesystem;

struct compare_options {
  std::string before;
  std::string after;
  std::optional<std::uint32_t> from;
  std::optional<std::uint32_t> to;
  std::vector<std::string> load_cases;
  std::string output;
  std::string length_unit = "mm";
  std::string server;
  server_access access;
  solver_options solver;
};

/// One of the two that are compared.
struct part_side {
  std::string name;  ///< For messages.
  version_ptr mesh;
  std::vector<fem::load_case> load_cases;  ///< All that it has.
  std::vector<std::string> solved = {};    ///< Names of those whose fields were asked for.
};

struct part_sides {
  part_side before;
  part_side after;
  std::vector<std::string> solved;  ///< Names of the load cases whose fields are compared.
};

// -- from a document -----------------------------------------------------------------------

expected<part_side> side_of(const std::string& file, std::optional<std::uint32_t> number) {
  auto part = read_version_of(file, number);
  if (!part)
    return fail(part.error());
  return part_side{"version " + std::to_string(part->number), std::move(part->mesh),
                   std::move(part->load_cases)};
}

/// Without numbers: the first version and the one that is the present one.
expected<part_sides> sides_of_document(const compare_options& options) {
  auto before = side_of(options.before, options.from.value_or(0));
  if (!before)
    return fail(before.error());
  auto after = side_of(options.before, options.to);
  if (!after)
    return fail(after.error());
  return part_sides{std::move(*before), std::move(*after), options.load_cases};
}

// -- from two files ---------------------------------------------------------------------------

expected<part_side> side_of_file(const part_input& input, const compare_options& options,
                                 session& s) {
  auto part = read_input(input, s);
  if (!part)
    return fail(part.error());
  part_side side{input.file, part->mesh.version, part->load_cases};
  if (options.load_cases.empty())
    return side;
  auto told = cases_of(input, *part, options.load_cases);
  if (!told)
    return fail(told.error());
  for (auto& one : *told) {
    side.solved.push_back(one.name);
    if (std::ranges::find(side.load_cases, one.name, &fem::load_case::name) ==
        side.load_cases.end())
      side.load_cases.push_back(std::move(one));
  }
  return side;
}

/// Meshes, or versions of two documents.
expected<part_sides> sides_of_files(const compare_options& options, session& s) {
  auto before = side_of_file({options.before, options.length_unit, options.from}, options, s);
  if (!before)
    return fail(before.error());
  auto after = side_of_file({options.after, options.length_unit, options.to}, options, s);
  if (!after)
    return fail(after.error());
  auto names = before->solved;
  return part_sides{std::move(*before), std::move(*after), std::move(names)};
}

/// Errors: `usage` when the options do not fit to each other.
expected<part_sides> read_sides(const compare_options& options, session& s) {
  const auto usage = [](const std::string& what, const std::string& remedy) {
    return fail(ec::usage, what, remedy);
  };
  if (!options.output.empty() && options.load_cases.empty())
    return usage("a file holds the difference of fields, and no load case is given",
                 "Give --load-case, or leave -o out");
  if (!options.output.empty() && fs::path(options.output).extension() != ".vtu")
    return usage(options.output + " does not end in .vtu", "Fields are written as VTU");
  if (!options.after.empty()) {
    if ((options.from && !is_document(options.before)) ||
        (options.to && !is_document(options.after)))
      return usage("--from and --to name versions of a document (.tedit)",
                   "Leave them out for a mesh");
    return sides_of_files(options, s);
  }
  if (is_document(options.before))
    return sides_of_document(options);
  return usage("a second mesh file is needed", "Write \"tedit compare BEFORE AFTER\"");
}

// -- fields ----------------------------------------------------------------------------------

/// Of each load case in the order asked for.
using case_fields = std::vector<std::vector<field>>;

expected<std::vector<fem::load_case>> wanted_cases(const part_side& of,
                                                   const std::vector<std::string>& names) {
  std::vector<fem::load_case> result;
  for (const auto& name : names) {
    const auto found = std::ranges::find(of.load_cases, name, &fem::load_case::name);
    if (found == of.load_cases.end()) {
      std::string known;
      for (const auto& one : of.load_cases)
        known += (known.empty() ? "\"" : ", \"") + one.name + "\"";
      return fail(ec::not_found, of.name + " has no load case \"" + name + "\"",
                  known.empty() ? "It has none" : "It has " + known);
    }
    result.push_back(*found);
  }
  return result;
}

expected<case_fields> solve_side(const part_side& of, const compare_options& options,
                                 const std::vector<std::string>& names, fem::backend& device,
                                 const execution& run) {
  const auto named = [&](error e) {
    e.message = of.name + ": " + e.message;
    return fail(std::move(e));
  };
  const auto loads = wanted_cases(of, names);
  if (!loads)
    return fail(loads.error());
  auto set = fem::make_cases(*of.mesh, *loads, options.solver.order);
  if (!set)
    return named(set.error());
  fem::solve_settings settings;
  settings.tolerance = options.solver.tolerance;
  const auto solved = fem::solve_cases(*set, device, settings, run);
  if (!solved)
    return named(solved.error());
  const bool several = names.size() > 1;
  const auto all = several ? fem::make_fields(*of.mesh, *set, *solved, fem::field_range::shown)
                           : fem::make_fields(*of.mesh, set->problem, solved->cases.front(),
                                              fem::field_range::shown);
  case_fields result;
  for (const auto& name : names)
    result.push_back(fem::fields_of_case(all, name, several));
  return result;
}

/// Adds what the file shows of one load case: its mark, its differences, and stress and
/// displacement after.
void add_to_file(const field_difference& made, const std::vector<field>& after,
                 const std::string& load_case, bool several, std::vector<field>& file) {
  const auto add = [&](field one) {
    if (several)
      one.name = fem::case_field(one.name, load_case);
    file.push_back(std::move(one));
  };
  for (const auto& one : made.fields)
    add(one);
  for (const auto* name : {"von_mises_pa", "displacement_m"})
    if (const auto* found = find_field(after, name))
      add(*found);
}

/// Solves both and compares; `file` gets the arrays to write.
expected<void> add_fields(const compare_options& options, const part_sides& sides,
                          const version_match& match, session& s, version_comparison& result,
                          std::vector<field>& file) {
  const auto& names = sides.solved;
  if (names.empty())
    return {};
  const auto device = fem::open_backend(options.solver.device);
  if (!device)
    return fail(device.error());
  const auto run = make_execution(s);
  const auto was = solve_side(sides.before, options, names, **device, run.part(0, .5));
  if (!was)
    return fail(was.error());
  const auto is = solve_side(sides.after, options, names, **device, run.part(.5, 1));
  if (!is)
    return fail(is.error());
  for (std::size_t c = 0; c < names.size(); ++c) {
    auto made =
      compare_fields({*sides.before.mesh, (*was)[c]}, {*sides.after.mesh, (*is)[c]}, match, run);
    if (!made)
      return fail(made.error());
    made->figures.load_case = names[c];
    result.fields.push_back(made->figures);
    add_to_file(*made, (*is)[c], names[c], names.size() > 1, file);
  }
  return {};
}

expected<void> write_difference(const compare_options& options, const version_comparison& result,
                                const mesh_version& mesh, std::vector<field> file) {
  if (options.output.empty())
    return {};
  const char* quality =
    options.solver.order < 2 ? "preview (linear tets)" : "final (quadratic tets)";
  return formats::vtu::write(
    options.output, mesh,
    {.fields = std::move(file),
     .notes = {
       {"before_id", result.before_id}, {"version_id", result.after_id}, {"quality", quality}}});
}

// -- on a server -----------------------------------------------------------------------------

/// Errors: `usage` for what a server cannot do.
expected<void> check_for_server(const compare_options& options) {
  if (!options.after.empty() || is_document(options.before))
    return fail(ec::usage, "a server compares two versions of one of its documents",
                "Give the document's name alone, with --from and --to");
  if (options.load_cases.size() > 1)
    return fail(ec::usage, "a server compares the fields of one load case at a time",
                "Give --load-case once");
  if (!options.output.empty() && options.load_cases.empty())
    return fail(ec::usage, "a file holds the difference of fields, and no load case is given",
                "Give --load-case, or leave -o out");
  return {};
}

/// With the fields that the server has; nothing is solved.
expected<client::comparison> ask_server(const compare_options& options, session& s) {
  if (auto ok = check_for_server(options); !ok)
    return fail(ok.error());
  auto how = reach_server(options.server, options.access);
  if (!how)
    return fail(how.error());
  how->client_name = "tedit compare " TEDIT_VERSION;
  const auto server = client::client::connect(*how, {});
  if (!server)
    return fail(server.error());
  const auto opened = (*server)->open(options.before, false, false);
  if (!opened)
    return fail(opened.error());
  if (!opened->head)
    return fail(ec::not_found, "the server has no document " + options.before,
                "Look for it with \"tedit doc list\" in the server's folder");
  const compared_versions wanted{options.from.value_or(0),
                                 options.to.value_or(opened->head->number),
                                 options.load_cases.empty() ? "" : options.load_cases.front()};
  auto made = compare_on_server(**server, wanted, s);
  if (made && !options.output.empty())
    if (auto ok = write_difference(**server, *made, options.output, s); !ok)
      return fail(ok.error());
  return made;
}

int run_compare_on_server(const compare_options& options, session& s) {
  const auto made = ask_server(options, s);
  end_progress(s);
  if (!made)
    return print_error(s, made.error());
  print_result(s, to_json(made->what), describe_comparison(*made));
  return 0;
}

int run_compare(const compare_options& options, session& s) {
  if (!options.server.empty())
    return run_compare_on_server(options, s);
  const auto sides = read_sides(options, s);
  if (!sides)
    return print_error(s, sides.error());
  const auto& before = *sides->before.mesh;
  const auto& after = *sides->after.mesh;
  const auto match = match_versions(before, after, make_execution(s));
  if (!match)
    return print_error(s, match.error());
  auto result = compare_versions({before, sides->before.load_cases},
                                 {after, sides->after.load_cases}, *match, make_execution(s));
  if (!result)
    return print_error(s, result.error());
  std::vector<field> file;
  if (auto ok = add_fields(options, *sides, *match, s, *result, file); !ok)
    return print_error(s, ok.error());
  if (auto ok = write_difference(options, *result, after, std::move(file)); !ok)
    return print_error(s, ok.error());
  print_result(
    s, to_json(*result),
    sides->before.name + " -> " + sides->after.name + "\n" + describe_comparison(*result));
  return 0;
}

}  // namespace

void add_compare(CLI::App& app, action& chosen) {
  auto options = std::make_shared<compare_options>();
  auto* command = app.add_subcommand(
    "compare", "Compare two meshes, or two versions of a document, and their stress");
  command
    ->add_option("before", options->before,
                 read_formats_text() +
                   "; or a document (.tedit); with --server the name of a "
                   "document there")
    ->required();
  command->add_option("after", options->after,
                      "The other mesh or document; without it two versions of the one document");
  command->add_option("--from", options->from,
                      "Version of the document before; the first one when it is not given");
  command->add_option("--to", options->to,
                      "Version of the document after; the present one when it is not given");
  command
    ->add_option("--load-case", options->load_cases,
                 "Compare the fields of this load case, too: a file (JSON), or the name of one "
                 "that the document has; again for more")
    ->allow_extra_args(false);
  command->add_option("-o,--output", options->output,
                      "Write the difference at the vertices after to this VTU file");
  command->add_option("--length-unit", options->length_unit, "Unit of the files' coordinates")
    ->capture_default_str();
  command->add_option("--server", options->server,
                      "Ask this server (ws[s]://HOST:PORT/v1), with the fields that it has solved");
  add_access_options(*command, options->access);
  add_solver_options(*command, options->solver);
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_compare(*options, s); }; });
}

}  // namespace tedit::cli
