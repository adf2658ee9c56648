// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numeric>

#include "cad/reader/step_text.hpp"

namespace tedit::cad {

namespace {

constexpr const char* as_solid =
  "Export the part as a solid (AP203, AP214 or AP242); check in the CAD program that it is closed";
constexpr const char* in_cad = "Export the part again from the CAD program, or mend this entity";

/// The parameters of an entity, between its commas.
std::vector<std::string_view> parameters_of(std::string_view inside) {
  std::vector<std::string_view> result;
  std::size_t begin = 0;
  std::size_t depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const char c = inside[i];
    in_text ^= c == '\'';
    if (in_text)
      continue;
    depth += c == '(';
    depth -= c == ')' && depth > 0;
    if (c == ',' && depth == 0) {
      result.push_back(inside.substr(begin, i - begin));
      begin = i + 1;
    }
  }
  result.push_back(inside.substr(begin));
  return result;
}

/// The entities that a text refers to: "(#17,#18)".
std::vector<std::uint64_t> references_in(std::string_view text) {
  std::vector<std::uint64_t> ids;
  bool in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    in_text ^= text[i] == '\'';
    if (in_text || text[i] != '#')
      continue;
    std::uint64_t id = 0;
    if (std::from_chars(text.data() + i + 1, text.data() + text.size(), id).ec == std::errc())
      ids.push_back(id);
  }
  return ids;
}

/// "0.,0.5,1.E-3" between parentheses; nothing where one of them is no finite number.
std::optional<std::vector<double>> numbers_in(std::string_view list) {
  std::vector<double> numbers;
  const auto open = list.find('(');
  const auto close = list.rfind(')');
  if (open == list.npos || close == list.npos || close < open)
    return std::nullopt;
  for (auto one : parameters_of(list.substr(open + 1, close - open - 1))) {
    const auto first = one.find_first_not_of(" \t\r\n");
    if (first == one.npos)
      return std::nullopt;
    one = one.substr(first, one.find_last_not_of(" \t\r\n") + 1 - first);
    if (one.starts_with('+'))
      one.remove_prefix(1);
    double value = 0;
    const auto read = std::from_chars(one.data(), one.data() + one.size(), value);
    if (read.ec != std::errc() || read.ptr != one.data() + one.size() || !std::isfinite(value))
      return std::nullopt;
    numbers.push_back(value);
  }
  return numbers;
}

bool is_surface(std::string_view type) {
  return type == "PLANE" || (type.find("SURFACE") != type.npos && type != "SURFACE_CURVE");
}

bool is_face(std::string_view type) {
  return type.find("FACE") != type.npos && type.find("BOUND") == type.npos;
}

bool is_shell(std::string_view type) {
  return type.find("SHELL") != type.npos;
}

bool is_bound(std::string_view type) {
  return type == "FACE_BOUND" || type == "FACE_OUTER_BOUND";
}

bool is_loop(std::string_view type) {
  return type.ends_with("_LOOP");
}

bool is_edge(std::string_view type) {
  return type == "EDGE_CURVE" || type == "ORIENTED_EDGE" || type == "SUBEDGE" || type == "EDGE";
}

bool is_vertex(std::string_view type) {
  return type.find("VERTEX") != type.npos;
}

bool is_point(std::string_view type) {
  return type.find("POINT") != type.npos;
}

/// What stands where: the parameter at `place`, one entity or a list of them.
struct rule {
  std::string_view type;
  std::size_t count;  ///< Of its parameters.
  std::size_t place;
  bool (*is_right)(std::string_view type);
  const char* wanted;
};

constexpr rule rules[] = {
  {"MANIFOLD_SOLID_BREP", 2, 1, is_shell, "a shell"},
  {"CLOSED_SHELL", 2, 1, is_face, "faces"},
  {"OPEN_SHELL", 2, 1, is_face, "faces"},
  {"ADVANCED_FACE", 4, 1, is_bound, "bounds"},
  {"ADVANCED_FACE", 4, 2, is_surface, "a surface"},
  {"FACE_BOUND", 3, 1, is_loop, "a loop of edges"},
  {"FACE_OUTER_BOUND", 3, 1, is_loop, "a loop of edges"},
  {"EDGE_LOOP", 2, 1, is_edge, "edges"},
  {"ORIENTED_EDGE", 5, 3, is_edge, "an edge"},
  {"EDGE_CURVE", 5, 1, is_vertex, "a vertex"},
  {"EDGE_CURVE", 5, 2, is_vertex, "a vertex"},
  {"VERTEX_POINT", 2, 1, is_point, "a point"},
};

