// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/error_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "fem/element.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

namespace {

/// s : C^-1 : s for a stress, J/m^3.
double energy_of(const std::array<double, 6>& s, const lame_constants& c) {
  const double trace = s[0] + s[1] + s[2];
  const double square =
    s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
  return (square - c.lambda / (3 * c.lambda + 2 * c.mu) * trace * trace) / (2 * c.mu);
}

/// eta_e^2 by the exact integral of a field d that is linear between corner values: V/20 (sum of
/// d_k.d_k + (sum of d_k).(sum of d_l)).
double element_error(const problem& p, const nodal_patches& patches, const corner_flux& stress,
                     std::span<const double> means, std::size_t e) {
  const auto* nodes = &p.element_nodes[static_cast<std::size_t>(p.nodes_per_element) * e];
  const auto& constants = p.constants[p.element_materials[e]];
  std::array<double, 6> sum{};
  double result = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double* mean = &means[6 * patches.patch_in(nodes[k], e)];
    const double* own = stress.at(e, k);
    std::array<double, 6> d;
    for (int c = 0; c < 6; ++c) {
      d[c] = mean[c] - own[c];
      sum[c] += d[c];
    }
    result += energy_of(d, constants);
  }
  // Rounding must not make it negative.
  return std::max(0.0, patches.volume_of(e) / 20 * (result + energy_of(sum, constants)));
}

/// A boundary triangle at a node: its other corners and the outward normal.
struct rim_triangle {
  std::array<std::uint32_t, 2> others;
  vec3 normal;
};

/// Faces around a node that one element only has. All elements with a face at the node are around
/// the node, so no search over the mesh is needed.
std::vector<rim_triangle> boundary_around(const problem& p, const incidence& corners,
                                          std::size_t node) {
  const auto per = static_cast<std::size_t>(p.nodes_per_element);
  std::vector<rim_triangle> faces;
  for (const auto corner : corners.of_node(node)) {
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

}  // namespace

void estimate_error(const problem& p, const nodal_patches& patches, const corner_flux& stress,
                    std::span<const double> means, solution& out) {
  polled_resize(out.element_error, p.element_count());
  const double sum = parallel_sum(p.element_count(), [&](std::size_t first, std::size_t last) {
    double part = 0;
    for (std::size_t e = first; e < last; ++e) {
      const double square = element_error(p, patches, stress, means, e);
      out.element_error[e] = std::sqrt(square);
      part += square;
    }
    return part;
  });
  const double whole = 2 * out.strain_energy_j + sum;
  out.relative_error = whole > 0 ? std::sqrt(sum / whole) : 0;
}

std::vector<double> nodal_error(const problem& p, const solution& result) {
  std::vector<double> volumes(p.corner_count, 0);
  std::vector<double> errors(p.corner_count, 0);
  double volume = 0;
  double energy = 2 * result.strain_energy_j;
  polled_for(p.element_count(), [&](std::size_t e) {
    const double v = gradients_of(p, e).volume;
    const double square = result.element_error[e] * result.element_error[e];
    volume += v;
    energy += square;
    const auto* nodes = &p.element_nodes[static_cast<std::size_t>(p.nodes_per_element) * e];
    for (int k = 0; k < 4; ++k) {
      volumes[nodes[k]] += v;
      errors[nodes[k]] += square;
    }
  });
  for (std::size_t n = 0; n < errors.size(); ++n)
    errors[n] =
      volumes[n] > 0 && energy > 0 ? std::sqrt(errors[n] / volumes[n] * volume / energy) : 0;
  return errors;
}

void find_singular_places(const problem& p, const nodal_patches& patches, solution& out) {
  constexpr double dense = 10;
  constexpr double high = 0.5;
  // Below this the estimate is rounding.
  if (out.relative_error < 1e-6)
    return;
  double sum = 0;
  for (const double eta : out.element_error)
    sum += eta * eta;
  const double limit = dense * sum / patches.volume();
  const double wanted = high * *std::ranges::max_element(out.von_mises);
  const auto per = static_cast<std::size_t>(p.nodes_per_element);
  polled_for(p.corner_count, [&](std::size_t at) {
    const auto n = static_cast<std::uint32_t>(at);
    const auto is_dense = [&](std::uint32_t corner) {
      const auto e = corner / per;
      return out.element_error[e] * out.element_error[e] > limit * patches.volume_of(e);
    };
    if (out.von_mises[n] < wanted || std::ranges::none_of(patches.corners().of_node(n), is_dense))
      return;
    const auto around = boundary_around(p, patches.corners(), n);
    if (on_clamp_rim(p, around, n))
      out.singular_places.push_back({n, singularity::clamp_rim, p.nodes[n], out.von_mises[n]});
    else if (on_reentrant_edge(p, around, n))
      out.singular_places.push_back({n, singularity::reentrant_edge, p.nodes[n], out.von_mises[n]});
  });
  std::ranges::stable_sort(out.singular_places, std::greater{}, &singular_place::von_mises_pa);
}

}  // namespace tedit::fem
