// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/clean.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <ranges>

#include "ops/boolean/thin_remains.hpp"

namespace tedit::ops {

namespace {

using freedom = surface_mesh::freedom;
using triangle = surface_mesh::triangle;

struct sized_edge {
  double length = 0;  ///< As a share of the size wanted.
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// Cosines of the angles by which a triangle may turn away from what it is a part of.
constexpr double turn_limit = 0.906;       // 25 degrees
constexpr double weld_turn_limit = 0.766;  // 40 degrees
constexpr double flip_limit = 0.978;       // 12 degrees
constexpr double poor_flip_limit = 0.883;  // 28 degrees

/// Edges where little is left are so many times as long as that, found in so many rounds, or until
/// there are so many times as many faces. A gap below this share of the least size ends it.
constexpr double thin_edges = 2.5;
constexpr int thin_rounds = 8;
constexpr std::size_t most_growth = 4;
constexpr double hopeless_gap = 1;

class cleaner {
public:
  cleaner(surface_mesh& mesh, const clean_settings& settings, const cancel_token& cancel)
      : mesh_(mesh), settings_(settings), cancel_(cancel) {
    double sum = 0;
    int count = 0;
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
      size_before_.push_back(mesh.vertices[v].size);
      const bool is_new = mesh.vertices[v].origin < 0 && !mesh.faces_at(v).empty();
      sum += is_new ? mesh.vertices[v].size : 0;
      count += is_new;
    }
    if (settings.fine && count > 0)
      least_fine_ = settings.least_size * sum / count;
  }

  void run() {
    weld(1e-4);
    grade(0.6);
    weld(settings_.weld);
    remesh(6);
    double least = settings_.least_size;
    for (int again = 0; again < (settings_.fine ? 3 : 2) && shrink_near_misses(least); ++again) {
      grade(0.7);
      remesh(settings_.fine ? 8 : 3);
      least = 0.6;
    }
    if (settings_.fine)
      refine_thin();
    weld(settings_.weld);
    remesh(2);
  }

private:
  // -- looking ---------------------------------------------------------------

  /// Those whose length, as a share of the size wanted, is between both, the shortest first.
  [[nodiscard]] std::vector<sized_edge> edges(double least = 0, double most = 1e300) const {
    std::vector<sized_edge> result;
    for (const auto& f : mesh_.faces) {
      if (!f.alive || f.frozen)
        continue;
      for (int k = 0; k < 3; ++k) {
        const auto a = f.v[k];
        const auto b = f.v[(k + 1) % 3];
        if (a >= b)
          continue;
        if (const double length = mesh_.length(a, b) / mesh_.size(a, b);
            length >= least && length <= most)
          result.push_back({length, a, b});
      }
    }
    std::ranges::sort(result, {}, [](const auto& e) { return std::tuple(e.length, e.a, e.b); });
    return result;
  }

  [[nodiscard]] vec3 at(std::uint32_t v) const { return mesh_.vertices[v].position; }

  [[nodiscard]] double longest_side(const triangle& t) const {
    return std::max({mesh_.length(t[0], t[1]), mesh_.length(t[1], t[2]), mesh_.length(t[2], t[0])});
  }

  /// Does the triangle point where it should, and is it no needle of rounding errors?
  [[nodiscard]] bool faces_along(const triangle& t, vec3 normal, double limit) const {
    const vec3 n = mesh_.normal_of(t);
    const double twice_area = norm(n);
    const double side = longest_side(t);
    return twice_area > 1e-10 * side * side && dot(n, normal) > limit * twice_area;
  }

  /// How far v is off the planes of the faces at u, less their slack, as a share of the size.
  [[nodiscard]] double off_planes(std::uint32_t u, vec3 to) const {
    double most = 0;
    for (const auto f : mesh_.faces_at(u))
      most =
        std::max(most, std::abs(dot(to - at(u), mesh_.faces[f].normal)) - mesh_.faces[f].slack);
    return most / mesh_.vertices[u].size;
  }

