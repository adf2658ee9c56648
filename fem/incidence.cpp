// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/incidence.hpp"

#include "base/parallel.hpp"
#include "fem/element.hpp"

namespace tedit::fem {

incidence::incidence(const problem& p)
    : first_(p.node_count() + 1, 0), corners_(p.element_nodes.size()) {
  for (const auto node : p.element_nodes)
    ++first_[node + 1];
  for (std::size_t n = 1; n < first_.size(); ++n)
    first_[n] += first_[n - 1];
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t corner = 0; corner < p.element_nodes.size(); ++corner)
    corners_[next[p.element_nodes[corner]]++] = corner;
}

void element_operator::apply(std::span<const double> displacement, std::span<double> result) const {
  const auto& p = problem_;
  // Nodal forces of each element: f_a = V sigma grad N_a.
  std::vector<vec3> forces(p.element_nodes.size());
  parallel_for(p.element_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t e = first; e < last; ++e) {
      const auto g = gradients_of(p, e);
      const auto s = stress_of(displacement_gradient(p, e, g, displacement.data()),
                               p.constants[p.element_materials[e]]);
      for (int a = 0; a < 4; ++a) {
        const auto& n = g.gradient[a];
        forces[4 * e + a] = g.volume * vec3{s[0] * n.x + s[3] * n.y + s[5] * n.z,
                                            s[3] * n.x + s[1] * n.y + s[4] * n.z,
                                            s[5] * n.x + s[4] * n.y + s[2] * n.z};
      }
    }
  });
  parallel_for(p.node_count(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t n = first; n < last; ++n) {
      vec3 sum;
      for (const auto corner : incidence_.of_node(n))
        sum += forces[corner];
      result[3 * n] = sum.x;
      result[3 * n + 1] = sum.y;
      result[3 * n + 2] = sum.z;
    }
  });
}

}  // namespace tedit::fem