struct edge_uses {
  std::map<std::uint64_t, int> counts;
  std::size_t left = 0;
};

constexpr std::size_t most_looked_at = 5'000'000;

/// All that is asked of entities, with a way to find them by their numbers.
class step_check {
public:
  explicit step_check(const step_text& step) : step_(step), order_(step.entities.size()) {
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    std::ranges::stable_sort(order_, {}, [&](std::uint32_t i) { return step.entities[i].id; });
  }

  std::optional<text_fault> first_fault() const {
    if (step_.entities.empty())
      return text_fault{step_.data_at, "", "there is no entity between DATA and ENDSEC", as_solid};
    if (!step_.is_whole)
      return std::nullopt;
    if (auto fault = of_bodies())
      return fault;
    if (auto fault = doubles())
      return fault;
    for (const auto& one : step_.entities)
      if (auto fault = of_one(one))
        return fault;
    return open_shell();
  }

private:
  /// `what` is said of the entity: "refers to #9999, which is not there".
  static text_fault about(const step_entity& one, const std::string& what,
                          const char* remedy = in_cad) {
    return {one.at, title_of(one), "#" + std::to_string(one.id) + " " + what, remedy};
  }

  /// What is said of the file, with an entity as its place.
  static text_fault at(const step_entity& one, std::string cause, const char* remedy) {
    return {one.at, title_of(one), std::move(cause), remedy};
  }

  const step_entity* find(std::uint64_t id) const {
    const auto at =
      std::ranges::lower_bound(order_, id, {}, [&](auto i) { return step_.entities[i].id; });
    return at != order_.end() && step_.entities[*at].id == id ? &step_.entities[*at] : nullptr;
  }

  std::size_t count_of(std::initializer_list<std::string_view> types) const {
    return static_cast<std::size_t>(std::ranges::count_if(step_.entities, [&](const auto& one) {
      return std::ranges::find(types, one.type) != types.end();
    }));
  }

  /// Whether there is something to mesh, and a product whose shape it is.
  std::optional<text_fault> of_bodies() const {
    const auto& first = step_.entities.front();
    const auto count = std::to_string(step_.entities.size());
    if (step_.schema.find("IFC") != step_.schema.npos)
      return at(first, "its schema is IFC, a building's, which is no CAD part",
                "Export the part as AP203, AP214 or AP242");
    if (count_of({"MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS", "FACETED_BREP", "CLOSED_SHELL",
                  "OPEN_SHELL", "ADVANCED_FACE", "FACE_SURFACE"}) == 0) {
      const auto tessellated = std::ranges::find_if(step_.entities, [](const auto& one) {
        return one.type.find("TESSELLATED") != one.type.npos ||
               one.type.find("TRIANGULATED") != one.type.npos;
      });
      if (tessellated != step_.entities.end())
        return at(*tessellated, "the part has triangles in place of CAD faces",
                  "Export it with exact geometry, or as STL or 3MF");
      return at(first, "there is no solid, no shell and no face among its entities (" + count + ")",
                as_solid);
    }
    if (count_of({"SHAPE_DEFINITION_REPRESENTATION"}) == 0 &&
        count_of({"SHAPE_REPRESENTATION", "ADVANCED_BREP_SHAPE_REPRESENTATION",
                  "MANIFOLD_SURFACE_SHAPE_REPRESENTATION", "FACETED_BREP_SHAPE_REPRESENTATION",
                  "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION"}) == 0)
      return at(first, "no SHAPE_REPRESENTATION says what belongs to the part", as_solid);
    return std::nullopt;
  }

