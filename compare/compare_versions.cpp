// SPDX-License-Identifier: AGPL-3.0-or-later
#include "compare/compare_versions.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "compare/boundary_deviation.hpp"
#include "compare/load_differences.hpp"
#include "mesh/facet_pages.hpp"

namespace tedit {

namespace {

using area_table = std::map<surface_id, std::map<surface_id, double>>;

/// What of a surface that both have other facets, and how much of one is in another.
struct surface_facts {
  std::set<surface_id> changed;
  area_table merged;  ///< Of before: area of the same facets by surface of after.
  area_table split;   ///< Of after: by surface of before.
};

using interface_key = std::tuple<surface_id, std::array<vertex_id, 3>>;

/// Facets between regions by surface and by corners as vertices of before, ascending.
template <class Twin>
std::vector<interface_key> interfaces_of(const mesh_version& mesh, const Twin& twin) {
  std::vector<interface_key> result;
  const auto& all = mesh.data().interfaces;
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto corners = all[i].v;
    for (auto& v : corners)
      v = twin(v);
    std::ranges::sort(corners);
    result.emplace_back(all[i].surface, corners);
  }
  std::ranges::sort(result);
  return result;
}

surface_facts facts_of(const mesh_version& before, const mesh_version& after,
                       const version_match& match) {
  surface_facts facts;
  for (const auto f : match.facets_before)
    facts.changed.insert(before.facet(f).surface);
  for (const auto f : match.facets_after)
    facts.changed.insert(after.facet(f).surface);
  for (const auto& [was, is] : match.facets_moved) {
    const auto from = before.facet(was).surface;
    const auto to = after.facet(is).surface;
    if (from == to)
      continue;
    facts.changed.insert({from, to});
    const double area = norm(area_vector(after, after.facet(is)));
    facts.merged[from][to] += area;
    facts.split[to][from] += area;
  }
  const auto was = interfaces_of(before, [](vertex_id v) { return v; });
  const auto is = interfaces_of(after, [&](vertex_id v) { return match.twin_of(v); });
  std::vector<interface_key> differing;
  std::ranges::set_symmetric_difference(was, is, std::back_inserter(differing));
  for (const auto& one : differing)
    facts.changed.insert(std::get<0>(one));
  return facts;
}

std::optional<surface_id> most_of(const area_table& table, surface_id id) {
  const auto found = table.find(id);
  if (found == table.end())
    return std::nullopt;
  return std::ranges::max_element(found->second, {}, [](const auto& row) { return row.second; })
    ->first;
}

std::vector<compared_surface> surfaces_of(const mesh_version& before, const mesh_version& after,
                                          const version_match& match) {
  const auto facts = facts_of(before, after, match);
  const auto was = surface_areas(before);
  const auto is = surface_areas(after);
  std::map<surface_id, compared_surface> rows;
  for (const auto& one : before.surfaces())
    rows[one.id] = {one.id, one.name, presence::only_before};
  for (const auto& one : after.surfaces())
    rows[one.id] = {one.id, one.name,
                    rows.contains(one.id) ? presence::both : presence::only_after};
  std::vector<compared_surface> result;
  for (auto& [id, row] : rows) {
    row.changed = facts.changed.contains(id);
    if (row.where != presence::both)
      row.kin = most_of(row.where == presence::only_before ? facts.merged : facts.split, id);
    row.area_before_m2 = was.contains(id) ? was.at(id) : 0;
    row.area_after_m2 = is.contains(id) ? is.at(id) : 0;
    result.push_back(std::move(row));
  }
  return result;
}

const fem::load_case* find_case(std::span<const fem::load_case> all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &fem::load_case::name);
  return found == all.end() ? nullptr : &*found;
}

std::vector<compared_load_case> compare_loads(const version_side& before, const version_side& after,
                                              std::span<const region_volume> volumes_before,
                                              std::span<const region_volume> volumes_after) {
  std::vector<compared_load_case> result;
  for (const auto& is : after.load_cases) {
    auto& row = result.emplace_back(compared_load_case{is.name, presence::only_after});
    row.mass_after_kg = mass_of(volumes_after, is);
    if (const auto* was = find_case(before.load_cases, is.name)) {
      row.where = presence::both;
      row.mass_before_kg = mass_of(volumes_before, *was);
      row.differences = differences_of(*was, is);
    }
  }
  for (const auto& was : before.load_cases)
    if (!find_case(after.load_cases, was.name))
      result.push_back({was.name, presence::only_before, mass_of(volumes_before, was)});
  return result;
}

compared_size size_of(const mesh_version& mesh, std::span<const region_volume> volumes) {
  compared_size result{mesh.vertex_count(), mesh.tet_count()};
  for (const auto& one : volumes)
    result.volume_m3 += one.volume_m3;
  return result;
}

}  // namespace

expected<version_comparison> compare_versions(const version_side& before, const version_side& after,
                                              const version_match& match, const execution& run) {
  const auto was = region_volumes(before.mesh);
  const auto is = region_volumes(after.mesh);
  const auto deviation = deviation_of(before.mesh, after.mesh, match, run);
  if (!deviation)
    return fail(deviation.error());
  version_comparison result;
  result.before_id = to_hex(before.mesh.id());
  result.after_id = to_hex(after.mesh.id());
  result.before = size_of(before.mesh, was);
  result.after = size_of(after.mesh, is);
  result.tets_in_common = after.mesh.tet_count() - match.tets_after.size();
  result.vertices_in_common = match.vertices;
  result.surfaces = surfaces_of(before.mesh, after.mesh, match);
  result.deviation = *deviation;
  result.load_cases = compare_loads(before, after, was, is);
  return result;
}

}  // namespace tedit
