// SPDX-License-Identifier: AGPL-3.0-or-later
// Fields that the elements hold exactly: whatever is left is rounding and the solver's tolerance.
#include <algorithm>
#include <cmath>

#include "fem/recovery.hpp"
#include "verification/cases.hpp"
#include "verification/fields.hpp"
#include "verification/meshes.hpp"

namespace tedit::verification {

namespace {

constexpr std::array<surface_id, 6> all_sides{s_low, s_high, t_low, t_high, u_low, u_high};

// -- patch tests -----------------------------------------------------------------------

/// MacNeal and Harder's field: all strains are 1e-3 (engineering shears, too).
vec3 patch_field(vec3 p) {
  return 1e-3 * vec3{p.x + 0.5 * (p.y + p.z), p.y + 0.5 * (p.x + p.z), p.z + 0.5 * (p.x + p.y)};
}

/// E = 1e6, nu = 0.25: lambda = mu = 4e5.
constexpr std::array<double, 6> patch_stress{2000, 2000, 2000, 400, 400, 400};

/// The unit cube of 3 x 3 x 3 cells whose eight inner points are those of MacNeal and Harder.
expected<version_ptr> patch_mesh() {
  constexpr std::array<vec3, 8> inner{{{.249, .342, .192},
                                       {.826, .288, .288},
                                       {.273, .750, .230},
                                       {.850, .649, .263},
                                       {.320, .186, .643},
                                       {.677, .305, .683},
                                       {.165, .745, .702},
                                       {.788, .693, .644}}};
  return block_mesh({3, 3, 3}, [&](vec3 p) {
    const auto place = [](double x) { return static_cast<int>(std::lround(3 * x)); };
    const std::array<int, 3> i{place(p.x), place(p.y), place(p.z)};
    const bool inside = std::ranges::all_of(i, [](int k) { return k == 1 || k == 2; });
    return inside ? inner[(i[0] - 1) + 2 * (i[1] - 1) + 4 * (i[2] - 1)] : p;
  });
}

void check_patch(case_context& c, const fem::problem& p, const fem::solution& s, double bound) {
  c.at_most("largest error of u / largest u", bound, largest_error(p, s.displacement, patch_field));
  double error = 0;
  for (std::size_t e = 0; e < p.element_count(); ++e) {
    const auto stress = fem::element_stress(p, s.displacement, e);
    for (std::size_t i = 0; i < 6; ++i)
      error = std::max(error, std::abs(stress[i] - patch_stress[i]));
  }
  // Backends in single precision give stresses of linear tets with 24 bits.
  c.at_most("largest error of stress / 2000",
            c.linear() && !c.double_precision_stress() ? 1e-5 : bound, error / 2000);
}

expected<void> displacement_patch(case_context& c) {
  const auto mesh = patch_mesh();
  if (!mesh)
    return fail(mesh.error());
  auto p = bare_problem(**mesh, with_material(1e6, 0.25), c.order());
  if (!p)
    return fail(p.error());
  prescribe(*p, **mesh, all_sides, patch_field);
  const auto s = c.solve(*p, 1e-14);
  if (!s)
    return fail(s.error());
  check_patch(c, *p, *s, 1e-12);
  return {};
}

/// Tractions on all six sides by the load case's own uniform loads; a corner and two neighbours
/// hold the six rigid motions at their exact place, so the supports push on nothing.
expected<void> traction_patch(case_context& c) {
  const auto mesh = patch_mesh();
  if (!mesh)
    return fail(mesh.error());
  auto loads = with_material(1e6, 0.25);
  loads.constraints = {{{s_low}, fem::fixed{}}};
  for (int side = 0; side < 6; ++side) {
    const double sign = side % 2 == 1 ? 1 : -1;
    const vec3 n{side / 2 == 0 ? sign : 0, side / 2 == 1 ? sign : 0, side / 2 == 2 ? sign : 0};
    loads.loads.push_back({{all_sides[side]}, fem::traction{traction_of(patch_stress, n)}});
  }
  auto p = fem::make_problem(**mesh, loads, c.order());
  if (!p)
    return fail(p.error());
  const auto forces = p->loads;
  clear_conditions(*p);
  p->loads = forces;
  const auto hold = [&](vec3 at, std::initializer_list<int> axes) {
    const auto node = nearest_node(*p, at);
    const vec3 u = patch_field(p->nodes[node]);
    for (const int axis : axes)
      prescribe(*p, node, axis, axis == 0 ? u.x : axis == 1 ? u.y : u.z);
  };
  hold({0, 0, 0}, {0, 1, 2});
  hold({1, 0, 0}, {1, 2});
  hold({0, 1, 0}, {2});
  const auto s = c.solve(*p, 1e-12);
  if (!s)
    return fail(s.error());
  check_patch(c, *p, *s, 1e-10);
  c.at_most(
    "largest reaction / 2000 N", 1e-10,
    std::abs(*std::ranges::max_element(s->reactions, {}, [](double r) { return std::abs(r); })) /
      2000);
  return {};
}

// -- quadratic fields ------------------------------------------------------------------

constexpr double bending_e = 210e9;
constexpr double bending_nu = 0.3;
constexpr double curvature = 1e-3;

/// A beam along x bent about z: sigma_xx = E k y, all other stresses vanish.
vec3 bending_field(vec3 p) {
  return curvature * vec3{p.x * p.y, -0.5 * (p.x * p.x + bending_nu * (p.y * p.y - p.z * p.z)),
                          -bending_nu * p.y * p.z};
}

/// The bar [0,4] x [-.5,.5]^2, shaken, with n cells across: held at x = 0 by the exact field,
/// pulled at x = 4 by the exact stress.
expected<double> bending_error(case_context& c, int n) {
  const auto shake = shaken_box({4, 1, 1});
  const auto mesh = block_mesh({4 * n, n, n}, [&](vec3 p) { return shake(p) - vec3{0, 0.5, 0.5}; });
  if (!mesh)
    return fail(mesh.error());
  auto p = bare_problem(**mesh, with_material(bending_e, bending_nu), c.order());
  if (!p)
    return fail(p.error());
  prescribe(*p, **mesh, std::array<surface_id, 1>{s_low}, bending_field);
  add_traction(*p, **mesh, std::array<surface_id, 1>{s_high},
               [](vec3 x) { return std::array<double, 6>{bending_e * curvature * x.y}; });
  const auto s = c.solve(*p, c.linear() ? 1e-9 : 1e-13);
  if (!s)
    return fail(s.error());
  return largest_error(*p, s->displacement, bending_field);
}

/// Linear tets lock: their error is known to be about 30 % at h = .4 and falls slowly.
expected<void> pure_bending(case_context& c) {
  if (!c.linear()) {
    const auto error = bending_error(c, 3);
    if (!error)
      return fail(error.error());
    c.at_most("largest error of u / largest u", 1e-9, *error);
    return {};
  }
  double last = 0;
  for (const int n : {4, 8}) {
    const auto error = bending_error(c, n);
    if (!error)
      return fail(error.error());
    if (last > 0)
      c.at_least("error of u at h=1/4 over error at h=1/8", 2.5, last / *error);
    last = *error;
  }
  return {};
}

/// The same bar, bent by the load `moment` of its end face instead of the exact stress.
expected<void> bending_moment(case_context& c) {
  const auto shake = shaken_box({4, 1, 1});
  const auto mesh = block_mesh({8, 2, 2}, [&](vec3 p) { return shake(p) - vec3{0, 0.5, 0.5}; });
  if (!mesh)
    return fail(mesh.error());
  constexpr double second_moment = 1.0 / 12;
  auto loads = with_material(bending_e, bending_nu);
  loads.constraints = {{{s_low}, fem::fixed{}}};
  loads.loads = {{{s_high}, fem::moment{{0, 0, -bending_e * curvature * second_moment}}}};
  auto p = fem::make_problem(**mesh, loads, c.order());
  if (!p)
    return fail(p.error());
  prescribe(*p, **mesh, std::array<surface_id, 1>{s_low}, bending_field);
  const auto s = c.solve(*p, 1e-13);
  if (!s)
    return fail(s.error());
  c.at_most("largest error of u / largest u", 1e-9,
            largest_error(*p, s->displacement, bending_field));
  return {};
}

constexpr double bar_e = 70e9;
constexpr double bar_nu = 0.33;
constexpr double bar_density = 2700;
constexpr double bar_g = 9.81;
constexpr double bar_length = 3;

/// A bar that hangs from z = L: sigma_zz = rho g z, all other stresses vanish.
vec3 hanging_field(vec3 p) {
  const double k = bar_density * bar_g / bar_e;
  return k * vec3{-bar_nu * p.x * p.z, -bar_nu * p.y * p.z,
                  0.5 * (p.z * p.z - bar_length * bar_length + bar_nu * (p.x * p.x + p.y * p.y))};
}

/// The weight comes from the load case, so this checks gravity, too.
expected<void> gravity_bar(case_context& c) {
  const auto mesh = block_mesh({2, 2, 5}, shaken_box({1, 1, bar_length}));
  if (!mesh)
    return fail(mesh.error());
  auto loads = with_material(bar_e, bar_nu, bar_density);
  loads.constraints = {{{u_high}, fem::fixed{}}};
  loads.loads = {{{}, fem::gravity{{0, 0, -bar_g}}}};
  auto p = fem::make_problem(**mesh, loads, c.order());
  if (!p)
    return fail(p.error());
  prescribe(*p, **mesh, std::array<surface_id, 1>{u_high}, hanging_field);
  const auto s = c.solve(*p, 1e-13);
  if (!s)
    return fail(s.error());
  c.at_most("largest error of u / largest u", 1e-9,
            largest_error(*p, s->displacement, hanging_field));
  c.within("pull of the support, N", bar_density * bar_g * bar_length, s->reaction_n.z, 1e-9);
  return {};
}

constexpr double twist = 1e-2;

/// A shaft turned without warping: only exact with the tractions that hold the sides.
vec3 shaft_field(vec3 p) {
  return twist * vec3{-p.y * p.z, p.x * p.z, 0};
}

/// Circular shaft's torsion on a bar of any shape: held at one end by the exact field, all other
/// sides loaded by the exact (linear) shear stress.
expected<void> shaft_torsion(case_context& c) {
  const auto mesh = block_mesh({3, 3, 4}, [shake = shaken_box({1, 1, 2})](vec3 p) {
    return shake(p) - vec3{0.4, 0.7, 0};
  });
  if (!mesh)
    return fail(mesh.error());
  auto p = bare_problem(**mesh, with_material(1000, 0.25), c.order());
  if (!p)
    return fail(p.error());
  prescribe(*p, **mesh, std::array<surface_id, 1>{u_low}, shaft_field);
  add_traction(*p, **mesh, std::array<surface_id, 5>{s_low, s_high, t_low, t_high, u_high},
               [](vec3 x) {
                 constexpr double shear_modulus = 400;
                 return std::array<double, 6>{
                   0, 0, 0, 0, shear_modulus * twist * x.x, -shear_modulus * twist * x.y};
               });
  const auto s = c.solve(*p, 1e-13);
  if (!s)
    return fail(s.error());
  c.at_most("largest error of u / largest u", 1e-9,
            largest_error(*p, s->displacement, shaft_field));
  return {};
}

}  // namespace

expected<fem::problem> bare_problem(const mesh_version& mesh, const fem::load_case& material,
                                    int order) {
  auto loads = material;
  loads.constraints = {{{mesh.surfaces().front().id}, fem::fixed{}}};
  loads.loads = {{{mesh.surfaces().back().id}, fem::traction{{1, 0, 0}}}};
  auto p = fem::make_problem(mesh, loads, order);
  if (p)
    clear_conditions(*p);
  return p;
}

std::vector<case_entry> exact_cases() {
  const std::string macneal = "MacNeal & Harder 1985";
  const std::string timoshenko = "Timoshenko & Goodier";
  return {{"displacement patch test",
           macneal,
           "a constant strain prescribed on the boundary comes out exactly inside.",
           {1, 2},
           displacement_patch},
          {"traction patch test",
           macneal,
           "the same strain from tractions alone, with six degrees of freedom held.",
           {1, 2},
           traction_patch},
          {"pure bending",
           timoshenko,
           "a quadratic field: exact with quadratic tets, slow with linear ones.",
           {1, 2},
           pure_bending},
          {"bar bent by a moment",
           timoshenko,
           "the same field from the load `moment`: Navier's stress on the end face.",
           {2},
           bending_moment},
          {"bar under its own weight",
           timoshenko,
           "a quadratic field under gravity: exact with quadratic tets.",
           {2},
           gravity_bar},
          {"torsion of a circular shaft",
           timoshenko,
           "a quadratic field under shear tractions: exact with quadratic tets.",
           {2},
           shaft_torsion}};
}

}  // namespace tedit::verification
