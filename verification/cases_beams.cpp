// SPDX-License-Identifier: AGPL-3.0-or-later
// Bending and torsion of bars, where linear tets are known to lock.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/cases.hpp"
#include "verification/fields.hpp"
#include "verification/meshes.hpp"

namespace tedit::verification {

namespace {

// -- cantilever ------------------------------------------------------------------------

/// Mean deflection of the loaded end of a cantilever 10 x 1 x 1 with n cells across.
expected<double> cantilever_tip(case_context& c, int n) {
  const auto mesh = block_mesh({10 * n, n, n}, box({10, 1, 1}));
  if (!mesh)
    return fail(mesh.error());
  auto loads = with_material(210e3, 0.3);
  loads.constraints = {{{s_low}, fem::fixed{}}};
  loads.loads = {{{s_high}, fem::force{{0, 0, 1000}}}};
  const auto s = c.solve(**mesh, loads);
  if (!s)
    return fail(s.error());
  return s->solution.compliance_j / 1000;
}

/// Timoshenko's beam with Cowper's shear coefficient. The clamp also holds the root's lateral
/// contraction, which makes the beam 0.5 to 1 % stiffer.
expected<void> cantilever(case_context& c) {
  constexpr double e = 210e3;
  constexpr double nu = 0.3;
  constexpr double k = 10 * (1 + nu) / (12 + 11 * nu);
  constexpr double target = 1000 * 1000 / (3 * e / 12) + 1000 * 10 / (k * e / (2 * (1 + nu)));
  if (!c.linear()) {
    const auto tip = cantilever_tip(c, 2);
    if (!tip)
      return fail(tip.error());
    c.within("mean deflection of the end, h=1/2", target, *tip, 0.015);
    return {};
  }
  // Locking: too stiff, better from mesh to mesh. Half the deflection at h = 1/2 is as measured
  // with other codes.
  double last = 0;
  for (const int n : {2, 4, 8}) {
    const auto tip = cantilever_tip(c, n);
    if (!tip)
      return fail(tip.error());
    const auto h = ", h=1/" + std::to_string(n);
    c.at_most("mean deflection of the end" + h, target, *tip);
    if (last > 0)
      c.at_least("deflection over that of twice the h" + h, 1.05, *tip / last);
    last = *tip;
  }
  return {};
}

// -- Cook's membrane -------------------------------------------------------------------

/// Cook's membrane in plane stress: one surface of the sheet is held in z, the other is free. The
/// deflection belongs to the middle of the loaded edge, (48, 52); at its upper end it is 5 % more.
expected<void> cook(case_context& c) {
  // h = 3 (the table of targets: 4) and h = 2/3 (1): all diagonals of these meshes point one way,
  // which costs about as much as a quarter of h. One layer of cells in both.
  const std::array<int, 3> cells = c.linear() ? std::array{72, 60, 1} : std::array{16, 12, 1};
  const auto mesh = block_mesh(cells, [](vec3 p) {
    const double x = 48 * p.x;
    const double low = 44 * p.x;
    const double high = 44 + 16 * p.x;
    return vec3{x, low + p.y * (high - low), p.z};
  });
  if (!mesh)
    return fail(mesh.error());
  auto loads = with_material(1, 1.0 / 3);
  loads.constraints = {{{s_low}, fem::prescribed_displacement{0.0, 0.0, {}}}, symmetry(u_low, 2)};
  loads.loads = {{{s_high}, fem::force{{0, 1, 0}}}};
  const auto s = c.solve(**mesh, loads);
  if (!s)
    return fail(s.error());
  const auto node = nearest_node(s->problem, {48, 52, 0});
  c.within("u_y at (48, 52)", 23.96, node_value(s->solution.displacement, node).y,
           c.linear() ? 0.01 : 0.003);
  return {};
}

// -- twisted beam ----------------------------------------------------------------------

/// Tip deflection along the load of the beam that turns by 90 degrees from root to tip.
expected<double> twisted_tip(case_context& c, std::array<int, 3> cells, vec3 direction) {
  const auto mesh = block_mesh(cells, [](vec3 p) {
    const double angle = 0.5 * std::numbers::pi * p.x;
    const double y = 1.1 * (p.y - 0.5);
    const double z = 0.32 * (p.z - 0.5);
    return vec3{12 * p.x, y * std::cos(angle) - z * std::sin(angle),
                y * std::sin(angle) + z * std::cos(angle)};
  });
  if (!mesh)
    return fail(mesh.error());
  auto loads = with_material(29e6, 0.22);
  loads.constraints = {{{s_low}, fem::fixed{}}};
  loads.loads = {{{s_high}, fem::force{direction}}};
  const auto s = c.solve(**mesh, loads);
  if (!s)
    return fail(s.error());
  const auto tip = nearest_node(s->problem, {12, 0, 0});
  return dot(node_value(s->solution.displacement, tip), direction);
}

/// Targets by Zupan & Saje 2004, who solve the beam to 13 digits (MacNeal & Harder: .001754 and
/// .005424). Linear tets lock by a third here; they are only asked not to be worse.
expected<void> twisted_beam(case_context& c) {
  const std::array<int, 3> cells = c.linear() ? std::array{96, 9, 3} : std::array{38, 4, 2};
  const double tolerance = c.linear() ? 0.4 : 0.005;
  const auto in_plane = twisted_tip(c, cells, {0, 1, 0});
  if (!in_plane)
    return fail(in_plane.error());
  c.within("u_y at the tip, load along y", 1.753248285256e-3, *in_plane, tolerance);
  const auto out_of_plane = twisted_tip(c, cells, {0, 0, 1});
  if (!out_of_plane)
    return fail(out_of_plane.error());
  c.within("u_z at the tip, load along z", 5.424534868469e-3, *out_of_plane, tolerance);
  return {};
}

// -- torsion of a square bar -----------------------------------------------------------

constexpr double square_twist = 1e-3;
constexpr double square_length = 3;

/// Torque over G theta a^4 of a square bar with n cells across whose ends turn, free to warp.
expected<double> torsion_constant(case_context& c, int n) {
  const auto mesh = block_mesh({n, n, 3 * n}, [](vec3 p) {
    return vec3{p.x - 0.5, p.y - 0.5, 3 * p.z};
  });
  if (!mesh)
    return fail(mesh.error());
  auto p = bare_problem(**mesh, with_material(1000, 0.25), c.order());
  if (!p)
    return fail(p.error());
  const auto ends = nodes_on(*p, **mesh, std::array<surface_id, 2>{u_low, u_high});
  for (const auto node : ends) {
    const vec3 x = p->nodes[node];
    prescribe(*p, node, 0, -square_twist * x.y * x.z);
    prescribe(*p, node, 1, square_twist * x.x * x.z);
  }
  // The axis does not warp: one node on it holds the bar along z.
  prescribe(*p, nearest_node(*p, {0, 0, 0}), 2, 0);
  const auto s = c.solve(*p);
  if (!s)
    return fail(s.error());
  double torque = 0;
  for (const auto node : ends)
    if (p->nodes[node].z > 0.5 * square_length) {
      const vec3 force = node_value(s->reactions, node);
      torque += p->nodes[node].x * force.y - p->nodes[node].y * force.x;
    }
  constexpr double shear_modulus = 400;
  return torque / (shear_modulus * square_twist);
}

/// Saint-Venant's torsion constant of the square: 0.140577 a^4. A displacement method gives more.
expected<void> square_torsion(case_context& c) {
  constexpr double target = 0.1405770;
  if (!c.linear()) {
    const auto constant = torsion_constant(c, 4);
    if (!constant)
      return fail(constant.error());
    c.within("torque / (G theta a^4), h=1/4", target, *constant, 0.01);
    return {};
  }
  double last = 0;
  for (const int n : {4, 8, 12}) {
    const auto constant = torsion_constant(c, n);
    if (!constant)
      return fail(constant.error());
    const double error = *constant / target - 1;
    if (n == 12)
      c.at_least("rate of the torque's error, h=1/8 to 1/12", 1.8,
                 std::log(last / error) / std::log(12.0 / 8));
    last = error;
  }
  return {};
}

}  // namespace

std::vector<case_entry> beam_cases() {
  return {{"end-loaded cantilever",
           "Timoshenko, Cowper 1966",
           "deflection of a slender bar; linear tets approach it from below.",
           {1, 2},
           cantilever},
          {"Cook's membrane", "Cook 1974", "a skew sheet in shear and bending.", {1, 2}, cook},
          {"twisted beam",
           "MacNeal & Harder 1985; Zupan & Saje 2004",
           "a thin beam twisted by 90 degrees, loaded in both directions.",
           {1, 2},
           twisted_beam},
          {"torsion of a square bar",
           "Saint-Venant; Timoshenko & Goodier",
           "the torque of a turned bar whose ends may warp, from the reactions.",
           {1, 2},
           square_torsion}};
}

}  // namespace tedit::verification