  /// m: how far a vertex may go off the plane of a face.
  [[nodiscard]] double may_leave(std::uint32_t f, double size) const {
    return settings_.off_plane * size + mesh_.faces[f].slack;
  }

  [[nodiscard]] static bool has(const triangle& t, std::uint32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
  }

  // -- merging ----------------------------------------------------------------

  /// Contracts an edge that is as good as nothing: a triangle counts only where it is one.
  bool weld_edge(std::uint32_t u, std::uint32_t v, double tolerance) {
    if (mesh_.vertices[u].fixed || !mesh_.may_go(u, v))
      return false;
    const double size = mesh_.size(u, v);
    const vec3 step = at(v) - at(u);
    for (const auto f : mesh_.faces_at(u)) {
      auto t = mesh_.faces[f].v;
      if (has(t, v))
        continue;
      std::ranges::replace(t, u, v);
      const vec3 n = mesh_.normal_of(t);
      const double side = longest_side(t);
      const double height = side > 0 ? norm(n) / side : 0;
      const vec3 normal = mesh_.faces[f].normal;
      if (height > 2 * tolerance * size && std::abs(dot(step, normal)) > may_leave(f, size))
        return false;
      if (height > 1.5 * tolerance * size && dot(n, normal) < weld_turn_limit * norm(n))
        return false;
    }
    mesh_.merge(u, v);
    return true;
  }

  /// The end that is less free stays; between equals the one that is further off the planes of the
  /// other, then the one that is a point of the part.
  [[nodiscard]] bool goes_first(std::uint32_t u, std::uint32_t v) const {
    const auto free_u = mesh_.freedom_of(u);
    const auto free_v = mesh_.freedom_of(v);
    if (free_u != free_v)
      return free_u < free_v;
    const double off_u = off_planes(u, at(v));
    const double off_v = off_planes(v, at(u));
    if (std::max(off_u, off_v) > 1e-9)
      return off_u < off_v;
    return mesh_.vertices[u].origin < 0 || mesh_.vertices[v].origin >= 0;
  }

  void weld(double tolerance) {
    for (int round = 0; round < 4; ++round) {
      bool changed = false;
      for (const auto& e : edges(0, tolerance)) {
        if (!mesh_.is_edge(e.a, e.b) || mesh_.length(e.a, e.b) > tolerance * mesh_.size(e.a, e.b))
          continue;
        const bool first = goes_first(e.a, e.b);
        const auto u = first ? e.a : e.b;
        const auto v = first ? e.b : e.a;
        changed |= weld_edge(u, v, tolerance) || weld_edge(v, u, tolerance);
      }
      const auto count = mesh_.faces.size();
      for (std::uint32_t f = 0; f < count; ++f)
        if (mesh_.faces[f].alive && !mesh_.faces[f].frozen)
          changed |= weld_needle(f, tolerance);
      if (!changed)
        return;
    }
  }

  /// The longest side of a face, and the corner opposite.
  [[nodiscard]] std::array<std::uint32_t, 3> by_longest_side(std::uint32_t f) const {
    const auto& t = mesh_.faces[f].v;
    int k = 0;
    for (int i = 1; i < 3; ++i)
      if (mesh_.length(t[i], t[(i + 1) % 3]) > mesh_.length(t[k], t[(k + 1) % 3]))
        k = i;
    return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
  }

