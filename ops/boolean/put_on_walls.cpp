// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/put_on_walls.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace tedit::ops {

namespace {

/// Faces of one surface whose normals differ by less lie in one plane.
constexpr double one_plane_cosine = 1 - 1e-9;
/// A triangle may lie so far askew to its round wall, and to the plane that it is a part of.
constexpr double askew_to_wall = 0.7;
constexpr double askew_to_plane = 0.9;
/// The shape that a triangle keeps, where it had it.
constexpr double kept_shape = 0.12;
constexpr double kept_share = 0.7;
/// Rounds in which what is poor is mended.
constexpr int mending_rounds = 4;
/// Of a triangle's longest edge: shorter ones are contracted first. And how long an edge may become
/// by that, in local sizes.
constexpr double short_edge = 0.4;
constexpr double longest_contracted = 1.9;
/// An edge is turned where its middle comes nearer to the wall by this factor.
constexpr double nearer_by_turning = 0.8;
constexpr double good_shape = 0.3;
/// Vertices of free form stay in the planes of its facets, by this share of the local size.
constexpr double off_free_form = 1e-4;
/// What moves by more than this share of the local size takes others along, so many rings of them,
/// in so many sweeps.
constexpr double near_move = 0.1;
constexpr int most_rings = 6;
constexpr int sweeps = 12;
/// Chords shorter than this share of the local size are not halved.
constexpr double least_halved = 0.7;
/// Off a wall by more than this share of its radius is to be moved, or to be taken out where all
/// of its faces stay in their planes by this share of the local size.
constexpr double far_off = 1e-9;
constexpr double in_plane = 1e-9;
/// A vertex is on its walls where it is so near, as a share of their radius.
constexpr double is_on = 1e-12;

class wall_putter {
public:
  wall_putter(labelled_surface& surface, round_walls& walls)
      : mesh_(surface.mesh), labels_(surface.labels), walls_(walls) {}

  /// Nothing has to move.
  [[nodiscard]] bool is_on_walls() const { return is_on_walls_; }
  /// Each vertex has a place on all of its walls.
  [[nodiscard]] bool has_places() const { return all_found_; }

  std::optional<double> put() {
    for (const auto& v : mesh_.vertices)
      was_.push_back(v.position);
    is_moved_.resize(was_.size());
    const double before = mesh_.volume();
    bool any_out = false;
    for (std::uint32_t v = 0; v < is_moved_.size(); ++v)
      any_out |= is_off(v) && take_out(v);
    for (std::uint32_t v = 0; v < is_moved_.size(); ++v)
      find_place(v);
    is_on_walls_ = moved_.empty() && !any_out && all_found_;
    if (is_on_walls_ || !all_found_)
      return std::nullopt;
    take_along();
    turn_onto_walls();
    auto poor = poor_faces();
    for (int round = 0; round < mending_rounds && mend(poor); ++round)
      poor = poor_faces();
    if (!all_found_ || !poor.empty())
      return std::nullopt;
    return mesh_.volume() - before;
  }

private:
  [[nodiscard]] vec3 at(std::uint32_t v) const { return mesh_.vertices[v].position; }

  /// What a vertex must lie on.
  std::vector<wall_demand> demands_at(std::uint32_t v) {
    std::vector<wall_demand> demands;
    std::vector<std::int32_t> seen;
    for (const auto f : mesh_.faces_at(v)) {
      const auto& face = mesh_.faces[f];
      const auto& wall = walls_.behind(labels_, face.label);
      if (const auto* round = wall.nearest(was_[v])) {
        if (std::ranges::find(seen, face.label) == seen.end())
          demands.push_back({round, {}, {}, false});
        seen.push_back(face.label);
        continue;
      }
      // A facet whose corners are a little off its plane is no part of that. The tool's are what
      // was asked for: where one nearly touches a round wall it does not run on as that.
      const wall_demand own{nullptr, wall.plane ? wall.plane->point : was_[v],
                            wall.plane ? wall.plane->axis : face.normal,
                            wall.free_form && !labels_.is_tool(face.label)};
      if (std::ranges::none_of(demands, [&](const wall_demand& d) {
            return !d.wall && std::abs(dot(d.normal, own.normal)) > one_plane_cosine;
          }))
        demands.push_back(own);
    }
    return demands;
  }

  [[nodiscard]] bool is_new(std::uint32_t v) const {
    return mesh_.vertices[v].origin < 0 && !mesh_.vertices[v].fixed && !mesh_.faces_at(v).empty();
  }

