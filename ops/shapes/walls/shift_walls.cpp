// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/shapes/walls/shift_walls.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "mesh/features/fitted_form.hpp"
#include "mesh/features/known_wall.hpp"
#include "mesh/level_set_freedom.hpp"
#include "mesh/level_set_patch.hpp"
#include "mesh/level_set_tidy.hpp"
#include "mesh/optimize/improve.hpp"
#include "mesh/place_text.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"
#include "ops/shapes/walls/carried_surfaces.hpp"
#include "ops/shapes/walls/facet_sheet.hpp"
#include "ops/shapes/walls/swept_facets.hpp"

namespace tedit::ops {

namespace {

/// A step may leave tets as bad as this (q = 3 r_in/R_circ); they are mended before the next one.
constexpr double step_floor = 0.05;
/// Mended is what is worse than this.
constexpr double mend_below = 0.3;
/// A curved neighbour may be left by this share of the longest edge around, where its vertices are
/// in the way of a wall that trims it.
constexpr double neighbour_tolerance = 0.1;
/// Steps are halved down to this share of the whole way.
constexpr double least_step(shift_patience patience) {
  return patience == shift_patience::all ? 1.0 / 128 : 1.0 / 32;
}
/// Surfaces that meet at less than this sine run on flush with each other.
constexpr double least_sine = 0.05;
/// What such surfaces may be off each other's way, as a share of it.
constexpr double flush_tolerance = 0.1;
constexpr int newton_steps = 30;

/// A surface as the shift sees it: its shape where it has one, or its facets stand for one.
struct known_surface {
  std::optional<exact_wall> wall;
  std::optional<facet_sheet> sheet;
};

/// What a moved vertex must fulfil: so far off one surface, m.
struct condition {
  const exact_wall* exact = nullptr;
  const facet_sheet* sheet = nullptr;  ///< Where there is no exact shape.
  wall_shape plane = {};               ///< Where there is neither.
  double target = 0;
  std::optional<surface_id> surface;  ///< None: a face between two regions.
  bool moves = false;
  vec3 carried = {};  ///< How far the surface has gone with a wall, m.

  [[nodiscard]] double distance(vec3 p) const {
    return exact ? exact->distance(p - carried) : plane_near(p).distance(p - carried);
  }
  [[nodiscard]] vec3 normal(vec3 p) const {
    return exact ? exact->normal(p - carried) : plane_near(p).axis;
  }

  /// The plane at a point that is off the sheet, or the one that there is.
  [[nodiscard]] wall_shape plane_near(vec3 p) const {
    return sheet ? sheet->plane_at(p - carried) : plane;
  }
};

/// @param surface of a moving wall; none: a face between two regions.
condition plane_demand(vec3 point, vec3 normal, double target, std::optional<surface_id> surface) {
  condition plane;
  plane.plane.point = point;
  plane.plane.axis = normal;
  plane.target = target;
  plane.surface = surface;
  plane.moves = surface.has_value();
  return plane;
}

class shifter {
public:
  shifter(mesh_builder& mesh, const wall_set& walls, const carried_set& carried, double distance,
          shift_patience patience, const execution& run)
      : mesh_(mesh),
        walls_(walls),
        carried_(carried),
        distance_(distance),
        least_step_(least_step(patience)),
        run_(run) {
    for (const auto& [id, wall] : walls)
      surfaces_.emplace(
        id, known_surface{wall.exact ? std::optional(exact_wall{*wall.exact}) : std::nullopt, {}});
  }

