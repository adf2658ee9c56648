// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/problem_update.hpp"

#include <algorithm>
#include <cstring>

#include "fem/problem_parts.hpp"
#include "fem/quadratic.hpp"
#include "mesh/changes.hpp"

namespace tedit::fem {

namespace {

/// Adds the slots of a paged array that differ, or that only one version has, to `slots`.
template <class T>
void list_different(const paged_array<T>& from, const paged_array<T>& to,
                    std::vector<std::uint32_t>& slots) {
  using array = paged_array<T>;
  for (const auto page : dirty_pages(from, to)) {
    const auto items = [&](const array& a) {
      return page < a.pages().size() ? a.page_items(page) : std::span<const T>{};
    };
    const auto before = items(from);
    const auto after = items(to);
    for (std::size_t i = 0; i < std::max(before.size(), after.size()); ++i)
      // Bit by bit: a zero that changed its sign, or another NaN, is a change.
      if (i >= before.size() || i >= after.size() ||
          // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
          std::memcmp(&before[i], &after[i], sizeof(T)) != 0)
        slots.push_back(static_cast<std::uint32_t>(page * array::items_per_page + i));
  }
}

bool has_vertex(const mesh_version& mesh, vertex_id v) {
  return v < mesh.vertex_slots() && mesh.is_live_vertex(v);
}

bool has_tet(const mesh_version& mesh, tet_id t) {
  return t < mesh.tet_slots() && mesh.is_live_tet(t);
}

}  // namespace

/// Slots that differ between two versions.
struct problem_updater::difference {
  std::vector<vertex_id> died, born, moved;
  std::vector<tet_id> gone, fresh, changed;
};

problem_updater::difference problem_updater::compare(const mesh_version& from,
                                                     const mesh_version& to) {
  difference d;
  std::vector<std::uint32_t> vertices;
  list_different(from.data().positions, to.data().positions, vertices);
  list_different(from.data().vertex_tet, to.data().vertex_tet, vertices);
  sort_unique(vertices);
  for (const auto v : vertices) {
    const bool before = has_vertex(from, v);
    const bool after = has_vertex(to, v);
    if (before && !after)
      d.died.push_back(v);
    else if (!before && after)
      d.born.push_back(v);
    else if (before && from.position(v) != to.position(v))
      d.moved.push_back(v);
  }
  std::vector<std::uint32_t> tets;
  list_different(from.data().tets, to.data().tets, tets);
  list_different(from.data().tet_regions, to.data().tet_regions, tets);
  sort_unique(tets);
  for (const auto t : tets) {
    const bool before = has_tet(from, t);
    const bool after = has_tet(to, t);
    if (before && !after)
      d.gone.push_back(t);
    else if (!before && after)
      d.fresh.push_back(t);
    else if (before && (from.tet_at(t).v != to.tet_at(t).v || from.region_of(t) != to.region_of(t)))
      d.changed.push_back(t);
  }
  return d;
}

problem_updater::problem_updater(const problem& p) : corners_(p, 4) {
  for (std::uint32_t e = 0; e < p.element_count(); ++e) {
    if (p.element_tets[e] >= element_of_.size())
      element_of_.resize(std::size_t{p.element_tets[e]} + 1, no_id);
    element_of_[p.element_tets[e]] = e;
  }
  for (std::uint32_t n = 0; n < p.corner_count; ++n) {
    const auto v = p.node_vertices[n];
    if (v == no_id)
      continue;
    if (v >= node_of_.size())
      node_of_.resize(std::size_t{v} + 1, no_id);
    node_of_[v] = n;
  }
}

bool problem_updater::fits(const difference& d, const problem& p) const {
  const std::size_t tets = d.gone.size() + d.fresh.size() + d.changed.size();
  const auto corners = std::ranges::lower_bound(p.unused, p.corner_count) - p.unused.begin();
  return tets + d.moved.size() <= p.element_count() / 20 &&
         d.born.size() <= d.died.size() + static_cast<std::size_t>(corners) &&
         p.late_edges.size() <= p.ordered_edges / 20 && !corners_.crowded();
}

void problem_updater::touch(std::uint32_t element, const problem& p, problem_change& change) const {
  const auto per = static_cast<std::size_t>(p.nodes_per_element);
  change.elements.push_back(element);
  for (std::size_t a = 0; a < per; ++a)
    change.nodes.push_back(p.element_nodes[per * element + a]);
}

void problem_updater::place_vertices(const difference& d, const mesh_version& to, problem& p,
                                     problem_change& change) {
  for (const auto v : d.died) {
    const auto n = std::exchange(node_of_[v], no_id);
    p.node_vertices[n] = no_id;
    p.nodes[n] = {};
    p.unused.push_back(n);
  }
  std::ranges::sort(p.unused);
  node_of_.resize(std::max<std::size_t>(node_of_.size(), to.vertex_slots()), no_id);
  std::size_t taken = 0;
  for (const auto v : d.born) {
    const auto n = p.unused[taken++];
    node_of_[v] = n;
    p.node_vertices[n] = v;
    p.nodes[n] = to.position(v);
    change.fresh.push_back(n);
  }
  p.unused.erase(p.unused.begin(), p.unused.begin() + static_cast<std::ptrdiff_t>(taken));
  for (const auto v : d.moved) {
    p.nodes[node_of_[v]] = to.position(v);
    change.fresh.push_back(node_of_[v]);
  }
}

/// Gives new tets the slots of those that went, and the slots that remain to the last elements.
void problem_updater::place_elements(const difference& d, problem& p, problem_change& change) {
  std::vector<std::uint32_t> open;
  for (const auto t : d.gone)
    open.push_back(std::exchange(element_of_[t], no_id));
  std::ranges::sort(open, std::greater{});
  const auto per = static_cast<std::size_t>(p.nodes_per_element);
  for (const auto t : d.fresh) {
    std::uint32_t e = static_cast<std::uint32_t>(p.element_count());
    if (!open.empty()) {
      e = open.back();
      open.pop_back();
    } else {
      p.element_tets.push_back(t);
      p.element_materials.push_back(0);
      p.element_nodes.resize(p.element_nodes.size() + per, 0);
      change.elements.push_back(e);
    }
    p.element_tets[e] = t;
    if (t >= element_of_.size())
      element_of_.resize(std::size_t{t} + 1, no_id);
    element_of_[t] = e;
  }
  // Largest slots first, so that the last element is never itself an open place.
  for (const auto e : open) {
    const auto last = static_cast<std::uint32_t>(p.element_count() - 1);
    touch(last, p, change);
    if (e != last) {
      std::copy_n(&p.element_nodes[per * last], per, &p.element_nodes[per * e]);
      p.element_tets[e] = p.element_tets[last];
      p.element_materials[e] = p.element_materials[last];
      element_of_[p.element_tets[e]] = e;
    }
    p.element_nodes.resize(per * last);
    p.element_tets.pop_back();
    p.element_materials.pop_back();
  }
}

void problem_updater::fill_element(const mesh_version& to, std::uint32_t element, problem& p) {
  const auto per = static_cast<std::size_t>(p.nodes_per_element);
  auto* nodes = &p.element_nodes[per * element];
  const auto& v = to.tet_at(p.element_tets[element]).v;
  for (int a = 0; a < 4; ++a)
    nodes[a] = node_of_[v[a]];
  for (std::size_t i = 0; per == 10 && i < 6; ++i) {
    const auto [low, high] =
      std::minmax(nodes[ends_of_mid_node[i][0]], nodes[ends_of_mid_node[i][1]]);
    auto mid = mid_node(p, low, high);
    if (mid == no_id) {
      mid = static_cast<std::uint32_t>(p.node_count());
      p.late_edges.emplace(std::array{low, high}, mid);
      p.edge_ends.push_back({low, high});
      p.nodes.emplace_back();
    }
    nodes[4 + i] = mid;
    p.nodes[mid] = 0.5 * (p.nodes[low] + p.nodes[high]);
  }
}

/// Mid nodes come and go with their edges.
void problem_updater::find_unused(std::size_t old_nodes, problem& p, problem_change& change) const {
  const auto used = [&](std::uint32_t mid) {
    const auto low = p.edge_ends[mid - p.corner_count][0];
    return std::ranges::any_of(corners_.of_node(low), [&](std::uint32_t corner) {
      const auto* n = &p.element_nodes[10 * std::size_t{corner / 10}];
      return std::find(n + 4, n + 10, mid) != n + 10;
    });
  };
  const auto first = std::ranges::lower_bound(change.nodes, p.corner_count);
  std::vector<std::uint32_t> now;
  for (auto n = first; n != change.nodes.end(); ++n) {
    const auto [low, high] = p.edge_ends[*n - p.corner_count];
    if (!used(*n))
      now.push_back(*n);
    else if (std::ranges::binary_search(p.unused, *n) || *n >= old_nodes ||
             std::ranges::binary_search(change.fresh, low) ||
             std::ranges::binary_search(change.fresh, high))
      change.fresh.push_back(*n);
  }
  std::erase_if(p.unused, [&](std::uint32_t n) {
    return n >= p.corner_count && std::ranges::binary_search(change.nodes, n);
  });
  p.unused.insert(p.unused.end(), now.begin(), now.end());
  std::ranges::sort(p.unused);
}

expected<std::optional<problem_change>> problem_updater::apply(const mesh_version& from,
                                                               const mesh_version& to,
                                                               const load_case& loads, problem& p) {
  const auto d = compare(from, to);
  if (!fits(d, p))
    return std::optional<problem_change>{};
  problem_change change;
  const std::size_t old_nodes = p.node_count();
  for (const auto v : d.moved)
    for (const auto corner : corners_.of_node(node_of_[v]))
      touch(corner / static_cast<std::uint32_t>(p.nodes_per_element), p, change);
  for (const auto* list : {&d.gone, &d.changed})
    for (const auto t : *list)
      touch(element_of_[t], p, change);
  place_vertices(d, to, p, change);
  place_elements(d, p, change);
  sort_unique(change.elements);
  const auto regions = materials_of_regions(loads);
  std::vector<tet_id> tets;
  for (const auto e : change.elements) {
    if (e >= p.element_count())
      break;
    fill_element(to, e, p);
    p.element_materials[e] = regions.of(to.region_of(p.element_tets[e]));
    if (p.element_materials[e] == no_id)
      return refuse_region(to.region_of(p.element_tets[e]));
    tets.push_back(p.element_tets[e]);
  }
  if (auto ok = check_shapes(to, tets); !ok)
    return fail(ok.error());
  for (std::size_t i = 0, count = change.elements.size(); i < count; ++i)
    if (change.elements[i] < p.element_count())
      touch(change.elements[i], p, change);
  sort_unique(change.elements);
  sort_unique(change.nodes);
  sort_unique(change.fresh);
  corners_.update(p, change.elements, change.nodes);
  if (p.element_order == 2)
    find_unused(old_nodes, p, change);
  return std::optional(std::move(change));
}

}  // namespace tedit::fem
