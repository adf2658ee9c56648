// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/deck_case.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "base/text.hpp"
#include "mesh/face_key.hpp"

namespace tedit::fem {

namespace {

/// How far two numbers of a deck that mean the same may be apart, of their size: decks print six
/// digits or more.
constexpr double same = 1e-5;

bool alike(double a, double b) {
  return std::abs(a - b) <= same * std::max(std::abs(a), std::abs(b));
}

/// "3 nodes", "1 node".
std::string count_of(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

struct surface_parts {
  std::vector<vertex_id> vertices;  ///< Ascending.
  std::vector<facet_id> facets;
};

std::map<surface_id, surface_parts> parts_of_surfaces(const mesh_version& mesh) {
  std::map<surface_id, surface_parts> result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    auto& part = result[mesh.facet(f).surface];
    part.facets.push_back(f);
    part.vertices.insert(part.vertices.end(), mesh.facet(f).v.begin(), mesh.facet(f).v.end());
  }
  for (auto& [surface, part] : result) {
    std::ranges::sort(part.vertices);
    const auto rest = std::ranges::unique(part.vertices);
    part.vertices.erase(rest.begin(), rest.end());
  }
  return result;
}

/// What a deck does to vertices, as surfaces.
class deck_reader {
public:
  deck_reader(const mesh_version& mesh, const deck& from)
      : mesh_(mesh), from_(from), surfaces_(parts_of_surfaces(mesh)) {}

  deck_case run() {
    out_.loads.name = from_.name;
    add_materials();
    add_supports();
    add_forces();
    add_pressures();
    if (from_.gravity)
      out_.loads.loads.push_back({{}, gravity{*from_.gravity}});
    return std::move(out_);
  }

private:
  void say(std::string sentence) { out_.remarks.push_back(std::move(sentence)); }

  void add_materials() {
    for (const auto& one : from_.materials) {
      if (!(one.young_modulus > 0)) {
        say("material \"" + one.name + "\" has no isotropic elasticity and is left out");
        continue;
      }
      material m;
      m.name = one.name;
      m.young_modulus_pa = one.young_modulus;
      m.poisson_ratio = one.poisson_ratio;
      m.density_kg_m3 = one.density;
      // Of all regions: then those that an edit adds are of it, too.
      if (one.regions.size() < mesh_.regions().size())
        m.regions = one.regions;
      if (!one.regions.empty() || from_.materials.size() == 1)
        out_.loads.materials.push_back(std::move(m));
      else
        say("material \"" + one.name + "\" is of no element and is left out");
    }
  }

  /// The fewest surfaces (nearly: the one that covers most comes first) whose vertices are all in
  /// `wanted` and that cover them; what is left stays in `wanted`.
  std::vector<surface_id> cover(std::set<vertex_id>& wanted) const {
    const auto all = wanted;
    std::vector<std::pair<surface_id, const surface_parts*>> candidates;
    for (const auto& [surface, part] : surfaces_)
      if (std::ranges::all_of(part.vertices, [&](vertex_id v) { return all.contains(v); }))
        candidates.emplace_back(surface, &part);
    std::ranges::stable_sort(candidates, std::ranges::greater{},
                             [](const auto& c) { return c.second->vertices.size(); });
    std::vector<surface_id> result;
    for (const auto& [surface, part] : candidates) {
      std::size_t fresh = 0;
      for (const auto v : part->vertices)
        fresh += wanted.erase(v);
      if (fresh > 0)
        result.push_back(surface);
    }
    std::ranges::sort(result);
    return result;
  }

  // -- supports --------------------------------------------------------------------------------

  using held = std::array<std::optional<double>, 3>;

  void add_supports() {
    std::map<vertex_id, held> of_vertex;
    for (const auto& one : from_.supports)
      of_vertex[one.vertex][static_cast<std::size_t>(one.component)] = one.value;
    // Vertices at a rim may be held by two supports: so each component and value by itself, then
    // surfaces that are alike together.
    std::map<surface_id, held> of_surface;
    std::size_t left = 0;
    for (std::size_t c = 0; c < 3; ++c)
      left += add_component(of_vertex, c, of_surface);
    std::map<held, std::vector<surface_id>> groups;
    for (const auto& [surface, components] : of_surface)
      groups[components].push_back(surface);
    for (const auto& [components, surfaces] : groups)
      out_.loads.constraints.push_back({surfaces, kind_of(components)});
    if (left > 0)
      say("supports of " + count_of(left, "nodal component") +
          " make up no whole surface and are left out");
  }

  /// Returns how many vertices are left over.
  std::size_t add_component(const std::map<vertex_id, held>& of_vertex, std::size_t c,
                            std::map<surface_id, held>& of_surface) const {
    std::map<double, std::set<vertex_id>> by_value;
    for (const auto& [vertex, components] : of_vertex)
      if (components[c])
        by_value[*components[c]].insert(vertex);
    std::size_t left = 0;
    for (auto& [value, vertices] : by_value) {
      for (const auto surface : cover(vertices))
        of_surface[surface][c] = value;
      left += vertices.size();
    }
    return left;
  }

