// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/recovery.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/parallel.hpp"
#include "fem/error_estimate.hpp"
#include "fem/polled.hpp"
#include "fem/quadratic.hpp"

namespace tedit::fem {

namespace {

vec3 node_vector(std::span<const double> x, std::size_t n) {
  return {x[3 * n], x[3 * n + 1], x[3 * n + 2]};
}

/// Calls work(i) for every item, on all cores.
template <typename Work>
void for_each(std::size_t items, const Work& work) {
  parallel_for(items, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i)
      work(i);
  });
}

}  // namespace

corner_flux corner_stress(const problem& p, std::span<const double> displacement) {
  corner_flux result(p.element_order == 2 ? 4 : 1, p.element_count());
  for_each(p.element_count(), [&](std::size_t e) {
    const auto g = gradients_of(p, e);
    const auto& c = p.constants[p.element_materials[e]];
    double* to = &result.storage[6 * result.per_element * e];
    if (p.element_order == 1) {
      std::ranges::copy(stress_of(displacement_gradient(p, e, g, displacement.data()), c), to);
      return;
    }
    std::array<vec3, 10> u;
    for (std::size_t a = 0; a < 10; ++a)
      u[a] = node_vector(displacement, p.element_nodes[10 * e + a]);
    for (const auto& stress : stress_at_corners(u, g, c))
      to = std::ranges::copy(stress, to).out;
  });
  return result;
}

// -- means over the elements around a node -------------------------------------------------

nodal_patches::nodal_patches(const problem& p)
    : problem_(p), corners_(p, 4), volumes_(p.element_count()), first_(p.corner_count + 1, 0) {
  for_each(p.element_count(), [&](std::size_t e) { volumes_[e] = gradients_of(p, e).volume; });
  const auto per = static_cast<std::size_t>(p.nodes_per_element);
  if (p.constants.size() == 1) {
    polled_for(p.corner_count, [&](std::size_t n) {
      first_[n + 1] = first_[n] + (corners_.of_node(n).empty() ? 0 : 1);
    });
    material_.assign(first_.back(), 0);
    share_.assign(first_.back(), 1);
    return;
  }
  std::vector<std::uint32_t> found;
  polled_for(p.corner_count, [&](std::size_t n) {
    found.clear();
    for (const auto corner : corners_.of_node(n))
      if (const auto m = p.element_materials[corner / per];
          std::ranges::find(found, m) == found.end())
        found.push_back(m);
    material_.insert(material_.end(), found.begin(), found.end());
    first_[n + 1] = material_.size();
  });
  share_.assign(material_.size(), 0);
  for_each(p.corner_count, [&](std::size_t n) {
    double all = 0;
    for (const auto corner : corners_.of_node(n)) {
      share_[patch_in(n, corner / per)] += volumes_[corner / per];
      all += volumes_[corner / per];
    }
    for (std::size_t i = first_[n]; i < first_[n + 1]; ++i)
      share_[i] /= all;
  });
}

double nodal_patches::volume() const {
  return std::accumulate(volumes_.begin(), volumes_.end(), 0.0);
}

std::vector<double> nodal_patches::means_of(const corner_flux& flux) const {
  const auto per = static_cast<std::size_t>(problem_.nodes_per_element);
  std::vector<double> means;
  polled_resize(means, 6 * count());
  for_each(problem_.corner_count, [&](std::size_t n) {
    double all = 0;
    for (const auto corner : corners_.of_node(n)) {
      const std::size_t e = corner / per;
      const double* value = flux.at(e, corner % per);
      double* sum = &means[6 * patch_in(n, e)];
      for (int c = 0; c < 6; ++c)
        sum[c] += volumes_[e] * value[c];
      all += volumes_[e];
    }
    for (std::size_t i = first_[n]; i < first_[n + 1]; ++i)
      for (int c = 0; c < 6; ++c)
        means[6 * i + c] /= share_[i] * all;
  });
  return means;
}

std::array<double, 3> principal_values(const double* s) {
  Eigen::Matrix3d m;
  m << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(m, Eigen::EigenvaluesOnly);
  const auto& values = solver.eigenvalues();
  return {values[2], values[1], values[0]};
}

// -- the parts of a recovery -----------------------------------------------------------------

