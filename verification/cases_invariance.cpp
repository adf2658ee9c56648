// SPDX-License-Identifier: AGPL-3.0-or-later
// What must not change a result: where a real part stands, how it is turned, the unit of its file,
// and the order in which its nodes and tets are listed.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "mesh/build_version.hpp"
#include "verification/cases.hpp"

namespace tedit::verification {

namespace {

/// The rows of an orthogonal matrix.
using rotation = std::array<vec3, 3>;

constexpr rotation no_rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

vec3 turned(const rotation& r, vec3 v) {
  return {dot(r[0], v), dot(r[1], v), dot(r[2], v)};
}

/// Rodrigues: about a unit axis by an angle in rad.
rotation rotation_about(vec3 axis, double angle) {
  rotation result;
  const std::array<vec3, 3> units = no_rotation;
  for (int i = 0; i < 3; ++i) {
    // Row i of R is R^T e_i: the unit vector turned back.
    const vec3 e = units[i];
    result[i] = std::cos(angle) * e - std::sin(angle) * cross(axis, e) +
                ((1 - std::cos(angle)) * dot(axis, e)) * axis;
  }
  return result;
}

/// The live part of a version as a file would give it.
raw_mesh to_raw(const mesh_version& mesh) {
  raw_mesh raw;
  std::vector<vertex_id> index(mesh.vertex_slots(), no_id);
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.is_live_vertex(v)) {
      index[v] = static_cast<vertex_id>(raw.positions.size());
      raw.positions.push_back(mesh.position(v));
    }
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t)) {
      tet moved = mesh.tet_at(t);
      for (auto& v : moved.v)
        v = index[v];
      raw.tets.push_back(moved);
      raw.tet_regions.push_back(mesh.region_of(t));
    }
  const auto add = [&](const std::array<vertex_id, 3>& v, surface_id id) {
    raw.triangles.push_back({{index[v[0]], index[v[1]], index[v[2]]}, id, true});
  };
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      add(mesh.facet(f).v, mesh.facet(f).surface);
  for (std::size_t i = 0; i < mesh.data().interfaces.size(); ++i)
    add(mesh.data().interfaces[i].v, mesh.data().interfaces[i].surface);
  return raw;
}

/// A permutation that is the same on every machine (the standard leaves std::shuffle open).
std::vector<std::uint32_t> permutation(std::size_t count, std::uint32_t seed) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937 random(seed);
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[random() % i]);
  return order;
}

raw_mesh renumbered(const raw_mesh& raw) {
  auto result = raw;
  const auto to = permutation(raw.positions.size(), 1);
  for (std::size_t v = 0; v < to.size(); ++v)
    result.positions[to[v]] = raw.positions[v];
  for (auto& t : result.tets)
    for (auto& v : t.v)
      v = to[v];
  for (auto& t : result.triangles)
    for (auto& v : t.v)
      v = to[v];
  return result;
}

raw_mesh reordered(const raw_mesh& raw) {
  auto result = raw;
  const auto from = permutation(raw.tets.size(), 2);
  for (std::size_t i = 0; i < from.size(); ++i) {
    result.tets[i] = raw.tets[from[i]];
    result.tet_regions[i] = raw.tet_regions[from[i]];
    // Another first corner, too: an even permutation keeps the volume positive.
    auto& v = result.tets[i].v;
    std::rotate(v.begin(), v.begin() + 1, v.begin() + 3);
  }
  return result;
}

