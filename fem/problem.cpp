// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/problem.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/guard.hpp"
#include "base/parallel.hpp"
#include "fem/polled.hpp"
#include "fem/problem_parts.hpp"
#include "fem/quadratic.hpp"
#include "mesh/flat.hpp"
#include "mesh/morton.hpp"
#include "mesh/place_text.hpp"
#include "mesh/quality.hpp"

namespace tedit::fem {

namespace {

/// Nodes along a Morton curve, so that neighbours in space are neighbours in memory.
void number_nodes(const mesh_version& mesh, std::uint32_t spare, problem& p,
                  std::vector<std::uint32_t>& node_of) {
  box extents;
  polled_for(mesh.vertex_slots(), [&](std::size_t slot) {
    const auto v = static_cast<vertex_id>(slot);
    if (!mesh.is_live_vertex(v))
      return;
    extents.add(mesh.position(v));
    p.node_vertices.push_back(v);
  });
  const morton_curve curve(extents);
  std::vector<std::uint64_t> code(mesh.vertex_slots());
  polled_for(p.node_vertices.size(), [&](std::size_t i) {
    const auto v = p.node_vertices[i];
    code[v] = curve.code(mesh.position(v));
  });
  polled_sort(p.node_vertices, [&](vertex_id a, vertex_id b) {
    return code[a] != code[b] ? code[a] < code[b] : a < b;
  });
  node_of.assign(mesh.vertex_slots(), no_id);
  polled_for(p.node_vertices.size(), [&](std::size_t n) {
    node_of[p.node_vertices[n]] = static_cast<std::uint32_t>(n);
    p.nodes.push_back(mesh.position(p.node_vertices[n]));
  });
  for (; spare > 0; --spare) {
    p.unused.push_back(static_cast<std::uint32_t>(p.nodes.size()));
    p.node_vertices.push_back(no_id);
    p.nodes.emplace_back();
  }
  p.corner_count = p.nodes.size();
}

/// Where a tet stands in the file that the mesh came from: what people can look up.
std::uint32_t place_in_file(const mesh_version& mesh, tet_id t) {
  const auto& order = mesh.data().tet_order;
  return t < order.size() ? order[t] : t;
}

std::string list_of(const mesh_version& mesh, const std::vector<tet_id>& tets) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(tets.size(), 8); ++i)
    text += (i ? ", " : "") + std::to_string(place_in_file(mesh, tets[i]));
  return tets.size() > 8 ? text + ", ..." : text;
}

void add_elements(const mesh_version& mesh, const std::vector<std::uint32_t>& node_of, problem& p) {
  polled_for(mesh.tet_slots(), [&](std::size_t slot) {
    const auto t = static_cast<tet_id>(slot);
    if (!mesh.is_live_tet(t))
      return;
    p.element_tets.push_back(t);
    for (const auto v : mesh.tet_at(t).v)
      p.element_nodes.push_back(node_of[v]);
  });
}

/// Elements by their smallest node (stable): a counting sort.
void sort_elements(problem& p) {
  const std::size_t count = p.element_count();
  std::vector<std::uint32_t> smallest(count);
  std::vector<std::uint32_t> next(p.node_count() + 1, 0);
  polled_for(count, [&](std::size_t e) {
    const auto* n = &p.element_nodes[4 * e];
    smallest[e] = std::min({n[0], n[1], n[2], n[3]});
    ++next[smallest[e] + 1];
  });
  std::partial_sum(next.begin(), next.end(), next.begin());
  problem sorted;
  sorted.element_nodes.resize(p.element_nodes.size());
  sorted.element_tets.resize(count);
  sorted.element_materials.resize(count);
  polled_for(count, [&](std::size_t e) {
    const std::size_t to = next[smallest[e]]++;
    std::copy_n(&p.element_nodes[4 * e], 4, &sorted.element_nodes[4 * to]);
    sorted.element_tets[to] = p.element_tets[e];
    sorted.element_materials[to] = p.element_materials[e];
  });
  p.element_nodes.swap(sorted.element_nodes);
  p.element_tets.swap(sorted.element_tets);
  p.element_materials.swap(sorted.element_materials);
}

