// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/features/remove_protrusion.hpp"

#include <algorithm>
#include <unordered_set>

#include "base/text.hpp"
#include "mesh/level_set.hpp"
#include "mesh/level_set_tidy.hpp"
#include "mesh/pieces.hpp"
#include "mesh/quality.hpp"
#include "ops/shapes/features/levels.hpp"

namespace tedit::ops {

namespace {

class remover {
public:
  remover(const version_ptr& mesh, const protrusion& feature, const std::vector<level>& levels)
      : mesh_(*mesh),
        own_(feature.surfaces.begin(), feature.surfaces.end()),
        levels_(levels),
        builder_(mesh) {}

  /// Splits the tets where the levels run through the protrusion.
  expected<void> split(const execution& run) {
    std::vector<const std::unordered_set<vertex_id>*> sheets;
    sheets_.reserve(levels_.size());
    for (const auto& at : levels_) {
      level_set_settings settings;
      settings.zero = at.tolerance;
      settings.sheets = sheets;
      if (at.curved)
        settings.exact = [&](vec3 p) { return at.value(p); };
      const auto cut = split_at_level(
        builder_, tets_above(false), [&](vertex_id v) { return at.value(builder_.position(v)); },
        settings, run);
      if (!cut)
        return fail(cut.error());
      sheets_.push_back(cut->on_level);
      sheets.push_back(&sheets_.back());
    }
    return {};
  }

  expected<edit_result> remove(const execution& run) {
    const auto above = tets_above(true);
    std::unordered_set<tet_id> removed(above.begin(), above.end());
    if (auto ok = check_share(removed); !ok)
      return fail(ok.error());
    const auto settled = settle_removal(builder_, removed);
    if (!settled)
      return fail(settled.error());
    cavity_change change;
    change.removed.assign(removed.begin(), removed.end());
    std::ranges::sort(change.removed);
    name_bared_faces(removed, change);
    if (const auto done = builder_.apply(change); !done)
      return fail(done.error());
    drop_bare_interfaces(builder_);
    if (const auto tidied = tidy_cut(builder_, builder_.touched(), {}, run); !tidied)
      return fail(tidied.error());
    edit_result result;
    result.quality_floor = 0.1;
    result.candidate = builder_.freeze();
    result.volume_change = boundary_volume_change(mesh_, *result.candidate);
    result.touched = around_cut(*result.candidate);
    if (settled->crumbs > 0)
      result.notices.push_back(std::to_string(settled->crumbs) +
                               " loose crumbs of the part were removed with it");
    return result;
  }

private:
  /// The tets that hang together with the protrusion's facets and lie above all levels: with a
  /// corner (not `wholly`), or with their middle once they are split.
  [[nodiscard]] std::vector<tet_id> tets_above(bool wholly) const {
    const auto counts = [&](tet_id t) {
      const auto p = builder_.corners(t);
      return std::ranges::all_of(levels_, [&](const level& at) {
        if (wholly) {
          double sum = 0;
          for (const auto& corner : p)
            sum += at.value(corner);
          return sum > 0;
        }
        return std::ranges::any_of(
          p, [&](const vec3& corner) { return at.value(corner) > at.tolerance; });
      });
    };
    std::unordered_set<tet_id> seen;
    std::vector<tet_id> found;
    const auto visit = [&](tet_id t) {
      if (counts(t) && seen.insert(t).second)
        found.push_back(t);
    };
    for (facet_id f = 0; f < builder_.facet_slots(); ++f)
      if (builder_.is_live_facet(f) && own_.contains(builder_.facet(f).surface))
        visit(builder_.facet(f).tet);
    for (std::size_t next = 0; next < found.size(); ++next)
      for (const auto behind : builder_.neighbours(found[next]))
        if (!is_facet(behind))
          visit(behind);
    std::ranges::sort(found);
    return found;
  }