/// Loads turned with the part. Errors: `unsupported_format` for supports along axes, which do not
/// turn.
expected<fem::load_case> turned(const fem::load_case& loads, const rotation& r) {
  auto result = loads;
  for (const auto& item : loads.constraints)
    if (std::holds_alternative<fem::prescribed_displacement>(item.kind))
      return fail(ec::unsupported_format, "a prescribed displacement cannot be turned",
                  "Verify on a part with clamps and rollers");
  for (auto& item : result.loads) {
    if (auto* f = std::get_if<fem::force>(&item.kind))
      f->total_n = turned(r, f->total_n);
    else if (auto* t = std::get_if<fem::traction>(&item.kind))
      t->pa = turned(r, t->pa);
    else if (auto* g = std::get_if<fem::gravity>(&item.kind))
      g->m_s2 = turned(r, g->m_s2);
    else if (auto* p = std::get_if<fem::pressure>(&item.kind))
      *p = {p->pa, turned(r, p->gradient_pa_m), turned(r, p->at_m)};
    else if (auto* m = std::get_if<fem::moment>(&item.kind))
      m->total_nm = turned(r, m->total_nm);
    else if (auto* far = std::get_if<fem::remote_force>(&item.kind))
      *far = {turned(r, far->total_n), turned(r, far->at_m), turned(r, far->moment_nm)};
    else if (auto* pin = std::get_if<fem::bearing_force>(&item.kind))
      pin->total_n = turned(r, pin->total_n);
  }
  return result;
}

/// Twice the work of the loads, J.
expected<double> compliance(case_context& c, raw_mesh raw, const fem::load_case& loads,
                            double metres_per_unit = 1) {
  const auto mesh = build_version(std::move(raw), metres_per_unit);
  if (!mesh)
    return fail(mesh.error());
  const auto s = c.solve(*mesh->version, loads);
  if (!s)
    return fail(s.error());
  return s->solution.compliance_j;
}

/// Sum of reactions, and work against energy.
expected<double> check_balance(case_context& c) {
  const auto s = c.solve(*c.part().mesh, c.part().loads, 1e-10);
  if (!s)
    return fail(s.error());
  const auto& out = s->solution;
  c.at_most("|reactions + loads| / |loads|", 1e-8,
            norm(out.reaction_n + out.applied_n) / norm(out.applied_n));
  c.within("strain energy, J, against half the work of the loads", 0.5 * out.compliance_j,
           out.strain_energy_j, 1e-8);
  return out.compliance_j;
}

/// Only for loads that are forces: then a part of s times the size has 1/s of the compliance.
bool only_forces(const fem::load_case& loads) {
  return std::ranges::all_of(loads.loads, [](const fem::load& item) {
    return std::holds_alternative<fem::force>(item.kind);
  });
}

expected<void> invariance(case_context& c) {
  const auto reference = check_balance(c);
  if (!reference)
    return fail(reference.error());
  const auto& loads = c.part().loads;
  const auto raw = to_raw(*c.part().mesh);
  const auto compare = [&](const char* what, const expected<double>& value) -> expected<void> {
    if (!value)
      return fail(value.error());
    c.within(std::string("compliance, J, ") + what, *reference, *value, 1e-6);
    return {};
  };
  auto moved = raw;
  for (auto& x : moved.positions)
    x += vec3{1e4, -1e4, 1e4};
  if (auto ok = compare("moved by 1e7 mm", compliance(c, std::move(moved), loads)); !ok)
    return ok;
  const auto r = rotation_about(normalized({1, 2, -3}), 1.1);
  const auto turned_loads = turned(loads, r);
  if (!turned_loads)
    return fail(turned_loads.error());
  auto rotated = raw;
  for (auto& x : rotated.positions)
    x = turned(r, x);
  if (auto ok = compare("turned by 63 degrees", compliance(c, std::move(rotated), *turned_loads));
      !ok)
    return ok;
  if (auto ok = compare("nodes renumbered", compliance(c, renumbered(raw), loads)); !ok)
    return ok;
  if (auto ok = compare("tets reordered", compliance(c, reordered(raw), loads)); !ok)
    return ok;
  if (!only_forces(loads))
    return {};
  auto scaled = compliance(c, raw, loads, 1e-3);
  if (scaled)
    *scaled *= 1e-3;
  return compare("read in mm, times 1e-3", scaled);
}

}  // namespace

std::vector<case_entry> invariance_cases() {
  return {
    {"balance and invariance of a real part",
     "mechanics",
     "reactions balance loads, energy is half the work, and neither place, turn, unit nor "
     "numbering changes the compliance (`examples/ctc01_plate` unless `--part` says otherwise).",
     {1, 2},
     invariance,
     true}};
}

}  // namespace tedit::verification
