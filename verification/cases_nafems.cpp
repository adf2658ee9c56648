// SPDX-License-Identifier: AGPL-3.0-or-later
// The Standard NAFEMS Benchmarks, TNSB Rev. 3 (1990): LE1, LE10 and LE11.
#include <algorithm>
#include <cmath>

#include "fem/recovery.hpp"
#include "mesh/quality.hpp"
#include "verification/cases.hpp"
#include "verification/fields.hpp"
#include "verification/meshes.hpp"

namespace tedit::verification {

namespace {

/// The quarter of an elliptic ring that LE1 and LE10 share: inner half axes 2 and 1 m, outer 3.25
/// and 2.75 m. Cells get smaller towards the inner ellipse and towards point D (2, 0), where the
/// ellipse is most curved. The polygon's corner at D raises the stress by 1 to 2 % on these meshes,
/// and less on finer ones (quadratic, 1.5 times finer: LE10 +1.4 % instead of +1.8 %).
quarter_ring ellipses(double height) {
  return {.inside = {2, 1},
          .outside = {3.25, 2.75},
          .height = height,
          .towards_inside = 1.5,
          .towards_x = 1.5};
}

double sigma_yy_at(const fem::problem& p, const fem::solution& s, vec3 at) {
  return s.nodal_stress[6 * nearest_node(p, at, true) + 1];
}

/// LE10, the thick plate: 0.6 m thick, 1 MPa on top, its curved outer face held in the plane and
/// its middle line held in z. The middle line lies between two layers of cells. Linear tets are
/// held to 3 %: this mesh, graded towards D, does much better than the 8 % of an even one.
expected<void> le10(case_context& c) {
  const std::array<int, 3> cells = c.linear() ? std::array{20, 30, 12} : std::array{8, 16, 4};
  const auto mesh = block_mesh(cells, ellipses(0.6));
  if (!mesh)
    return fail(mesh.error());
  auto loads = with_material(210e9, 0.3);
  loads.constraints = {symmetry(t_low, 1), symmetry(t_high, 0), {{s_high}, fem::fixed{}}};
  loads.loads = {{{u_high}, fem::pressure{1e6}}};
  auto p = fem::make_problem(**mesh, loads, c.order());
  if (!p)
    return fail(p.error());
  // A load case holds whole surfaces: free the outer face along z except for its middle line.
  for (const auto node : nodes_on(*p, **mesh, std::array<surface_id, 1>{s_high}))
    if (std::abs(p->nodes[node].z - 0.3) > 1e-9)
      p->filter[node][5] = 1;
  p->holders.clear();
  const auto s = c.solve(*p);
  if (!s)
    return fail(s.error());
  c.within("sigma_yy at D (2, 0, 0.6), Pa", -5.38e6, sigma_yy_at(*p, *s, {2, 0, 0.6}),
           c.linear() ? 0.03 : 0.02);
  return {};
}

/// LE1, the elliptic membrane, as a slab 0.1 m thick whose upper surface is free: plane stress.
/// 10 MPa pull on the outer ellipse.
expected<void> le1(case_context& c) {
  const std::array<int, 3> cells = c.linear() ? std::array{24, 40, 2} : std::array{10, 20, 1};
  const auto mesh = block_mesh(cells, ellipses(0.1));
  if (!mesh)
    return fail(mesh.error());
  auto loads = with_material(210e9, 0.3);
  loads.constraints = {symmetry(t_low, 1), symmetry(t_high, 0), symmetry(u_low, 2)};
  loads.loads = {{{s_high}, fem::pressure{-10e6}}};
  const auto s = c.solve(**mesh, loads);
  if (!s)
    return fail(s.error());
  c.within("sigma_yy at D (2, 0), Pa", 92.7e6, sigma_yy_at(s->problem, s->solution, {2, 0, 0}),
           0.03);
  return {};
}

// -- LE11 ------------------------------------------------------------------------------

constexpr double le11_e = 210e9;
constexpr double le11_nu = 0.3;

/// Stress that hinders the thermal strain fully, Pa per degree: 3 K alpha.
constexpr double le11_hindered = le11_e * 2.3e-4 / (1 - 2 * le11_nu);

/// Degrees above the stress-free state.
double le11_temperature(vec3 p) {
  return std::hypot(p.x, p.y) + p.z;
}

/// sigma_zz at a node, less the thermal part. Order 1: the mean of its elements by volume, each
/// with the temperature of its centroid, where its constant strain belongs.
double le11_stress(const fem::problem& p, const fem::solution& s, std::uint32_t node) {
  if (p.element_order == 2)
    return s.nodal_stress[6 * node + 2] - le11_hindered * le11_temperature(p.nodes[node]);
  double sum = 0;
  double volume = 0;
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    const auto* n = &p.element_nodes[4 * e];
    if (std::find(n, n + 4, node) == n + 4)
      continue;
    const vec3 centroid = 0.25 * (p.nodes[n[0]] + p.nodes[n[1]] + p.nodes[n[2]] + p.nodes[n[3]]);
    const double v = signed_volume(p.nodes[n[0]], p.nodes[n[1]], p.nodes[n[2]], p.nodes[n[3]]);
    sum += v * (fem::element_stress(p, s.displacement, e)[2] -
                le11_hindered * le11_temperature(centroid));
    volume += v;
  }
  return sum / volume;
}

/// LE11, the solid cylinder, taper and sphere under a temperature of r + z. Load cases know no
/// temperature: the case adds the forces of the hindered thermal strain and takes its stress away.
/// Cells get smaller towards A, where the stress rises steeply. Even cells of 0.13 m give -5 % in
/// order 2 and -14 % with half that size in order 1; finer graded meshes of order 2 settle near
/// -106.2 MPa: the last per cent is the published target's own.
expected<void> le11(case_context& c) {
  const std::array<int, 3> cells = c.linear() ? std::array{8, 40, 24} : std::array{4, 15, 12};
  const auto mesh = block_mesh(cells, [](vec3 p) {
    const double in_sphere = 0.4 * std::pow(p.y / 0.4, 1.5);
    return tapered_sphere({std::pow(p.x, 1.5), p.y < 0.4 ? in_sphere : p.y, p.z});
  });
  if (!mesh)
    return fail(mesh.error());
  auto loads = with_material(le11_e, le11_nu);
  loads.constraints = {symmetry(u_low, 1), symmetry(u_high, 0), symmetry(t_low, 2),
                       symmetry(t_high, 2)};
  // A load case without loads is refused; what stands in for them is replaced.
  loads.loads = {{{s_high}, fem::pressure{1}}};
  auto p = fem::make_problem(**mesh, loads, c.order());
  if (!p)
    return fail(p.error());
  std::ranges::fill(p->loads, 0.0);
  add_initial_stress(*p, [](vec3 x) {
    const double hindered = le11_hindered * le11_temperature(x);
    return std::array<double, 6>{hindered, hindered, hindered, 0, 0, 0};
  });
  const auto s = c.solve(*p);
  if (!s)
    return fail(s.error());
  const auto node = static_cast<std::uint32_t>(nearest_node(*p, {1, 0, 0}, true));
  c.within("sigma_zz at A (1, 0, 0), Pa", -105e6, le11_stress(*p, *s, node),
           c.linear() ? 0.05 : 0.04);
  return {};
}

}  // namespace

std::vector<case_entry> nafems_cases() {
  const std::string source = "NAFEMS TNSB Rev. 3, 1990";
  return {{"NAFEMS LE1 elliptic membrane",
           source,
           "the stress at the tip of an elliptic hole, as a thin slab.",
           {1, 2},
           le1},
          {"NAFEMS LE10 thick plate",
           source,
           "the stress at the tip of an elliptic hole in a thick plate under pressure.",
           {1, 2},
           le10},
          {"NAFEMS LE11 cylinder, taper and sphere",
           source,
           "the stress at the inner edge of a hot body whose ends are held; the case makes the "
           "thermal loads itself.",
           {1, 2},
           le11}};
}

}  // namespace tedit::verification