namespace {

/// Strain (xx, yy, zz, xy, yz, zx; engineering shears) of a stress.
std::array<double, 6> strain_of(const double* s, const lame_constants& c) {
  const double spread = c.lambda / (3 * c.lambda + 2 * c.mu) * (s[0] + s[1] + s[2]);
  const double two_mu = 2 * c.mu;
  return {(s[0] - spread) / two_mu,
          (s[1] - spread) / two_mu,
          (s[2] - spread) / two_mu,
          s[3] / c.mu,
          s[4] / c.mu,
          s[5] / c.mu};
}

/// Mid nodes take the mean of their ends.
void fill_mid_nodes(const problem& p, std::vector<double>& values, std::size_t width) {
  for_each(p.edge_ends.size(), [&](std::size_t i) {
    const auto [low, high] = p.edge_ends[i];
    for (std::size_t c = 0; c < width; ++c)
      values[width * (p.corner_count + i) + c] =
        0.5 * (values[width * low + c] + values[width * high + c]);
  });
}

/// Mean of each element: the stress at its centroid.
void fill_element_stress(const problem& p, corner_flux& stress, solution& out) {
  if (stress.per_element == 1) {
    out.element_stress = std::move(stress.storage);
    return;
  }
  polled_resize(out.element_stress, 6 * p.element_count());
  for_each(p.element_count(), [&](std::size_t e) {
    for (std::size_t c = 0; c < 6; ++c)
      out.element_stress[6 * e + c] =
        0.25 * (stress.at(e, 0)[c] + stress.at(e, 1)[c] + stress.at(e, 2)[c] + stress.at(e, 3)[c]);
  });
}

/// Nodal stress and strain from the patches.
void fill_nodal(const problem& p, const nodal_patches& patches, std::span<const double> means,
                solution& out) {
  polled_assign(out.nodal_strain, 6 * p.node_count(), 0.0);
  polled_assign(out.nodal_stress, 6 * p.node_count(), 0.0);
  for_each(p.corner_count, [&](std::size_t n) {
    for (std::size_t i = patches.first_of(n); i < patches.end_of(n); ++i) {
      const auto strain = strain_of(&means[6 * i], p.constants[patches.material_of(i)]);
      for (std::size_t c = 0; c < 6; ++c) {
        out.nodal_strain[6 * n + c] += patches.share_of(i) * strain[c];
        out.nodal_stress[6 * n + c] += patches.share_of(i) * means[6 * i + c];
      }
    }
  });
  fill_mid_nodes(p, out.nodal_strain, 6);
  fill_mid_nodes(p, out.nodal_stress, 6);
}

void fill_von_mises(const problem& p, const nodal_patches& patches, std::span<const double> means,
                    solution& out) {
  polled_resize(out.von_mises, p.node_count());
  polled_resize(out.principal_stress, 3 * p.node_count());
  for_each(p.node_count(), [&](std::size_t n) {
    out.von_mises[n] = von_mises(&out.nodal_stress[6 * n]);
    if (p.element_order == 2 && n < p.corner_count)
      for (std::size_t i = patches.first_of(n); i < patches.end_of(n); ++i)
        out.von_mises[n] = std::max(out.von_mises[n], von_mises(&means[6 * i]));
    if (n < p.corner_count)
      std::ranges::copy(principal_values(&out.nodal_stress[6 * n]), &out.principal_stress[3 * n]);
  });
  fill_mid_nodes(p, out.principal_stress, 3);
  out.element_von_mises.resize(p.element_count());
  for_each(p.element_count(), [&](std::size_t e) {
    out.element_von_mises[e] = von_mises(&out.element_stress[6 * e]);
  });
}

void find_max_von_mises(const problem& p, solution& out) {
  out.max_von_mises_pa = 0;
  out.max_von_mises_at = {};
  const auto& values = p.element_order == 2 ? out.von_mises : out.element_von_mises;
  const auto largest = std::ranges::max_element(values);
  if (largest == values.end() || !(*largest > 0))
    return;
  out.max_von_mises_pa = *largest;
  const auto at = static_cast<std::size_t>(largest - values.begin());
  if (p.element_order == 2)
    out.max_von_mises_at = p.nodes[at];
  else
    for (std::size_t a = 0; a < 4; ++a)
      out.max_von_mises_at += p.nodes[p.element_nodes[4 * at + a]] / 4;
}

/// Smallest over the materials at a node with known yield strength; mid nodes take the smaller of
/// their ends.
void fill_safety(const problem& p, const nodal_patches& patches, std::span<const double> means,
                 solution& out) {
  if (std::ranges::none_of(p.yield_strengths, [](double y) { return y > 0; }))
    return;
  const auto smaller = [](double a, double b) { return a == 0 || (b > 0 && b < a) ? b : a; };
  polled_assign(out.safety_factor, p.node_count(), 0.0);
  for_each(p.corner_count, [&](std::size_t n) {
    for (std::size_t i = patches.first_of(n); i < patches.end_of(n); ++i) {
      const double yield = p.yield_strengths[patches.material_of(i)];
      const double stress = von_mises(&means[6 * i]);
      const double factor =
        stress * solution::most_safety > yield ? yield / stress : solution::most_safety;
      if (yield > 0)
        out.safety_factor[n] = smaller(out.safety_factor[n], factor);
    }
  });
  for_each(p.edge_ends.size(), [&](std::size_t i) {
    const auto [low, high] = p.edge_ends[i];
    out.safety_factor[p.corner_count + i] =
      smaller(out.safety_factor[low], out.safety_factor[high]);
  });
  for (std::size_t n = 0; n < p.corner_count; ++n)
    if (const double factor = out.safety_factor[n];
        factor > 0 && (out.min_safety_factor == 0 || factor < out.min_safety_factor)) {
      out.min_safety_factor = factor;
      out.min_safety_factor_at = p.nodes[n];
    }
}

void summarise_displacement(const problem& p, solution& out) {
  polled_for(p.node_count(), [&](std::size_t n) {
    const auto u = node_vector(out.displacement, n);
    if (norm(u) > out.max_displacement_m) {
      out.max_displacement_m = norm(u);
      out.max_displacement_at = p.nodes[n];
    }
    const auto f = node_vector(p.loads, n);
    out.applied_n += f;
    out.compliance_j += dot(f, u);
  });
}

/// Reactions: K u - f in the held directions; strain energy u.Ku/2.
void add_reactions(const problem& p, const element_operator& k, solution& out) {
  polled_resize(out.reactions, p.dofs());
  k.apply(out.displacement, out.reactions);
  polled_for(p.node_count(), [&](std::size_t n) {
    const auto force = node_vector(out.reactions, n);
    out.strain_energy_j += 0.5 * dot(node_vector(out.displacement, n), force);
    const vec3 rest = force - node_vector(p.loads, n);
    const auto& s = p.filter[n];
    const vec3 held = rest - vec3{s[0] * rest.x + s[1] * rest.y + s[2] * rest.z,
                                  s[1] * rest.x + s[3] * rest.y + s[4] * rest.z,
                                  s[2] * rest.x + s[4] * rest.y + s[5] * rest.z};
    out.reactions[3 * n] = held.x;
    out.reactions[3 * n + 1] = held.y;
    out.reactions[3 * n + 2] = held.z;
    out.reaction_n += held;
  });
  out.surface_reactions = reactions_by_surface(p, out.reactions);
}

void add_mass(const problem& p, const nodal_patches& patches, solution& out) {
  out.mass_known = true;
  polled_for(p.element_count(), [&](std::size_t e) {
    const double density = p.densities[p.element_materials[e]];
    out.mass_known = out.mass_known && density > 0;
    out.mass_kg += density * patches.volume_of(e);
  });
  if (!out.mass_known)
    out.mass_kg = 0;
}

Eigen::Matrix3d symmetric(const std::array<double, 6>& s) {
  Eigen::Matrix3d m;
  m << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
  return m;
}

}  // namespace

