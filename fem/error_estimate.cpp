// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/error_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.hpp"
#include "fem/element_lanes.hpp"
#include "fem/incidence.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

namespace {

/// s : C^-1 : s of stresses, J/m^3.
TEDIT_INLINE lanes energy_of(const lanes6& s, const lane_elements& e) {
  const lanes trace = s[0] + s[1] + s[2];
  const lanes shears = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  const lanes square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + (shears + shears);
  const lanes twice = e.mu + e.mu;
  return (square - e.lambda / (3.0 * e.lambda + twice) * trace * trace) / twice;
}

/// eta_e^2 by the exact integral of a field d that is linear between corner values: V/20 (sum of
/// d_k.d_k + (sum of d_k).(sum of d_l)).
template <std::size_t Nodes>
TEDIT_INLINE lanes error_of(const nodal_patches& patches, const lane_group<Nodes>& group) {
  const auto stress_at = [&](auto corner) TEDIT_INLINED {
    if constexpr (Nodes == 4)
      return stress_of(group.value, group.elements);
    else
      return corner_stress_of<corner>(group.value, group.elements);
  };
  lanes6 sum{};
  lanes result{};
  unrolled<4>([&](auto corner) TEDIT_INLINED {
    const auto mean = [&](std::size_t lane) TEDIT_INLINED -> const std::array<double, 6>& {
      return patches.mean_of(patches.patch_in(group.node(lane, corner), group.element(lane)));
    };
    const auto &a = mean(0), &b = mean(1), &c = mean(2), &d = mean(3);
    lanes6 gap = stress_at(corner);
    unrolled<6>([&](auto i) TEDIT_INLINED {
      gap[i] = lanes{a[i], b[i], c[i], d[i]} - gap[i];
      sum[i] += gap[i];
    });
    result += energy_of(gap, group.elements);
  });
  return group.elements.volume * (1.0 / 20) * (result + energy_of(sum, group.elements));
}

/// Fills the errors of elements and adds their squares to the nodes; returns the sum of squares.
template <std::size_t Nodes>
TEDIT_INLINE double add_errors(const nodal_patches& patches, const chunk_elements& elements,
                               std::array<double, 1>* sums, std::vector<float>& element_error) {
  double all = 0;
  for_each_lanes<Nodes>(elements, [&](const lane_group<Nodes>& group) TEDIT_INLINED {
    const lanes squares = error_of(patches, group);
    for (std::size_t lane = 0; lane < group.count; ++lane) {
      const double square = std::max(0.0, squares[lane]);  // Rounding can make it negative.
      element_error[group.element(lane)] = static_cast<float>(std::sqrt(square));
      all += square;
      for (std::size_t corner = 0; corner < 4; ++corner)
        sums[group.place(lane, corner)][0] += square;
    }
  });
  return all;
}

/// A boundary triangle at a node: its other corners and the outward normal.
struct rim_triangle {
  std::array<std::uint32_t, 2> others;
  vec3 normal;
};

/// Faces around a node that one element only has. All elements with a face at the node are around
/// the node, so no search over the mesh is needed.
std::vector<rim_triangle> boundary_around(const problem& p, std::span<const std::uint32_t> corners,
                                          std::size_t node) {
  const auto per = static_cast<std::size_t>(p.nodes_per_element);
  std::vector<rim_triangle> faces;
  for (const auto corner : corners) {
    const auto* n = &p.element_nodes[per * (corner / per)];
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      if (opposite == corner % per)
        continue;
      rim_triangle face;
      std::size_t count = 0;
      for (std::size_t a = 0; a < 4; ++a)
        if (a != opposite && a != corner % per)
          face.others[count++] = n[a];
      std::ranges::sort(face.others);
      const vec3 at = p.nodes[node];
      face.normal = normalized(cross(p.nodes[face.others[0]] - at, p.nodes[face.others[1]] - at));
      if (dot(face.normal, p.nodes[n[opposite]] - at) > 0)
        face.normal = -face.normal;
      faces.push_back(face);
    }
  }
  std::ranges::sort(faces, {}, &rim_triangle::others);
  std::vector<rim_triangle> once;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool shared = (i > 0 && faces[i - 1].others == faces[i].others) ||
                        (i + 1 < faces.size() && faces[i + 1].others == faces[i].others);
    if (!shared)
      once.push_back(faces[i]);
  }
  return once;
}

bool held_in_all_directions(const problem& p, std::uint32_t node) {
  auto holder = std::ranges::lower_bound(p.holders, node, {}, &node_holder::node);
  for (; holder != p.holders.end() && holder->node == node; ++holder) {
    const auto& s = holder->stiffness;
    const double scale = (s[0] + s[3] + s[5]) / 3;
    const double det = s[0] * (s[3] * s[5] - s[4] * s[4]) - s[1] * (s[1] * s[5] - s[4] * s[2]) +
                       s[2] * (s[1] * s[4] - s[3] * s[2]);
    // Three directions held alike give 1; a curved roller surface stays far below.
    if (det > 0.1 * scale * scale * scale)
      return true;
  }
  return false;
}