  std::optional<text_fault> doubles() const {
    for (std::size_t i = 1; i < order_.size(); ++i) {
      const auto& one = step_.entities[order_[i]];
      if (one.id == step_.entities[order_[i - 1]].id)
        return about(one, "is there twice");
    }
    return std::nullopt;
  }

  std::optional<text_fault> of_one(const step_entity& one) const {
    for (const auto id : references_in(one.inside))
      if (!find(id))
        return about(one, "refers to #" + std::to_string(id) + ", which is not there");
    const auto given = parameters_of(one.inside);
    for (const auto& asked : rules)
      if (asked.type == one.type)
        if (auto fault = against(one, given, asked))
          return fault;
    return of_coordinates(one, given);
  }

  std::optional<text_fault> against(const step_entity& one,
                                    const std::vector<std::string_view>& given,
                                    const rule& asked) const {
    if (given.size() != asked.count)
      return about(one, "has " + std::to_string(given.size()) + " parameters in place of " +
                          std::to_string(asked.count));
    const auto ids = references_in(given[asked.place]);
    if (ids.empty())
      return about(one, std::string("names no entity where ") + asked.wanted + " must be");
    for (const auto id : ids)
      if (const auto* other = find(id); !asked.is_right(other->type))
        return about(one, "refers to " + title_of(*other) + " where " + asked.wanted + " must be");
    return std::nullopt;
  }

  static std::optional<text_fault> of_coordinates(const step_entity& one,
                                                  const std::vector<std::string_view>& given) {
    if (one.type != "CARTESIAN_POINT" && one.type != "DIRECTION")
      return std::nullopt;
    const auto numbers = given.size() == 2 ? numbers_in(given[1]) : std::nullopt;
    if (!numbers)
      return about(one, "has coordinates that are no list of finite numbers");
    if (numbers->size() > 3)
      return about(one, "has " + std::to_string(numbers->size()) +
                          " coordinates: a decimal comma, where STEP wants a point?");
    if (one.type == "DIRECTION" &&
        std::ranges::all_of(*numbers, [](double value) { return value == 0; }))
      return about(one, "points nowhere: all its coordinates are 0");
    return std::nullopt;
  }

  /// Counts the curves of edges below an entity, each as often as it is there. `left` is how much
  /// more may be looked at: entities may list others again and again.
  void add_edges(const step_entity& one, edge_uses& uses) const {
    const auto below = [&](std::string_view type) {
      return is_bound(one.type)            ? is_loop(type)
             : is_loop(one.type)           ? is_edge(type)
             : one.type == "ORIENTED_EDGE" ? type == "EDGE_CURVE"
             : is_face(one.type)           ? is_bound(type)
                                           : is_shell(one.type) && is_face(type);
    };
    for (const auto id : references_in(one.inside)) {
      const auto* other = find(id);
      if (uses.left == 0 || !below(other->type))
        continue;
      --uses.left;
      if (other->type == "EDGE_CURVE")
        ++uses.counts[other->id];
      else
        add_edges(*other, uses);
    }
  }

  /// A closed shell has two faces at each edge.
  std::optional<text_fault> open_shell() const {
    std::size_t left = most_looked_at;
    for (const auto& shell : step_.entities) {
      if (shell.type != "CLOSED_SHELL" && shell.type != "OPEN_SHELL")
        continue;
      edge_uses found{{}, left};
      add_edges(shell, found);
      left = found.left;
      if (left == 0)
        return std::nullopt;
      const auto& uses = found.counts;
      const auto is_loose = [](const auto& use) { return use.second == 1; };
      const auto loose = std::ranges::count_if(uses, is_loose);
      if (loose > 0)
        return about(shell,
                     "is open: " + std::to_string(loose) + " of its " +
                       std::to_string(uses.size()) + " edges are on one face only, the first is " +
                       title_of(*find(std::ranges::find_if(uses, is_loose)->first)),
                     as_solid);
    }
    return std::nullopt;
  }

  const step_text& step_;
  std::vector<std::uint32_t> order_;  ///< Entities by their numbers.
};

}  // namespace

std::optional<text_fault> fault_of_entities(const step_text& step) {
  return step_check(step).first_fault();
}

}  // namespace tedit::cad
