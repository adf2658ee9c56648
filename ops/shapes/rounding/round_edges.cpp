// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/rounding/round_edges.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/checks.hpp"
#include "mesh/optimize/improve.hpp"
#include "mesh/pieces.hpp"
#include "mesh/quality.hpp"
#include "ops/shapes/most_that_works.hpp"
#include "ops/shapes/rounding/round_boundary.hpp"
#include "ops/shapes/rounding/round_cavity.hpp"

namespace tedit::ops {

namespace {

/// How the cavity around the edge is made: first small and lean, then with more room.
struct attempt {
  double margin;  ///< Of the widest contact.
  bool depth;     ///< Points in the material behind the rounded surface.
};
constexpr std::array<attempt, 6> attempts{
  {{0.5, false}, {0.5, true}, {1.0, false}, {1.0, true}, {2.0, false}, {4.0, true}}};

/// No new attempt after this many tets.
constexpr std::size_t most_tets = 30'000;

/// What the host asks of the touched region.
constexpr double quality_floor = 0.15;
constexpr std::size_t few_tets = 2500;

struct rounded {
  version_ptr version;
  std::vector<tet_id> touched;
  double worst = 0;   ///< q = 3 r_in/R_circ of the touched tets after improvement.
  double wanted = 0;  ///< min(floor, what was there before).

  [[nodiscard]] bool good() const { return worst >= wanted; }
};

class rounder {
public:
  rounder(const version_ptr& mesh, const round_plan& plan, context& ctx)
      : base_(mesh), mesh_(*mesh), plan_(plan), ctx_(ctx) {}