  /// A corner that is as good as on the opposite side: the side is turned away or gets the corner.
  bool weld_needle(std::uint32_t f, double tolerance) {
    const auto [u, v, apex] = by_longest_side(f);
    const auto all = mesh_.all_faces_of_edge(u, v);
    if (all.empty())
      return false;
    const double size = mesh_.size(u, v);
    const vec3 side = at(v) - at(u);
    const double length = norm(side);
    if (length <= 0 || norm(cross(at(apex) - at(u), side)) > 0.7 * tolerance * size * length)
      return false;
    const double along = dot(at(apex) - at(u), side) / (length * length);
    if (std::min(along, 1 - along) * length < tolerance * size)
      return false;
    if (!mesh_.is_crease(u, v) && turn_if_better(u, v))
      return true;
    if (std::ranges::any_of(all, [&](auto g) { return mesh_.faces[g].frozen; }))
      return false;
    const vec3 foot = at(u) + along * side;
    const bool stays = mesh_.freedom_of(apex) != freedom::face || mesh_.vertices[apex].origin >= 0;
    const vec3 place = stays ? at(apex) : foot;
    // On a crease only what leaves its faces where they are.
    if (mesh_.is_crease(u, v))
      for (const auto g : all)
        if (std::abs(dot(place - foot, mesh_.faces[g].normal)) > may_leave(g, size))
          return false;
    const auto middle = mesh_.split(u, v, place);
    return middle != no_id &&
           (stays ? weld_edge(middle, apex, tolerance) : weld_edge(apex, middle, tolerance));
  }

  /// Contracts a short edge where the triangles stay good ones.
  bool contract(std::uint32_t u, std::uint32_t v, bool tiny) {
    const auto free = mesh_.freedom_of(u);
    if (free >= freedom::corner || (free == freedom::crease && !mesh_.is_crease(u, v)) ||
        !mesh_.may_go(u, v) || off_planes(u, at(v)) > settings_.off_plane)
      return false;
    double before = 1;
    double after = 1;
    for (const auto f : mesh_.faces_at(u)) {
      auto t = mesh_.faces[f].v;
      before = std::min(before, mesh_.shape_of(t));
      if (has(t, v))
        continue;
      std::ranges::replace(t, u, v);
      if (!faces_along(t, mesh_.faces[f].normal, turn_limit))
        return false;
      after = std::min(after, mesh_.shape_of(t));
      for (const auto w : t)
        if (!tiny && w != v && mesh_.length(w, v) > 1.9 * mesh_.size(w, v))
          return false;
    }
    if (after < before && after < (tiny ? 0.02 : 0.25))
      return false;
    mesh_.merge(u, v);
    return true;
  }

  void contract_short(double below) {
    for (const auto& e : edges(0, below)) {
      if (!mesh_.is_edge(e.a, e.b))
        continue;
      const bool first = goes_first(e.a, e.b);
      const auto u = first ? e.a : e.b;
      const auto v = first ? e.b : e.a;
      const bool tiny = e.length < 0.15;
      if (!contract(u, v, tiny))
        (void)contract(v, u, tiny);
    }
  }

  // -- splitting, turning, moving -------------------------------------------------

  void halve_long(double above) {
    for (const auto& e : std::views::reverse(edges(above))) {
      const auto at_edge = mesh_.all_faces_of_edge(e.a, e.b);
      if (at_edge.empty())
        continue;
      double longest = 0;
      for (const auto f : at_edge)
        longest = std::max(longest, longest_side(mesh_.faces[f].v));
      if (mesh_.length(e.a, e.b) >= 0.8 * longest)
        (void)mesh_.split(e.a, e.b, 0.5 * (at(e.a) + at(e.b)));
    }
  }

  bool turn_if_better(std::uint32_t a, std::uint32_t b) {
    std::array<std::uint32_t, 2> both{};
    std::array<triangle, 2> next;
    if (!mesh_.faces_of_edge(a, b, both) || !mesh_.turned(a, b, both, next))
      return false;
    const auto& one = mesh_.faces[both[0]];
    const auto& other = mesh_.faces[both[1]];
    const double before = std::min(mesh_.shape_of(one.v), mesh_.shape_of(other.v));
    const double after = std::min(mesh_.shape_of(next[0]), mesh_.shape_of(next[1]));
    const bool poor = before < 0.2;
    if (after <= 1.02 * before || dot(one.normal, other.normal) < (poor ? 0.86 : flip_limit))
      return false;
    const vec3 normal = normalized(one.normal + other.normal);
    for (const auto& t : next)
      if (!faces_along(t, normal, poor ? poor_flip_limit : flip_limit))
        return false;
    const double rise = std::abs(dot(at(next[0][1]) - at(a), one.normal));
    const double size = mesh_.size(a, b);
    if (rise > std::min(may_leave(both[0], size), may_leave(both[1], size)))
      return false;
    mesh_.turn(a, b, both);
    return true;
  }

