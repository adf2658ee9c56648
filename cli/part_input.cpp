// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/part_input.hpp"

#include <algorithm>
#include <utility>

#include <CLI/CLI.hpp>

#include "cli/load_case_files.hpp"
#include "cli/part_document.hpp"
#include "mesh/formats.hpp"

namespace tedit::cli {

namespace {

expected<input_part> read_from_document(const part_input& input) {
  auto found = read_version_of(input.file, input.version);
  if (!found)
    return fail(found.error());
  input_part part;
  part.mesh.version = std::move(found->mesh);
  part.mesh.length_unit = input.length_unit;
  part.load_cases = std::move(found->load_cases);
  part.number = found->number;
  return part;
}

const fem::load_case* find_case(const input_part& part, const std::string& name) {
  const auto found = std::ranges::find(part.load_cases, name, &fem::load_case::name);
  return found == part.load_cases.end() ? nullptr : &*found;
}

}  // namespace

std::string names_of(const std::vector<fem::load_case>& load_cases) {
  std::string text;
  for (const auto& one : load_cases)
    text += (text.empty() ? "" : ", ") + one.name;
  return text.empty() ? "none" : text;
}

void add_part_options(CLI::App& command, part_input& input, const std::string& unit_help) {
  command.add_option("mesh", input.file, read_formats_text() + "; or a document (.tedit)")
    ->required();
  command.add_option("--version", input.version,
                     "Of a document: the version's number; the current one without it");
  command.add_option("--length-unit", input.length_unit, unit_help)->capture_default_str();
}

expected<input_part> read_input(const part_input& input, const session& s) {
  if (is_document(input.file))
    return read_from_document(input);
  if (input.version)
    return fail(ec::usage,
                "--version names a version of a document, and " + input.file + " is a mesh",
                "Leave it out, or give a document (.tedit)");
  auto imported = import_mesh(input.file, input.length_unit);
  if (!imported)
    return fail(imported.error());
  for (const auto& warning : imported->warnings)
    notice(s, "note: " + warning);
  return input_part{std::move(*imported), {}, {}};
}

expected<std::vector<fem::load_case>> cases_of(const part_input& input, const input_part& part,
                                               const std::vector<std::string>& told) {
  if (told.empty() && part.load_cases.empty())
    return fail(ec::usage,
                part.number
                  ? input.file + " has no load case in version " + std::to_string(*part.number)
                  : "--load-case is missing",
                "Name the file of one with --load-case: materials, supports and loads");
  if (told.empty())
    return part.load_cases;
  std::vector<std::string> files;
  std::vector<fem::load_case> own;
  for (const auto& word : told)
    if (const auto* one = find_case(part, word))
      own.push_back(*one);
    else
      files.push_back(word);
  auto read = read_load_cases(files);
  if (!read) {
    auto why = read.error();
    if (part.number && why.code == ec::io_error)
      why.remedy =
        "Name a file, or a load case that the document has: " + names_of(part.load_cases);
    return fail(std::move(why));
  }
  own.insert(own.end(), read->begin(), read->end());
  name_apart(own);
  return own;
}

}  // namespace tedit::cli