bool on_clamp_rim(const problem& p, const std::vector<rim_triangle>& around, std::uint32_t node) {
  return held_in_all_directions(p, node) && std::ranges::any_of(around, [&](const rim_triangle& t) {
           return !held_in_all_directions(p, t.others[0]) ||
                  !held_in_all_directions(p, t.others[1]);
         });
}

/// The third corner of `t` when it shares the edge to `end` with the node.
std::uint32_t behind_edge(const rim_triangle& t, std::uint32_t end) {
  return t.others[0] == end ? t.others[1] : t.others[1] == end ? t.others[0] : no_id;
}

bool on_reentrant_edge(const problem& p, const std::vector<rim_triangle>& around,
                       std::uint32_t node) {
  constexpr double cos_45 = 0.70710678118654752;
  for (std::size_t i = 0; i < around.size(); ++i)
    for (std::size_t j = i + 1; j < around.size(); ++j)
      for (const auto end : around[i].others) {
        const auto third = behind_edge(around[j], end);
        if (third == no_id || dot(around[i].normal, around[j].normal) >= cos_45)
          continue;
        // Concave: the second triangle rises over the outer side of the first.
        if (dot(around[i].normal, p.nodes[third] - p.nodes[node]) > 0)
          return true;
      }
  return false;
}

/// Nodes of at least `wanted` von Mises stress beside an element whose error density is above
/// `limit`, ascending.
std::vector<std::uint32_t> suspicious_nodes(const problem& p, const solution& out, double wanted,
                                            double limit) {
  const auto per = static_cast<std::size_t>(p.nodes_per_element);
  std::vector<std::vector<std::uint32_t>> found(chunk_count(p.element_count()));
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t chunk) {
    for (std::size_t e = first; e < last; ++e) {
      const auto corners = std::span(p.element_nodes).subspan(per * e, 4);
      const auto high = [&](std::uint32_t n) { return out.von_mises[n] >= wanted; };
      const double eta = out.element_error[e];
      if (std::ranges::any_of(corners, high) && eta * eta > limit * gradients_of(p, e).volume)
        std::ranges::copy_if(corners, std::back_inserter(found[chunk]), high);
    }
  });
  std::vector<std::uint32_t> nodes;
  for (const auto& part : found)
    nodes.insert(nodes.end(), part.begin(), part.end());
  sort_unique(nodes);
  return nodes;
}

}  // namespace

void estimate_error(const problem& p, const nodal_patches& patches, const element_chunks& chunks,
                    solution& out) {
  polled_resize(out.element_error, p.element_count());
  polled_resize(out.nodal_error, p.corner_count);
  std::vector<double> parts(chunk_count(p.element_count()));
  const auto fill = [&](std::size_t first, std::size_t last, std::size_t c,
                        std::array<double, 1>* sums) {
    const chunk_elements elements(p, chunks, c, first, last, out.displacement);
    run_wide_unfused([&]() TEDIT_INLINED {
      parts[c] = p.element_order == 2 ? add_errors<10>(patches, elements, sums, out.element_error)
                                      : add_errors<4>(patches, elements, sums, out.element_error);
    });
  };
  chunks.sum_at_nodes<1>(fill, [&](std::size_t node, const std::array<double, 1>& sum) {
    if (node < p.corner_count)
      out.nodal_error[node] = sum[0];
  });
  const double sum = std::accumulate(parts.begin(), parts.end(), 0.0);
  const double whole = 2 * out.strain_energy_j + sum;
  // Energies may be so small that nothing can be related to them (a displacement of 1e-160 m).
  const bool measurable = std::isfinite(patches.volume() / whole);
  out.relative_error = measurable ? std::sqrt(sum / whole) : 0;
  const double density = measurable ? patches.volume() / whole : 0;
  parallel_for(p.corner_count, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n)
      if (auto& error = out.nodal_error[n]; error > 0)
        error = std::sqrt(error / patches.volume_around(n) * density);
  });
}

void find_singular_places(const problem& p, const nodal_patches& patches, solution& out) {
  constexpr double dense = 10;
  constexpr double high = 0.5;
  // Below this the estimate is rounding.
  if (out.relative_error < 1e-6)
    return;
  const double sum = parallel_sum(p.element_count(), [&](std::size_t first, std::size_t last) {
    double part = 0;
    for (std::size_t e = first; e < last; ++e)
      part += double{out.element_error[e]} * double{out.element_error[e]};
    return part;
  });
  const auto nodes = suspicious_nodes(p, out, high * *std::ranges::max_element(out.von_mises),
                                      dense * sum / patches.volume());
  const auto corners = corners_at(p, nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto n = nodes[i];
    const auto around = boundary_around(p, corners[i], n);
    if (on_clamp_rim(p, around, n))
      out.singular_places.push_back({n, singularity::clamp_rim, p.nodes[n], out.von_mises[n]});
    else if (on_reentrant_edge(p, around, n))
      out.singular_places.push_back({n, singularity::reentrant_edge, p.nodes[n], out.von_mises[n]});
  }
  std::ranges::stable_sort(out.singular_places, std::greater{}, &singular_place::von_mises_pa);
}

}  // namespace tedit::fem