  void turn_all() {
    for (int round = 0; round < 3; ++round) {
      bool changed = false;
      for (const auto& e : edges())
        changed |= mesh_.is_edge(e.a, e.b) && turn_if_better(e.a, e.b);
      if (!changed)
        return;
    }
  }

  /// Flat triangles whose longest side is a crease: the crease gets a vertex, and the corner goes
  /// there.
  void open_caps() {
    const auto count = mesh_.faces.size();
    for (std::uint32_t f = 0; f < count; ++f) {
      if (!mesh_.faces[f].alive || mesh_.faces[f].frozen || mesh_.shape_of(mesh_.faces[f].v) > 0.12)
        continue;
      const auto [u, v, apex] = by_longest_side(f);
      if (!mesh_.is_edge(u, v) || !mesh_.is_crease(u, v))
        continue;
      const vec3 side = at(v) - at(u);
      const double along = dot(at(apex) - at(u), side) / dot(side, side);
      const double gap = norm(cross(at(apex) - at(u), side)) / norm(side);
      if (along < 0.15 || along > 0.85 || gap > 0.3 * mesh_.size(u, v))
        continue;
      if (const auto middle = mesh_.split(u, v, at(u) + along * side); middle != no_id)
        (void)contract(apex, middle, true);
    }
  }

  void centre(std::uint32_t v) {
    if (mesh_.faces_at(v).empty() || mesh_.freedom_of(v) != freedom::face)
      return;
    vec3 middle;
    const auto around = mesh_.neighbours(v);
    for (const auto w : around)
      middle += at(w) / static_cast<double>(around.size());
    const vec3 old = at(v);
    vec3 step = middle - old;
    vec3 normal;
    double before = 1;
    for (const auto f : mesh_.faces_at(v)) {
      normal += mesh_.faces[f].normal;
      before = std::min(before, mesh_.shape_of(mesh_.faces[f].v));
    }
    normal = normalized(normal);
    step = step - dot(step, normal) * normal;
    if (off_planes(v, old + step) > settings_.off_plane)
      return;
    for (const double share : {1.0, 0.5, 0.25}) {
      mesh_.vertices[v].position = old + share * step;
      const bool better = std::ranges::all_of(mesh_.faces_at(v), [&](auto f) {
        const auto& face = mesh_.faces[f];
        return mesh_.shape_of(face.v) > before && faces_along(face.v, face.normal, turn_limit);
      });
      if (better) {
        mesh_.vertices[v].origin = -1;
        return;
      }
    }
    mesh_.vertices[v].position = old;
  }

  void remesh(int rounds) {
    for (int round = 0; round < rounds && !cancel_.cancelled(); ++round) {
      contract_short(0.6);
      halve_long(1.45);
      turn_all();
      open_caps();
      if (round > 0)
        for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v)
          centre(v);
    }
  }

  /// Where little is left between two faces their triangles become as small.
  void refine_thin() {
    const auto most = most_growth * count_alive();
    for (int round = 0; round < thin_rounds && !cancel_.cancelled(); ++round) {
      const auto places = thin_places(mesh_);
      const auto least = std::ranges::min_element(places, {}, &thin_place::gap);
      // What no triangle is small enough for comes to nothing.
      if (least == places.end() || least->gap < hopeless_gap * least_fine_ ||
          count_alive() > most || !shrink_at(mesh_, places, thin_edges, least_fine_))
        return;
      grade(0.7);
      remesh(2);
    }
  }

  [[nodiscard]] std::size_t count_alive() const {
    return static_cast<std::size_t>(
      std::ranges::count_if(mesh_.faces, [](const auto& f) { return f.alive; }));
  }