std::vector<surface_reaction> reactions_by_surface(const problem& p,
                                                   std::span<const double> reactions) {
  std::map<surface_id, vec3> sums;
  for (std::size_t i = 0; i < p.holders.size();) {
    const auto node = p.holders[i].node;
    std::size_t end = i;
    const Eigen::Matrix3d free = symmetric(p.filter[node]);
    const Eigen::Matrix3d held = Eigen::Matrix3d::Identity() - free;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (; end < p.holders.size() && p.holders[end].node == node; ++end)
      sum += held * symmetric(p.holders[end].stiffness) * held;
    // The free part only makes the matrix regular: the reaction has no component there.
    const double scale = sum.trace();
    const Eigen::Vector3d r(&reactions[3 * std::size_t{node}]);
    const Eigen::Vector3d y =
      scale > 0 ? Eigen::Vector3d((sum + scale * free).ldlt().solve(r)) : Eigen::Vector3d::Zero();
    for (; i < end; ++i) {
      const Eigen::Vector3d part = held * (symmetric(p.holders[i].stiffness) * (held * y));
      sums[p.holders[i].surface] += vec3{part[0], part[1], part[2]};
    }
  }
  std::vector<surface_reaction> result;
  for (const auto& [surface, force] : sums)
    result.push_back({surface, force});
  return result;
}

void recover(const problem& p, const element_operator& k, solution& out) {
  auto stress = corner_stress(p, out.displacement);
  fill_element_stress(p, stress, out);
  const nodal_patches patches(p);
  const auto means = patches.means_of(stress);
  fill_nodal(p, patches, means, out);
  fill_von_mises(p, patches, means, out);
  find_max_von_mises(p, out);
  fill_safety(p, patches, means, out);
  summarise_displacement(p, out);
  add_reactions(p, k, out);
  add_mass(p, patches, out);
  estimate_error(p, patches, stress, means, out);
  find_singular_places(p, patches, out);
}

}  // namespace tedit::fem