  static bool is_round(const std::vector<wall_demand>& demands) {
    return std::ranges::any_of(demands, [](const wall_demand& d) { return d.wall != nullptr; });
  }

  [[nodiscard]] bool is_off(std::uint32_t v) {
    return is_new(v) && std::ranges::any_of(demands_at(v), [&](const wall_demand& d) {
             return d.wall &&
                    std::abs(d.wall->distance(at(v))) > far_off * d.wall->radius_at(at(v));
           });
  }

  /// Contracts a vertex that its planes and edges do not need: so the tool's polygon stays as it
  /// is.
  bool take_out(std::uint32_t v) {
    if (!may_slide(v))
      return false;
    const bool within = mesh_.freedom_of(v) == surface_mesh::freedom::face;
    for (const auto w : mesh_.neighbours(v))
      if ((within || mesh_.is_crease(v, w)) && mesh_.may_go(v, w) && stays_plane(v, w)) {
        mesh_.merge(v, w);
        return true;
      }
    return false;
  }

  /// Would all faces of u keep their planes, and a fair shape, with v in its place?
  [[nodiscard]] bool stays_plane(std::uint32_t u, std::uint32_t v) const {
    double before = 1;
    double after = 1;
    for (const auto f : mesh_.faces_at(u)) {
      const auto& face = mesh_.faces[f];
      before = std::min(before, mesh_.shape_of(face.v));
      if (std::abs(dot(at(v) - at(u), face.normal)) > in_plane * mesh_.vertices[u].size)
        return false;
      auto t = face.v;
      if (std::ranges::find(t, v) != t.end())
        continue;
      std::ranges::replace(t, u, v);
      const vec3 n = mesh_.normal_of(t);
      if (!(dot(n, face.normal) > askew_to_plane * norm(n)))
        return false;
      after = std::min(after, mesh_.shape_of(t));
    }
    return after >= std::min(before, good_shape);
  }

  void find_place(std::uint32_t v) {
    if (!is_new(v))
      return;
    const auto demands = demands_at(v);
    if (!is_round(demands) && meets(demands, v, in_plane))
      return;
    const auto place = place_on_walls(demands, was_[v]);
    all_found_ &= place.found;
    if (place.found && place.after != place.before)
      move(v, place.at);
  }

  void move(std::uint32_t v, vec3 to) {
    mesh_.vertices[v].position = to;
    mesh_.vertices[v].origin = -1;
    if (!is_moved_[v])
      moved_.push_back(v);
    is_moved_[v] = 1;
  }

  /// Where vertices go further than their neighbours are away, these go along: on their walls,
  /// planes and creases, less the further they are.
  void take_along() {
    std::vector<follower> followers;
    std::vector<std::uint8_t> seen(was_.size());
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      if (norm(at(moved_[i]) - was_[moved_[i]]) > near_move * mesh_.vertices[moved_[i]].size)
        add_followers(moved_[i], seen, followers);
    }
    for (std::size_t i = 0; i < followers.size(); ++i)
      if (followers[i].ring < most_rings)
        add_followers(followers[i], seen, followers);
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (const auto& one : followers) {
        vec3 along;
        for (const auto w : one.around)
          along += (at(w) - was_[w]) / static_cast<double>(one.around.size());
        const auto place = place_on_walls(one.demands, was_[one.vertex] + along);
        if (place.found)
          move(one.vertex, place.at);
      }
  }

  struct follower {
    std::uint32_t vertex = 0;
    int ring = 0;
    std::vector<std::uint32_t> around;  ///< What it follows.
    std::vector<wall_demand> demands;
  };

  /// A point of the part may within its wall, but not along an edge; what is a corner because a
  /// coarse edge bends is held by its demands where it is one.
  [[nodiscard]] bool may_slide(std::uint32_t v) const {
    return mesh_.freedom_of(v) == surface_mesh::freedom::face ||
           (is_new(v) && mesh_.creases_at(v).size() == 2);
  }

  void add_followers(const follower& from, std::vector<std::uint8_t>& seen,
                     std::vector<follower>& followers) {
    add_followers(from.vertex, seen, followers, from.ring + 1);
  }

  void add_followers(std::uint32_t from, std::vector<std::uint8_t>& seen,
                     std::vector<follower>& followers, int ring = 0) {
    auto all = mesh_.neighbours(from);
    all.push_back(from);
    for (const auto v : all) {
      if (seen[v] || mesh_.faces_at(v).empty())
        continue;
      if (!may_slide(v))
        continue;
      seen[v] = 1;
      followers.push_back({v, ring,
                           mesh_.freedom_of(v) == surface_mesh::freedom::face ? mesh_.neighbours(v)
                                                                              : mesh_.creases_at(v),
                           demands_at(v)});
    }
  }

