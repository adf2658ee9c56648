// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/recovery.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/number_range.hpp"
#include "base/parallel.hpp"
#include "fem/error_estimate.hpp"
#include "fem/nodal_patches.hpp"
#include "fem/node_values.hpp"
#include "fem/polled.hpp"

namespace tedit::fem {

namespace {

/// Calls work(i) for every item, on all cores.
template <typename Work>
void for_each(std::size_t items, const Work& work) {
  parallel_for(items, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i)
      work(i);
  });
}

}  // namespace

namespace {

std::array<double, 6> linear_stress(const problem& p, std::span<const double> displacement,
                                    std::size_t element) {
  const auto g = gradients_of(p, element);
  return stress_of(displacement_gradient(p, element, g, displacement.data()),
                   p.constants[p.element_materials[element]]);
}

}  // namespace

corner_stresses corner_stress(const problem& p, std::span<const double> displacement,
                              std::size_t element) {
  if (p.element_order == 1) {
    const auto s = linear_stress(p, displacement, element);
    return {s, s, s, s};
  }
  std::array<vec3, 10> u;
  for (std::size_t a = 0; a < 10; ++a)
    u[a] = value_at(displacement, p.element_nodes[10 * element + a]);
  return stress_at_corners(u, gradients_of(p, element), p.constants[p.element_materials[element]]);
}

