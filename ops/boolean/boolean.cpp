// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/boolean.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/number_range.hpp"
#include "mesh/adapt/split_edges.hpp"
#include "mesh/checks.hpp"
#include "mesh/optimize/improve.hpp"
#include "mesh/pieces.hpp"
#include "mesh/quality.hpp"
#include "ops/boolean/bonded.hpp"
#include "ops/boolean/cut_volumes.hpp"
#include "ops/boolean/flush.hpp"
#include "ops/boolean/put_on_walls.hpp"
#include "ops/boolean/remesh.hpp"
#include "ops/boolean/rounder_part.hpp"
#include "ops/boolean/rounder_tool.hpp"
#include "ops/boolean/tets_in_box.hpp"
#include "ops/boolean/thin_remains.hpp"
#include "ops/boolean/ways.hpp"
#include "ops/tools/local_size.hpp"

namespace tedit::ops {

namespace {

/// Shares of the local size: what lies in one plane, and the layer that keeps faces apart.
constexpr double flush_tolerance = 1e-4;
constexpr double flush_layer = 0.15;

/// How far around the tool's box facets are looked for, as a share of it: a bit more than
/// `cavity_finder` asks for.
constexpr double near_share = 0.06;

/// What a part may gain or lose as chords beside the tool are halved, as a share of what the tool
/// does; where the CAD model has the walls, any: their arcs are no guess.
constexpr double most_by_walls = 0.5;

class tool_boolean {
public:
  tool_boolean(const version_ptr& mesh, const tool_surface& tool,
               const std::vector<std::optional<surface_id>>& continues,
               const boolean_request& request, const execution& run)
      : tool_boolean(mesh, {mesh, false, {}}, tool, continues, request, run) {
    is_rounder_ = false;
  }

  /// On the part, or with the tool, made rounder.
  tool_boolean(const version_ptr& part, rounder_part rounder, const tool_surface& tool,
               const std::vector<std::optional<surface_id>>& continues,
               const boolean_request& request, const execution& run)
      : part_(part),
        mesh_(std::move(rounder.mesh)),
        also_(std::move(rounder.flat)),
        continues_(continues),
        request_(request),
        run_(run),
        size_(local_size(*mesh_, tool)) {
    find_near(tool);
    flush_ =
      make_flush(*mesh_, tool, request.mode, near_, flush_tolerance * size_, flush_layer * size_);
    // A wall that moves takes its neighbours' chords along: on a coarse part what lies between
    // these and their arcs is more than many an edit.
    if (!moves_walls(*mesh_, tool, continues, near_))
      walls_.emplace(*mesh_, flush_.tool, continues);
  }

