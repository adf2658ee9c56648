// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/inp_reader.hpp"

#include <algorithm>

#include "mesh/formats.hpp"
#include "mesh/io/marked_cards.hpp"

namespace tedit {

namespace {

constexpr std::string_view own_comment = "** ";

/// Nodes of an element type, and what becomes of it.
struct inp_element {
  enum class use { tet, face, skip, refuse };
  use purpose = use::refuse;
  std::size_t nodes = 0;
};

inp_element kind_of(const std::string& type) {
  using enum inp_element::use;
  const auto begins = [&](const char* text) { return type.starts_with(text); };
  if (begins("C3D10"))
    return {tet, 10};
  if (begins("C3D4"))
    return {tet, 4};
  for (const auto* name : {"STRI65", "S6", "CPS6", "CPE6", "CAX6", "M3D6", "DS6", "SFM3D6"})
    if (begins(name))
      return {face, 6};
  for (const auto* name : {"STRI3", "S3", "CPS3", "CPE3", "CAX3", "M3D3", "DS3", "SFM3D3", "R3D3"})
    if (begins(name))
      return {face, 3};
  for (const auto* name :
       {"T3D", "T2D", "B3", "B2", "SPRING", "MASS", "ROTARYI", "CONN", "DASHPOT"})
    if (begins(name))
      return {skip, 0};
  return {};
}

}  // namespace

inp_reader::inp_reader(std::span<const char> bytes)
    : in_(bytes),
      node_sets_(1'000'000 + 4 * std::uint64_t{bytes.size()}),
      element_sets_(1'000'000 + 4 * std::uint64_t{bytes.size()}) {}

const inp_reader::row* inp_reader::find(const std::string& keyword) {
  using me = inp_reader;
  static constexpr row rows[] = {
    {"HEADING", &me::read_heading},
    {"INCLUDE", &me::refuse_include},
    {"PART", &me::begin_part},
    {"INSTANCE", &me::begin_instance},
    {"NODE", &me::read_nodes},
    {"ELEMENT", &me::read_elements},
    {"NSET", &me::read_node_set},
    {"ELSET", &me::read_element_set},
    {"SURFACE", &me::read_surface},
    {"MATERIAL", &me::begin_material},
    {"ELASTIC", &me::read_elastic},
    {"DENSITY", &me::read_density},
    {"SOLIDSECTION", &me::read_section},
    {"BOUNDARY", &me::read_boundary},
    {"CLOAD", &me::read_cload},
    {"DLOAD", &me::read_dload},
    {"DSLOAD", &me::read_dsload},
    {"STEP", &me::begin_step},
    {"ENDSTEP", &me::end_step},
    {"STATIC", &me::skip},
    {"FREQUENCY", &me::read_procedure},
    {"BUCKLE", &me::read_procedure},
    {"DYNAMIC", &me::read_procedure},
    {"HEATTRANSFER", &me::read_procedure},
    {"COUPLEDTEMPERATURE-DISPLACEMENT", &me::read_procedure},
  };
  const auto* found =
    std::ranges::find_if(rows, [&](const row& r) { return keyword == r.keyword; });
  return found == std::end(rows) ? nullptr : found;
}

namespace {

/// What asks for output, or closes what another keyword opened: nothing is lost with it.
bool says_nothing_of_the_part(const std::string& keyword) {
  for (const auto* name :
       {"ENDPART", "ENDASSEMBLY", "ENDINSTANCE", "ASSEMBLY", "PREPRINT", "RESTART", "OUTPUT",
        "NODEOUTPUT", "ELEMENTOUTPUT", "NODEPRINT", "NODEFILE", "ELPRINT", "ELFILE", "ENERGYFILE",
        "CONTACTFILE", "PHYSICALCONSTANTS", "CONTROLS", "MONITOR", "FILEFORMAT"})
    if (keyword == name)
      return true;
  return false;
}

}  // namespace

void inp_reader::read_comment(std::string_view line) {
  const auto text = trimmed(line).substr(2);
  if (!out_.read_comment(trimmed(text)) && trimmed(text).starts_with("Units: SI (m,"))
    out_.length_unit = "m";
}

bool inp_reader::next_data() {
  while (in_.next()) {
    if (is_comment_line(in_.line())) {
      read_comment(in_.line());
    } else if (is_keyword_line(in_.line())) {
      in_.back();
      return false;
    } else if (!trimmed(in_.line()).empty()) {
      return true;
    }
  }
  return false;
}

void inp_reader::skip(const inp_keyword&) {
  while (next_data()) {
    // Nothing of it is kept.
  }
}

void inp_reader::read_heading(const inp_keyword&) {
  if (next_data())
    out_.loads.name = std::string(trimmed(in_.line()));
  skip({});
}

void inp_reader::refuse_include(const inp_keyword& key) {
  const auto word = "*" + key.name + (key.name == "INCLUDE" ? "" : ", INPUT");
  in_.fail_here(
    ec::unsupported_format,
    "the deck takes in another file by " + word + " (" + shown(key.value("INPUT")) + ")",
    "Put its lines in the place of " + word + ": files are read one by one");
}

void inp_reader::refuse_many(const inp_keyword& key) {
  in_.fail_here(
    ec::unsupported_format,
    "the deck has more than one *" + key.name + ", here \"" + shown(key.value("NAME")) + "\"",
    "Write a flat deck (in Abaqus: *PREPRINT, MODEL or \"Do not use parts and "
    "assemblies\"), or each part by itself");
}

void inp_reader::begin_part(const inp_keyword& key) {
  if (++parts_ > 1)
    refuse_many(key);
  skip(key);
}

void inp_reader::begin_instance(const inp_keyword& key) {
  if (++instances_ > 1)
    refuse_many(key);
  if (next_data())
    in_.fail_here(ec::unsupported_format,
                  "instance \"" + shown(key.value("NAME")) + "\" is moved from where its part is",
                  "Write a flat deck (in Abaqus: \"Do not use parts and assemblies\")");
}

read_mesh inp_reader::run() {
  while (in_.next()) {
    if (is_comment_line(in_.line())) {
      read_comment(in_.line());
      continue;
    }
    if (trimmed(in_.line()).empty())
      continue;
    if (!is_keyword_line(in_.line()))
      in_.fail_here(ec::bad_input,
                    "a line that begins with * was expected, not \"" + shown(in_.line()) + "\"",
                    "The file is no deck of Abaqus or CalculiX, or it is damaged");
    const auto key = read_keyword(in_);
    if (const auto* known = find(key.name)) {
      (this->*known->read)(key);
    } else {
      if (!says_nothing_of_the_part(key.name))
        out_.leave_out("*" + shown(key.name), key.line);
      skip(key);
    }
  }
  make_regions();
  resolve_surfaces();
  resolve_loads();
  for (const auto* set : node_sets_.all())
    out_.mesh.node_sets.push_back({set->name, set->numbers});
  take_marked_case();
  auto read = out_.finish();
  if (steps_ > ended_steps_)
    read.notices.push_back("a *STEP of the deck has no *END STEP: it may be cut off");
  return read;
}

void inp_reader::read_nodes(const inp_keyword& key) {
  if (key.has("INPUT"))
    refuse_include(key);
  if (key.has("SYSTEM") && key.upper_value("SYSTEM") != "R")
    in_.fail_here(ec::unsupported_format, "*NODE with cylindrical or spherical coordinates",
                  "Write the nodes in Cartesian coordinates");
  auto* set = key.has("NSET") ? &node_sets_.set(key.value("NSET")) : nullptr;
  while (next_data()) {
    const auto fields = fields_of_line(in_.line());
    const auto number = in_.positive(fields[0], "a node's number");
    // Behind three coordinates Abaqus has the normals of shells; mostly it is a decimal comma.
    if (fields.size() > 4)
      in_.fail_here(ec::bad_input,
                    "node " + std::to_string(number) + " has " + std::to_string(fields.size() - 1) +
                      " coordinates, not 3",
                    "Write decimals with a point, and leave out normals");
    vec3 at;
    at.x = real_or_zero(fields, 1, "a node's x");
    at.y = real_or_zero(fields, 2, "a node's y");
    at.z = real_or_zero(fields, 3, "a node's z");
    out_.mesh.add_node(number, at);
    if (set)
      require_room(node_sets_.add(*set, number));
  }
}

double inp_reader::real_or_zero(const std::vector<std::string_view>& fields, std::size_t i,
                                const char* what) {
  return i < fields.size() && !fields[i].empty() ? in_.real(fields[i], what) : 0;
}

void inp_reader::read_elements(const inp_keyword& key) {
  const auto type = key.upper_value("TYPE");
  const auto kind = kind_of(type);
  if (key.has("INPUT"))
    refuse_include(key);
  if (kind.purpose == inp_element::use::skip)
    return skip(key);
  if (type.empty())
    in_.fail_here(ec::bad_input, "*ELEMENT does not say its TYPE", "Write *ELEMENT, TYPE=C3D4");
  if (kind.purpose == inp_element::use::refuse)
    in_.fail_here(ec::unsupported_format,
                  "the deck holds elements of type \"" + shown(type) +
                    "\"; only tetrahedra (C3D4, C3D10) are supported",
                  "Mesh the volume with tetrahedra");
  std::vector<std::uint64_t> numbers;
  std::size_t line = 0;
  while (next_data()) {
    line = numbers.empty() ? in_.number() : line;
    for (const auto field : fields_of_line(in_.line()))
      numbers.push_back(in_.positive(field, "a number of an element"));
    // An element goes on in the next line until it has all of its nodes.
    if (numbers.size() < kind.nodes + 1)
      continue;
    if (numbers.size() > kind.nodes + 1)
      refuse_element(type, numbers, kind.nodes, line);
    add_element(type, numbers, key);
    numbers.clear();
  }
  if (!numbers.empty())
    refuse_element(type, numbers, kind.nodes, line);
}

void inp_reader::refuse_element(const std::string& type, const std::vector<std::uint64_t>& numbers,
                                std::size_t nodes, std::size_t line) {
  throw file_failure{
    {ec::bad_input,
     "element " + std::to_string(numbers[0]) + " of type " + shown(type) + " lists " +
       std::to_string(numbers.size() - 1) + " nodes, it has " + std::to_string(nodes),
     "The file is cut off or damaged: write it again", "line " + std::to_string(line)}};
}

void inp_reader::add_element(const std::string& type, const std::vector<std::uint64_t>& numbers,
                             const inp_keyword& key) {
  const auto name = key.value("ELSET");
  const std::vector<std::uint64_t> nodes(numbers.begin() + 1, numbers.end());
  if (kind_of(type).purpose == inp_element::use::face) {
    const auto [at, fresh] = shells_.try_emplace(upper(name), out_.mesh.face_sets.size());
    if (fresh)
      out_.mesh.face_sets.push_back({name.empty() ? "shells" : name});
    out_.mesh.face_sets[at->second].faces.push_back({nodes[0], nodes[1], nodes[2]});
    return;
  }
  out_.mesh.add_tet(numbers[0], 0, nodes);
  const auto same = [&](const std::string& other) { return upper(other) == upper(name); };
  auto block = element_blocks_.empty() || !same(element_blocks_.back())
                 ? std::ranges::find_if(element_blocks_, same)
                 : element_blocks_.end() - 1;
  if (block == element_blocks_.end())
    block = element_blocks_.insert(block, name);
  block_of_tet_.push_back(static_cast<std::size_t>(block - element_blocks_.begin()));
  if (!name.empty())
    require_room(element_sets_.add(element_sets_.set(name), numbers[0]));
}

void inp_reader::require_room(bool has_room) {
  if (!has_room)
    in_.fail_here(ec::bad_input,
                  "a set has more members than such a file can have nodes or elements",
                  "Check first, last and step of GENERATE, and sets that hold each other");
}

void inp_reader::add_member(number_sets_of_deck& sets, number_sets_of_deck::entry& to,
                            std::string_view field) {
  if (integer_of(field))
    return require_room(sets.add(to, in_.positive(field, "a number of a set")));
  const auto* other = sets.find(plain_name(field));
  if (!other)
    in_.fail_here(ec::bad_input,
                  "set \"" + shown(to.name) + "\" names \"" + shown(field) +
                    "\", which is neither a number nor a set",
                  "Define that set first");
  require_room(sets.add_all(to, *other));
}

void inp_reader::read_set(const inp_keyword& key, number_sets_of_deck& sets,
                          const std::string& name) {
  if (name.empty())
    in_.fail_here(ec::bad_input, "*" + key.name + " does not say the name of its set",
                  "Write *" + key.name + ", " + key.name + "=NAME");
  auto& set = sets.set(name);
  while (next_data()) {
    const auto fields = fields_of_line(in_.line());
    if (!key.has("GENERATE")) {
      for (const auto field : fields)
        add_member(sets, set, field);
      continue;
    }
    const auto first = in_.positive(fields[0], "the first number of GENERATE");
    const auto last =
      fields.size() > 1 ? in_.positive(fields[1], "the last number of GENERATE") : first;
    const auto step = fields.size() > 2 ? in_.positive(fields[2], "the step of GENERATE") : 1;
    if (last < first)
      in_.fail_here(
        ec::bad_input,
        "GENERATE goes back, from " + std::to_string(first) + " to " + std::to_string(last),
        "Write: first, last, step");
    require_room(sets.add_range(set, first, last, step));
  }
}

void inp_reader::read_node_set(const inp_keyword& key) {
  read_set(key, node_sets_, key.value("NSET"));
}

void inp_reader::read_element_set(const inp_keyword& key) {
  read_set(key, element_sets_, key.value("ELSET"));
}

void inp_reader::read_surface(const inp_keyword& key) {
  const auto name = key.value("NAME");
  if (key.upper_value("TYPE") == "NODE") {
    auto& set = node_sets_.set(name);
    while (next_data())
      add_member(node_sets_, set, fields_of_line(in_.line())[0]);
    return;
  }
  const auto [at, fresh] = surface_places_.try_emplace(upper(name), out_.mesh.face_sets.size());
  if (fresh)
    out_.mesh.face_sets.push_back({name});
  while (next_data()) {
    const auto fields = fields_of_line(in_.line());
    const auto face = fields.size() > 1 ? upper(fields[1]) : std::string();
    const bool is_side = face.size() == 2 && face[0] == 'S' && face[1] >= '1' && face[1] <= '4';
    if (!is_side && face != "SPOS" && face != "SNEG")
      in_.fail_here(
        ec::bad_input,
        "surface \"" + shown(name) + "\" names face \"" + shown(face) + "\"; tets have S1 to S4",
        "Write each line as: element or set, S1");
    surface_lines_.push_back({at->second, plain_name(fields[0]),
                              is_side ? static_cast<std::size_t>(face[1] - '0') : 0, in_.number()});
  }
}

void inp_reader::add_faces(std::size_t set, std::int64_t element, std::size_t face,
                           std::size_t line) {
  const auto* corners =
    element > 0 ? out_.mesh.find_tet(static_cast<std::uint64_t>(element)) : nullptr;
  if (!corners)
    throw file_failure{{ec::bad_input,
                        "surface \"" + shown(out_.mesh.face_sets[set].name) + "\" names element " +
                          std::to_string(element) + ", which is no tet",
                        "Write the file with all of its elements", "line " + std::to_string(line)}};
  const auto& sides = inp_faces_of_tet[face - 1];
  out_.mesh.face_sets[set].faces.push_back(
    {(*corners)[sides[0]], (*corners)[sides[1]], (*corners)[sides[2]]});
}

void inp_reader::resolve_surfaces() {
  for (const auto& one : surface_lines_) {
    if (const auto shells = shells_.find(upper(one.elements)); shells != shells_.end()) {
      // The shells of a set are a surface already, under the set's name.
      continue;
    }
    if (one.face == 0)
      continue;
    if (const auto number = integer_of(one.elements)) {
      add_faces(one.surface, *number, one.face, one.line);
    } else if (const auto* set = element_sets_.find(one.elements)) {
      for (const auto element : set->numbers)
        add_faces(one.surface, static_cast<std::int64_t>(element), one.face, one.line);
    } else {
      throw file_failure{{ec::bad_input,
                          "surface \"" + shown(out_.mesh.face_sets[one.surface].name) +
                            "\" names the set \"" + shown(one.elements) + "\", which is not there",
                          "Define that set", "line " + std::to_string(one.line)}};
    }
  }
}

void inp_reader::take_marked_case() {
  auto marked = find_marked_case(in_.text(), own_comment);
  out_.loads.load_case = std::move(marked.load_case);
  if (!out_.loads.load_case.empty())
    out_.forget("*EQUATION");
  if (marked.changed)
    out_.mesh_notice =
      "the load case that TEdit wrote into the file is left out: its cards were "
      "changed since, and are read as they are";
}

bool formats::inp::recognises(std::span<const char> bytes) {
  constexpr std::size_t enough = 1 << 16;
  line_cursor in(bytes.first(std::min(bytes.size(), enough)));
  while (in.next()) {
    const auto line = trimmed(in.line());
    if (line.empty() || line.starts_with("**"))
      continue;
    return line.size() > 1 && line[0] == '*' && std::isalpha(static_cast<unsigned char>(line[1]));
  }
  return false;
}

expected<read_mesh> formats::inp::read(std::span<const char> bytes) {
  return guarded_read([&] { return inp_reader(bytes).run(); });
}

}  // namespace tedit
