// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/fill_hole/fill_hole.hpp"

#include <algorithm>
#include <optional>

#include "ops/fill_hole/caps.hpp"
#include "ops/fill_hole/gates.hpp"

namespace tedit::ops {

namespace {

struct meshed_plug {
  plug_surface plug;
  tet_filling filling;
};

/// Caps, gates and mesher, with denser caps when the mesher does not succeed.
expected<meshed_plug> mesh_plug(const mesh_version& mesh, const shell& part, context& ctx) {
  std::optional<error> last;
  for (const double factor : {1.0, 0.7}) {
    if (ctx.run.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    auto plug = close_shell(mesh, part, factor, *ctx.host);
    if (!plug)
      return fail(plug.error());
    if (auto ok = check_plug(mesh, *plug); !ok)
      return fail(ok.error());
    auto filling = ctx.host->tetrahedralise(plug->surface, ctx.run);
    if (filling)
      return meshed_plug{std::move(*plug), std::move(*filling)};
    last = filling.error();
    if (last->code != ec::mesher_failed)
      break;
  }
  if (last->remedy.empty())
    last->remedy = "The version is unchanged; select fewer or other surfaces";
  return fail(*last);
}

/// The surface that a cap continues: the one around it everywhere, when that lies in the cap's
/// plane.
std::optional<surface_id> continued_surface(const mesh_version& mesh, const shell& part,
                                            const cap& c) {
  std::optional<surface_id> result;
  for (const auto i : c.rims) {
    for (const auto f : part.rims[i].outer) {
      const auto& facet = mesh.facet(f);
      const vec3 n = normalized(area_vector(mesh, facet));
      if (dot(n, c.normal) < 1 - 1e-6 || (result && *result != facet.surface))
        return std::nullopt;
      result = facet.surface;
    }
  }
  return result;
}

class plug_merger {
public:
  plug_merger(const mesh_version& mesh, mesh_builder& builder) : mesh_(mesh), builder_(builder) {}

  expected<std::vector<tet_id>> merge(const shell& part, const meshed_plug& plug) {
    auto vertices = plug.plug.vertices;
    vertices.resize(plug.filling.points.size(), no_id);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (vertices[i] == no_id)
        vertices[i] = builder_.add_vertex(plug.filling.points[i]);
    cavity_change change;
    const auto region = mesh_.region_of(mesh_.facet(part.facets.front()).tet);
    for (const auto& t : plug.filling.tets)
      change.added.push_back(
        {{{vertices[t[0]], vertices[t[1]], vertices[t[2]], vertices[t[3]]}}, region});
    change.glued = part.facets;
    for (const auto& c : plug.plug.caps) {
      const auto continued = continued_surface(mesh_, part, c);
      const auto surface = continued ? *continued : builder_.add_surface("cap");
      for (const auto& t : c.triangles)
        change.facets.push_back({{vertices[t[0]], vertices[t[1]], vertices[t[2]]}, surface});
    }
    return builder_.apply(change);
  }

private:
  const mesh_version& mesh_;
  mesh_builder& builder_;
};

std::string list_of(const std::vector<surface_id>& ids) {
  std::string text;
  for (const auto id : ids)
    text += (text.empty() ? "" : ", ") + std::to_string(id);
  return text;
}

}  // namespace

expected<edit_result> fill_holes(const mesh_version& mesh, const std::vector<surface_id>& surfaces,
                                 const completion_settings& settings, context& ctx) {
  ctx.run.report(0.05, "finding rims");
  const boundary_edges edges(mesh);
  auto selected = complete_selection(mesh, edges, surfaces, settings);
  if (!selected)
    return fail(selected.error());
  // The version outlives the call; the builder only needs a handle without ownership.
  mesh_builder builder(version_ptr(version_ptr{}, &mesh));
  plug_merger merger(mesh, builder);
  edit_result result;
  double done = 0;
  for (const auto& part : selected->shells) {
    ctx.run.report(0.1 + 0.8 * done / static_cast<double>(selected->shells.size()),
                   "meshing the plug");
    const auto plug = mesh_plug(mesh, part, ctx);
    if (!plug)
      return fail(plug.error());
    const auto added = merger.merge(part, *plug);
    if (!added)
      return fail(added.error());
    result.touched.insert(result.touched.end(), added->begin(), added->end());
    result.volume_change += plug->plug.volume;
    ++done;
  }
  result.candidate = builder.freeze();
  std::ranges::sort(result.touched);
  result.surfaces_used = selected->surfaces;
  if (!selected->added.empty())
    result.notices.push_back("the selection was completed by surface " + list_of(selected->added) +
                             " (bottom or inner part of the hole)");
  ctx.run.report(1, "filled");
  return result;
}

}  // namespace tedit::ops