/// All edges, by lower end: the higher ends of each corner node, ascending, each once.
struct edge_rows {
  std::vector<std::size_t> first;  ///< Row of each corner node, with gaps at the ends.
  std::vector<std::uint32_t> high;
  std::vector<std::uint32_t> length;  ///< Entries of each row that are in use.
};

edge_rows rows_of_edges(const problem& p) {
  edge_rows rows;
  rows.first.assign(p.corner_count + 1, 0);
  const auto for_each_edge = [&](const auto& visit) {
    polled_for(p.element_count(), [&](std::size_t e) {
      for (const auto& [i, j] : ends_of_mid_node) {
        const auto [low, high] =
          std::minmax(p.element_nodes[4 * e + i], p.element_nodes[4 * e + j]);
        visit(low, high);
      }
    });
  };
  for_each_edge([&](std::uint32_t low, std::uint32_t) { ++rows.first[low + 1]; });
  std::partial_sum(rows.first.begin(), rows.first.end(), rows.first.begin());
  rows.high.resize(rows.first.back());
  rows.length.assign(p.corner_count, 0);
  for_each_edge([&](std::uint32_t low, std::uint32_t high) {
    rows.high[rows.first[low] + rows.length[low]++] = high;
  });
  parallel_for(p.corner_count, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n) {
      const auto begin = rows.high.begin() + static_cast<std::ptrdiff_t>(rows.first[n]);
      std::sort(begin, begin + rows.length[n]);
      const auto end = std::unique(begin, begin + rows.length[n]);
      rows.length[n] = static_cast<std::uint32_t>(end - begin);
    }
  });
  return rows;
}

}  // namespace

expected<void> check_shapes(const mesh_version& mesh, std::span<const tet_id> tets) {
  std::vector<tet_id> flat;
  std::vector<tet_id> inverted;
  polled_for(tets.size(), [&](std::size_t i) {
    const auto corners = mesh.corners(tets[i]);
    const double volume = signed_volume(corners);
    if (is_flat(corners, volume))
      flat.push_back(tets[i]);
    else if (volume < 0)
      inverted.push_back(tets[i]);
  });
  const auto refuse = [&](ec code, std::vector<tet_id> bad, const char* what, const char* remedy) {
    std::ranges::sort(bad, {}, [&](tet_id t) { return place_in_file(mesh, t); });
    const auto c = mesh.corners(bad.front());
    const vec3 at = 0.25 * (c[0] + c[1] + c[2] + c[3]);
    return fail(code, std::to_string(bad.size()) + " tets " + what + ": tet " + list_of(mesh, bad),
                remedy, "first at " + place_text(at));
  };
  if (!inverted.empty())
    return refuse(ec::inverted_tet, inverted, "are inverted (negative volume)",
                  "Repair or remesh the part there");
  if (!flat.empty())
    return refuse(ec::degenerate_tet, flat, "have zero volume (flat within rounding)",
                  "Improve the mesh (operation improve_mesh), or remesh the part there");
  return {};
}

void add_mid_nodes(problem& p) {
  const auto rows = rows_of_edges(p);
  std::vector<std::uint32_t> node_of_row(p.corner_count + 1,
                                         static_cast<std::uint32_t>(p.corner_count));
  for (std::size_t n = 0; n < p.corner_count; ++n)
    node_of_row[n + 1] = node_of_row[n] + rows.length[n];
  polled_resize(p.nodes, node_of_row.back());
  polled_resize(p.edge_ends, p.nodes.size() - p.corner_count);
  parallel_for(p.corner_count, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n)
      for (std::uint32_t i = 0; i < rows.length[n]; ++i) {
        const auto other = rows.high[rows.first[n] + i];
        const std::size_t mid = node_of_row[n] + i;
        p.nodes[mid] = 0.5 * (p.nodes[n] + p.nodes[other]);
        p.edge_ends[mid - p.corner_count] = {static_cast<std::uint32_t>(n), other};
      }
  });
  std::vector<std::uint32_t> all;
  polled_resize(all, 10 * p.element_count());
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t e = first; e < last; ++e) {
      std::copy_n(&p.element_nodes[4 * e], 4, &all[10 * e]);
      for (std::size_t i = 0; i < 6; ++i) {
        const auto [low, high] =
          std::minmax(all[10 * e + ends_of_mid_node[i][0]], all[10 * e + ends_of_mid_node[i][1]]);
        const auto* row = &rows.high[rows.first[low]];
        const auto* found = std::lower_bound(row, row + rows.length[low], high);
        all[10 * e + 4 + i] = node_of_row[low] + static_cast<std::uint32_t>(found - row);
      }
    }
  });
  p.element_nodes.swap(all);
  p.ordered_edges = p.edge_ends.size();
  p.element_order = 2;
  p.nodes_per_element = 10;
}