  expected<edit_result> round(const round_settings& settings) {
    auto made = make_strips(mesh_, plan_, settings);
    if (!made)
      return fail(made.error());
    made_ = std::move(*made);
    const auto cuts = cut_edges(mesh_, plan_, made_);
    if (!cuts)
      return fail(cuts.error());
    auto best = best_of_attempts(*cuts);
    if (!best)
      return fail(best.error());
    edit_result result;
    result.volume_change = boundary_volume_change(mesh_, *best->version);
    result.candidate = std::move(best->version);
    result.touched = std::move(best->touched);
    result.improve = improvement::none;  // Done, with each attempt.
    result.figures = {
      {"edges", static_cast<double>(plan_.chains.size()), "", "runs of edges rounded"},
      {"segments", static_cast<double>(made_.segments), "", "facets over each arc"}};
    return result;
  }

private:
  /// The first attempt that is good enough, else the best.
  expected<rounded> best_of_attempts(const round_cuts& cuts) {
    std::optional<rounded> best;
    std::optional<error> first;
    std::size_t spent = 0;
    double fraction = 0.1;
    std::set<std::pair<std::size_t, bool>> tried;
    for (const auto& how : attempts) {
      if (ctx_.run.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      ctx_.run.report(fraction += 0.15, "meshing around the edge");
      const auto cavity = find_cavity(mesh_, plan_, made_, cuts.dropped, how.margin * made_.widest);
      // A wider margin takes the same tets and more: as many are the same ones, with the same end.
      if (cavity && !tried.emplace(cavity->size(), how.depth).second)
        continue;
      auto trial = cavity ? make(cuts, *cavity, how.depth) : fail(cavity.error());
      if (!trial) {
        if (trial.error().code == ec::cancelled)
          return fail(trial.error());
        if (!first)
          first = trial.error();
        continue;
      }
      if (!best || trial->worst - trial->wanted > best->worst - best->wanted)
        best = std::move(*trial);
      // Further attempts at a very long edge would take longer than a person waits.
      spent += best->touched.size();
      if (best->good() || spent > most_tets)
        break;
    }
    if (best)
      return std::move(*best);
    return fail(*first);
  }

  expected<rounded> make(const round_cuts& cuts, const std::unordered_set<tet_id>& cavity,
                         bool depth) {
    auto shell = make_shell(mesh_, plan_, made_, cuts, cavity, *ctx_.host);
    if (!shell)
      return fail(shell.error());
    if (auto ok = check_free(mesh_, plan_, *shell); !ok)
      return fail(ok.error());
    if (depth)
      add_depth(made_, *shell);
    const auto filling = ctx_.host->tetrahedralise(shell->surface, ctx_.run);
    if (!filling)
      return fail(filling.error());
    mesh_builder builder(base_);
    if (auto ok = replace(cavity, *shell, *filling, builder); !ok)
      return fail(ok.error());
    if (auto ok = lift(builder); !ok)
      return fail(ok.error());
    rounded result;
    result.version = builder.freeze();
    result.touched = builder.touched();
    result.worst = radius_ratios(*result.version, result.touched).min;
    result.wanted =
      std::min(quality_floor, worst_quality_before(mesh_, *result.version, result.touched));
    return result;
  }

  /// Shows which attempt is worth keeping. Worst first only: of many thousand new tets the local
  /// pass would take ten times as long; of a few it finds what the other does not.
  expected<void> lift(mesh_builder& builder) const {
    improve_settings settings;
    settings.thorough = thorough_settings{};
    settings.thorough->harmonic = false;
    execution quiet;  // The attempts have their own progress.
    quiet.cancel = ctx_.run.cancel;
    auto done = improve(builder, builder.touched(), settings, quiet);
    if (done && done->min_after < quality_floor && builder.touched().size() < few_tets)
      done = improve(builder, builder.touched(), {}, quiet);
    if (!done)
      return fail(done.error());
    return {};
  }

  expected<void> replace(const std::unordered_set<tet_id>& cavity, const round_shell& shell,
                         const tet_filling& filling, mesh_builder& builder) const {
    auto vertices = shell.vertices;
    vertices.resize(filling.points.size(), no_id);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (vertices[i] == no_id)
        vertices[i] = builder.add_vertex(filling.points[i]);
    cavity_change change;
    change.removed.assign(cavity.begin(), cavity.end());
    std::ranges::sort(change.removed);
    const auto region = mesh_.region_of(change.removed.front());
    for (const auto& t : filling.tets)
      change.added.push_back(
        {{{vertices[t[0]], vertices[t[1]], vertices[t[2]], vertices[t[3]]}}, region});
    name_facets(shell, vertices, builder, change);
    if (const auto done = builder.apply(change); !done)
      return fail(done.error());
    return {};
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

  const version_ptr& base_;
  const mesh_version& mesh_;
  const round_plan& plan_;
  context& ctx_;
  round_surface made_;
};

}  // namespace

std::vector<parameter_description> round_parameters() {
  return {
    {"radius",
     "Radius",
     "Radius of the ball that rolls along both walls.",
     parameter_type::real,
     "m",
     1e-9,
     10.0,
     {},
     0.002},
    {"segments",
     "Segments",
     "Facets over an arc of 90 degrees, at least; where the mesh is finer there are more.",
     parameter_type::integer,
     "",
     2.0,
     12.0,
     {},
     std::int64_t{4}},
  };
}

round_settings read_round_parameters(const parameters& values) {
  round_settings settings;
  settings.radius = std::get<double>(values.at("radius"));
  settings.segments = static_cast<int>(std::get<std::int64_t>(values.at("segments")));
  return settings;
}

expected<edit_result> round_edges(const version_ptr& mesh, const std::vector<surface_id>& surfaces,
                                  double side, const round_settings& settings, context& ctx) {
  if (surfaces.empty())
    return fail(ec::empty_selection, "no surface was selected",
                "Select two walls that meet, or one wall for all its edges");
  if (ctx.run.cancel.cancelled())
    return fail(ec::cancelled, "the edit was cancelled");
  ctx.run.report(0.05, "finding edges");
  const auto plan = find_chains(*mesh, surfaces, side);
  if (!plan)
    return fail(plan.error());
  const auto round = [&](double radius, context& trial) {
    auto taken = settings;
    taken.radius = radius;
    return rounder(mesh, *plan, trial).round(taken);
  };
  auto result = at_most(mesh, {"radius", "radius", settings.radius}, round, ctx);
  if (!result)
    return fail(result.error());
  result->surfaces_used = plan->used;
  if (!plan->added.empty()) {
    std::string list;
    for (const auto id : plan->added)
      list += (list.empty() ? "" : ", ") + std::to_string(id);
    result->notices.push_back("the rounding went on smoothly onto surface " + list);
  }
  ctx.run.report(1, "rounded");
  return result;
}

}  // namespace tedit::ops
