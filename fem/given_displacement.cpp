// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/given_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "fem/node_values.hpp"
#include "fem/recovery.hpp"

namespace tedit::fem {

namespace {

/// S u + (I - S) z.
void hold(const problem& p, std::span<double> u) {
  for (std::size_t n = 0; n < p.node_count(); ++n) {
    const auto z = value_at(p.prescribed, n);
    put(z + filtered(p.filter[n], value_at(u, n) - z), n, u);
  }
}

/// S(f - K u).
std::vector<double> residual_of(const problem& p, const element_operator& k,
                                std::span<const double> u) {
  std::vector<double> r(u.size());
  k.apply(u, r);
  for (std::size_t n = 0; n < p.node_count(); ++n)
    put(filtered(p.filter[n], value_at(p.loads, n) - value_at(r, n)), n, r);
  return r;
}

double product(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// What is wrong with a displacement that meets the supports.
struct shortfall {
  double residual = 0;
  double imbalance = 0;
};

shortfall shortfall_of(const problem& p, const element_operator& k, std::span<const double> u) {
  const auto driving = residual_of(p, k, p.prescribed);
  const auto left = residual_of(p, k, u);
  std::vector<double> d(u.begin(), u.end());
  for (std::size_t i = 0; i < d.size(); ++i)
    d[i] -= p.prescribed[i];
  const double reference = std::sqrt(product(driving, driving));
  const double norm = std::sqrt(product(left, left));
  const double work = product(d, driving);
  const double off = product(d, left);
  const double scale = std::max(std::abs(work), std::abs(work - off));
  return {reference > 0 ? norm / reference
          : norm > 0    ? 1.0
                        : 0.0,
          scale > 0 ? std::abs(off) / scale : 0.0};
}

}  // namespace

expected<solution> solution_of(const problem& p, const element_operator& k,
                               std::vector<double> displacement, std::string device) {
  const auto is_finite = [](double x) { return std::isfinite(x); };
  if (displacement.size() != p.dofs() || !std::ranges::all_of(displacement, is_finite))
    return fail(ec::bad_input,
                "the solver " + device + " did not give a finite displacement for each of " +
                  std::to_string(p.node_count()) + " nodes",
                "Tell whoever made that solver, or choose another device");
  solution result;
  result.element_order = p.element_order;
  result.device = std::move(device);
  result.converged = true;
  result.displacement = std::move(displacement);
  hold(p, result.displacement);
  const auto missing = shortfall_of(p, k, result.displacement);
  result.true_relative_residual = result.energy_error = missing.residual;
  if (!(missing.residual <= most_given_residual && missing.imbalance <= most_given_imbalance)) {
    char text[128];
    std::snprintf(text, sizeof(text),
                  "leaves a relative residual of %.2g, and loads and stiffness do different work "
                  "(%.2g apart)",
                  missing.residual, missing.imbalance);
    return fail(ec::not_converged,
                "what the solver " + result.device + " gave is no solution: it " + text,
                "Tell whoever made that solver, or choose another device");
  }
  if (auto ok = recover(p, k, result); !ok)
    return fail(ok.error());
  return result;
}

}  // namespace tedit::fem
