// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/formats.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"

namespace tedit::cli {

namespace {

/// What a command other than `convert` reads or writes.
struct command_format {
  const char* name;
  const char* kind;
  const char* command;
  bool reads;
  bool writes;
  std::vector<std::string> keeps;
};

const std::vector<command_format>& of_commands() {
  static const std::vector<command_format> rows{
    {"step",
     "a STEP file",
     "import, export",
     true,
     true,
     {"surfaces", "regions", "names", "colours", "unit"}},
    {"iges", "an IGES file", "import", true, false, {"surfaces", "regions", "names", "unit"}},
    {"brep", "a BREP of OpenCASCADE", "import", true, false, {"surfaces", "regions"}},
    {"frd", "results of CalculiX", "solve", false, true, {"tets", "fields"}},
    {"tedit",
     "a whole document",
     "doc",
     true,
     true,
     {"tets", "surfaces", "regions", "names", "history"}}};
  return rows;
}

std::vector<std::string> kept_by(const file_format& format) {
  std::vector<std::string> kept;
  if (format.keeps.tets)
    kept.insert(kept.end(), {"tets", "regions"});
  if (format.keeps.surfaces)
    kept.insert(kept.end(), {"surfaces", "names"});
  if (format.keeps.fields)
    kept.emplace_back("fields");
  if (format.keeps.unit)
    kept.emplace_back("unit");
  if (format.keeps.loads)
    kept.emplace_back("loads");
  if (format.keeps.colours)
    kept.emplace_back("colours");
  return kept;
}

nlohmann::ordered_json row_of(std::string_view name, std::string_view kind, bool reads, bool writes,
                              const std::string& command, const std::vector<std::string>& keeps) {
  return {{"name", name},     {"kind", kind},       {"reads", reads},
          {"writes", writes}, {"command", command}, {"keeps", keeps}};
}

nlohmann::ordered_json all_rows() {
  auto rows = nlohmann::ordered_json::array();
  for (const auto& one : file_formats)
    rows.push_back(row_of(one.name, one.kind, one.reads, one.writes, "convert", kept_by(one)));
  for (const auto& one : of_commands())
    rows.push_back(row_of(one.name, one.kind, one.reads, one.writes, one.command, one.keeps));
  return rows;
}

std::string describe(const nlohmann::ordered_json& rows) {
  std::vector<std::vector<std::string>> table{
    {"format", "what", "read", "written", "command", "keeps"}};
  for (const auto& row : rows) {
    std::string keeps;
    for (const auto& one : row["keeps"])
      keeps += (keeps.empty() ? "" : ", ") + one.get<std::string>();
    const auto yes = [&](const char* key) { return row[key].get<bool>() ? "yes" : ""; };
    table.push_back({row["name"], row["kind"], yes("reads"), yes("writes"),
                     "tedit " + row["command"].get<std::string>(),
                     keeps.empty() ? "the boundary alone" : keeps});
  }
  return format_table(table);
}

}  // namespace

void add_formats(CLI::App& app, action& chosen) {
  auto* command =
    app.add_subcommand("formats", "List the file formats: what is read, written and kept");
  command->callback([&chosen] {
    chosen = [](session& s) {
      const auto rows = all_rows();
      print_result(s, {{"formats", rows}}, describe(rows));
      return 0;
    };
  });
}

}  // namespace tedit::cli