  [[nodiscard]] double shape_before(const surface_mesh::triangle& t) const {
    double squares = 0;
    for (int k = 0; k < 3; ++k) {
      const vec3 edge = was_[t[(k + 1) % 3]] - was_[t[k]];
      squares += dot(edge, edge);
    }
    const vec3 n = cross(was_[t[1]] - was_[t[0]], was_[t[2]] - was_[t[0]]);
    return squares > 0 ? 2 * std::sqrt(3.0) * norm(n) / squares : 0;
  }

  /// Does it turn away from its wall, or from its plane?
  [[nodiscard]] bool is_askew(const surface_mesh::face& face) {
    const vec3 n = mesh_.normal_of(face.v);
    const vec3 middle = (at(face.v[0]) + at(face.v[1]) + at(face.v[2])) / 3;
    const auto& wall = walls_.behind(labels_, face.label);
    vec3 normal = face.normal;
    double limit = wall.free_form ? askew_to_wall : askew_to_plane;
    if (const auto* round = wall.nearest(middle)) {
      const vec3 outward = round->normal(middle);
      normal = dot(outward, face.normal) < 0 ? -outward : outward;
      limit = askew_to_wall;
    }
    return !(dot(n, normal) > limit * norm(n));
  }

  [[nodiscard]] bool is_poor(std::uint32_t f) {
    const auto& face = mesh_.faces[f];
    return is_askew(face) ||
           mesh_.shape_of(face.v) < std::min(kept_shape, kept_share * shape_before(face.v));
  }

  /// Of those at vertices that have moved.
  std::vector<std::uint32_t> poor_faces() {
    std::vector<std::uint32_t> result;
    for (const auto v : moved_)
      if (is_moved_[v])
        for (const auto f : mesh_.faces_at(v))
          if (is_poor(f))
            result.push_back(f);
    std::ranges::sort(result);
    result.erase(std::ranges::unique(result).begin(), result.end());
    return result;
  }

  bool mend(const std::vector<std::uint32_t>& poor) {
    bool any = false;
    for (const auto f : poor) {
      if (!mesh_.faces[f].alive || mesh_.faces[f].frozen || !is_poor(f))
        continue;
      const auto t = mesh_.faces[f].v;
      any |= contract_shortest(t) || turn_longest(t) || halve_longest(t);
    }
    return any;
  }

  /// The first corner of the edge whose length comes first.
  template <class Comes>
  [[nodiscard]] int edge_that(const surface_mesh::triangle& t, const Comes& comes) const {
    int k = 0;
    for (int i = 1; i < 3; ++i)
      if (comes(mesh_.length(t[i], t[(i + 1) % 3]), mesh_.length(t[k], t[(k + 1) % 3])))
        k = i;
    return k;
  }

  [[nodiscard]] int longest_edge(const surface_mesh::triangle& t) const {
    return edge_that(t, std::greater{});
  }

  bool contract_shortest(const surface_mesh::triangle& t) {
    const int k = edge_that(t, std::less{});
    const int l = longest_edge(t);
    const auto a = t[k];
    const auto b = t[(k + 1) % 3];
    return mesh_.length(a, b) < short_edge * mesh_.length(t[l], t[(l + 1) % 3]) &&
           (contract(a, b) || contract(b, a));
  }

  /// Both lie on the walls that the first one lies on: it may go where no triangle becomes poor.
  bool contract(std::uint32_t u, std::uint32_t v) {
    if (!may_slide(u) || !mesh_.may_go(u, v) ||
        (mesh_.freedom_of(u) != surface_mesh::freedom::face &&
         (!mesh_.is_crease(u, v) || !meets(demands_at(u), v, off_free_form))))
      return false;
    double before = 1;
    double after = 1;
    for (const auto f : mesh_.faces_at(u)) {
      auto face = mesh_.faces[f];
      before = std::min(before, mesh_.shape_of(face.v));
      if (std::ranges::find(face.v, v) != face.v.end())
        continue;
      std::ranges::replace(face.v, u, v);
      if (is_askew(face) || leaves_free_form(face, u, v))
        return false;
      for (const auto w : face.v)
        if (w != v && mesh_.length(w, v) > longest_contracted * mesh_.size(w, v))
          return false;
      after = std::min(after, mesh_.shape_of(face.v));
    }
    if (after < before && after < good_shape)
      return false;
    mesh_.merge(u, v);
    return true;
  }

