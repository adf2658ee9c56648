// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>

#include "base/number_range.hpp"
#include "fem/polled.hpp"
#include "fem/problem_parts.hpp"
#include "fem/surface_loads.hpp"
#include "mesh/quality.hpp"

namespace tedit::fem {

namespace {

/// Each component by itself, with its letter.
expected<void> check_vector(vec3 value, const char* unit, const std::string& of) {
  const std::array<std::pair<const char*, double>, 3> components{
    {{"x", value.x}, {"y", value.y}, {"z", value.z}}};
  for (const auto& [letter, component] : components)
    if (auto ok = check_number(component, any_number(unit), of + ": " + letter, ec::invalid_load);
        !ok)
      return ok;
  return {};
}

/// One load after the other, added to the loads of a problem as the nodal forces that do the same
/// work (consistent ones).
class load_adder {
public:
  load_adder(const surface_triangles& triangles, problem& p) : triangles_(triangles), p_(p) {}

  expected<void> add(const load& item, std::string name) {
    name_ = std::move(name);
    if (const auto* g = std::get_if<gravity>(&item.kind))
      return act(*g);
    const loaded_patch patch(triangles_, p_, item.surfaces);
    if (!(patch.area() > 0))
      return fail(ec::invalid_load, name_ + " acts on no surface", "Name at least one surface");
    patch_ = &patch;
    return std::visit([this](const auto& kind) { return act(kind); }, item.kind);
  }

private:
  using triangle = surface_triangles::triangle;

  expected<void> act(const force& f) {
    if (auto ok = check_vector(f.total_n, "N", name_); !ok)
      return ok;
    name_ += " on its area";
    return act(traction{f.total_n / patch_->area()});
  }

  expected<void> act(const traction& t) {
    if (auto ok = check_vector(t.pa, "Pa", name_); !ok)
      return ok;
    patch_->for_each([&](const triangle& on, vec3 area) { add_even(on, norm(area) * t.pa); });
    return {};
  }

  expected<void> act(const normal_force& f) {
    if (auto ok = check_number(f.total_n, any_number("N"), name_, ec::invalid_load); !ok)
      return ok;
    name_ += " on its area";
    return act(pressure{f.total_n / patch_->area()});
  }

  expected<void> act(const pressure& p) {
    if (auto ok = check_number(p.pa, any_number("Pa"), name_, ec::invalid_load); !ok)
      return ok;
    if (auto ok = check_vector(p.gradient_pa_m, "Pa/m", name_ + ": gradient_pa_m"); !ok)
      return ok;
    if (auto ok = check_vector(p.at_m, "m", name_ + ": at_m"); !ok)
      return ok;
    if (auto ok = has_outside("a traction or a force"); !ok)
      return ok;
    if (p.gradient_pa_m == vec3{}) {
      patch_->for_each([&](const triangle& on, vec3 area) { add_even(on, -p.pa * area); });
      return {};
    }
    patch_->for_each([&](const triangle& on, vec3 area) {
      corner_tractions pa;
      const auto corners = patch_->corners(on);
      for (int i = 0; i < 3; ++i)
        pa[i] = -(p.pa + dot(p.gradient_pa_m, corners[i] - p.at_m)) * normalized(area);
      add_linear(on, norm(area), pa);
    });
    return check_sums();
  }

  expected<void> act(const moment& m) {
    if (auto ok = check_vector(m.total_nm, "N m", name_); !ok)
      return ok;
    return add_spread({}, m.total_nm, {});
  }

  expected<void> act(const remote_force& f) {
    auto ok = check_vector(f.total_n, "N", name_);
    if (ok)
      ok = check_vector(f.at_m, "m", name_ + ": at_m");
    if (ok)
      ok = check_vector(f.moment_nm, "N m", name_ + ": moment_nm");
    return ok ? add_spread(f.total_n, f.moment_nm, f.at_m) : ok;
  }

  expected<void> act(const bearing_force& f) {
    if (auto ok = check_vector(f.total_n, "N", name_); !ok)
      return ok;
    if (auto ok = has_outside("a force"); !ok)
      return ok;
    if (f.total_n == vec3{})
      return {};
    const auto pin = press_like_a_pin(*patch_, f.total_n, name_);
    if (!pin)
      return fail(pin.error());
    patch_->for_each(
      [&](const triangle& on, vec3 area) { add_even(on, norm(area) * pin->on(area)); });
    return check_sums();
  }