std::array<double, 6> element_stress(const problem& p, std::span<const double> displacement,
                                     std::size_t element) {
  if (p.element_order == 1)
    return linear_stress(p, displacement, element);
  const auto at = corner_stress(p, displacement, element);
  std::array<double, 6> mean;
  for (std::size_t c = 0; c < 6; ++c)
    mean[c] = 0.25 * (at[0][c] + at[1][c] + at[2][c] + at[3][c]);
  return mean;
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

/// Nodal stress and strain from the patches.
void fill_nodal(const problem& p, const nodal_patches& patches, solution& out) {
  polled_resize(out.nodal_strain, 6 * p.corner_count);
  polled_resize(out.nodal_stress, 6 * p.corner_count);
  for_each(p.corner_count, [&](std::size_t n) {
    std::array<double, 6> strain{};
    std::array<double, 6> stress{};
    for (std::size_t i = patches.first_of(n); i < patches.end_of(n); ++i) {
      const auto& mean = patches.mean_of(i);
      const auto its_strain = strain_of(mean.data(), p.constants[patches.material_of(i)]);
      for (std::size_t c = 0; c < 6; ++c) {
        strain[c] += patches.share_of(i) * its_strain[c];
        stress[c] += patches.share_of(i) * mean[c];
      }
    }
    std::ranges::copy(strain, &out.nodal_strain[6 * n]);
    std::ranges::copy(stress, &out.nodal_stress[6 * n]);
  });
}

void fill_von_mises(const problem& p, const nodal_patches& patches, solution& out) {
  polled_resize(out.von_mises, p.corner_count);
  polled_resize(out.principal_stress, 3 * p.corner_count);
  for_each(p.corner_count, [&](std::size_t n) {
    out.von_mises[n] = von_mises(&out.nodal_stress[6 * n]);
    if (p.element_order == 2)
      for (std::size_t i = patches.first_of(n); i < patches.end_of(n); ++i)
        out.von_mises[n] = std::max(out.von_mises[n], von_mises(patches.mean_of(i).data()));
    std::ranges::copy(principal_values(&out.nodal_stress[6 * n]), &out.principal_stress[3 * n]);
  });
}

void find_max_von_mises(const problem& p, const nodal_patches& patches, solution& out) {
  if (p.element_order == 1) {
    if (patches.worst_element() == no_id)
      return;
    out.max_von_mises_element = patches.worst_element();
    out.max_von_mises_pa = patches.worst_von_mises();
    for (std::size_t a = 0; a < 4; ++a)
      out.max_von_mises_at += p.nodes[p.element_nodes[4 * out.max_von_mises_element + a]] / 4;
    return;
  }
  const auto largest = std::ranges::max_element(out.von_mises);
  if (largest == out.von_mises.end() || !(*largest > 0))
    return;
  out.max_von_mises_pa = *largest;
  out.max_von_mises_at = p.nodes[static_cast<std::size_t>(largest - out.von_mises.begin())];
}

/// Smallest over the materials at a node with known yield strength.
void fill_safety(const problem& p, const nodal_patches& patches, solution& out) {
  if (std::ranges::none_of(p.yield_strengths, [](double y) { return y > 0; }))
    return;
  const auto smaller = [](double a, double b) { return a == 0 || (b > 0 && b < a) ? b : a; };
  polled_resize(out.safety_factor, p.corner_count);
  for_each(p.corner_count, [&](std::size_t n) {
    for (std::size_t i = patches.first_of(n); i < patches.end_of(n); ++i) {
      const double yield = p.yield_strengths[patches.material_of(i)];
      const double stress = von_mises(patches.mean_of(i).data());
      const double factor =
        stress * solution::most_safety > yield ? yield / stress : solution::most_safety;
      if (yield > 0)
        out.safety_factor[n] = smaller(out.safety_factor[n], factor);
    }
  });
  for (std::size_t n = 0; n < p.corner_count; ++n)
    if (const double factor = out.safety_factor[n];
        factor > 0 && (out.min_safety_factor == 0 || factor < out.min_safety_factor)) {
      out.min_safety_factor = factor;
      out.min_safety_factor_at = p.nodes[n];
    }
}

void summarise_displacement(const problem& p, solution& out) {
  struct part {
    double largest = 0;
    std::size_t node = 0;
    vec3 applied;
    double compliance = 0;
  };
  const auto parts = parts_of_nodes<part>(p.node_count(), [&](std::size_t n, part& to) {
    const auto u = value_at(out.displacement, n);
    if (const double size = norm(u); size > to.largest) {
      to.largest = size;
      to.node = n;
    }
    const auto f = value_at(p.loads, n);
    to.applied += f;
    to.compliance += dot(f, u);
  });
  for (const auto& one : parts) {
    if (one.largest > out.max_displacement_m) {
      out.max_displacement_m = one.largest;
      out.max_displacement_at = p.nodes[one.node];
    }
    out.applied_n += one.applied;
    out.compliance_j += one.compliance;
  }
}

/// Reactions: K u - f in the held directions; strain energy u.Ku/2.
void add_reactions(const problem& p, const element_operator& k, solution& out) {
  struct part {
    double energy = 0;
    vec3 reaction;
  };
  polled_resize(out.reactions, p.dofs());
  k.apply(out.displacement, out.reactions);
  const auto parts = parts_of_nodes<part>(p.node_count(), [&](std::size_t n, part& to) {
    const auto force = value_at(out.reactions, n);
    to.energy += 0.5 * dot(value_at(out.displacement, n), force);
    const vec3 rest = force - value_at(p.loads, n);
    const vec3 held = rest - filtered(p.filter[n], rest);
    put(held, n, out.reactions);
    to.reaction += held;
  });
  for (const auto& one : parts) {
    out.strain_energy_j += one.energy;
    out.reaction_n += one.reaction;
  }
  out.surface_reactions = reactions_by_surface(p, out.reactions);
}

/// Known when every material that an element has says its density.
void add_mass(const problem& p, const nodal_patches& patches, solution& out) {
  std::vector<std::uint8_t> used(p.densities.size(), p.densities.size() == 1 ? 1 : 0);
  if (used.size() > 1)
    for (const auto material : p.element_materials)
      used[material] = 1;
  out.mass_known = true;
  for (std::size_t m = 0; m < used.size(); ++m)
    out.mass_known = out.mass_known && (used[m] == 0 || p.densities[m] > 0);
  out.mass_kg = out.mass_known ? patches.mass() : 0;
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

namespace {

/// The sums over all nodes and elements hide nothing that is no number; maxima would.
expected<void> check_result(const solution& out) {
  const auto& reaction = out.reaction_n;
  for (const double value :
       {out.max_displacement_m, out.max_von_mises_pa, out.strain_energy_j, out.compliance_j,
        out.relative_error, reaction.x, reaction.y, reaction.z})
    if (!(std::abs(value) <= std::numeric_limits<float>::max()))
      return fail(ec::invalid_load,
                  "the result is beyond what a number can hold: displacement " +
                    number_text(out.max_displacement_m) + " m, stress " +
                    number_text(out.max_von_mises_pa) + " Pa, energy " +
                    number_text(out.strain_energy_j) + " J",
                  "Check the units of loads, materials and the mesh");
  return {};
}

}  // namespace

expected<void> recover(const problem& p, const element_operator& k, solution& out) {
  const nodal_patches patches(p, k.chunks(), out.displacement);
  fill_nodal(p, patches, out);
  fill_von_mises(p, patches, out);
  find_max_von_mises(p, patches, out);
  fill_safety(p, patches, out);
  summarise_displacement(p, out);
  add_reactions(p, k, out);
  add_mass(p, patches, out);
  estimate_error(p, patches, k.chunks(), out);
  find_singular_places(p, patches, out);
  return check_result(out);
}

}  // namespace tedit::fem