  expected<void> shift() {
    double step = 1;
    while (reached_ < 1) {
      if (run_.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      step = std::min(step, 1 - reached_);
      const double to = step == 1 - reached_ ? 1 : reached_ + step;
      const auto places = places_at(to);
      if (!places)
        return fail(places.error());
      if (!fits(*places)) {
        if (0.5 * step < least_step_)
          return no_room();
        step *= 0.5;
        continue;
      }
      if (auto ok = move(*places); !ok)
        return fail(ok.error());
      reached_ = to;
      run_.report(0.1 + 0.8 * reached_, "moving the surfaces");
      step *= 2;
    }
    return {};
  }

private:
  using vertex_places = std::map<vertex_id, vec3>;

  [[nodiscard]] bool goes(surface_id id) const {
    return walls_.contains(id) || carried_.contains(id);
  }

  /// Where the vertices of the walls, and of what goes with them, belong at a share of the way.
  expected<vertex_places> places_at(double share) {
    vertex_places places;
    for (facet_id f = 0; f < mesh_.facet_slots(); ++f) {
      if (!mesh_.is_live_facet(f) || !goes(mesh_.facet(f).surface))
        continue;
      for (const auto v : mesh_.facet(f).v) {
        if (places.contains(v))
          continue;
        const auto place = place_at(v, share);
        if (!place)
          return fail(place.error());
        places.emplace(v, *place);
      }
    }
    return places;
  }

  expected<vec3> place_at(vertex_id v, double share) {
    const auto conditions = conditions_at(v, share);
    const vec3 start = mesh_.position(v);
    const double close = 1e-10 * std::abs(distance_);
    // Where a sheet's facets meet the nearest one may change to and fro.
    const double loose = 1e-3 * std::abs(distance_);
    vec3 x = start + first_way(conditions, share);
    for (int n = 0; n < newton_steps; ++n) {
      const auto move = newton_step(conditions, x, share);
      if (!move)
        return fail(move.error());
      x += *move;
      if (norm(*move) <= close || (n + 1 == newton_steps && norm(*move) <= loose))
        return x;
      if (!is_finite(x) || norm(x - start) > 50 * std::abs(distance_))
        break;
    }
    return fail(ec::invalid_argument, "surface " + std::to_string(*conditions.front().surface) +
                                        " at " + place_text(start) +
                                        " finds no place on its neighbours so far away");
  }

  /// What goes along keeps its place on its surface.
  [[nodiscard]] vec3 first_way(const std::vector<condition>& conditions, double share) const {
    for (const auto& c : conditions)
      if (c.surface && carried_.contains(*c.surface))
        return (share - reached_) * carried_.at(*c.surface);
    return {};
  }

  /// The shortest step that fulfils all conditions to first order; moving walls come first.
  expected<vec3> newton_step(const std::vector<condition>& conditions, vec3 x, double share) const {
    std::vector<vec3> basis;
    vec3 move;
    for (const auto& c : conditions) {
      const vec3 slope = c.normal(x);
      const double missing = c.target - c.distance(x) - dot(slope, move);
      vec3 rest = slope;
      for (const auto& b : basis)
        rest = rest - dot(rest, b) * b;
      const double size = norm(rest);
      if (size >= least_sine && basis.size() < 3) {
        basis.push_back(rest / size);
        move += missing / size * basis.back();
        continue;
      }
      // What is fulfilled along with the others is no further condition.
      if (std::abs(missing) > std::max(flush_tolerance * share * std::abs(distance_), slack_of(c)))
        return flush(c, x, *conditions.front().surface);
    }
    return move;
  }

  /// How far a fitted shape may be off its surface, m.
  [[nodiscard]] static double slack_of(const condition& c) {
    if (!c.exact)
      return 0;
    return c.exact->is_known ? c.exact->vague : 2 * round_enough.roundness * c.exact->shape.radius;
  }

  [[nodiscard]] static tl::unexpected<error> flush(const condition& c, vec3 x, surface_id moved) {
    if (!c.surface)
      return fail(ec::invalid_argument,
                  "the face between two regions leaves surface " + std::to_string(moved) +
                    " no way at " + place_text(x),
                  "Take a smaller depth, or other surfaces");
    const auto id = std::to_string(*c.surface);
    return fail(ec::invalid_argument,
                "surface " + id + " runs on flush with surface " + std::to_string(moved) +
                  " or leaves it no way at " + place_text(x),
                c.moves ? "Select fewer surfaces" : "Select surface " + id + ", too");
  }

  std::vector<condition> conditions_at(vertex_id v, double share) {
    std::vector<condition> result;
    const auto star = mesh_.star(v);
    std::vector<surface_id> beside;
    for (const auto f : facets_at(mesh_, v, star)) {
      const auto id = mesh_.facet(f).surface;
      if (std::ranges::count(beside, id))
        continue;
      beside.push_back(id);
      if (add_free_form(v, id, share, result))
        continue;
      const auto& known = surface_of(id);
      condition next;
      next.exact = known.wall ? &*known.wall : nullptr;
      next.sheet = known.sheet ? &*known.sheet : nullptr;
      next.surface = id;
      next.moves = walls_.contains(id);
      const vec3 here = mesh_.position(v);
      const auto along = carried_.find(id);
      if (along != carried_.end())
        next.carried = reached_ * along->second;
      next.target = next.moves ? share * distance_ + offset_of(v, id) : next.distance(here);
      if (along != carried_.end())
        next.carried = share * along->second;
      result.push_back(next);
    }
    add_interfaces(v, star, result);
    std::ranges::stable_sort(result, std::ranges::greater{}, &condition::moves);
    return result;
  }

  /// A moving wall without an exact shape: a plane for each of its normals at the vertex.
  bool add_free_form(vertex_id v, surface_id id, double share,
                     std::vector<condition>& result) const {
    const auto wall = walls_.find(id);
    if (wall == walls_.end() || wall->second.exact)
      return false;
    const auto normals = wall->second.normals.find(v);
    if (normals == wall->second.normals.end())
      return true;
    for (const auto& normal : normals->second)
      result.push_back(plane_demand(mesh_.base()->position(v), normal, share * distance_, id));
    return true;
  }

  /// How far a vertex of a moving wall was off its shape at first, m.
  double offset_of(vertex_id v, surface_id wall) {
    const auto [row, fresh] = offsets_.try_emplace({v, wall}, 0.0);
    if (fresh && reached_ == 0)
      row->second = walls_.at(wall).exact->distance(mesh_.position(v));
    return row->second;
  }

  /// Faces between regions stay in their planes.
  void add_interfaces(vertex_id v, const std::vector<tet_id>& star,
                      std::vector<condition>& result) const {
    for (const auto t : star)
      for (int face = 0; face < 4; ++face) {
        const auto behind = mesh_.neighbours(t)[face];
        if (mesh_.tet_at(t).v[face] == v || is_facet(behind) || behind < t ||
            mesh_.region_of(behind) == mesh_.region_of(t))
          continue;
        const auto p = mesh_.corners(t);
        const auto& [a, b, c] = tet_faces[face];
        result.push_back(plane_demand(mesh_.position(v), normalized(area_vector(p[a], p[b], p[c])),
                                      0, std::nullopt));
      }
  }

  /// A surface as it was before the edit.
  const known_surface& surface_of(surface_id id) {
    const auto [row, fresh] = surfaces_.try_emplace(id);
    if (fresh) {
      const auto& base = *mesh_.base();
      const auto facets = facets_of(base, std::vector{id});
      row->second.wall = known_wall(base, facets, corners_of(base, facets));
      if (!row->second.wall)
        if (const auto shape = fit_wall(base, facets, round_enough))
          row->second.wall = exact_wall{*shape};
      if (!row->second.wall)
        row->second.wall = fitted_near(corners_of(base, facets));
      if (!row->second.wall)
        row->second.sheet.emplace(base, id);
    }
    return row->second;
  }

  /// What the facets of a wall of free form stand for, beside what moves.
  std::optional<exact_wall> fitted_near(const facet_corners& facets) {
    if (!near_) {
      near_.emplace();
      for (const auto& [id, wall] : walls_)
        for (const auto& p :
             corners_of(*mesh_.base(), facets_of(*mesh_.base(), std::array{id})).points)
          near_->add(p);
      *near_ = near_->grown(std::abs(distance_));
    }
    return fit_free_form(facets, near_);
  }

  /// Would all tets around stay as good as they must, and the boundary clear of itself?
  bool fits(const vertex_places& places) {
    std::unordered_set<tet_id> seen;
    for (const auto& [v, place] : places)
      for (const auto t : mesh_.star(v)) {
        if (!seen.insert(t).second)
          continue;
        auto p = mesh_.corners(t);
        const double before = radius_ratio(p);
        for (int i = 0; i < 4; ++i)
          if (const auto found = places.find(mesh_.tet_at(t).v[i]); found != places.end())
            p[i] = found->second;
        if (orient3d(p[0], p[1], p[2], p[3]) <= 0 ||
            radius_ratio(p) < std::min(step_floor, before)) {
          obstacle_ =
            "the mesh at " + place_text(0.25 * (p[0] + p[1] + p[2] + p[3])) + " leaves no room";
          return false;
        }
      }
    const auto met = first_meeting(mesh_, places);
    if (met)
      obstacle_ =
        "surface " + std::to_string(met->surface) + " is in the way at " + place_text(met->place);
    return !met;
  }

  expected<void> move(const vertex_places& places) {
    std::unordered_set<tet_id> around;
    double worst = 1;
    for (const auto& [v, place] : places)
      mesh_.set_position(v, place);
    for (const auto& [v, place] : places)
      for (const auto t : mesh_.star(v))
        if (around.insert(t).second)
          worst = std::min(worst, radius_ratio(mesh_.corners(t)));
    if (worst >= mend_below)
      return {};
    std::vector<tet_id> region(around.begin(), around.end());
    std::ranges::sort(region);
    tidy_settings tidy;
    tidy.target = mend_below;
    tidy.tolerance_of = [&](surface_id id) {
      return goes(id) ? tidy.tolerance : neighbour_tolerance;
    };
    if (const auto done = tidy_cut(mesh_, region, tidy, run_); !done)
      return fail(done.error());
    std::erase_if(region, [&](tet_id t) { return !mesh_.is_live_tet(t); });
    improve_settings improving;
    improving.rings = 1;
    improving.sweeps = 3;
    if (const auto done = improve(mesh_, region, improving, run_); !done)
      return fail(done.error());
    return {};
  }

  [[nodiscard]] tl::unexpected<error> no_room() const {
    std::string ids;
    for (const auto& [id, wall] : walls_)
      ids += (ids.empty() ? "" : ", ") + std::to_string(id);
    return fail(ec::invalid_argument, (walls_.size() == 1 ? "surface " : "surfaces ") + ids +
                                        " cannot be moved so far: " + obstacle_);
  }

  mesh_builder& mesh_;
  const wall_set& walls_;
  const carried_set& carried_;
  double distance_;
  double least_step_;
  const execution& run_;
  double reached_ = 0;  ///< Share of the way.
  std::string obstacle_;
  std::map<surface_id, known_surface> surfaces_;
  std::optional<box> near_;  ///< What moves, and where it goes.
  std::map<std::pair<vertex_id, surface_id>, double> offsets_;
};

}  // namespace

expected<carried_set> shift_walls(mesh_builder& mesh, const wall_set& walls, double distance,
                                  shift_patience patience, const execution& run) {
  if (auto ok = check_room(walls, distance); !ok)
    return fail(ok.error());
  auto moving = walls;
  auto carried = find_carried(*mesh.base(), moving, distance);
  if (auto ok = shifter(mesh, moving, carried, distance, patience, run).shift(); !ok)
    return fail(ok.error());
  return carried;
}

}  // namespace tedit::ops