  expected<void> act(const gravity& g) {
    if (auto ok = check_vector(g.m_s2, "m/s2", name_); !ok)
      return ok;
    bool known = true;
    polled_for(p_.element_count(), [&](std::size_t e) {
      const double density = p_.densities[p_.element_materials[e]];
      known = known && density > 0;
      const auto* n = &p_.element_nodes[static_cast<std::size_t>(p_.nodes_per_element) * e];
      const double mass =
        density * signed_volume(p_.nodes[n[0]], p_.nodes[n[1]], p_.nodes[n[2]], p_.nodes[n[3]]);
      // Integrals of the shape functions over the volume: 1/4; -1/20 at corners, 1/5 at middles.
      const double at_corner = p_.element_order == 2 ? -1.0 / 20 : 1.0 / 4;
      for (int a = 0; a < p_.nodes_per_element; ++a)
        add_to(n[a], ((a < 4 ? at_corner : 1.0 / 5) * mass) * g.m_s2);
    });
    if (!known)
      return fail(ec::invalid_load, name_ + " (gravity) needs the density of every material",
                  "Give density_kg_m3");
    return {};
  }

  /// A force at a place and a moment, as the traction of a rigid face.
  expected<void> add_spread(vec3 force_n, vec3 moment_nm, vec3 at_m) {
    const auto traction = spread_evenly(*patch_, force_n, moment_nm, at_m, name_);
    if (!traction)
      return fail(traction.error());
    patch_->for_each([&](const triangle& on, vec3 area) {
      corner_tractions pa;
      const auto corners = patch_->corners(on);
      for (int i = 0; i < 3; ++i)
        pa[i] = (*traction)(corners[i]);
      add_linear(on, norm(area), pa);
    });
    return check_sums();
  }

  expected<void> has_outside(const char* instead) const {
    const auto surface = patch_->interface_surface();
    if (!surface)
      return {};
    return fail(ec::invalid_load,
                name_ + " presses on surface " + std::to_string(*surface) +
                  ", which lies between two regions and has no outer side",
                std::string("Use ") + instead + " there");
  }

  /// An even load of this size in all.
  void add_even(const triangle& on, vec3 force_n) {
    for (const auto node : on.loaded())
      add_to(node, force_n / 3);
  }

  /// Integrals of the shape functions with a linear traction. By barycentric coordinates L: of
  /// L_i L_j area/12 and of L_i^2 area/6; the quadratic functions are L_i (2 L_i - 1) and 4 L_i
  /// L_j.
  void add_linear(const triangle& on, double area, const corner_tractions& pa) {
    const vec3 sum = pa[0] + pa[1] + pa[2];
    for (int i = 0; i < 3; ++i) {
      if (on.count == 3) {
        add_to(on.nodes[i], (area / 12) * (pa[i] + sum));
        continue;
      }
      add_to(on.nodes[i], (area / 60) * (3 * pa[i] - sum));
      add_to(on.nodes[3 + i], (area / 15) * (pa[i] + pa[(i + 1) % 3] + sum));
    }
  }

  void add_to(std::uint32_t node, vec3 force_n) {
    p_.loads[3 * node] += force_n.x;
    p_.loads[3 * node + 1] += force_n.y;
    p_.loads[3 * node + 2] += force_n.z;
  }

  /// What small areas make of large numbers.
  [[nodiscard]] expected<void> check_sums() const {
    expected<void> ok;
    const auto of = name_ + " on its area";
    const auto range = any_number("N");
    patch_->for_each([&](const triangle& on, vec3) {
      for (const auto node : on.all())
        for (int i = 0; i < 3 && ok; ++i)
          ok = check_number(p_.loads[3 * node + i], range, of, ec::invalid_load);
    });
    return ok;
  }

  const surface_triangles& triangles_;
  problem& p_;
  std::string name_;
  const loaded_patch* patch_ = nullptr;
};

}  // namespace

expected<void> add_loads(const surface_triangles& triangles, const load_case& loads, problem& p) {
  polled_assign(p.loads, p.dofs(), 0.0);
  load_adder adder(triangles, p);
  for (std::size_t i = 0; i < loads.loads.size(); ++i)
    if (auto ok = adder.add(loads.loads[i], "load " + std::to_string(i)); !ok)
      return ok;
  const auto zero = [](double value) { return value == 0; };
  if (std::ranges::all_of(p.loads, zero) && std::ranges::all_of(p.prescribed, zero))
    return fail(ec::invalid_load,
                "nothing acts on the part: no load and no prescribed displacement",
                "Add a load to the load case");
  return {};
}

}  // namespace tedit::fem
