// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "base/number_range.hpp"
#include "fem/node_table.hpp"
#include "fem/polled.hpp"
#include "fem/problem_parts.hpp"
#include "fem/rollers.hpp"

namespace tedit::fem {

// -- surfaces ----------------------------------------------------------------------

surface_triangles::surface_triangles(const mesh_version& mesh, const load_case& loads,
                                     const std::vector<std::uint32_t>& node_of, const problem& p) {
  for (const auto& item : loads.constraints)
    for (const auto id : item.surfaces)
      by_surface_[id];
  for (const auto& item : loads.loads)
    for (const auto id : item.surfaces)
      by_surface_[id];
  const auto add = [&](surface_id id, const std::array<vertex_id, 3>& v, bool interface) {
    const auto list = by_surface_.find(id);
    if (list == by_surface_.end())
      return;
    triangle t;
    t.interface = interface;
    for (int i = 0; i < 3; ++i)
      t.nodes[i] = node_of[v[i]];
    if (p.element_order == 2) {
      t.count = 6;
      for (int i = 0; i < 3; ++i)
        t.nodes[3 + i] = mid_node(p, t.nodes[i], t.nodes[(i + 1) % 3]);
    }
    list->second.push_back(t);
  };
  std::vector<surface_id> wanted;
  for (const auto& [id, triangles] : by_surface_)
    wanted.push_back(id);
  const auto facets = facets_of(mesh, wanted);
  polled_for(facets.size(), [&](std::size_t i) {
    add(mesh.facet(facets[i]).surface, mesh.facet(facets[i]).v, false);
  });
  const auto& interfaces = mesh.data().interfaces;
  polled_for(interfaces.size(),
             [&](std::size_t i) { add(interfaces[i].surface, interfaces[i].v, true); });
}

const std::vector<surface_triangles::triangle>& surface_triangles::of(surface_id id) const {
  const auto found = by_surface_.find(id);
  return found == by_surface_.end() ? none_ : found->second;
}

expected<void> check_surfaces(const mesh_version& mesh, const load_case& loads) {
  const auto check = [&](const std::string& item,
                         const std::vector<surface_id>& ids) -> expected<void> {
    for (const auto id : ids) {
      if (mesh.find_surface(id) != nullptr)
        continue;
      surface_id nearest = 0;
      surface_id distance = INT64_MAX;
      for (const auto& row : mesh.surfaces())
        if (const auto d = row.id > id ? row.id - id : id - row.id; d < distance)
          std::tie(nearest, distance) = std::tuple(row.id, d);
      return fail(ec::surface_not_found,
                  item + " names surface " + std::to_string(id) +
                    ", which this version of the "
                    "mesh does not have",
                  "The nearest id that it has is " + std::to_string(nearest));
    }
    return {};
  };
  for (std::size_t i = 0; i < loads.constraints.size(); ++i)
    if (auto ok = check("constraint " + std::to_string(i), loads.constraints[i].surfaces); !ok)
      return ok;
  for (std::size_t i = 0; i < loads.loads.size(); ++i)
    if (auto ok = check("load " + std::to_string(i), loads.loads[i].surfaces); !ok)
      return ok;
  return {};
}

// -- constraints ---------------------------------------------------------------------

namespace {

/// Those components that are given.
expected<void> check_displacement(const prescribed_displacement& given, const std::string& of) {
  const std::array<std::pair<const char*, std::optional<double>>, 3> components{
    {{"x_m", given.x_m}, {"y_m", given.y_m}, {"z_m", given.z_m}}};
  for (const auto& [field, value] : components)
    if (auto ok = check_number(value.value_or(0), any_number("m"), of + ": " + field); !ok)
      return ok;
  return {};
}

/// Directions in which a node is held, orthonormal, and the displacement along each.
struct held_directions {
  std::array<vec3, 3> direction;
  std::array<double, 3> value{};
  int count = 0;

