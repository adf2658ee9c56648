// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/exchange.hpp"

#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "base/text.hpp"

namespace tedit::cad {

namespace {

using nlohmann::json;

/// Bytes of a name that are kept, as for meshes.
constexpr std::size_t longest_name = 200;

json to_json(const std::optional<colour>& looks) {
  return looks ? json(*looks) : json();
}

std::optional<colour> colour_of(const json& from) {
  return from.is_null() ? std::nullopt : std::optional(from.get<colour>());
}

/// What a file says goes into files and messages that must be UTF-8 and of one line.
std::string name_of(const json& from) {
  auto name = to_utf8(from.get<std::string>());
  for (auto& c : name)
    if (static_cast<unsigned char>(c) < ' ' || c == '"')
      c = ' ';
  return std::string(cut_text(name, longest_name));
}

/// A hundred thousand faces have less.
constexpr std::uintmax_t most_bytes = std::uintmax_t{64} << 20;

expected<json> load(const std::filesystem::path& file) {
  std::error_code code;
  const auto size = std::filesystem::file_size(file, code);
  if (!code && size > most_bytes)
    return fail(ec::bad_input, "the part has more faces than can be taken",
                "Import its solids one by one");
  std::ifstream in(file);
  auto read = json::parse(in, nullptr, false);
  if (read.is_discarded())
    return fail(ec::internal, file.filename().string() + " of the import's folder is damaged",
                "Try again; if it stays, report it with the CAD file");
  return read;
}

bool save(const json& what, const std::filesystem::path& file) {
  std::ofstream out(file);
  out << what.dump(-1, ' ', false, json::error_handler_t::replace);
  return static_cast<bool>(out.flush());
}

tl::unexpected<error> not_as_written(const json::exception& why) {
  return fail(ec::internal, std::string("an import's program wrote what cannot be: ") + why.what(),
              "Try again; if it stays, report it with the CAD file");
}

json to_json(const part_facts& facts) {
  json faces = json::array();
  for (const auto& one : facts.faces)
    faces.push_back({{"name", one.name},
                     {"colour", to_json(one.looks)},
                     {"area", one.area_mm2},
                     {"ids", one.ids}});
  json solids = json::array();
  for (const auto& one : facts.solids)
    solids.push_back({{"name", one.name},
                      {"colour", to_json(one.looks)},
                      {"volume", one.volume_mm3},
                      {"area", one.area_mm2}});
  return {
    {"unit", facts.length_unit}, {"faces", faces}, {"solids", solids}, {"notices", facts.notices}};
}

expected<part_facts> facts_of(const json& from) {
  try {
    part_facts facts;
    facts.length_unit = from.at("unit").get<std::string>();
    for (const auto& one : from.at("faces"))
      facts.faces.push_back({name_of(one.at("name")), colour_of(one.at("colour")),
                             one.at("area").get<double>(), one.at("ids").get<std::vector<int>>()});
    for (const auto& one : from.at("solids"))
      facts.solids.push_back({name_of(one.at("name")), colour_of(one.at("colour")),
                              one.at("volume").get<double>(), one.at("area").get<double>()});
    facts.notices = from.at("notices").get<std::vector<std::string>>();
    return facts;
  } catch (const json::exception& why) {
    return not_as_written(why);
  }
}

}  // namespace

std::string to_text(const part_facts& facts) {
  return to_json(facts).dump(-1, ' ', false, json::error_handler_t::replace);
}

expected<part_facts> facts_from(std::string_view text) {
  const auto read = json::parse(text, nullptr, false);
  if (read.is_discarded())
    return fail(ec::internal, "what is known of the CAD model's faces is damaged",
                "Import the CAD file again");
  return facts_of(read);
}

bool save_facts(const part_facts& facts, const std::filesystem::path& folder) {
  return save(to_json(facts), folder / facts_file);
}

expected<part_facts> load_facts(const std::filesystem::path& folder) {
  const auto read = load(folder / facts_file);
  return read ? facts_of(*read) : expected<part_facts>(fail(read.error()));
}

bool save_report(const mesh_report& report, const std::filesystem::path& folder) {
  return save({{"size", report.size_mm},
               {"collapsed", report.collapsed},
               {"flipped", report.flipped},
               {"moved", report.moved_mm},
               {"gone", report.gone}},
              folder / report_file);
}

expected<mesh_report> load_report(const std::filesystem::path& folder) {
  const auto read = load(folder / report_file);
  if (!read)
    return fail(read.error());
  try {
    return mesh_report{read->at("size").get<double>(), read->at("collapsed").get<std::size_t>(),
                       read->at("flipped").get<std::size_t>(), read->at("moved").get<double>(),
                       read->at("gone").get<std::vector<int>>()};
  } catch (const json::exception& why) {
    return not_as_written(why);
  }
}

}  // namespace tedit::cad