  /// Does a vertex lie on all of it, by this share of the local size?
  [[nodiscard]] bool meets(const std::vector<wall_demand>& demands, std::uint32_t v,
                           double share) const {
    const double near = share * mesh_.vertices[v].size;
    return std::ranges::all_of(demands, [&](const wall_demand& d) {
      return std::abs(d.wall ? d.wall->distance(at(v)) : dot(d.normal, at(v) - d.point)) <= near;
    });
  }

  [[nodiscard]] bool leaves_free_form(const surface_mesh::face& face, std::uint32_t u,
                                      std::uint32_t v) {
    const auto& wall = walls_.behind(labels_, face.label);
    return wall.round.empty() &&
           std::abs(dot(at(v) - at(u), face.normal)) > off_free_form * mesh_.vertices[u].size;
  }

  bool turn_longest(const surface_mesh::triangle& t) {
    const int k = longest_edge(t);
    return turn(t[k], t[(k + 1) % 3], false);
  }

  /// Edges of round walls whose triangles would lie nearer to the wall the other way are turned.
  void turn_onto_walls() {
    for (int round = 0; round < 2; ++round) {
      bool any = false;
      for (const auto v : moved_)
        for (const auto w : mesh_.neighbours(v))
          any |= turn(v, w, true);
      if (!any)
        return;
    }
  }

  bool turn(std::uint32_t a, std::uint32_t b, bool nearer) {
    std::array<std::uint32_t, 2> both{};
    std::array<surface_mesh::triangle, 2> next;
    if (!mesh_.faces_of_edge(a, b, both) || !mesh_.turned(a, b, both, next))
      return false;
    auto face = mesh_.faces[both[0]];
    const auto& wall = walls_.behind(labels_, face.label);
    const vec3 middle = 0.5 * (at(a) + at(b));
    const vec3 turned = 0.5 * (at(next[0][1]) + at(next[0][2]));
    const auto* round = wall.nearest(middle);
    if (!round || (nearer && std::abs(round->distance(turned)) >
                               nearer_by_turning * std::abs(round->distance(middle))))
      return false;
    const double before = std::min(mesh_.shape_of(face.v), mesh_.shape_of(mesh_.faces[both[1]].v));
    double after = 1;
    for (const auto& t : next) {
      face.v = t;
      if (is_askew(face))
        return false;
      after = std::min(after, mesh_.shape_of(t));
    }
    if (after <= before && (!nearer || after < good_shape))
      return false;
    mesh_.turn(a, b, both);
    return true;
  }

  /// Where that is the chord of an arc.
  bool halve_longest(const surface_mesh::triangle& t) {
    const int k = longest_edge(t);
    const auto a = t[k];
    const auto b = t[(k + 1) % 3];
    const bool is_chord = std::ranges::any_of(mesh_.all_faces_of_edge(a, b), [&](auto f) {
      const auto* round =
        walls_.behind(labels_, mesh_.faces[f].label).nearest(0.5 * (at(a) + at(b)));
      return round &&
             std::abs(round->distance(0.5 * (at(a) + at(b)))) > is_on * round->radius_at(at(a));
    });
    if (!is_chord || mesh_.length(a, b) < least_halved * mesh_.size(a, b))
      return false;
    const vec3 middle = 0.5 * (was_[a] + was_[b]);
    const auto v = mesh_.split(a, b, middle);
    if (v == no_id)
      return false;
    was_.push_back(middle);
    is_moved_.push_back(0);
    find_place(v);
    return true;
  }

  surface_mesh& mesh_;
  const surface_labels& labels_;
  round_walls& walls_;
  std::vector<vec3> was_;  ///< Of each vertex, on its chords.
  std::vector<std::uint8_t> is_moved_;
  std::vector<std::uint32_t> moved_;
  bool all_found_ = true;
  bool is_on_walls_ = false;
};

}  // namespace

put_on_outcome put_on_round_walls(const labelled_surface& surface, round_walls& walls) {
  if (surface.mesh.vertices.empty())
    return {};
  rounded_surface result{surface, 0};
  wall_putter putter(result.surface, walls);
  const auto change = putter.put();
  if (!change)
    return {std::nullopt, !putter.is_on_walls(), putter.has_places()};
  result.volume_change = *change;
  return {std::move(result), true, true};
}

}  // namespace tedit::ops