  /// Adds u . d = value. `slack` is the sine below which d counts as held already; then the
  /// values must agree unless the caller says that they are approximate.
  bool add(vec3 d, double value_along, double slack, bool approximate) {
    double rest = value_along;
    vec3 left = d;
    for (int i = 0; i < count; ++i) {
      const double part = dot(d, direction[i]);
      left -= part * direction[i];
      rest -= part * value[i];
    }
    const double size = norm(left);
    if (size <= slack)
      return approximate || std::abs(rest) <= 1e-9 * (std::abs(value_along) + 1e-12);
    direction[count] = left / size;
    value[count] = rest / size;
    ++count;
    return true;
  }
};

using held_table = node_table<held_directions>;

/// What rollers on all these surfaces hold.
void add_rollers(const mesh_version& mesh, const surface_triangles& triangles,
                 std::vector<surface_id> surfaces, problem& p, held_table& held) {
  std::ranges::sort(surfaces);
  surfaces.erase(std::ranges::unique(surfaces).begin(), surfaces.end());
  for (const auto& one : roller_directions(mesh, p, triangles, surfaces)) {
    const vec3 d = one.direction;
    for (const auto& [surface, area] : one.shares)
      p.holders.push_back({one.node,
                           surface,
                           {area * d.x * d.x, area * d.x * d.y, area * d.x * d.z, area * d.y * d.y,
                            area * d.y * d.z, area * d.z * d.z},
                           one.uncertainty});
    // What is held there already within 20 degrees counts as this direction, too.
    held[one.node].add(d, 0, 0.34, true);
  }
}

bool add_components(const surface_triangles& triangles, surface_id id,
                    const std::array<std::optional<double>, 3>& values, problem& p,
                    held_table& held) {
  const std::array<vec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  node_table<double> area_at(p);
  const auto& list = triangles.of(id);
  const auto add = [&](const surface_triangles::triangle& t) {
    const double area = norm(area_of(p, t));
    for (const auto node : t.all())
      area_at[node] += area;
  };
  polled_for(
    list.size(), [&](std::size_t i) { add(list[i]); }, triangles_between);
  bool ok = true;
  for (const auto& [node, area] : area_at.rows()) {
    auto& row = held[node];
    for (int i = 0; i < 3; ++i)
      if (values[i])
        ok = row.add(axes[i], *values[i], 1e-9, false) && ok;
    const auto along = [&](int axis) { return values[axis] ? area : 0.0; };
    p.holders.push_back({node, id, {along(0), 0, 0, along(1), 0, along(2)}, 0});
  }
  return ok;
}

/// One row for each node and surface.
void merge_holders(std::vector<node_holder>& holders) {
  const auto key = [](const node_holder& h) { return std::pair(h.node, h.surface); };
  std::ranges::stable_sort(holders, {}, key);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < holders.size(); ++i) {
    if (kept > 0 && key(holders[kept - 1]) == key(holders[i])) {
      auto& sum = holders[kept - 1];
      for (int c = 0; c < 6; ++c)
        sum.stiffness[c] += holders[i].stiffness[c];
      sum.uncertainty = std::max(sum.uncertainty, holders[i].uncertainty);
    } else {
      holders[kept++] = holders[i];
    }
  }
  holders.resize(kept);
}

void write_filter(const held_table& held, problem& p) {
  for (const auto& [node, row] : held.rows()) {
    auto& s = p.filter[node];
    for (int i = 0; i < row.count; ++i) {
      const vec3 d = row.direction[i];
      s[0] -= d.x * d.x;
      s[1] -= d.x * d.y;
      s[2] -= d.x * d.z;
      s[3] -= d.y * d.y;
      s[4] -= d.y * d.z;
      s[5] -= d.z * d.z;
      p.prescribed[3 * node] += row.value[i] * d.x;
      p.prescribed[3 * node + 1] += row.value[i] * d.y;
      p.prescribed[3 * node + 2] += row.value[i] * d.z;
    }
    if (row.count == 3)
      s = {0, 0, 0, 0, 0, 0};
  }
}

}  // namespace

expected<void> add_constraints(const mesh_version& mesh, const surface_triangles& triangles,
                               const load_case& loads, problem& p) {
  p.holders.clear();
  polled_assign(p.filter, p.node_count(), {1, 0, 0, 1, 0, 1});
  polled_assign(p.prescribed, p.dofs(), 0.0);
  held_table held(p);
  // Exact components first: a roller on the same node then only adds what is left.
  std::vector<surface_id> rollers;
  for (std::size_t i = 0; i < loads.constraints.size(); ++i) {
    const auto& item = loads.constraints[i];
    if (item.surfaces.empty())
      return fail(ec::invalid_argument, "constraint " + std::to_string(i) + " names no surface");
    if (std::holds_alternative<roller>(item.kind)) {
      rollers.insert(rollers.end(), item.surfaces.begin(), item.surfaces.end());
      continue;
    }
    std::array<std::optional<double>, 3> values{0.0, 0.0, 0.0};
    if (const auto* given = std::get_if<prescribed_displacement>(&item.kind)) {
      if (auto ok = check_displacement(*given, "constraint " + std::to_string(i)); !ok)
        return ok;
      values = {given->x_m, given->y_m, given->z_m};
    }
    for (const auto id : item.surfaces)
      if (!add_components(triangles, id, values, p, held))
        return fail(ec::invalid_argument,
                    "constraint " + std::to_string(i) + " contradicts another one on surface " +
                      std::to_string(id),
                    "Prescribe one value for each direction where surfaces meet");
  }
  add_rollers(mesh, triangles, std::move(rollers), p, held);
  write_filter(held, p);
  merge_holders(p.holders);
  return {};
}

}  // namespace tedit::fem
