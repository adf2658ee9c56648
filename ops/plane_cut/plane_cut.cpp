// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/plane_cut/plane_cut.hpp"

#include <algorithm>
#include <unordered_map>

#include "mesh/checks.hpp"

namespace tedit::ops {

namespace {

struct plane {
  vec3 at;
  vec3 normal;
};

struct half {
  tool_surface tool;
  boolean_result made;
};

/// The part without what lies above the plane. `name`: of the cut.
expected<half> without_above(const version_ptr& mesh, const plane& p, const std::string& name,
                             services& host, const execution& run) {
  const auto extent = extent_of(*mesh);
  const double size = local_size(*mesh, extent);
  auto tool = half_space(extent, p.at, -p.normal, size, name, host);
  if (!tool)
    return fail(tool.error());
  auto made = host.boolean(mesh, *tool, {boolean_mode::cut, deviation_share * size}, run);
  if (!made && made.error().code == ec::empty_selection)
    return fail(ec::empty_selection, "the plane leaves the part as it is, or nothing of it",
                "Move the plane into the part, or keep its other side");
  if (!made)
    return fail(made.error());
  return half{std::move(*tool), std::move(*made)};
}

/// Puts a version beside what a builder has: tets, surfaces and interfaces, with vertices of its
/// own.
class joiner {
public:
  joiner(mesh_builder& builder, const mesh_version& other, const mesh_version& whole)
      : builder_(builder), other_(other), whole_(whole) {}

  expected<void> join() {
    cavity_change change;
    for (tet_id t = 0; t < other_.tet_slots(); ++t)
      if (other_.is_live_tet(t)) {
        new_tet added{other_.tet_at(t), other_.region_of(t)};
        for (auto& v : added.corners.v)
          v = vertex(v);
        change.added.push_back(added);
      }
    for (facet_id f = 0; f < other_.facet_slots(); ++f)
      if (other_.is_live_facet(f))
        change.facets.push_back({vertices_of(other_.facet(f).v), surface(other_.facet(f).surface)});
    if (auto ok = builder_.apply(change); !ok)
      return fail(ok.error());
    add_interfaces();
    return {};
  }

private:
  vertex_id vertex(vertex_id of_other) {
    const auto [found, is_new] = vertices_.emplace(of_other, no_id);
    if (is_new)
      found->second = builder_.add_vertex(other_.position(of_other));
    return found->second;
  }

  std::array<vertex_id, 3> vertices_of(std::array<vertex_id, 3> v) {
    for (auto& one : v)
      one = vertex(one);
    return v;
  }

  /// The part's surfaces keep their ids on both sides; the cut has one of its own on each.
  surface_id surface(surface_id of_other) {
    const auto [found, is_new] = surfaces_.emplace(of_other, of_other);
    if (is_new) {
      const auto* row = other_.find_surface(of_other);
      if (whole_.find_surface(of_other))
        builder_.restore_surface(of_other, row->name, row->geometry);
      else
        found->second = builder_.add_surface(row->name, row->geometry);
    }
    return found->second;
  }

  void add_interfaces() {
    std::vector<interface_facet> all;
    for (std::size_t i = 0; i < builder_.interfaces().size(); ++i)
      all.push_back(builder_.interfaces()[i]);
    for (std::size_t i = 0; i < other_.data().interfaces.size(); ++i) {
      auto one = other_.data().interfaces[i];
      one.v = vertices_of(one.v);
      one.surface = surface(one.surface);
      all.push_back(one);
    }
    builder_.set_interfaces(all);
  }

  mesh_builder& builder_;
  const mesh_version& other_;
  const mesh_version& whole_;  ///< Whose surfaces keep their ids.
  std::unordered_map<vertex_id, vertex_id> vertices_;
  std::unordered_map<surface_id, surface_id> surfaces_;
};

expected<edit_result> in_two(const version_ptr& mesh, const plane& p,
                             const std::vector<surface_id>& picked, context& ctx) {
  const auto below = without_above(mesh, p, "cut below", *ctx.host, ctx.run.part(0, 0.45));
  if (!below)
    return fail(below.error());
  const auto above =
    without_above(mesh, {p.at, -p.normal}, "cut above", *ctx.host, ctx.run.part(0.45, 0.9));
  if (!above)
    return fail(above.error());
  mesh_builder builder(below->made.candidate);
  if (auto ok = joiner(builder, *above->made.candidate, *mesh).join(); !ok)
    return fail(ok.error());
  edit_result result;
  result.candidate = builder.freeze();
  result.touched = changed_tets(*mesh, *result.candidate);
  result.volume_change =
    below->made.volume_change + above->made.volume_change + total_volume(*mesh);
  result.improve = improvement::none;  // The booleans have done it.
  result.quality_floor = lowest_boolean_quality;
  result.surfaces_used = picked;
  const auto bodies = boundary_components(*result.candidate);
  result.bodies_added = bodies - boundary_components(*mesh);
  result.notices.push_back("the part is " + std::to_string(bodies) +
                           " bodies now; each needs supports of its own");
  result.figures.push_back({"deviation_mm",
                            1e3 * std::max(below->made.deviation, above->made.deviation), "mm",
                            "furthest off what was asked for"});
  return result;
}

}  // namespace

expected<edit_result> plane_cut(const version_ptr& mesh, vec3 at, vec3 normal, kept_side keep,
                                const std::vector<surface_id>& picked, context& ctx) {
  if (keep == kept_side::both)
    return in_two(mesh, {at, normal}, picked, ctx);
  const vec3 up = keep == kept_side::below ? normal : -normal;
  const auto cut = without_above(mesh, {at, up}, "cut", *ctx.host, ctx.run);
  if (!cut)
    return fail(cut.error());
  return as_edit(*mesh, cut->made, cut->tool, picked);
}

}  // namespace tedit::ops
