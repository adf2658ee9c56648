// SPDX-License-Identifier: AGPL-3.0-or-later
// Thick-walled vessels and the plate with a hole. Tets are straight here, so a circle is a polygon:
// its error falls with the square of the angle between its corners, and meshes are finer along the
// circle than across it.
#include <algorithm>
#include <cmath>

#include "verification/cases.hpp"
#include "verification/fields.hpp"
#include "verification/meshes.hpp"

namespace tedit::verification {

namespace {

/// Means over the corner nodes of a loaded inner surface.
struct wall_means {
  double radial_displacement = 0;
  double hoop_stress = 0;
};

/// `radius` gives the vector from the axis (or centre) to a point. The hoop stress is the mean of
/// the two stresses along the wall for a sphere, and the one that is not axial for a cylinder.
wall_means means_on_wall(const case_context::solved& s, const mesh_version& mesh,
                         surface_id inner_wall, bool sphere) {
  wall_means sum;
  double count = 0;
  for (const auto node : nodes_on(s.problem, mesh, std::array<surface_id, 1>{inner_wall})) {
    if (node >= s.problem.corner_count)
      continue;
    vec3 r = s.problem.nodes[node];
    if (!sphere)
      r.z = 0;
    const vec3 n = normalized(r);
    std::array<double, 6> stress;
    std::copy_n(&s.solution.nodal_stress[6 * node], 6, stress.begin());
    const double radial = dot(n, traction_of(stress, n));
    const double trace = stress[0] + stress[1] + (sphere ? stress[2] : 0);
    sum.radial_displacement += dot(node_value(s.solution.displacement, node), n);
    sum.hoop_stress += (trace - radial) / (sphere ? 2 : 1);
    ++count;
  }
  return {sum.radial_displacement / count, sum.hoop_stress / count};
}

// -- vessels ---------------------------------------------------------------------------

/// A quarter of a pipe of inner radius 1 and outer radius 2 in plane strain, unit pressure inside.
expected<void> lame_cylinder(case_context& c) {
  // 36 corners on the quarter circle keep the polygon's part of the error of u below 0.05 %.
  const std::array<int, 3> cells = c.linear() ? std::array{10, 24, 5} : std::array{5, 36, 2};
  const auto mesh = block_mesh(
    cells, quarter_ring{.inside = {1, 1}, .outside = {2, 2}, .height = 0.5, .towards_inside = 1.3});
  if (!mesh)
    return fail(mesh.error());
  auto loads = with_material(1000, 0.3);
  loads.constraints = {symmetry(t_low, 1), symmetry(t_high, 0), symmetry(u_low, 2),
                       symmetry(u_high, 2)};
  loads.loads = {{{s_low}, fem::pressure{1}}};
  const auto s = c.solve(**mesh, loads);
  if (!s)
    return fail(s.error());
  const auto means = means_on_wall(*s, **mesh, s_low, false);
  c.within("u_r at the inner wall", 1.9066667e-3, means.radial_displacement,
           c.linear() ? 0.01 : 0.0005);
  c.within("hoop stress at the inner wall", 5.0 / 3, means.hoop_stress, c.linear() ? 0.03 : 0.015);
  return {};
}

/// An octant of a sphere of inner radius 1 and outer radius 2, unit pressure inside. The facets of
/// the sphere cost more than those of the pipe: 32 along a quarter circle for 0.2 % of u.
expected<void> lame_sphere(case_context& c) {
  const auto mesh = c.linear() ? octant_mesh(22, 12, 1, 2) : octant_mesh(32, 4, 1, 2);
  if (!mesh)
    return fail(mesh.error());
  auto loads = with_material(1000, 0.3);
  loads.constraints = {symmetry(x_zero, 0), symmetry(y_zero, 1), symmetry(z_zero, 2)};
  loads.loads = {{{inner}, fem::pressure{1}}};
  const auto s = c.solve(**mesh, loads);
  if (!s)
    return fail(s.error());
  const auto means = means_on_wall(*s, **mesh, inner, true);
  c.within("u_r at the inner wall", 8e-4, means.radial_displacement, c.linear() ? 0.02 : 0.002);
  c.within("hoop stress at the inner wall", 5.0 / 7, means.hoop_stress, c.linear() ? 0.02 : 0.04);
  return {};
}

// -- Kirsch's plate --------------------------------------------------------------------

/// Kirsch's stresses of a unit hole under unit tension along x. In plane strain they are exact in
/// three dimensions for every Poisson ratio; a free surface would change them by some per cent.
std::array<double, 6> kirsch_stress(vec3 p) {
  constexpr double nu = 0.3;
  const double r2 = p.x * p.x + p.y * p.y;
  const double cos2 = (p.x * p.x - p.y * p.y) / r2;
  const double sin2 = 2 * p.x * p.y / r2;
  const double cos4 = cos2 * cos2 - sin2 * sin2;
  const double sin4 = 2 * sin2 * cos2;
  const double a = 1 / r2;
  const double b = 1.5 / (r2 * r2);
  const double xx = 1 - a * (1.5 * cos2 + cos4) + b * cos4;
  const double yy = -a * (0.5 * cos2 - cos4) - b * cos4;
  const double xy = -a * (0.5 * sin2 + sin4) + b * sin4;
  return {xx, yy, nu * (xx + yy), xy, 0, 0};
}

/// Where the ray at an angle leaves the square of half width 4.
vec3 kirsch_place(vec3 stu, double height) {
  const vec3 hole = quarter_ring{.inside = {1, 1}, .outside = {1, 1}, .height = height}(stu);
  const double reach = 4 / std::max(hole.x, hole.y);
  const double s = stu.x * stu.x;  // Cells next to the hole are thinnest.
  return {hole.x * (1 + s * (reach - 1)), hole.y * (1 + s * (reach - 1)), hole.z};
}

/// A quarter of a plate 8 x 8 with a hole of radius 1 in plane strain; the exact stress pulls at
/// the outer sides, so that the finite plate has the exact solution of the infinite one. 48 cells
/// go round the whole hole.
expected<void> kirsch(case_context& c) {
  const std::array<int, 3> cells = c.linear() ? std::array{20, 24, 4} : std::array{8, 12, 1};
  const auto mesh = block_mesh(cells, [](vec3 stu) { return kirsch_place(stu, 0.4); });
  if (!mesh)
    return fail(mesh.error());
  auto loads = with_material(1000, 0.3);
  loads.constraints = {symmetry(t_low, 1), symmetry(t_high, 0), symmetry(u_low, 2),
                       symmetry(u_high, 2)};
  loads.loads = {{{s_high}, fem::traction{{1, 0, 0}}}};
  auto p = fem::make_problem(**mesh, loads, c.order());
  if (!p)
    return fail(p.error());
  std::ranges::fill(p->loads, 0.0);
  add_traction(*p, **mesh, std::array<surface_id, 1>{s_high}, kirsch_stress);
  const auto s = c.solve(*p);
  if (!s)
    return fail(s.error());
  double sum = 0;
  double count = 0;
  for (std::size_t n = 0; n < p->corner_count; ++n)
    if (norm(p->nodes[n] - vec3{0, 1, p->nodes[n].z}) < 1e-9) {
      sum += s->nodal_stress[6 * n];
      ++count;
    }
  c.within("sigma_xx at (0, 1), mean over z", 3, sum / count, c.linear() ? 0.05 : 0.03);
  return {};
}

}  // namespace

std::vector<case_entry> ring_cases() {
  return {{"Lame's cylinder",
           "Timoshenko & Goodier",
           "a thick pipe under pressure in plane strain.",
           {1, 2},
           lame_cylinder},
          {"Lame's sphere",
           "Timoshenko & Goodier",
           "a thick sphere under pressure.",
           {1, 2},
           lame_sphere},
          {"Kirsch's plate with a hole",
           "Kirsch 1898; Timoshenko & Goodier",
           "the stress at the hole's edge; in plane strain, where the solution is exact in 3D.",
           {1, 2},
           kirsch}};
}

}  // namespace tedit::verification
