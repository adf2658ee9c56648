// SPDX-License-Identifier: AGPL-3.0-or-later
// The method of manufactured solutions: how fast the error falls from mesh to mesh.
#include <cmath>
#include <numbers>

#include "verification/cases.hpp"
#include "verification/fields.hpp"
#include "verification/meshes.hpp"

namespace tedit::verification {

namespace {

using std::numbers::pi;

constexpr double mms_e = 1;
constexpr double mms_nu = 0.3;
constexpr double mms_mu = mms_e / (2 * (1 + mms_nu));
constexpr double mms_lambda = mms_e * mms_nu / ((1 + mms_nu) * (1 - 2 * mms_nu));

/// u_i = sin(pi x) sin(pi y) sin(pi z) in all three components: zero on the unit cube's boundary.
vec3 mms_field(vec3 p) {
  const double s = std::sin(pi * p.x) * std::sin(pi * p.y) * std::sin(pi * p.z);
  return {s, s, s};
}

std::array<vec3, 3> mms_gradient(vec3 p) {
  const vec3 s{std::sin(pi * p.x), std::sin(pi * p.y), std::sin(pi * p.z)};
  const vec3 c{std::cos(pi * p.x), std::cos(pi * p.y), std::cos(pi * p.z)};
  const vec3 g = pi * vec3{c.x * s.y * s.z, s.x * c.y * s.z, s.x * s.y * c.z};
  return {g, g, g};
}

/// f = -(lambda + mu) grad div u - mu laplace u.
vec3 mms_force(vec3 p) {
  const vec3 s{std::sin(pi * p.x), std::sin(pi * p.y), std::sin(pi * p.z)};
  const vec3 c{std::cos(pi * p.x), std::cos(pi * p.y), std::cos(pi * p.z)};
  const double sss = s.x * s.y * s.z;
  const vec3 grad_div =
    pi * pi *
    vec3{-sss + c.x * c.y * s.z + c.x * s.y * c.z, -sss + c.x * c.y * s.z + s.x * c.y * c.z,
         -sss + c.x * s.y * c.z + s.x * c.y * c.z};
  const double laplace = -3 * pi * pi * sss;
  return -(mms_lambda + mms_mu) * grad_div - (mms_mu * laplace) * vec3{1, 1, 1};
}

expected<convergence_row> mms_row(case_context& c, int n) {
  const auto mesh = block_mesh({n, n, n}, shaken_box({1, 1, 1}));
  if (!mesh)
    return fail(mesh.error());
  auto p = bare_problem(**mesh, with_material(mms_e, mms_nu), c.order());
  if (!p)
    return fail(p.error());
  prescribe(*p, **mesh, std::array<surface_id, 6>{s_low, s_high, t_low, t_high, u_low, u_high},
            mms_field);
  add_body_force(*p, mms_force);
  const auto s = c.solve(*p);
  if (!s)
    return fail(s.error());
  const auto error = errors_of(*p, s->displacement, mms_field, mms_gradient);
  return convergence_row{c.order(), p->element_count(), 1.0 / n, error.l2, error.energy, 0, 0};
}

/// Rates from the two finest meshes; theory: order + 1 in L2 and order in the energy norm.
expected<void> manufactured_solution(case_context& c) {
  const auto cells = c.linear() ? std::array{4, 8, 16} : std::array{3, 6, 12};
  convergence_row last;
  for (const int n : cells) {
    auto row = mms_row(c, n);
    if (!row)
      return fail(row.error());
    if (last.elements > 0) {
      const double step = std::log(last.size / row->size);
      row->l2_rate = std::log(last.l2_error / row->l2_error) / step;
      row->energy_rate = std::log(last.energy_error / row->energy_error) / step;
    }
    c.add_convergence(*row);
    last = *row;
  }
  c.at_least("rate of the L2 error", c.linear() ? 1.8 : 2.7, last.l2_rate);
  c.at_least("rate of the energy error", c.linear() ? 0.9 : 1.8, last.energy_rate);
  return {};
}

}  // namespace

std::vector<case_entry> convergence_cases() {
  return {{"manufactured solution",
           "by construction",
           "the rates at which the errors fall from mesh to mesh, in two norms.",
           {1, 2},
           manufactured_solution}};
}

}  // namespace tedit::verification
