// SPDX-License-Identifier: AGPL-3.0-or-later
// Input that has no answer must be refused by name, never answered with numbers.
#include <limits>

#include "mesh/build_version.hpp"
#include "verification/cases.hpp"
#include "verification/meshes.hpp"

namespace tedit::verification {

namespace {

/// A clamped, pulled cube: every case breaks one thing of it.
fem::load_case sound_loads() {
  auto loads = with_material(210e9, 0.3, 7850);
  loads.constraints = {{{s_low}, fem::fixed{}}};
  loads.loads = {{{s_high}, fem::force{{1, 0, 0}}}};
  return loads;
}

std::string with_number(const char* text, double value) {
  char buffer[48];
  std::snprintf(buffer, sizeof(buffer), "%s%g", text, value);
  return buffer;
}

class refusals {
public:
  refusals(case_context& c, const mesh_version& cube) : c_(c), cube_(cube) {}

  void loads(const std::string& what, ec code, const std::function<void(fem::load_case&)>& spoil) {
    auto loads = sound_loads();
    spoil(loads);
    c_.refusal(what, code, fem::make_problem(cube_, loads, c_.order()));
  }

  void mesh(const std::string& what, ec code, const mesh_version& mesh) {
    c_.refusal(what, code, fem::make_problem(mesh, sound_loads(), c_.order()));
  }

private:
  case_context& c_;
  const mesh_version& cube_;
};

void refuse_supports(refusals& r) {
  r.loads("no support", ec::under_constrained, [](auto& l) { l.constraints.clear(); });
  r.loads("a support that only holds one direction", ec::under_constrained, [](auto& l) {
    l.constraints = {{{s_low}, fem::roller{}}};
  });
  r.loads("supports that leave a sliding direction", ec::under_constrained, [](auto& l) {
    l.constraints = {{{t_low}, fem::roller{}}, {{u_low}, fem::roller{}}};
  });
  r.loads("supports that contradict each other", ec::invalid_argument, [](auto& l) {
    l.constraints.push_back({{s_low}, fem::prescribed_displacement{1e-3, {}, {}}});
  });
  r.loads("a support on a surface that is not there", ec::surface_not_found,
          [](auto& l) { l.constraints[0].surfaces = {99}; });
}

void refuse_materials(refusals& r) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double e : {0.0, -1.0, nan})
    r.loads(with_number("E = ", e), ec::invalid_material,
            [e](auto& l) { l.materials[0].young_modulus_pa = e; });
  for (const double nu : {0.5, 0.6, -1.0, nan})
    r.loads(with_number("nu = ", nu), ec::invalid_material,
            [nu](auto& l) { l.materials[0].poisson_ratio = nu; });
  r.loads("no material", ec::invalid_material, [](auto& l) { l.materials.clear(); });
}

void refuse_loads(refusals& r) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  r.loads("a force that is no number", ec::invalid_load, [nan](auto& l) {
    l.loads[0].kind = fem::force{{nan, 0, 0}};
  });
  r.loads("an infinite pressure", ec::invalid_load,
          [infinite](auto& l) { l.loads[0].kind = fem::pressure{infinite}; });
  r.loads("a moment that is no number", ec::invalid_load, [nan](auto& l) {
    l.loads[0].kind = fem::moment{{0, nan, 0}};
  });
  r.loads("a pin that pulls", ec::invalid_load, [](auto& l) {
    l.loads[0] = {{s_high}, fem::bearing_force{{1, 0, 0}}};
  });
  r.loads("no load", ec::invalid_load, [](auto& l) { l.loads.clear(); });
  r.loads("gravity without a density", ec::invalid_load, [](auto& l) {
    l.materials[0].density_kg_m3 = 0;
    l.loads = {{{}, fem::gravity{{0, 0, -9.81}}}};
  });
}

/// The unit cube of 2^3 cells with its middle point somewhere else; tets stay as they are listed.
raw_mesh cube_with_middle_at(vec3 middle) {
  raw_mesh raw;
  const auto sound = block_mesh({2, 2, 2}, box({1, 1, 1}));
  const auto& mesh = **sound;
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v) {
    const vec3 x = mesh.position(v);
    raw.positions.push_back(norm(x - vec3{0.5, 0.5, 0.5}) < 1e-12 ? middle : x);
  }
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    raw.tets.push_back(mesh.tet_at(t));
    raw.tet_regions.push_back(1);
  }
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    raw.triangles.push_back({mesh.facet(f).v, mesh.facet(f).surface, true});
  return raw;
}

/// Two cubes side by side with a gap; the second one shares no surface with the first's support.
raw_mesh two_cubes() {
  auto raw = cube_with_middle_at({0.5, 0.5, 0.5});
  const auto first = raw;
  const auto shift = static_cast<vertex_id>(first.positions.size());
  for (const auto& x : first.positions)
    raw.positions.push_back(x + vec3{3, 0, 0});
  for (auto t : first.tets) {
    for (auto& v : t.v)
      v += shift;
    raw.tets.push_back(t);
    raw.tet_regions.push_back(1);
  }
  for (auto t : first.triangles) {
    for (auto& v : t.v)
      v += shift;
    t.surface += 10;
    raw.triangles.push_back(t);
  }
  return raw;
}

expected<void> refuse_meshes(refusals& r) {
  const auto inverted = build_version(cube_with_middle_at({1.3, 0.5, 0.5}), 1);
  const auto flat = build_version(cube_with_middle_at({1, 0.5, 0.5}), 1);
  const auto apart = build_version(two_cubes(), 1);
  for (const auto* built : {&inverted, &flat, &apart})
    if (!*built)
      return fail(built->error());
  r.mesh("inverted tets", ec::inverted_tet, *inverted->version);
  r.mesh("tets without volume", ec::degenerate_tet, *flat->version);
  r.mesh("a separate body without support", ec::under_constrained, *apart->version);
  return {};
}

expected<void> refuse_nonsense(case_context& c) {
  const auto cube = block_mesh({2, 2, 2}, box({1, 1, 1}));
  if (!cube)
    return fail(cube.error());
  // What is refused below must not be refused for another reason.
  const auto sound = c.solve(**cube, sound_loads());
  if (!sound)
    return fail(sound.error());
  refusals r(c, **cube);
  refuse_supports(r);
  refuse_materials(r);
  refuse_loads(r);
  return refuse_meshes(r);
}

}  // namespace

std::vector<case_entry> refusal_cases() {
  return {{"refusals",
           "mechanics",
           "input without an answer is refused by name.",
           {1, 2},
           refuse_nonsense}};
}

}  // namespace tedit::verification
