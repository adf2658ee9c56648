// SPDX-License-Identifier: AGPL-3.0-or-later
// Materials, supports and loads of decks of Abaqus and CalculiX.
#include <algorithm>

#include "mesh/io/inp_reader.hpp"

namespace tedit {

namespace {

/// Which components a word holds, instead of numbers.
std::vector<int> components_of(const std::string& word) {
  if (word == "ENCASTRE" || word == "PINNED")
    return {0, 1, 2};
  if (word == "XSYMM")
    return {0};
  if (word == "YSYMM")
    return {1};
  if (word == "ZSYMM")
    return {2};
  return {};
}

}  // namespace

// -- materials ---------------------------------------------------------------------------------

void inp_reader::begin_material(const inp_keyword& key) {
  out_.loads.materials.push_back({key.value("NAME"), 0, 0, 0, {}});
  skip(key);
}

void inp_reader::read_elastic(const inp_keyword& key) {
  const auto type = key.upper_value("TYPE");
  if (!type.empty() && type != "ISO" && type != "ISOTROPIC") {
    out_.leave_out("*ELASTIC, TYPE=" + shown(type), key.line);
    return skip(key);
  }
  if (out_.loads.materials.empty())
    in_.fail_here(ec::bad_input, "*ELASTIC stands outside of a *MATERIAL",
                  "Put it behind its *MATERIAL");
  if (!next_data())
    return;
  const auto fields = fields_of_line(in_.line());
  auto& material = out_.loads.materials.back();
  material.young_modulus = real_or_zero(fields, 0, "Young's modulus");
  material.poisson_ratio = real_or_zero(fields, 1, "Poisson's ratio");
  if (next_data())
    out_.leave_out("*ELASTIC at more than one temperature", in_.number());
  skip(key);
}

void inp_reader::read_density(const inp_keyword& key) {
  if (!out_.loads.materials.empty() && next_data())
    out_.loads.materials.back().density =
      real_or_zero(fields_of_line(in_.line()), 0, "the density");
  skip(key);
}

void inp_reader::read_section(const inp_keyword& key) {
  sections_.push_back({key.value("ELSET"), key.value("MATERIAL")});
  skip(key);
}

// -- supports and loads ------------------------------------------------------------------------

void inp_reader::begin_step(const inp_keyword& key) {
  if (++steps_ > 1)
    out_.leave_out("*STEP", key.line);
  skip(key);
}

void inp_reader::end_step(const inp_keyword& key) {
  ++ended_steps_;
  skip(key);
}

void inp_reader::read_procedure(const inp_keyword& key) {
  if (steps_ <= 1)
    out_.leave_out("*" + key.name + " (its loads are read as those of *STATIC)", key.line);
  skip(key);
}

bool inp_reader::loads_count(const inp_keyword& key) {
  if (key.has("AMPLITUDE"))
    out_.leave_out("AMPLITUDE of *" + key.name, key.line);
  if (steps_ <= 1)
    return true;
  skip(key);
  return false;
}

void inp_reader::read_boundary(const inp_keyword& key) {
  if (!loads_count(key))
    return;
  while (next_data()) {
    const auto fields = fields_of_line(in_.line());
    if (fields.size() < 2)
      in_.fail_here(ec::bad_input, "*BOUNDARY holds no component on this line",
                    "Write: node or set, first component, last component, value");
    const auto on = plain_name(fields[0]);
    const auto word = upper(fields[1]);
    if (const auto held = components_of(word); !held.empty()) {
      for (const int c : held)
        nodal_lines_.push_back({on, c, c, 0, true, in_.number()});
      continue;
    }
    const auto first = in_.integer(fields[1], "the first component");
    const auto last = fields.size() > 2 && !fields[2].empty()
                        ? in_.integer(fields[2], "the last component")
                        : first;
    const auto value = real_or_zero(fields, 3, "the prescribed value");
    if (first > 3)
      out_.leave_out("*BOUNDARY of component " + std::to_string(first), in_.number());
    else if (first < 1 || last < first)
      in_.fail_here(ec::bad_input,
                    "*BOUNDARY holds the components " + std::to_string(first) + " to " +
                      std::to_string(last) + "; there are 1 to 3",
                    "Correct the line");
    else
      nodal_lines_.push_back({on, static_cast<int>(first) - 1,
                              static_cast<int>(std::min<std::int64_t>(last, 3)) - 1, value, true,
                              in_.number()});
  }
}

void inp_reader::read_cload(const inp_keyword& key) {
  if (!loads_count(key))
    return;
  while (next_data()) {
    const auto fields = fields_of_line(in_.line());
    if (fields.size() < 3)
      in_.fail_here(ec::bad_input, "*CLOAD has too few fields on this line",
                    "Write: node or set, component, force");
    const auto component = in_.integer(fields[1], "the component of a force");
    const auto value = in_.real(fields[2], "a force");
    if (component < 1 || component > 3)
      out_.leave_out("*CLOAD of component " + std::to_string(component), in_.number());
    else
      nodal_lines_.push_back({plain_name(fields[0]), static_cast<int>(component) - 1,
                              static_cast<int>(component) - 1, value, false, in_.number()});
  }
}

void inp_reader::read_dload(const inp_keyword& key) {
  if (!loads_count(key))
    return;
  while (next_data()) {
    const auto fields = fields_of_line(in_.line());
    const auto label = fields.size() > 1 ? upper(fields[1]) : std::string();
    if (label == "GRAV") {
      const auto size = real_or_zero(fields, 2, "the acceleration");
      out_.loads.gravity = size * vec3{real_or_zero(fields, 3, "the direction of gravity"),
                                       real_or_zero(fields, 4, "the direction of gravity"),
                                       real_or_zero(fields, 5, "the direction of gravity")};
    } else if (label.size() == 2 && label[0] == 'P' && label[1] >= '1' && label[1] <= '4') {
      face_loads_.push_back({plain_name(fields[0]), static_cast<std::size_t>(label[1] - '0'),
                             real_or_zero(fields, 2, "a pressure"), in_.number()});
    } else {
      out_.leave_out("*DLOAD of type " + shown(label), in_.number());
    }
  }
}

void inp_reader::read_dsload(const inp_keyword& key) {
  if (!loads_count(key))
    return;
  while (next_data()) {
    const auto fields = fields_of_line(in_.line());
    const auto label = fields.size() > 1 ? upper(fields[1]) : std::string();
    if (label == "P")
      face_loads_.push_back(
        {plain_name(fields[0]), 0, real_or_zero(fields, 2, "a pressure"), in_.number()});
    else
      out_.leave_out("*DSLOAD of type " + shown(label), in_.number());
  }
}

// -- once all is read --------------------------------------------------------------------------

void inp_reader::make_regions() {
  // What our own comments name comes first, then sections, then the blocks of elements.
  std::vector<std::string> names;
  for (const auto& name : out_.region_comment_names())
    if (element_sets_.find(name))
      names.push_back(name);
  if (names.empty())
    for (const auto& one : sections_)
      if (element_sets_.find(one.elements) &&
          std::ranges::find(names, upper(one.elements), upper) == names.end())
        names.push_back(one.elements);
  const bool by_set = !names.empty();
  const auto ids = out_.number_regions(by_set ? names : element_blocks_);
  std::map<std::uint64_t, region_id> region_of;
  for (std::size_t i = 0; by_set && i < names.size(); ++i)
    for (const auto element : element_sets_.find(names[i])->numbers)
      region_of.try_emplace(element, ids[i]);
  for (std::size_t t = 0; t < out_.mesh.tets.size(); ++t)
    if (!by_set)
      out_.mesh.regions[t] = ids[block_of_tet_[t]];
    else if (const auto at = region_of.find(out_.mesh.tet_numbers[t]); at != region_of.end())
      out_.mesh.regions[t] = at->second;
  give_materials();
}

/// A material is that of the regions of its sections' tets.
void inp_reader::give_materials() {
  std::map<std::uint64_t, region_id> region_of;
  for (std::size_t t = 0; t < out_.mesh.tets.size(); ++t)
    region_of.try_emplace(out_.mesh.tet_numbers[t], out_.mesh.regions[t]);
  std::map<std::string, std::set<region_id>> of_material;
  for (const auto& one : sections_)
    if (const auto* set = element_sets_.find(one.elements))
      for (const auto element : set->numbers)
        if (const auto at = region_of.find(element); at != region_of.end())
          of_material[upper(one.material)].insert(at->second);
  for (auto& material : out_.loads.materials)
    if (const auto at = of_material.find(upper(material.name)); at != of_material.end())
      material.regions.assign(at->second.begin(), at->second.end());
}

void inp_reader::resolve_nodal(const nodal_line& one) {
  std::vector<std::uint64_t> nodes;
  if (const auto number = integer_of(one.on)) {
    nodes.push_back(static_cast<std::uint64_t>(*number));
  } else if (const auto* set = node_sets_.find(one.on)) {
    nodes = set->numbers;
  } else {
    throw file_failure{{ec::bad_input,
                        std::string(one.is_support ? "a support" : "a force") +
                          " acts on the set \"" + shown(one.on) + "\", which is not there",
                        "Define that set", "line " + std::to_string(one.line)}};
  }
  for (const auto node : nodes)
    for (int c = one.first; c <= one.last; ++c)
      if (one.is_support)
        out_.add_support(node, c, one.value);
      else
        out_.add_force(node,
                       {c == 0 ? one.value : 0, c == 1 ? one.value : 0, c == 2 ? one.value : 0});
}

std::vector<std::uint64_t> inp_reader::elements_under(const face_load& one) const {
  if (const auto number = integer_of(one.on))
    return {static_cast<std::uint64_t>(*number)};
  if (const auto* set = element_sets_.find(one.on))
    return set->numbers;
  throw file_failure{{ec::bad_input,
                      "a pressure acts on the set \"" + shown(one.on) + "\", which is not there",
                      "Define that set", "line " + std::to_string(one.line)}};
}

void inp_reader::resolve_face(const face_load& one) {
  if (one.face == 0) {
    if (const auto at = surface_places_.find(upper(one.on)); at != surface_places_.end())
      for (const auto& face : out_.mesh.face_sets[at->second].faces)
        out_.add_pressure(face, one.value);
    else
      out_.leave_out("*DSLOAD on \"" + shown(one.on) + "\", which is no surface", one.line);
    return;
  }
  const auto& sides = inp_faces_of_tet[one.face - 1];
  for (const auto element : elements_under(one))
    if (const auto* corners = out_.mesh.find_tet(element))
      out_.add_pressure({(*corners)[sides[0]], (*corners)[sides[1]], (*corners)[sides[2]]},
                        one.value);
    else
      out_.leave_out("*DLOAD on elements that are no tets", one.line);
}

void inp_reader::resolve_loads() {
  std::uint64_t left = 50'000'000;
  const auto count = [&](const std::string& set) {
    const auto* found = node_sets_.find(set);
    const auto* elements = element_sets_.find(set);
    return 1 + (found ? found->numbers.size() : 0) + (elements ? elements->numbers.size() : 0);
  };
  const auto take = [&](std::uint64_t size) {
    if (size > left)
      throw file_failure{{ec::bad_input,
                          "the deck has more supports and loads than can be read",
                          "Write each support and load once",
                          {}}};
    left -= size;
  };
  for (const auto& one : nodal_lines_) {
    take(count(one.on));
    resolve_nodal(one);
  }
  for (const auto& one : face_loads_) {
    const auto at = surface_places_.find(upper(one.on));
    take(count(one.on) +
         (at == surface_places_.end() ? 0 : out_.mesh.face_sets[at->second].faces.size()));
    resolve_face(one);
  }
}

}  // namespace tedit