  // -- sizes ----------------------------------------------------------------------

  /// Sizes grow by at most `by` a length, from new vertices and those that were made smaller.
  void grade(double by) {
    using entry = std::pair<double, std::uint32_t>;
    std::priority_queue<entry, std::vector<entry>, std::greater<>> open;
    const auto before = [&](std::uint32_t v) {
      return v < size_before_.size() ? size_before_[v] : 1e300;
    };
    for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v)
      if (!mesh_.faces_at(v).empty() &&
          (mesh_.vertices[v].origin < 0 || mesh_.vertices[v].size < 0.95 * before(v)))
        open.push({mesh_.vertices[v].size, v});
    while (!open.empty()) {
      const auto [size, v] = open.top();
      open.pop();
      if (size > mesh_.vertices[v].size)
        continue;
      for (const auto w : mesh_.neighbours(v)) {
        const double grown = size + by * mesh_.length(v, w);
        auto& next = mesh_.vertices[w];
        if (grown < next.size && !(next.fixed && grown < 0.6 * before(w))) {
          next.size = grown;
          open.push({grown, w});
        }
      }
    }
  }

  /// Where creases nearly meet triangles must be as small as what is between them.
  bool shrink_near_misses(double least) {
    std::vector<double> next;
    for (const auto& v : mesh_.vertices)
      next.push_back(v.size);
    bool any = false;
    const auto shrink = [&](std::uint32_t v, double gap) {
      const double lowest = settings_.fine ? least_fine_ : least * mesh_.vertices[v].size;
      const double size = std::max(lowest, 1.4 * gap);
      if (size < next[v]) {
        next[v] = size;
        any = true;
      }
    };
    for (const auto& f : mesh_.faces) {
      if (!f.alive || f.frozen)
        continue;
      for (int k = 0; k < 3; ++k)
        near_miss(f.v[k], f.v[(k + 1) % 3], f.v[(k + 2) % 3], shrink);
    }
    for (std::size_t v = 0; v < next.size(); ++v)
      mesh_.vertices[v].size = std::min(mesh_.vertices[v].size, next[v]);
    return any;
  }

  template <class Shrink>
  void near_miss(std::uint32_t apex, std::uint32_t u, std::uint32_t w, const Shrink& shrink) const {
    const auto free_u = mesh_.freedom_of(u);
    const auto free_w = mesh_.freedom_of(w);
    if (free_u == freedom::face || free_w == freedom::face)
      return;
    const double length = mesh_.length(u, w);
    // A short edge along a crease is still there where the crease bends, so that it may not go.
    const bool corners = free_u >= freedom::corner && free_w >= freedom::corner;
    const double share = corners || !mesh_.is_crease(u, w) ? 0.7 : 0.5;
    if (length < share * mesh_.size(u, w))
      for (const auto v : {u, w})
        shrink(v, length);
    if (length <= 0 || mesh_.freedom_of(apex) == freedom::face)
      return;
    const vec3 side = at(w) - at(u);
    const double along = dot(at(apex) - at(u), side) / (length * length);
    if (along <= 0.05 || along >= 0.95 || (mesh_.is_crease(apex, u) && mesh_.is_crease(apex, w)))
      return;
    const double gap = norm(cross(at(apex) - at(u), side)) / length;
    for (const auto v : {apex, u, w})
      shrink(v, gap);
  }

  surface_mesh& mesh_;
  clean_settings settings_;
  const cancel_token& cancel_;
  std::vector<double> size_before_;
  double least_fine_ = 0;  ///< m.
};

}  // namespace

void clean_surface(surface_mesh& mesh, const clean_settings& settings, const cancel_token& cancel) {
  mesh.crease_cosine = settings.fine ? surface_mesh::any_bend : surface_mesh::sharp;
  cleaner(mesh, settings, cancel).run();
  mesh.crease_cosine = surface_mesh::sharp;
}

}  // namespace tedit::ops
