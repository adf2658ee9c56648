// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/facet_pages.hpp"

#include <algorithm>
#include <ranges>

namespace tedit {

namespace {

bool is_of(const facet_page& facts, const mesh_version& mesh) {
  const auto& pages = mesh.data().positions.pages();
  return std::ranges::all_of(facts.positions, [&](const auto& was) {
    return was.first < pages.size() && pages[was.first]->id() == was.second;
  });
}

std::shared_ptr<facet_page> read_page(const mesh_version& mesh, std::size_t p) {
  auto result = std::make_shared<facet_page>();
  const auto& pages = mesh.data().positions.pages();
  std::vector<bool> used(pages.size(), false);
  std::map<surface_id, surface_size> sizes;
  auto now = sizes.end();  // Facets of one surface mostly follow each other.
  const auto items = mesh.data().facets.page_items(p);
  result->extents.resize((items.size() + facet_page::block - 1) / facet_page::block);
  for (std::size_t slot = 0; slot < items.size(); ++slot) {
    const auto& f = items[slot];
    if (f.tet == no_id)
      continue;
    if (now == sizes.end() || now->first != f.surface)
      now = sizes.try_emplace(f.surface).first;
    std::array<vec3, 3> at;
    if (std::ranges::any_of(f.v, [&](vertex_id v) { return v >= mesh.vertex_slots(); }))
      continue;  // A damaged version: `check_version` names it.
    for (int i = 0; i < 3; ++i) {
      at[i] = mesh.position(f.v[i]);
      used[f.v[i] >> paged_array<vec3>::shift] = true;
    }
    ++now->second.facets;
    now->second.area_m2 += norm(area_vector(at[0], at[1], at[2]));
    result->extents[slot / facet_page::block].add(at);
  }
  for (const auto& part : result->extents)
    result->extent.add(part);
  for (const auto& [surface, size] : sizes)
    result->parts.push_back({surface, size});
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i])
      result->positions.emplace_back(i, pages[i]->id());
  return result;
}

}  // namespace

std::shared_ptr<const facet_page> facet_page_of(const mesh_version& mesh, std::size_t p) {
  const auto& holder = *mesh.data().facets.pages()[p];
  if (auto known = std::dynamic_pointer_cast<const facet_page>(holder.facts());
      known && is_of(*known, mesh))
    return known;
  auto made = read_page(mesh, p);
  holder.keep(made);
  return made;
}

std::map<surface_id, surface_size> surface_sizes(const mesh_version& mesh) {
  std::map<surface_id, surface_size> result;
  for (std::size_t p = 0; p < mesh.data().facets.pages().size(); ++p) {
    const auto facts = facet_page_of(mesh, p);  // The page may lose them to another version's.
    for (const auto& part : facts->parts) {
      auto& sum = result[part.surface];
      sum.facets += part.size.facets;
      sum.area_m2 += part.size.area_m2;
    }
  }
  return result;
}

std::map<surface_id, double> surface_areas(const mesh_version& mesh) {
  std::map<surface_id, double> result;
  for (const auto& [surface, size] : surface_sizes(mesh))
    result[surface] = size.area_m2;
  const auto& between = mesh.data().interfaces;
  for (std::size_t i = 0; i < between.size(); ++i) {
    const auto& v = between[i].v;
    result[between[i].surface] +=
      norm(area_vector(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])));
  }
  return result;
}

std::vector<facet_id> facets_of(const mesh_version& mesh, std::span<const surface_id> surfaces) {
  std::vector<surface_id> wanted(surfaces.begin(), surfaces.end());
  std::ranges::sort(wanted);
  const auto is_wanted = [&](surface_id id) { return std::ranges::binary_search(wanted, id); };
  constexpr auto per_page = paged_array<boundary_facet>::items_per_page;
  const auto& facets = mesh.data().facets;
  std::vector<facet_id> result;
  for (std::size_t p = 0; p < facets.pages().size(); ++p) {
    if (std::ranges::none_of(facet_page_of(mesh, p)->parts, is_wanted, &facet_page::part::surface))
      continue;
    const auto items = facets.page_items(p);
    for (std::size_t i = 0; i < items.size(); ++i)
      if (items[i].tet != no_id && is_wanted(items[i].surface))
        result.push_back(static_cast<facet_id>(p * per_page + i));
  }
  return result;
}

std::vector<vertex_id> boundary_vertices(const mesh_version& mesh) {
  std::vector<bool> marks(mesh.vertex_slots(), false);
  std::size_t count = 0;
  const auto& facets = mesh.data().facets;
  for (std::size_t p = 0; p < facets.pages().size(); ++p)
    for (const auto& f : facets.page_items(p))
      if (f.tet != no_id)
        for (const auto v : f.v) {
          count += !marks[v];
          marks[v] = true;
        }
  std::vector<vertex_id> result;
  result.reserve(count);
  for (vertex_id v = 0; v < marks.size(); ++v)
    if (marks[v])
      result.push_back(v);
  return result;
}

}  // namespace tedit
