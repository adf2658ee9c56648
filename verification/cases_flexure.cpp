// SPDX-License-Identifier: AGPL-3.0-or-later
// Bending by an end force with exact end tractions: no clamp that disturbs the field, so the
// energy error falls at the rate of the elements.
#include <cmath>

#include "verification/cases.hpp"
#include "verification/fields.hpp"
#include "verification/meshes.hpp"

namespace tedit::verification {

namespace {

constexpr double length = 4;
constexpr double depth = 1;
constexpr double width = 0.5;
constexpr double e = 210e9;
constexpr double nu = 0.3;
constexpr double inertia = depth * depth * depth / 12;  ///< Per unit of width.
constexpr double end_force = 1e6;                       ///< P, N per unit of width.
constexpr double k = end_force / (e * inertia);

/// The cantilever of Augarde & Deeks 2008 (Timoshenko & Goodier), whose plane stress is completed
/// to an exact solution in three dimensions. The plane field strains the sheet by nu (L - x) y P/EI
/// across, which bends it, unless u_z and the terms in z^2 go with it (Timoshenko & Goodier, "plane
/// stress", where the stress function gains -nu z^2 / 2(1+nu) of its Laplacian). Here that adds
/// nu z^2 P / 2(1+nu)I to tau_xy and nothing else: equilibrium and all six of Beltrami-Michell's
/// equations hold, sigma_zz, tau_yz and tau_zx are zero, and the faces z = const stay free.
std::array<double, 6> flexure_stress(vec3 p) {
  const double shear = 0.5 * (0.25 * depth * depth - p.y * p.y) + 0.5 * nu / (1 + nu) * p.z * p.z;
  return {-end_force / inertia * (length - p.x) * p.y, 0, 0, end_force / inertia * shear, 0, 0};
}

vec3 flexure_field(vec3 p) {
  const auto [x, y, z] = p;
  const double d2 = depth * depth;
  const double ux =
    -y / 6 * ((6 * length - 3 * x) * x + (2 + nu) * (y * y - 0.25 * d2)) + 0.5 * nu * y * z * z;
  const double uy = (3 * nu * (y * y - z * z) * (length - x) + (4 + 5 * nu) * 0.25 * d2 * x +
                     (3 * length - x) * x * x) /
                    6;
  return k * vec3{ux, uy, nu * (length - x) * y * z};
}

std::array<vec3, 3> flexure_gradient(vec3 p) {
  const auto [x, y, z] = p;
  const double d2 = depth * depth;
  const double rest = length - x;
  return {
    {k * vec3{-rest * y,
              -x * (length - 0.5 * x) - (2 + nu) / 6 * (3 * y * y - 0.25 * d2) + 0.5 * nu * z * z,
              nu * y * z},
     k * vec3{-0.5 * nu * (y * y - z * z) + (4 + 5 * nu) / 24 * d2 + x * (length - 0.5 * x),
              nu * rest * y, -nu * rest * z},
     k * vec3{-nu * y * z, nu * rest * z, nu * rest * y}}};
}

/// Tractions on all six sides; the six rigid motions are held at three corners of the root.
expected<field_errors> flexure_errors(case_context& c, int n) {
  const auto shake = shaken_box({length, depth, width});
  const auto mesh = block_mesh({4 * n, n, n / 2}, [&](vec3 p) {
    return shake(p) - vec3{0, 0.5 * depth, 0.5 * width};
  });
  if (!mesh)
    return fail(mesh.error());
  auto p = bare_problem(**mesh, with_material(e, nu), c.order());
  if (!p)
    return fail(p.error());
  add_traction(*p, **mesh, std::array<surface_id, 6>{s_low, s_high, t_low, t_high, u_low, u_high},
               flexure_stress);
  const auto hold = [&](vec3 at, std::initializer_list<int> axes) {
    const auto node = nearest_node(*p, at);
    const vec3 u = flexure_field(p->nodes[node]);
    for (const int axis : axes)
      prescribe(*p, node, axis, axis == 0 ? u.x : axis == 1 ? u.y : u.z);
  };
  hold({0, -0.5 * depth, -0.5 * width}, {0, 1, 2});
  hold({0, 0.5 * depth, -0.5 * width}, {0, 2});
  hold({0, -0.5 * depth, 0.5 * width}, {0});
  const auto s = c.solve(*p);
  if (!s)
    return fail(s.error());
  return errors_of(*p, s->displacement, flexure_field, flexure_gradient);
}

/// Theory: the energy error falls with h to the order.
expected<void> flexure(case_context& c) {
  const auto cells = c.linear() ? std::array{8, 16} : std::array{6, 12};
  const auto coarse = flexure_errors(c, cells[0]);
  if (!coarse)
    return fail(coarse.error());
  const auto fine = flexure_errors(c, cells[1]);
  if (!fine)
    return fail(fine.error());
  const auto h = ", h=1/" + std::to_string(cells[0]) + " to 1/" + std::to_string(cells[1]);
  c.at_least("rate of the energy error" + h, c.linear() ? 0.9 : 1.9,
             std::log2(coarse->energy / fine->energy));
  c.at_most("relative energy error, h=1/" + std::to_string(cells[1]), c.linear() ? 0.15 : 0.002,
            fine->energy);
  return {};
}

}  // namespace

std::vector<case_entry> flexure_cases() {
  return {{"St. Venant flexure",
           "Timoshenko & Goodier; Augarde & Deeks 2008, completed to 3D",
           "a cubic field: a bar bent by an end force with exact tractions on all sides and only "
           "the rigid motions held.",
           {1, 2},
           flexure}};
}

}  // namespace tedit::verification
