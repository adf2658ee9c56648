// SPDX-License-Identifier: AGPL-3.0-or-later
#include "verification/agreement.hpp"

#include <algorithm>
#include <cmath>

#include "fem/recovery.hpp"
#include "verification/fields.hpp"

namespace tedit::verification {

namespace {

/// Largest |a - b| over all nodes, divided by the largest |b|; 0 where both are nothing.
double largest_difference(std::span<const double> a, std::span<const double> b) {
  double difference = 0;
  double scale = 0;
  for (std::size_t n = 0; n < a.size() / 3; ++n) {
    difference = std::max(difference, norm(node_value(a, n) - node_value(b, n)));
    scale = std::max(scale, norm(node_value(b, n)));
  }
  return difference == 0 ? 0 : difference / scale;
}

double work_of(std::span<const double> forces, std::span<const double> displacement) {
  double work = 0;
  for (std::size_t i = 0; i < forces.size(); ++i)
    work += forces[i] * displacement[i];
  return work;
}

void compare_reactions(const fem::problem& p, const fem::solution& ours,
                       std::span<const double> theirs, agreement& result) {
  const auto by_surface = fem::reactions_by_surface(p, theirs);
  double scale = 0;
  vec3 total;
  for (std::size_t i = 0; i < by_surface.size(); ++i) {
    const vec3 difference = by_surface[i].force_n - ours.surface_reactions[i].force_n;
    scale += norm(by_surface[i].force_n);
    result.surface_reaction = std::max(result.surface_reaction, norm(difference));
    total += difference;
  }
  result.reaction = norm(total);
  if (scale > 0) {
    result.reaction /= scale;
    result.surface_reaction /= scale;
  }
}

double von_mises(const double* s) {
  const double a = s[0] - s[1];
  const double b = s[1] - s[2];
  const double c = s[2] - s[0];
  const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * shear);
}

double median_of(std::vector<double> values) {
  if (values.empty())
    return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

agreement compare_solutions(const fem::problem& p, const fem::solution& ours,
                            const calculix_solution& theirs) {
  agreement result;
  result.displacement = largest_difference(ours.displacement, theirs.displacement);
  compare_reactions(p, ours, theirs.reactions, result);
  result.compliance_j = work_of(p.loads, theirs.displacement);
  if (result.compliance_j != 0)
    result.compliance = std::abs(ours.compliance_j / result.compliance_j - 1);
  return result;
}

std::vector<double> plain_nodal_stress(const fem::problem& p,
                                       std::span<const double> displacement) {
  std::vector<double> sum(6 * p.corner_count);
  std::vector<std::uint32_t> around(p.corner_count);
  const auto width = static_cast<std::size_t>(p.nodes_per_element);
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    const auto stress = fem::corner_stress(p, displacement, e);
    for (std::size_t k = 0; k < stress.size(); ++k) {
      const auto node = p.element_nodes[width * e + k];
      ++around[node];
      for (std::size_t i = 0; i < 6; ++i)
        sum[6 * node + i] += stress[k][i];
    }
  }
  for (std::size_t n = 0; n < around.size(); ++n)
    for (std::size_t i = 0; i < 6; ++i)
      sum[6 * n + i] /= std::max(around[n], 1U);
  return sum;
}

stress_agreement compare_stress(const fem::problem& p, const fem::solution& ours,
                                const calculix_solution& theirs) {
  const auto plain = plain_nodal_stress(p, ours.displacement);
  stress_agreement result;
  std::vector<double> differences(p.corner_count);
  double same_means = 0;
  double own_means = -1;
  for (std::size_t n = 0; n < p.corner_count; ++n) {
    const double their = von_mises(&theirs.stress[6 * n]);
    const double shown = von_mises(&ours.nodal_stress[6 * n]);
    result.most_theirs_pa = std::max(result.most_theirs_pa, their);
    result.most_ours_pa = std::max(result.most_ours_pa, shown);
    same_means = std::max(same_means, std::abs(von_mises(&plain[6 * n]) - their));
    differences[n] = std::abs(shown - their);
    if (differences[n] > own_means) {
      own_means = differences[n];
      result.own_means_at = p.nodes[n];
    }
  }
  if (!(result.most_theirs_pa > 0))
    return result;
  result.same_means = same_means / result.most_theirs_pa;
  result.own_means = own_means / result.most_theirs_pa;
  result.own_means_median = median_of(std::move(differences)) / result.most_theirs_pa;
  return result;
}

}  // namespace tedit::verification