  expected<boolean_result> best() {
    // In a part that says of its surfaces what they are those of the tool say so, too.
    if (walls_ && has_geometries(*mesh_))
      flush_.tool.geometries = walls_->tool_geometries();
    const auto finder = make_finder();
    // Somebody waits. Not by the clock: the same edit gives the same version everywhere.
    const bool is_large = flush_.tool.triangles.size() > many_triangles;
    const std::size_t tries = is_rounder_ ? (knows_walls() ? ways_onto_walls : 1)
                              : is_large  ? 2
                                          : boolean_ways.size();
    std::optional<boolean_result> best;
    std::optional<error> last;
    for (std::size_t i = 0; i < tries; ++i) {
      if (run_.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      // The first ones are nearly always the last.
      const auto share = [](std::size_t done) { return 1 - std::pow(0.25, done); };
      auto made = try_way(finder, boolean_ways[i], run_.part(share(i), share(i + 1)));
      if (!made) {
        last = made.error();
        if (last->code == ec::cancelled)
          return fail(*last);
        if (last->code != ec::mesher_failed || (walls_only_ && i + 1 >= ways_onto_walls))
          break;
        continue;
      }
      if (!best || (walls_only_ ? is_good(*made) : is_better(*made, *best))) {
        best = std::move(*made);
        on_chords_ = last_on_chords_;
        put_on_ = last_put_on_;
      }
      if (is_done(*best, i + 1, tries))
        break;
      // What is as flat as this after several tries does not come right.
      if (i + 1 >= hopeless_tries &&
          best->worst_after < hopeless * std::min(lowest_boolean_quality, best->worst_before))
        break;
    }
    if (!best) {
      if (last->remedy.empty())
        last->remedy = "Move the tool a little, or make it larger or smaller";
      return fail(*last);
    }
    if (best->worst_after < std::min(lowest_boolean_quality, best->worst_before))
      return fail(too_flat(best->worst_after, thin_));
    return std::move(*best);
  }

  [[nodiscard]] bool is_exact(double deviation) const {
    return deviation <= 2 * exact_of_size * size_;
  }

  /// Are new vertices of what came out last on chords of round walls instead of on the walls?
  [[nodiscard]] bool on_chords() const { return on_chords_; }
  /// m^3: of its change of volume, what came of new vertices on their walls.
  [[nodiscard]] double put_on() const { return put_on_; }
  /// Where little is left of the part. What no tets fit into has been merged.
  [[nodiscard]] std::optional<thin_remain> thin() const {
    return thin_ && thin_->thickness >= merged_share * size_ ? thin_ : std::nullopt;
  }

  /// The part with shorter chords where the tool is. None, or an error, where that is no help.
  expected<rounder_part> part_with_shorter_chords() {
    if (!walls_)
      return rounder_part();
    return with_shorter_chords(mesh_, flush_.tool, near_, *walls_, size_, run_);
  }

  /// And the tool, where it says of what walls its faces are.
  std::optional<tool_surface> tool_with_shorter_chords(const tool_surface& tool) const {
    return walls_ ? with_shorter_chords(tool, most_off_walls(tool, size_)) : std::nullopt;
  }

  expected<boolean_result> draft() {
    const auto opened = cut_open(make_finder(), boolean_ways.front(), run_);
    if (!opened)
      return fail(opened.error());
    const auto surface = surface_of(**opened, boolean_ways.front());
    if (!surface)
      return fail(surface.error());
    auto builder = begin();
    auto made =
      replace_cavity(builder, (*opened)->hollow, *surface, flush_.tool, filling::fan, run_);
    if (!made)
      return fail(made.error());
    if (builder.tet_count() == 0)
      return fail(ec::empty_selection, "nothing of the part would be left");
    boolean_result result;
    result.candidate = builder.freeze();
    result.touched = builder.touched();
    result.volume_change = boundary_volume_change(*mesh_, *result.candidate);
    name_surfaces(result, std::move(made->surfaces));
    return result;
  }

private:
  /// m: how far anything may go that is to stay on its walls.
  [[nodiscard]] double off_walls() const {
    return std::min(exact_of_size * size_, exact_of_part * part_size_);
  }

  /// Does the CAD model have all round walls near the tool?
  bool knows_walls() {
    if (!are_walls_known_)
      are_walls_known_ = walls_ && walls_->are_known(near_);
    return *are_walls_known_;
  }

  /// Once it is good only ways that keep to planes may be better, or those that leave no chords.
  bool is_done(const boolean_result& best, std::size_t tried, std::size_t tries) {
    if (!is_good(best) || (!is_exact(best.deviation) && tried < tries &&
                           boolean_ways[tried].clean.off_plane <= exact_of_size))
      return false;
    walls_only_ =
      on_chords_ && has_places_ && tried < std::min(tries, ways_onto_walls) && knows_walls();
    return !walls_only_;
  }

  [[nodiscard]] cavity_finder make_finder() const {
    std::vector<surface_id> moved;
    for (const auto& id : continues_)
      if (id)
        moved.push_back(*id);
    return {*mesh_, flush_.tool, request_.mode, near_, moved};
  }

  /// With the surfaces that faces of the tool continue, which may have gone.
  [[nodiscard]] mesh_builder begin() const {
    mesh_builder builder(mesh_);
    for (std::size_t i = 0; i < continues_.size(); ++i)
      if (continues_[i])
        builder.restore_surface(*continues_[i], flush_.tool.names[i], flush_.tool.geometry(i));
    return builder;
  }

  void name_surfaces(boolean_result& result, std::vector<std::optional<surface_id>>&& made) const {
    result.surfaces = std::move(made);
    for (std::size_t i = 0; i < continues_.size(); ++i)
      if (continues_[i])
        result.surfaces[i] = continues_[i];
  }

  /// All facets that anything of the boolean looks at, and the part's size.
  void find_near(const tool_surface& tool) {
    box extent = extent_of(tool);
    // The tool may get a layer all around.
    extent = extent.grown((flush_tolerance + 2 * flush_layer) * size_);
    extent = extent.grown(near_share * norm(extent.high - extent.low));
    box part;
    near_ = facets_in_box(*mesh_, extent, part);
    part_size_ = norm(part.high - part.low);
  }

  /// Made once for so many rings: most ways clean what an earlier one has cut.
  expected<const cut_cavity*> cut_open(const cavity_finder& finder, const boolean_way& how,
                                       const execution& run) {
    const std::pair key(how.rings, how.clean.fine && mesh_->regions().size() > 1);
    if (const auto known = cuts_.find(key); known != cuts_.end())
      return &known->second;
    auto hollow = finder.find(how.rings, also_, key.second);
    if (!hollow)
      return fail(hollow.error());
    run.report(0.2, "cutting");
    auto cut = hollow->tets.empty() ? expected<corefined>(corefined{}) : cut_of(*hollow, run);
    if (!cut)
      return fail(cut.error());
    cut_cavity opened{std::move(*hollow), std::move(*cut)};
    if (!opened.hollow.tets.empty() && changes_nothing(*mesh_, flush_.tool, opened))
      return fail(ec::empty_selection, "the tool changes nothing of the part",
                  "Place it so that it cuts the part's surface");
    return &cuts_.emplace(key, std::move(opened)).first->second;
  }

  [[nodiscard]] expected<labelled_surface> surface_of(const cut_cavity& of,
                                                      const boolean_way& how) const {
    return label_surface(*mesh_, of.hollow, flush_.tool, continues_, of.cut, request_.mode, size_,
                         how.steps, how.clean.fine);
  }

  expected<boolean_result> try_way(const cavity_finder& finder, const boolean_way& how,
                                   const execution& run) {
    const auto opened = cut_open(finder, how, run);
    if (!opened)
      return fail(opened.error());
    auto labelled = surface_of(**opened, how);
    if (!labelled)
      return fail(labelled.error());
    if (how.clean.fine)
      thin_ = thinnest(labelled->mesh, size_);
    auto settings = how.clean;
    if (settings.off_plane <= exact_of_size)
      settings.off_plane = off_walls() / size_;
    auto surface = *labelled;
    const auto deviation = clean(surface, settings, run);
    // Bonded regions are cut each for itself, and share their interfaces to the last digit.
    on_walls round;
    if (walls_ && (walls_only_ || !no_good_on_walls_) && (*opened)->hollow.shares.size() == 1) {
      if (deviation)
        round = filled_on_walls(**opened, surface, *deviation, run);
      if (!round.made || !*round.made || !is_good(**round.made))
        if (auto made = filled_with_slack(**opened, *labelled, settings, run))
          return std::move(*made);
    }
    if (!deviation)
      return fail(deviation.error());
    return on_walls_or_facets(std::move(round), **opened, surface, *deviation, run);
  }

  /// Returns the deviation, if it may be.
  expected<double> clean(labelled_surface& surface, const clean_settings& settings,
                         const execution& run) const {
    const auto before = surface.mesh;
    clean_surface(surface.mesh, settings, run.cancel);
    if (run.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    const double deviation = deviation_of(before, surface.mesh);
    if (deviation > request_.max_deviation && !is_exact(deviation))
      return fail(ec::mesher_failed, "the result would be off what was asked for by " +
                                       number_text(1e3 * deviation) + " mm");
    return deviation;
  }

  /// What came of putting new vertices on the round walls.
  struct on_walls {
    bool wanted = false;  ///< Some are not there by themselves.
    std::optional<expected<boolean_result>> made;
  };

  /// With new vertices on the round walls, where they fit there.
  on_walls filled_on_walls(const cut_cavity& opened, const labelled_surface& surface,
                           double deviation, const execution& run) {
    const auto [round, wanted, found] = put_on_round_walls(surface, *walls_);
    has_places_ &= found;
    last_put_on_ = 0;
    if (round && may_put_on(round->volume_change, opened)) {
      last_put_on_ = round->volume_change;
      return {wanted, filled(opened, round->surface, round->volume_change, deviation, run)};
    }
    if (!wanted)
      return {wanted, filled(opened, surface, 0, deviation, run)};
    return {wanted, std::nullopt};
  }

  /// The same where cleaning need not keep to the chords of round walls: one that nearly meets
  /// another edge makes no needles. Nothing where no good tets come of it.
  std::optional<boolean_result> filled_with_slack(const cut_cavity& opened,
                                                  labelled_surface surface,
                                                  const clean_settings& settings,
                                                  const execution& run) {
    if (!give_slack(surface, opened.hollow, opened.cut, flush_.tool, *walls_))
      return std::nullopt;
    const double before = surface.mesh.volume();
    const auto deviation = clean(surface, settings, run);
    if (!deviation || !is_exact(*deviation))
      return std::nullopt;
    auto [round, wanted, found] = put_on_round_walls(surface, *walls_);
    if (round)
      surface = std::move(round->surface);
    const double put_on = surface.mesh.volume() - before;
    if ((wanted && !round) || !may_put_on(put_on, opened))
      return std::nullopt;
    auto made = filled(opened, surface, put_on, *deviation, run);
    if (!made || !is_good(*made))
      return std::nullopt;
    last_on_chords_ = false;
    last_put_on_ = put_on;
    return std::move(*made);
  }

  /// Where no good tets came with new vertices on the round walls, with them on the facets.
  expected<boolean_result> on_walls_or_facets(on_walls round, const cut_cavity& opened,
                                              const labelled_surface& surface, double deviation,
                                              const execution& run) {
    last_on_chords_ = false;
    auto& made = round.made;
    if (made && (is_rounder_ || !round.wanted ||
                 (*made ? is_good(**made) : made->error().code != ec::mesher_failed)))
      return std::move(*made);
    // Made for that alone: the part as it was has been filled with vertices on chords already.
    if (round.wanted && (is_rounder_ || walls_only_))
      return fail(ec::mesher_failed, "its new vertices do not fit on their walls");
    // Where it does not come out once it does not in other ways: each would be meshed twice.
    no_good_on_walls_ |= made.has_value();
    auto plain = filled(opened, surface, 0, deviation, run);
    if (made && *made && (!plain || !is_better(*plain, **made)))
      return std::move(*made);
    last_on_chords_ = round.wanted || no_good_on_walls_;
    last_put_on_ = 0;
    return plain;
  }

  [[nodiscard]] expected<corefined> cut_of(const cavity& hollow, const execution& run) const {
    std::vector<solid_share> shares;
    for (const auto& share : hollow.shares)
      shares.push_back({share.last - share.first, share.stays});
    auto cut = corefine(hollow.surface, shares, {flush_.tool.points, flush_.tool.triangles},
                        request_.mode, planes_among(flush_, hollow.vertices), run);
    if (!cut || hollow.shares.size() == 1)
      return cut;
    return join_shares(hollow, std::move(*cut));
  }

  /// @param put_on m^3: by how much vertices that were put on round walls have changed the surface.
  expected<boolean_result> filled(const cut_cavity& opened, const labelled_surface& surface,
                                  double put_on, double deviation, const execution& run) {
    run.report(0.5, "meshing");
    auto builder = begin();
    auto made = replace_cavity(builder, opened.hollow, surface, flush_.tool, filling::tets, run);
    if (!made)
      return fail(made.error());
    if (builder.tet_count() == 0)
      return fail(ec::empty_selection, "nothing of the part would be left");
    run.report(0.7, "improving");
    if (const auto improved = improve(builder, made->tets, {}, run.part(0.7, 0.8)); !improved)
      return fail(improved.error());
    auto result = result_of(builder, *part_, *mesh_);
    for (int step = 0; step < 2 && made->tets.size() < many_tets && !is_good(result); ++step) {
      // Where all corners of a flat tet are on walls, what may change within these alone helps.
      if (auto ok = step == 0
                      ? tidy_filling(builder, run.part(0.8, 0.9))
                      : mend_flat(builder, builder.touched(), off_walls(), run.part(0.9, 1));
          !ok)
        return fail(ok.error());
      result = result_of(builder, *part_, *mesh_);
    }
    result.deviation = deviation;
    name_surfaces(result, std::move(made->surfaces));
    if (auto ok = volume_fits(*mesh_, size_, opened, put_on, result); !ok)
      return fail(ok.error());
    return result;
  }

  /// May new vertices on their walls change the part by that volume, m^3? Where the CAD model has
  /// all round walls there, by any: it is no guess that they are the part.
  [[nodiscard]] bool may_put_on(double volume, const cut_cavity& opened) {
    return knows_walls() || is_small(volume, *mesh_, flush_.tool, opened);
  }

  const version_ptr part_;
  const version_ptr mesh_;  ///< What is cut.
  const std::vector<tet_id> also_;
  const std::vector<std::optional<surface_id>>& continues_;
  const boolean_request& request_;
  const execution& run_;
  double size_ = 0;
  double part_size_ = 0;
  std::vector<facet_id> near_;
  flush_tool flush_;
  std::optional<round_walls> walls_;
  bool is_rounder_ = true;         ///< Made for vertices on walls alone.
  bool no_good_on_walls_ = false;  ///< No good tets came out of it.
  bool has_places_ = true;         ///< Each new vertex is somewhere on all of its walls.
  bool walls_only_ = false;        ///< It is good on chords already.
  bool last_on_chords_ = false;    ///< Of the last try: see `on_chords`.
  bool on_chords_ = false;
  double last_put_on_ = 0;  ///< Of the last try: see `put_on`.
  double put_on_ = 0;
  std::optional<thin_remain> thin_;  ///< See `combined::thin`.
  std::optional<bool> are_walls_known_;
  std::map<std::pair<int, bool>, cut_cavity> cuts_;  ///< By rings, and whether beyond.
};

/// Once more on a part whose walls are rounder where the tool is. Nothing where that is no better,
/// or much beside what the tool does.
std::optional<combined> made_on_rounder_part(
  tool_boolean& first, const version_ptr& mesh, const tool_surface& tool,
  const std::vector<std::optional<surface_id>>& continues, const boolean_request& request,
  const execution& run) {
  const auto shorter = first.tool_with_shorter_chords(tool);
  auto rounder = first.part_with_shorter_chords();
  if (!rounder || !rounder->mesh) {
    if (!shorter)
      return std::nullopt;
    rounder = rounder_part{mesh, true, {}};
  }
  const bool is_guess = !rounder->is_known;
  tool_boolean second(mesh, std::move(*rounder), shorter ? *shorter : tool, continues, request,
                      run);
  auto made = second.best();
  if (!made)
    return std::nullopt;
  // What became flat beside the tool's cavity as chords were halved.
  mesh_builder builder(made->candidate);
  if (!mend_flat(builder, changed_tets(*mesh, *made->candidate), 0, run))
    return std::nullopt;
  made->candidate = builder.freeze();
  made->touched = changed_tets(*mesh, *made->candidate);
  const double by_tool =
    std::exchange(made->volume_change, boundary_volume_change(*mesh, *made->candidate));
  made->worst_before = worst_quality_before(*mesh, *made->candidate, made->touched);
  made->worst_after = worst_quality(*made->candidate, made->touched);
  const double by_walls = made->volume_change - by_tool;
  if (is_guess && std::abs(by_walls) > most_by_walls * std::abs(by_tool))
    return std::nullopt;
  return combined{std::move(*made), by_walls + second.put_on(), second.thin()};
}

}  // namespace

expected<combined> combine_with_tool(const version_ptr& mesh, const tool_surface& tool,
                                     const std::vector<std::optional<surface_id>>& continues,
                                     const boolean_request& request, const execution& run) {
  if (auto ok = validate(tool, continues); !ok)
    return fail(ok.error());
  tool_boolean first(mesh, tool, continues, request, run);
  auto made = first.best();
  if (made ? first.on_chords() : made.error().code == ec::postcondition_failed)
    if (auto rounder =
          made_on_rounder_part(first, mesh, tool, continues, request, run.part(0.8, 1));
        rounder &&
        (!made || is_good(rounder->made) || rounder->made.worst_after >= made->worst_after))
      return std::move(*rounder);
  if (!made)
    return fail(made.error());
  return combined{std::move(*made), first.put_on(), first.thin()};
}

expected<boolean_result> draft_with_tool(const version_ptr& mesh, const tool_surface& tool,
                                         const std::vector<std::optional<surface_id>>& continues,
                                         const boolean_request& request, const execution& run) {
  if (auto ok = validate(tool, continues); !ok)
    return fail(ok.error());
  return tool_boolean(mesh, tool, continues, request, run).draft();
}

}  // namespace tedit::ops
