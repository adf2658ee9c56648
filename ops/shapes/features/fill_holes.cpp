// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/features/fill_holes.hpp"

#include <algorithm>
#include <optional>

#include "base/text.hpp"
#include "mesh/quality.hpp"
#include "ops/shapes/caps/caps.hpp"
#include "ops/shapes/features/plug_gates.hpp"

namespace tedit::ops {

namespace {

/// Below this worst quality (q = 3 r_in/R_circ) of a plug denser caps are tried: what the host's
/// local improvement lifts well above the floor of 0.15 otherwise.
constexpr double try_again_below = 0.1;

struct meshed_plug {
  plug_surface plug;
  tet_filling filling;
  double worst = 0;  ///< Quality of the worst tet.
};

double worst_quality(const tet_filling& filling) {
  double worst = 1;
  const auto& p = filling.points;
  for (const auto& t : filling.tets)
    worst = std::min(worst, radius_ratio(p[t[0]], p[t[1]], p[t[2]], p[t[3]]));
  return worst;
}

/// Caps, gates and mesher, with denser caps when the mesher fails or its tets are bad.
expected<meshed_plug> mesh_plug(const mesh_version& mesh, const shell& part, context& ctx) {
  std::optional<error> last;
  std::optional<meshed_plug> best;
  for (const double factor : {1.0, 0.85, 0.7, 0.5}) {
    if (ctx.run.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    auto plug = close_shell(mesh, part, factor, *ctx.host);
    auto ok = plug ? check_plug(mesh, part, *plug) : tl::unexpected(plug.error());
    if (!ok && !best)
      return fail(ok.error());
    auto filling = ok ? ctx.host->tetrahedralise(plug->surface, ctx.run)
                      : expected<tet_filling>(tl::unexpected(ok.error()));
    if (filling) {
      const double worst = worst_quality(*filling);
      if (!best || worst > best->worst)
        best = meshed_plug{std::move(*plug), std::move(*filling), worst};
      if (worst >= try_again_below || part.rims.empty())
        break;
    } else {
      last = filling.error();
      if (last->code != ec::mesher_failed)
        break;
    }
  }
  if (best)
    return std::move(*best);
  if (last->remedy.empty())
    last->remedy = "The version is unchanged; select fewer or other surfaces";
  return fail(*last);
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
      const auto surface = c.continues ? *c.continues : builder_.add_surface("cap");
      for (const auto& t : c.triangles)
        change.facets.push_back({{vertices[t[0]], vertices[t[1]], vertices[t[2]]}, surface});
    }
    return builder_.apply(change);
  }

private:
  const mesh_version& mesh_;
  mesh_builder& builder_;
};

}  // namespace

expected<edit_result> fill_holes(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                                 const completion_settings& settings, context& ctx) {
  ctx.run.report(0.05, "finding rims");
  auto selected = complete_hole(*mesh, surfaces, settings);
  if (!selected)
    return fail(selected.error());
  mesh_builder builder(mesh);
  plug_merger merger(*mesh, builder);
  edit_result result;
  double done = 0;
  for (const auto& part : selected->shells) {
    ctx.run.report(0.1 + 0.8 * done / static_cast<double>(selected->shells.size()),
                   "meshing the plug");
    const auto plug = mesh_plug(*mesh, part, ctx);
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
