// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/doc_loads.hpp"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "actors/session/change_log.hpp"
#include "actors/store/check.hpp"
#include "actors/store/document.hpp"
#include "actors/store/loading.hpp"
#include "actors/store/store.hpp"
#include "cli/import_mesh_file.hpp"
#include "cli/load_case_files.hpp"
#include "cli/part_document.hpp"
#include "cli/part_input.hpp"
#include "protocol/convert.hpp"

namespace tedit::cli {

namespace {

struct loads_options {
  std::string document;
  std::vector<std::string> set;
  std::vector<std::string> remove;
};

/// What the current version gets. Errors: `not_found` for a name that is not there;
/// `surface_not_found`.
expected<std::vector<fem::load_case>> changed(const loads_options& options,
                                              const document_part& part) {
  auto result = part.load_cases;
  for (const auto& name : options.remove)
    if (std::erase_if(result, [&](const auto& one) { return one.name == name; }) == 0)
      return fail(ec::not_found, options.document + " has no load case \"" + name + "\"",
                  "It has: " + names_of(part.load_cases));
  const auto given = read_load_cases(options.set);
  if (!given)
    return fail(given.error());
  if (const auto ok = check_load_cases(*part.mesh, *given); !ok)
    return fail(ok.error());
  for (const auto& one : *given) {
    const auto same = std::ranges::find(result, one.name, &fem::load_case::name);
    if (same == result.end())
      result.push_back(one);
    else
      *same = one;
  }
  return result;
}

/// As one change, with one line in the document's log.
expected<void> write(const loads_options& options, const document_part& part,
                     const std::vector<fem::load_case>& load_cases) {
  const auto document = store::document::open(options.document);
  if (!document)
    return fail(document.error());
  store::change change;
  change.load_cases.emplace_back(part.number, actors::stored_form(load_cases));
  nlohmann::json how{{"load_case", nlohmann::json::array()}, {"remove", options.remove}};
  for (const auto& one : load_cases)
    how["load_case"].push_back(protocol::load_case_to_json(one));
  actors::past_change past;
  past.what = change.what = "load_case";
  past.client = "tedit";
  past.time = actors::utc_now();
  change.details = past.to_details(how.dump());
  return (*document)->commit(change);
}

nlohmann::ordered_json to_json(const loads_options& options, const document_part& part,
                               const std::vector<fem::load_case>& load_cases) {
  auto rows = nlohmann::ordered_json::array();
  for (const auto& one : load_cases)
    rows.push_back(
      {{"name", one.name}, {"supports", one.constraints.size()}, {"loads", one.loads.size()}});
  return {{"file", options.document}, {"number", part.number}, {"load_cases", std::move(rows)}};
}

std::string describe(const loads_options& options, const document_part& part,
                     const std::vector<fem::load_case>& load_cases) {
  auto text = options.document + ", version " + std::to_string(part.number) + ": " +
              (load_cases.empty() ? "no load case" : "load cases") + "\n";
  std::vector<std::vector<std::string>> rows{{"load case", "supports", "loads"}};
  for (const auto& one : load_cases)
    rows.push_back(
      {one.name, std::to_string(one.constraints.size()), std::to_string(one.loads.size())});
  return load_cases.empty() ? text : text + format_table(rows);
}

int run_loads(const loads_options& options, session& s) {
  const auto part = read_version_of(options.document, {});
  if (!part)
    return print_error(s, part.error());
  const auto load_cases = changed(options, *part);
  if (!load_cases)
    return print_error(s, load_cases.error());
  if (*load_cases != part->load_cases)
    if (const auto ok = write(options, *part, *load_cases); !ok)
      return print_error(s, ok.error());
  print_result(s, to_json(options, *part, *load_cases), describe(options, *part, *load_cases));
  return 0;
}

}  // namespace

void add_doc_loads(CLI::App& doc, action& chosen) {
  auto options = std::make_shared<loads_options>();
  auto* command = doc.add_subcommand(
    "loads", "List the load cases of a document's current version, set or remove some");
  command->add_option("file", options->document, "A document (.tedit)")->required();
  command
    ->add_option("--set", options->set,
                 "A load case (JSON): instead of the one of its name, or a new one; again for more")
    ->allow_extra_args(false);
  command->add_option("--remove", options->remove, "The name of one that shall go; again for more")
    ->allow_extra_args(false);
  command->footer("A document that a server has open is changed by its clients only.");
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_loads(*options, s); }; });
}

}  // namespace tedit::cli
