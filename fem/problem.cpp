// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/problem.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fem/problem_parts.hpp"
#include "mesh/quality.hpp"

namespace tedit::fem {

namespace {

std::uint64_t spread_bits(std::uint64_t x) {
  // 21 bits to every third place.
  x &= 0x1FFFFF;
  x = (x | x << 32) & 0x1F00000000FFFF;
  x = (x | x << 16) & 0x1F0000FF0000FF;
  x = (x | x << 8) & 0x100F00F00F00F00F;
  x = (x | x << 4) & 0x10C30C30C30C30C3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Nodes along a Morton curve, so that neighbours in space are neighbours in memory.
void number_nodes(const mesh_version& mesh, problem& p, std::vector<std::uint32_t>& node_of) {
  vec3 low{1e300, 1e300, 1e300};
  vec3 high = -low;
  for (vertex_id v = 0; v < mesh.vertex_slots(); ++v) {
    if (!mesh.is_live_vertex(v))
      continue;
    const auto& x = mesh.position(v);
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
    p.node_vertices.push_back(v);
  }
  const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-300});
  std::vector<std::uint64_t> code(mesh.vertex_slots());
  for (const auto v : p.node_vertices) {
    const vec3 x = (mesh.position(v) - low) * (2097151.0 / size);
    code[v] = spread_bits(static_cast<std::uint64_t>(x.x)) |
              spread_bits(static_cast<std::uint64_t>(x.y)) << 1 |
              spread_bits(static_cast<std::uint64_t>(x.z)) << 2;
  }
  std::ranges::sort(p.node_vertices, [&](vertex_id a, vertex_id b) {
    return code[a] != code[b] ? code[a] < code[b] : a < b;
  });
  node_of.assign(mesh.vertex_slots(), no_id);
  for (std::uint32_t n = 0; n < p.node_vertices.size(); ++n) {
    node_of[p.node_vertices[n]] = n;
    p.nodes.push_back(mesh.position(p.node_vertices[n]));
  }
}

/// A tet whose volume is lost in the rounding of its coordinates cannot carry a stiffness.
bool is_flat(const std::array<vec3, 4>& c) {
  double longest = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      longest = std::max(longest, norm(c[i] - c[j]));
  return std::abs(signed_volume(c)) <= 1e-10 * longest * longest * longest;
}

std::string list_of(const std::vector<tet_id>& tets) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(tets.size(), 8); ++i)
    text += (i ? ", " : "") + std::to_string(tets[i]);
  return tets.size() > 8 ? text + ", ..." : text;
}

expected<void> add_elements(const mesh_version& mesh, const std::vector<std::uint32_t>& node_of,
                            problem& p) {
  std::vector<tet_id> flat;
  std::vector<tet_id> inverted;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t) {
    if (!mesh.is_live_tet(t))
      continue;
    const auto corners = mesh.corners(t);
    if (is_flat(corners))
      flat.push_back(t);
    else if (signed_volume(corners) < 0)
      inverted.push_back(t);
    p.element_tets.push_back(t);
    for (const auto v : mesh.tet_at(t).v)
      p.element_nodes.push_back(node_of[v]);
  }
  const auto refuse = [&](ec code, const std::vector<tet_id>& tets, const char* what) {
    const auto c = mesh.corners(tets.front());
    const vec3 at = 0.25 * (c[0] + c[1] + c[2] + c[3]);
    return fail(code, std::to_string(tets.size()) + " tets " + what + ": tet " + list_of(tets),
                "Repair or remesh the part there", "first at " + point_text(at));
  };
  if (!inverted.empty())
    return refuse(ec::inverted_tet, inverted, "are inverted (negative volume)");
  if (!flat.empty())
    return refuse(ec::degenerate_tet, flat, "have no volume (flat within rounding)");
  return {};
}

}  // namespace

std::string point_text(vec3 p) {
  char text[96];
  std::snprintf(text, sizeof(text), "(%.4g, %.4g, %.4g) mm", 1e3 * p.x, 1e3 * p.y, 1e3 * p.z);
  return text;
}

expected<problem> make_problem(const mesh_version& mesh, const load_case& loads) {
  problem p;
  std::vector<std::uint32_t> node_of;
  number_nodes(mesh, p, node_of);
  if (auto ok = assign_materials(mesh, loads, p); !ok)
    return fail(ok.error());
  if (auto ok = add_elements(mesh, node_of, p); !ok)
    return fail(ok.error());
  const surface_triangles triangles(mesh, node_of);
  if (auto ok = triangles.check_ids(mesh, loads); !ok)
    return fail(ok.error());
  if (auto ok = add_constraints(triangles, loads, p); !ok)
    return fail(ok.error());
  if (auto ok = add_loads(triangles, loads, p); !ok)
    return fail(ok.error());
  if (auto ok = check_supports(mesh, p); !ok)
    return fail(ok.error());
  return p;
}

}  // namespace tedit::fem