  static std::variant<fixed, prescribed_displacement, roller> kind_of(const held& components) {
    if (std::ranges::all_of(components, [](const auto& c) { return c && *c == 0; }))
      return fixed{};
    return prescribed_displacement{components[0], components[1], components[2]};
  }

  // -- forces ----------------------------------------------------------------------------------

  void add_forces() {
    std::map<vertex_id, vec3> of_vertex;
    for (const auto& one : from_.forces)
      of_vertex[one.vertex] = of_vertex[one.vertex] + one.value;
    std::erase_if(of_vertex, [](const auto& entry) { return norm(entry.second) == 0; });
    std::set<vertex_id> wanted;
    for (const auto& [vertex, value] : of_vertex)
      wanted.insert(vertex);
    for (const auto& group : touching(cover(wanted)))
      add_force(group, of_vertex);
    if (wanted.empty())
      return;
    vec3 total;
    for (const auto v : wanted)
      total = total + of_vertex[v];
    say("forces on " + count_of(wanted.size(), "node") + ", " + newtons(total) +
        " together, make up no whole surface and are left out");
  }

  static std::string newtons(vec3 f) {
    return "(" + format_number("%.4g", f.x) + ", " + format_number("%.4g", f.y) + ", " +
           format_number("%.4g", f.z) + ") N";
  }

  /// Surfaces with a vertex in common, together.
  std::vector<std::vector<surface_id>> touching(const std::vector<surface_id>& surfaces) const {
    std::vector<std::vector<surface_id>> groups;
    for (const auto surface : surfaces) {
      std::vector<surface_id> joined{surface};
      std::erase_if(groups, [&](const std::vector<surface_id>& group) {
        if (!std::ranges::any_of(group, [&](surface_id g) { return touch(g, surface); }))
          return false;
        joined.insert(joined.end(), group.begin(), group.end());
        return true;
      });
      std::ranges::sort(joined);
      groups.push_back(std::move(joined));
    }
    return groups;
  }

  [[nodiscard]] bool touch(surface_id a, surface_id b) const {
    const auto& one = surfaces_.at(a).vertices;
    return std::ranges::any_of(surfaces_.at(b).vertices,
                               [&](vertex_id v) { return std::ranges::binary_search(one, v); });
  }

  void add_force(const std::vector<surface_id>& group, const std::map<vertex_id, vec3>& of_vertex) {
    std::map<vertex_id, double> areas;  // Thirds of the facets around.
    double area = 0;
    for (const auto surface : group)
      for (const auto f : surfaces_.at(surface).facets) {
        const double part = norm(area_vector(mesh_, mesh_.facet(f)));
        area += part;
        for (const auto v : mesh_.facet(f).v)
          areas[v] += part / 3;
      }
    vec3 total;
    for (const auto& [vertex, share] : areas)
      total = total + of_vertex.at(vertex);
    double off = 0;
    for (const auto& [vertex, share] : areas)
      off = std::max(off, norm(of_vertex.at(vertex) - (share / area) * total));
    out_.loads.loads.push_back({group, force{total}});
    double largest = 0;
    for (const auto& [vertex, share] : areas)
      largest = std::max(largest, share / area * norm(total));
    if (off > 1e-3 * largest)
      say("nodal forces on " + std::string(group.size() == 1 ? "surface " : "surfaces ") +
          list_of(group) + " are not spread evenly: read is their sum, " + newtons(total) +
          ", spread evenly");
  }

  // -- pressures -------------------------------------------------------------------------------

  void add_pressures() {
    std::map<std::array<vertex_id, 3>, double> of_face;
    for (const auto& one : from_.pressures)
      of_face[make_face_key(one.corners).v] += one.value;
    std::size_t used = 0;
    std::map<double, std::vector<surface_id>> groups;
    for (const auto& [surface, part] : surfaces_) {
      const auto value = pressure_on(part, of_face);
      if (!value)
        continue;
      used += part.facets.size();
      groups[*value].push_back(surface);
    }
    for (const auto& [value, surfaces] : groups)
      out_.loads.loads.push_back({surfaces, pressure{value}});
    if (used < of_face.size())
      say("pressures on " + count_of(of_face.size() - used, "face") +
          " make up no whole surface of one pressure and are left out");
  }

  [[nodiscard]] std::optional<double> pressure_on(
    const surface_parts& part, const std::map<std::array<vertex_id, 3>, double>& of_face) const {
    std::optional<double> value;
    for (const auto f : part.facets) {
      const auto found = of_face.find(make_face_key(mesh_.facet(f).v).v);
      if (found == of_face.end() || (value && !alike(*value, found->second)))
        return std::nullopt;
      value = value.value_or(found->second);
    }
    return value;
  }

  const mesh_version& mesh_;
  const deck& from_;
  std::map<surface_id, surface_parts> surfaces_;
  deck_case out_;
};

}  // namespace

deck_case load_case_of_deck(const mesh_version& mesh, const deck& from) {
  return deck_reader(mesh, from).run();
}

}  // namespace tedit::fem
