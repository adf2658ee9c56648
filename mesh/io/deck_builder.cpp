// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/deck_builder.hpp"

#include <algorithm>
#include <set>

#include "base/units.hpp"
#include "mesh/io/line_cursor.hpp"

namespace tedit {

namespace {

/// Longest of sentences about what is left out; a hostile file has as many words as it likes.
constexpr std::size_t most_words = 12;

/// The word before the next blank, taken off `text`.
std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  const auto word = text.substr(0, text.find(' '));
  text.remove_prefix(word.size());
  return word;
}

}  // namespace

bool deck_builder::read_comment(std::string_view comment) {
  auto rest = comment;
  if (take_word(rest) != "TEdit")
    return false;
  const auto what = take_word(rest);
  if (what == "unit") {
    const auto unit = take_word(rest);
    if (metres_per_unit(unit))
      length_unit = std::string(unit);
    return true;
  }
  if (what != "surface" && what != "region")
    return false;
  const auto id = integer_of(take_word(rest));
  if (!id || take_word(rest) != "is")
    return false;
  rest = trimmed(rest);
  const auto colon = rest.find(": ");
  const auto word = upper(trimmed(rest.substr(0, std::min(rest.find(':'), rest.size()))));
  auto& known = what == "surface" ? surface_comments_ : region_comments_;
  known[word] = {*id, colon == rest.npos ? "" : std::string(rest.substr(colon + 2))};
  return true;
}

std::vector<std::string> deck_builder::region_comment_names() const {
  std::vector<std::string> result;
  for (const auto& [word, known] : region_comments_)
    result.push_back(word);
  return result;
}

void deck_builder::add_support(std::uint64_t node, int component, double value) {
  supports_.push_back({node, component, {value, 0, 0}});
}

void deck_builder::add_force(std::uint64_t node, vec3 value) {
  forces_.push_back({node, 0, value});
}

void deck_builder::add_pressure(const std::array<std::uint64_t, 3>& corners, double value) {
  pressures_.push_back({corners, value});
}

void deck_builder::leave_out(const std::string& what, std::size_t line) {
  if (left_out_.size() >= 1000 && !left_out_.contains(what))
    return;
  auto& [first, count] = left_out_[what];
  first = count == 0 ? line : first;
  ++count;
}

std::vector<region_id> deck_builder::number_regions(const std::vector<std::string>& names) {
  std::vector<std::int64_t> ids;
  std::set<std::int64_t> distinct;
  for (const auto& name : names) {
    const auto known = region_comments_.find(upper(name));
    const auto number =
      known == region_comments_.end() ? number_at_end(name) : std::optional(known->second.id);
    if (number && *number >= INT32_MIN && *number <= INT32_MAX && distinct.insert(*number).second)
      ids.push_back(*number);
  }
  if (ids.size() != names.size()) {
    ids.clear();
    for (std::size_t i = 0; i < names.size(); ++i)
      ids.push_back(static_cast<std::int64_t>(i + 1));
  }
  std::vector<region_id> result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto known = region_comments_.find(upper(names[i]));
    result.push_back(static_cast<region_id>(ids[i]));
    mesh.region_names.push_back(
      {result.back(), known == region_comments_.end() ? names[i] : known->second.name});
  }
  return result;
}

void deck_builder::name_surfaces() {
  std::set<surface_id> taken;
  for (auto& set : mesh.face_sets) {
    const auto known = surface_comments_.find(upper(set.name));
    if (known == surface_comments_.end() || !taken.insert(known->second.id).second)
      continue;
    set.id = known->second.id;
    set.name = known->second.name;
  }
}

std::optional<vertex_id> deck_builder::vertex_in_tet(std::uint64_t node) {
  const auto vertex = mesh.find_node(node);
  return vertex && is_used_[*vertex] ? vertex : std::nullopt;
}

void deck_builder::add_forces(read_mesh& out) {
  for (const auto& one : forces_) {
    if (const auto vertex = vertex_in_tet(one.node)) {
      out.loads.forces.push_back({*vertex, one.value});
      continue;
    }
    // That of a middle goes to the ends of its edge: force and moment stay.
    const auto ends = mesh.ends_of(one.node);
    stray_ += !ends;
    if (ends)
      for (const auto end : *ends)
        if (const auto vertex = vertex_in_tet(end))
          out.loads.forces.push_back({*vertex, 0.5 * one.value});
  }
}

void deck_builder::add_loads(read_mesh& out) {
  is_used_.assign(mesh.positions.size(), false);
  for (const auto& t : out.mesh.tets)
    for (const auto v : t.v)
      is_used_[v] = true;
  out.loads = std::move(loads);
  for (const auto& one : supports_)
    if (const auto vertex = vertex_in_tet(one.node))
      out.loads.supports.push_back({*vertex, one.component, one.value.x});
    else
      stray_ += !mesh.ends_of(one.node);
  add_forces(out);
  for (const auto& one : pressures_) {
    deck::pressure load{{}, one.value};
    bool whole = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto vertex = vertex_in_tet(one.corners[i]);
      whole = whole && vertex;
      load.corners[i] = vertex.value_or(0);
    }
    if (whole)
      out.loads.pressures.push_back(load);
    else
      ++stray_;
  }
}

void deck_builder::say_left_out(read_mesh& out) const {
  std::string text;
  std::size_t listed = 0;
  for (const auto& [what, place] : left_out_) {
    if (++listed > most_words)
      break;
    text += (text.empty() ? "" : ", ") + what + " (line " + std::to_string(place.first) +
            (place.second > 1 ? " and " + std::to_string(place.second - 1) + " more" : "") + ")";
  }
  if (left_out_.size() > most_words)
    text += ", and " + std::to_string(left_out_.size() - most_words) + " more kinds";
  if (!text.empty())
    out.notices.push_back("not read, because nothing here can hold it: " + text);
  if (stray_ > 0)
    out.notices.push_back(std::to_string(stray_) +
                          " supports and loads are on nodes that no tet has, and are left out");
}

read_mesh deck_builder::finish() {
  name_surfaces();
  auto out = mesh.finish();
  add_loads(out);
  out.length_unit = length_unit;
  if (!mesh_notice.empty())
    out.notices.push_back(mesh_notice);
  say_left_out(out);
  return out;
}

}  // namespace tedit
