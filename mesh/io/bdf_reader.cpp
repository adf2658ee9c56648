// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/bdf_reader.hpp"

#include <algorithm>

#include "mesh/formats.hpp"
#include "mesh/io/deck_names.hpp"
#include "mesh/io/marked_cards.hpp"

namespace tedit {

const bdf_reader::row* bdf_reader::find(const std::string& name) {
  using me = bdf_reader;
  static constexpr row rows[] = {
    {"GRID", &me::read_grid},         {"CTETRA", &me::read_tetra},
    {"CTRIA3", &me::read_triangle},   {"CTRIA6", &me::read_triangle},
    {"CTRIAR", &me::read_triangle},   {"CHEXA", &me::refuse_element},
    {"CPENTA", &me::refuse_element},  {"CPYRAM", &me::refuse_element},
    {"CPYRA", &me::refuse_element},   {"CQUAD4", &me::refuse_element},
    {"CQUAD8", &me::refuse_element},  {"CQUADR", &me::refuse_element},
    {"INCLUDE", &me::refuse_include}, {"PSOLID", &me::read_solid},
    {"BSURFS", &me::read_bsurfs},     {"MAT1", &me::read_material},
    {"SPC", &me::read_spc},           {"SPC1", &me::read_spc1},
    {"SPCADD", &me::read_spcadd},     {"FORCE", &me::read_force},
    {"LOAD", &me::read_load},         {"PLOAD4", &me::read_pload4},
    {"GRAV", &me::read_grav},
  };
  const auto* found = std::ranges::find_if(rows, [&](const row& r) { return name == r.name; });
  return found == std::end(rows) ? nullptr : found;
}

namespace {

/// Cards that say nothing of a part of tets.
bool is_without_meaning(const std::string& name) {
  for (const auto* one : {"PARAM", "ENDDATA", "PSHELL", "MDLPRM", "EIGRL", "EIGR"})
    if (name == one)
      return true;
  return false;
}

/// "12 \"Name\"" or "12\"Name\"": HyperMesh's comments, behind their first words.
std::pair<std::optional<std::int64_t>, std::string> number_and_name(std::string_view text) {
  const auto quote = text.find('"');
  const auto last = text.rfind('"');
  if (quote == text.npos || last == quote)
    return {};
  return {integer_of(text.substr(0, quote)), std::string(text.substr(quote + 1, last - quote - 1))};
}

}  // namespace

void bdf_reader::read_comment(std::string_view line) {
  auto text = trimmed(line).substr(1);
  if (out_.read_comment(trimmed(text)))
    return;
  if (text.starts_with("HMNAME PROP") || text.starts_with("HMNAME COMP")) {
    const auto [id, name] = number_and_name(text.substr(11));
    if (id && *id > 0)
      names_[static_cast<std::uint64_t>(*id)] = name;
    return;
  }
  constexpr std::string_view femap = " Femap Property ";
  const auto colon = text.find(" : ");
  if (!text.starts_with(femap) || colon == text.npos || colon < femap.size())
    return;
  if (const auto id = integer_of(text.substr(femap.size(), colon - femap.size())); id && *id > 0)
    names_[static_cast<std::uint64_t>(*id)] = std::string(trimmed(text.substr(colon + 3)));
}

void bdf_reader::read_case_control(std::string_view line) {
  const auto text = upper(trimmed(line));
  subcases_ += text.starts_with("SUBCASE");
  if (subcases_ > 1) {
    if (text.starts_with("SUBCASE"))
      out_.leave_out("SUBCASE", in_.number());
    return;
  }
  const auto equals = text.find('=');
  if (equals == text.npos)
    return;
  const auto word = trimmed(std::string_view(text).substr(0, equals));
  const auto value = integer_of(std::string_view(text).substr(equals + 1));
  if (word == "TITLE" || (word == "SUBTITLE" && out_.loads.name.empty()))
    out_.loads.name = std::string(trimmed(trimmed(line).substr(equals + 1)));
  if (!value || *value < 1)
    return;
  if (word == "LOAD")
    asked_load_ = static_cast<std::uint64_t>(*value);
  if (word == "SPC")
    asked_spc_ = static_cast<std::uint64_t>(*value);
}

namespace {

/// Whether a line is of the bulk data, in a file that has no BEGIN BULK.
bool begins_bulk(const std::string& text) {
  return text.starts_with("GRID") || text.starts_with("CTETRA") || text.starts_with("MAT1");
}

}  // namespace

read_mesh bdf_reader::run() {
  // First all comments: they may stand between a card and its continuation.
  for (auto lines = in_; lines.next();)
    if (is_bdf_comment(lines.line()))
      read_comment(lines.line());
  while (in_.next()) {
    const auto text = upper(trimmed(in_.line()));
    if (text.empty() || text.starts_with('$'))
      continue;
    if (!in_bulk_ && !begins_bulk(text)) {
      in_bulk_ = text.starts_with("BEGIN") && text.find("BULK") != text.npos;
      has_begin_ = in_bulk_;
      if (!in_bulk_)
        read_case_control(in_.line());
      continue;
    }
    in_bulk_ = true;
    if (text.starts_with("ENDDATA")) {
      has_end_ = true;
      break;
    }
    const auto card = read_bdf_card(in_);
    if (const auto* known = find(card.name()))
      (this->*known->read)(card);
    else if (!is_without_meaning(card.name()))
      out_.leave_out(shown(card.name()), card.line);
  }
  make_regions();
  make_surfaces();
  take_loads();
  auto marked = find_marked_case(in_.text(), "$ ");
  out_.loads.load_case = std::move(marked.load_case);
  if (!out_.loads.load_case.empty())
    out_.forget("MPC");
  if (marked.changed)
    out_.mesh_notice =
      "the load case that TEdit wrote into the file is left out: its cards were "
      "changed since, and are read as they are";
  auto read = out_.finish();
  if (has_begin_ && !has_end_)
    read.notices.push_back("the deck has BEGIN BULK and no ENDDATA: it may be cut off");
  for (const auto& words : nothing_asked_)
    read.notices.push_back(words);
  return read;
}

std::uint64_t bdf_reader::number(const bdf_card& card, std::size_t field, const char* what) {
  const auto value = integer_of(card.at(field));
  if (value && *value > 0)
    return static_cast<std::uint64_t>(*value);
  throw file_failure{
    {ec::bad_input,
     std::string(what) + " of a " + shown(card.name()) + " is \"" + shown(card.at(field)) +
       "\", not a whole number from 1 (field " + std::to_string(field + 1) + ")",
     "Correct the card or write the file again", "line " + std::to_string(card.line)}};
}

double bdf_reader::real(const bdf_card& card, std::size_t field, const char* what) {
  if (card.at(field).empty())
    return 0;
  if (const auto value = real_of(card.at(field)))
    return *value;
  throw file_failure{
    {ec::bad_input,
     std::string(what) + " of a " + shown(card.name()) + " is \"" + shown(card.at(field)) +
       "\", not a finite number (field " + std::to_string(field + 1) + ")",
     "Correct the card or write the file again", "line " + std::to_string(card.line)}};
}

void bdf_reader::refuse_element(const bdf_card& card) {
  throw file_failure{
    {ec::unsupported_format,
     "the deck holds a " + shown(card.name()) + "; only tetrahedra (CTETRA) are supported",
     "Mesh the volume with tetrahedra", "line " + std::to_string(card.line)}};
}

void bdf_reader::refuse_include(const bdf_card& card) {
  throw file_failure{{ec::unsupported_format, "the deck takes in another file by INCLUDE",
                      "Put its lines in the place of INCLUDE: files are read one by one",
                      "line " + std::to_string(card.line)}};
}

void bdf_reader::refuse_system(const bdf_card& card) {
  throw file_failure{{ec::unsupported_format,
                      "GRID " + shown(card.at(1)) + " is in coordinate system " +
                        shown(card.at(2)) + "; only the basic one (0) is read",
                      "Write the nodes in basic coordinates", "line " + std::to_string(card.line)}};
}

/// Fields behind the coordinates: mostly a decimal comma has made them.
void bdf_reader::check_behind_coordinates(const bdf_card& card) {
  const auto is_set = [&](std::size_t field) {
    return !card.at(field).empty() && integer_of(card.at(field)) != 0;
  };
  if (!is_set(6) && !is_set(7) && !is_set(8))
    return;
  for (std::size_t field = 3; field < 6; ++field)
    if (integer_of(card.at(field)).value_or(0) != 0)
      throw file_failure{{ec::bad_input,
                          "GRID " + shown(card.at(1)) + " has the whole number " +
                            shown(card.at(field)) +
                            " as a coordinate, and fields behind its coordinates",
                          "Write decimals with a point", "line " + std::to_string(card.line)}};
  if (is_set(6))
    out_.leave_out("GRID with displacements in a coordinate system of its own", card.line);
  if (is_set(7))
    out_.leave_out("GRID with supports of its own", card.line);
}

void bdf_reader::read_grid(const bdf_card& card) {
  if (!card.at(2).empty() && integer_of(card.at(2)) != 0)
    refuse_system(card);
  const auto node = number(card, 1, "the number");
  check_behind_coordinates(card);
  out_.mesh.add_node(node, {real(card, 3, "a coordinate"), real(card, 4, "a coordinate"),
                            real(card, 5, "a coordinate")});
}

void bdf_reader::read_tetra(const bdf_card& card) {
  const auto element = number(card, 1, "the number");
  property_of_tet_.push_back(card.at(2).empty() ? element : number(card, 2, "the property"));
  std::vector<std::uint64_t> nodes;
  for (std::size_t i = 3; i < 7; ++i)
    nodes.push_back(number(card, i, "a node"));
  // Middles may be left out, one by one: then the tet is read as one of four nodes.
  bool all = true;
  for (std::size_t i = 7; i < 13; ++i)
    all = all && !card.at(i).empty() && integer_of(card.at(i)) != 0;
  for (std::size_t i = 7; all && i < 13; ++i)
    nodes.push_back(number(card, i, "a node"));
  out_.mesh.add_tet(element, 0, nodes);
}

void bdf_reader::read_triangle(const bdf_card& card) {
  const auto property = number(card, 2, "the property");
  const auto [at, fresh] = shells_.try_emplace(property, out_.mesh.face_sets.size());
  if (fresh)
    out_.mesh.face_sets.push_back(
      {surface_word(static_cast<surface_id>(property)), static_cast<surface_id>(property)});
  out_.mesh.face_sets[at->second].faces.push_back(
    {number(card, 3, "a node"), number(card, 4, "a node"), number(card, 5, "a node")});
}

void bdf_reader::read_solid(const bdf_card& card) {
  if (!card.at(2).empty())
    material_of_property_[number(card, 1, "the number")] = number(card, 2, "the material");
}

void bdf_reader::read_bsurfs(const bdf_card& card) {
  const auto surface = number(card, 1, "the number");
  for (std::size_t i = 5; i + 3 < card.size(); i += 4)
    if (!card.at(i).empty())
      surface_faces_.push_back({surface,
                                {number(card, i + 1, "a node"), number(card, i + 2, "a node"),
                                 number(card, i + 3, "a node")}});
}

void bdf_reader::make_surfaces() {
  std::map<std::uint64_t, std::size_t> places;
  for (const auto& one : surface_faces_) {
    const auto [at, fresh] = places.try_emplace(one.surface, out_.mesh.face_sets.size());
    if (fresh)
      out_.mesh.face_sets.push_back({surface_word(static_cast<surface_id>(one.surface)), {}});
    out_.mesh.face_sets[at->second].faces.push_back(one.corners);
  }
  for (const auto& [property, place] : shells_)
    if (const auto name = names_.find(property); name != names_.end())
      out_.mesh.face_sets[place].name = name->second;
}

void bdf_reader::make_regions() {
  const std::set<std::uint64_t> properties(property_of_tet_.begin(), property_of_tet_.end());
  std::vector<std::string> words;
  for (const auto property : properties)
    words.push_back("REGION-" + std::to_string(property));
  const auto ids = out_.number_regions(words);
  std::map<std::uint64_t, region_id> id_of;
  for (const auto property : properties)
    id_of[property] = ids[id_of.size()];
  for (std::size_t t = 0; t < property_of_tet_.size(); ++t)
    out_.mesh.regions[t] = id_of[property_of_tet_[t]];
  std::size_t place = 0;
  for (const auto property : properties) {
    auto& row = out_.mesh.region_names[place];
    // Without a comment of ours the word stands there, which says nothing.
    if (row.name == words[place++])
      row.name = names_.contains(property) ? names_[property] : "";
    const auto material = material_of_property_.find(property);
    if (material == material_of_property_.end())
      continue;
    if (const auto at = material_places_.find(material->second); at != material_places_.end())
      out_.loads.materials[at->second].regions.push_back(row.id);
  }
}

bool formats::bdf::recognises(std::span<const char> bytes) {
  constexpr std::size_t enough = 1 << 16;
  line_cursor in(bytes.first(std::min(bytes.size(), enough)));
  while (in.next()) {
    const auto line = upper(trimmed(in.line()));
    if (line.empty() || line.starts_with("$ ") || line == "$")
      continue;
    if (line.starts_with('$'))  // A section of Gmsh begins with a word.
      if (line.starts_with("$MESHFORMAT"))
        return false;
    for (const auto* word : {"SOL ", "SOL,", "CEND", "BEGIN", "GRID", "CTETRA", "NASTRAN ",
                             "ASSIGN ", "INIT ", "ID ", "MAT1", "PSOLID", "PARAM", "TITLE"})
      if (line.starts_with(word))
        return true;
    if (!line.starts_with('$'))
      return false;
  }
  return false;
}

expected<read_mesh> formats::bdf::read(std::span<const char> bytes) {
  return guarded_read([&] { return bdf_reader(bytes).run(); });
}

}  // namespace tedit