  /// A protrusion is less than half of its part: more is the part itself, seen from a wrong pick.
  [[nodiscard]] expected<void> check_share(const std::unordered_set<tet_id>& removed) const {
    if (removed.empty())
      return fail(ec::not_a_protrusion, "nothing stands above the foot of the selected surfaces",
                  "Select the sides of one boss, rib or fin");
    double volume = 0;
    for (const auto t : removed)
      volume += signed_volume(builder_.corners(t));
    if (const double all = total_volume(mesh_); volume > 0.5 * all)
      return fail(ec::not_a_protrusion,
                  "the selected surfaces bound " +
                    std::to_string(static_cast<int>(100 * volume / all)) +
                    " % of the part, not a boss, rib or fin on it",
                  "Select surfaces of the protrusion alone");
    return {};
  }

  void name_bared_faces(const std::unordered_set<tet_id>& removed, cavity_change& change) {
    std::vector<surface_id> names(levels_.size(), 0);
    const auto name_of = [&](std::size_t i) {
      if (levels_[i].surface)
        return *levels_[i].surface;
      if (names[i] == 0)
        names[i] = builder_.add_surface("foot");
      return names[i];
    };
    for (const auto t : change.removed)
      for (int face = 0; face < 4; ++face) {
        const auto behind = builder_.neighbours(t)[face];
        if (is_facet(behind) || removed.contains(behind))
          continue;
        new_facet bared;
        for (int i = 0; i < 3; ++i)
          bared.v[i] = builder_.tet_at(t).v[tet_faces[face][i]];
        bared.surface = name_of(nearest_level(bared.v));
        change.facets.push_back(bared);
      }
  }

  [[nodiscard]] std::size_t nearest_level(const std::array<vertex_id, 3>& v) const {
    std::size_t best = 0;
    double least = 1e300;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      double off = 0;
      for (const auto corner : v)
        off = std::max(off, std::abs(levels_[i].value(builder_.position(corner))));
      if (off < least)
        std::tie(least, best) = std::tuple(off, i);
    }
    return best;
  }

  /// What the edit changed, and the tets at the cut.
  [[nodiscard]] std::vector<tet_id> around_cut(const mesh_version& after) const {
    std::vector<vertex_id> cut;
    for (const auto& sheet : sheets_)
      for (const auto v : sheet)
        if (v < after.vertex_slots() && after.is_live_vertex(v))
          cut.push_back(v);
    std::ranges::sort(cut);
    auto touched = builder_.touched();
    const auto near = tets_around(after, cut);
    touched.insert(touched.end(), near.begin(), near.end());
    std::ranges::sort(touched);
    touched.erase(std::ranges::unique(touched).begin(), touched.end());
    return touched;
  }

  const mesh_version& mesh_;
  std::unordered_set<surface_id> own_;
  const std::vector<level>& levels_;
  mesh_builder builder_;
  std::vector<std::unordered_set<vertex_id>> sheets_;
};

}  // namespace

expected<edit_result> remove_protrusion(const version_ptr& mesh,
                                        const std::vector<surface_id>& surfaces, bool exact,
                                        context& ctx) {
  if (ctx.run.cancel.cancelled())
    return fail(ec::cancelled, "the edit was cancelled");
  ctx.run.report(0.05, "finding the foot");
  const auto feature = complete_protrusion(*mesh, surfaces, exact);
  if (!feature)
    return fail(feature.error());
  const auto levels = levels_of(*mesh, *feature);
  if (!levels)
    return fail(levels.error());
  remover work(mesh, *feature, *levels);
  ctx.run.report(0.2, "cutting at the foot");
  if (auto ok = work.split(ctx.run); !ok)
    return fail(ok.error());
  ctx.run.report(0.7, "taking off");
  auto result = work.remove(ctx.run);
  if (!result)
    return fail(result.error());
  result->surfaces_used = feature->surfaces;
  if (!feature->added.empty())
    result->notices.push_back("the selection was completed by surface " + list_of(feature->added));
  ctx.run.report(1, "removed");
  return result;
}

}  // namespace tedit::ops
