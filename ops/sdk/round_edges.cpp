// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/sdk/round_edges.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/pieces.hpp"
#include "mesh/quality.hpp"
#include "ops/sdk/round_boundary.hpp"
#include "ops/sdk/round_cavity.hpp"

namespace tedit::ops {

namespace {

/// Below this worst quality (q = 3 r_in/R_circ) a larger cavity is tried: what the host's local
/// improvement lifts well above the floor otherwise.
constexpr double try_again_below = 0.1;

struct meshed_rounding {
  round_shell shell;
  tet_filling filling;
  std::vector<tet_id> cavity;
  double worst = 0;
};

double worst_quality(const tet_filling& filling) {
  double worst = 1;
  const auto& p = filling.points;
  for (const auto& t : filling.tets)
    worst = std::min(worst, radius_ratio(p[t[0]], p[t[1]], p[t[2]], p[t[3]]));
  return worst;
}

class rounder {
public:
  rounder(const mesh_version& mesh, const round_plan& plan, context& ctx)
      : mesh_(mesh), plan_(plan), ctx_(ctx) {}

  expected<edit_result> round(const round_settings& settings) {
    auto made = make_strips(mesh_, plan_, settings);
    if (!made)
      return fail(made.error());
    made_ = std::move(*made);
    const auto cuts = cut_edges(mesh_, plan_, made_);
    if (!cuts)
      return fail(cuts.error());
    const auto best = mesh_cavity(*cuts);
    if (!best)
      return fail(best.error());
    ctx_.run.report(0.9, "joining");
    return merge(*best);
  }

private:
  expected<meshed_rounding> try_margin(const round_cuts& cuts, double margin) {
    const auto cavity = find_cavity(mesh_, plan_, made_, cuts.dropped, margin);
    if (!cavity)
      return fail(cavity.error());
    meshed_rounding result;
    result.cavity.assign(cavity->begin(), cavity->end());
    std::ranges::sort(result.cavity);
    auto shell = make_shell(mesh_, plan_, made_, cuts, *cavity, *ctx_.host);
    if (!shell)
      return fail(shell.error());
    if (auto ok = check_free(mesh_, plan_, *shell); !ok)
      return fail(ok.error());
    auto filling = ctx_.host->tetrahedralise(shell->surface, ctx_.run);
    if (!filling)
      return fail(filling.error());
    result.shell = std::move(*shell);
    result.filling = std::move(*filling);
    result.worst = worst_quality(result.filling);
    return result;
  }

  /// Cavities that grow, until the mesher fills one well.
  expected<meshed_rounding> mesh_cavity(const round_cuts& cuts) {
    std::optional<meshed_rounding> best;
    std::optional<error> last;
    double fraction = 0.2;
    for (const double factor : {0.5, 1.0, 2.0}) {
      if (ctx_.run.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      ctx_.run.report(fraction += 0.2, "meshing around the edge");
      auto trial = try_margin(cuts, factor * made_.widest);
      if (trial) {
        if (!best || trial->worst > best->worst)
          best = std::move(*trial);
        if (best->worst >= try_again_below)
          break;
      } else if (!last || trial.error().code == ec::cancelled) {
        last = trial.error();
      }
      if (last && last->code == ec::cancelled)
        return fail(*last);
    }
    if (best)
      return std::move(*best);
    if (last->remedy.empty())
      last->remedy = "The version is unchanged; take another radius";
    return fail(*last);
  }

  expected<edit_result> merge(const meshed_rounding& meshed) {
    mesh_builder builder(version_ptr(version_ptr{}, &mesh_));
    auto vertices = meshed.shell.vertices;
    vertices.resize(meshed.filling.points.size(), no_id);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (vertices[i] == no_id)
        vertices[i] = builder.add_vertex(meshed.filling.points[i]);
    cavity_change change;
    change.removed = meshed.cavity;
    const auto region = mesh_.region_of(meshed.cavity.front());
    for (const auto& t : meshed.filling.tets)
      change.added.push_back(
        {{{vertices[t[0]], vertices[t[1]], vertices[t[2]], vertices[t[3]]}}, region});
    name_facets(meshed.shell, vertices, builder, change);
    if (const auto done = builder.apply(change); !done)
      return fail(done.error());
    edit_result result;
    result.candidate = builder.freeze();
    result.touched = builder.touched();
    result.volume_change = boundary_volume_change(mesh_, *result.candidate);
    return result;
  }

  /// Chains that go on smoothly in each other are one surface.
  [[nodiscard]] std::vector<std::size_t> groups() const {
    std::vector<std::size_t> group(plan_.chains.size() + plan_.corners.size());
    for (std::size_t i = 0; i < group.size(); ++i)
      group[i] = i;
    for (const auto& corner : plan_.corners)
      if (corner.type == round_corner::kind::smooth) {
        const auto keep = group[corner.ends[0].chain];
        const auto gone = group[corner.ends[1].chain];
        std::ranges::replace(group, gone, keep);
      }
    return group;
  }

  void name_facets(const round_shell& shell, const std::vector<vertex_id>& vertices,
                   mesh_builder& builder, cavity_change& change) const {
    const auto group = groups();
    std::map<std::size_t, surface_id> names;
    const auto& triangles = shell.surface.triangles;
    for (std::size_t i = shell.kept; i < triangles.size(); ++i) {
      const auto& t = triangles[i];
      const auto& name = shell.names[i - shell.kept];
      surface_id surface = 0;
      if (name) {
        surface = *name;
      } else {
        const auto [row, fresh] = names.try_emplace(group[shell.chain[i - shell.kept]], 0);
        if (fresh)
          row->second = builder.add_surface(label(row->first));
        surface = row->second;
      }
      change.facets.push_back({{vertices[t[0]], vertices[t[1]], vertices[t[2]]}, surface});
    }
  }

  [[nodiscard]] std::string label(std::size_t group) const {
    const std::string kind = plan_.side > 0 ? "fillet" : "round";
    if (group >= plan_.chains.size())
      return kind + " corner";
    const auto& chain = plan_.chains[group];
    return kind + " " + std::to_string(chain.a) + "-" + std::to_string(chain.b);
  }

  const mesh_version& mesh_;
  const round_plan& plan_;
  context& ctx_;
  round_surface made_;
};

}  // namespace

expected<edit_result> round_edges(const mesh_version& mesh, const std::vector<surface_id>& surfaces,
                                  double side, const round_settings& settings, context& ctx) {
  if (surfaces.empty())
    return fail(ec::empty_selection, "no surface was selected",
                "Select two walls that meet, or one wall for all its edges");
  if (ctx.run.cancel.cancelled())
    return fail(ec::cancelled, "the edit was cancelled");
  ctx.run.report(0.05, "finding edges");
  const auto plan = find_chains(mesh, surfaces, side);
  if (!plan)
    return fail(plan.error());
  auto result = rounder(mesh, *plan, ctx).round(settings);
  if (!result)
    return fail(result.error());
  result->surfaces_used = plan->used;
  if (!plan->added.empty()) {
    std::string list;
    for (const auto id : plan->added)
      list += (list.empty() ? "" : ", ") + std::to_string(id);
    result->notices.push_back("the rounding went on smoothly onto surface " + list);
  }
  result->figures.push_back(
    {"edges", static_cast<double>(plan->chains.size()), "", "edges rounded"});
  ctx.run.report(1, "rounded");
  return result;
}

}  // namespace tedit::ops