std::uint32_t mid_node(const problem& p, std::uint32_t a, std::uint32_t b) {
  const std::array<std::uint32_t, 2> ends{std::min(a, b), std::max(a, b)};
  const auto ordered = std::span(p.edge_ends).first(p.ordered_edges);
  const auto found = std::ranges::lower_bound(ordered, ends);
  if (found != ordered.end() && *found == ends)
    return static_cast<std::uint32_t>(p.corner_count +
                                      static_cast<std::size_t>(found - ordered.begin()));
  const auto late = p.late_edges.find(ends);
  return late == p.late_edges.end() ? no_id : late->second;
}

namespace {

expected<problem> discretised(const mesh_version& mesh, const load_case& loads, int element_order,
                              std::uint32_t spare_corners) {
  if (element_order != 1 && element_order != 2)
    return fail(ec::invalid_argument,
                "there are no elements of order " + std::to_string(element_order),
                "Ask for order 1 (linear) or 2 (quadratic)");
  problem p;
  std::vector<std::uint32_t> node_of;
  number_nodes(mesh, spare_corners, p, node_of);
  check_cancelled();
  if (auto ok = assign_materials(mesh, loads, p); !ok)
    return fail(ok.error());
  add_elements(mesh, node_of, p);
  if (auto ok = check_shapes(mesh, p.element_tets); !ok)
    return fail(ok.error());
  check_cancelled();
  sort_elements(p);
  check_cancelled();
  if (element_order == 2)
    add_mid_nodes(p);
  if (spare_corners > 0) {
    reserve_for_edits(p.element_nodes, p.element_nodes.size());
    reserve_for_edits(p.element_tets, p.element_tets.size());
    reserve_for_edits(p.element_materials, p.element_materials.size());
    reserve_for_edits(p.nodes, p.nodes.size());
    reserve_for_edits(p.edge_ends, p.edge_ends.size());
  }
  if (auto ok = set_conditions(mesh, loads, p); !ok)
    return fail(ok.error());
  return p;
}

}  // namespace

expected<problem> make_problem(const mesh_version& mesh, const load_case& loads, int element_order,
                               std::uint32_t spare_corners) {
  return guarded([&] { return discretised(mesh, loads, element_order, spare_corners); });
}

expected<void> place_conditions(const mesh_version& mesh, const load_case& loads, problem& p) {
  if (auto ok = check_surfaces(mesh, loads); !ok)
    return ok;
  std::vector<std::uint32_t> node_of(mesh.vertex_slots(), no_id);
  for (std::uint32_t n = 0; n < p.node_vertices.size(); ++n)
    if (p.node_vertices[n] != no_id)
      node_of[p.node_vertices[n]] = n;
  const surface_triangles triangles(mesh, loads, node_of, p);
  check_cancelled();
  if (auto ok = add_constraints(mesh, triangles, loads, p); !ok)
    return ok;
  for (const auto n : p.unused)
    p.filter[n] = {};
  if (auto ok = add_loads(triangles, loads, p); !ok)
    return ok;
  return {};
}

expected<void> set_conditions(const mesh_version& mesh, const load_case& loads, problem& p) {
  if (auto ok = place_conditions(mesh, loads, p); !ok)
    return ok;
  check_cancelled();
  return check_supports(mesh, p);
}

}  // namespace tedit::fem
