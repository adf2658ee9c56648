// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scan/mesher/remesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scan/mesher/working_surface.hpp"

namespace tedit::scan {

namespace {

// Botsch and Kobbelt 2004: edges longer than 4/3 are halved, those shorter than 4/5 contracted.
constexpr double too_long = 4.0 / 3;
constexpr double too_short = 4.0 / 5;
constexpr int sweeps = 10;
constexpr int last_sweeps = 4;  ///< Which change no vertices' number.
constexpr double growth = 0.5;  ///< Of edge lengths over a way.
/// A triangle may turn by so much in one step, in terms of the cosine (45 degrees).
constexpr double least_cosine = 0.7;
constexpr double poor = 0.3;  ///< Quality below which a triangle's turning does not count.

class remesher {
public:
  using vertex = working_surface::vertex;

  remesher(const surface_part& part, const edge_lengths& lengths)
      : base_(part), lengths_(lengths), mesh_(base_) {}

  cad::surface_mesh run(const std::function<void(double)>& stage) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      stage(static_cast<double>(sweep) / (sweeps + last_sweeps));
      find_sizes();
      split_long();
      find_sizes();
      contract_short();
      flip_all();
      smooth();
    }
    for (int sweep = 0; sweep < last_sweeps; ++sweep) {
      flip_all();
      smooth();
    }
    return result();
  }

private:
  // -- sizes ------------------------------------------------------------------------

  double wanted_on(vec3 p, std::uint32_t patch) const {
    const double most = lengths_.of_solid[base_.part().solid_of[patch]];
    const double round =
      2 * std::numbers::pi / lengths_.on_circle * base_.radius_at(p, patch, most);
    return std::min(most, std::max(lengths_.shortest, round));
  }

  void find_sizes() {
    size_.assign(mesh_.point_count(), 0);
    std::vector<std::pair<double, vertex>> order;
    for (vertex v = 0; v < mesh_.point_count(); ++v) {
      double least = HUGE_VAL;
      for (const auto patch : patches_at(v))
        least = std::min(least, wanted_on(mesh_.point(v), patch));
      size_[v] = least;
      if (!mesh_.around(v).empty())
        order.emplace_back(least, v);
    }
    // From the finest on: each is looked at once, as none grows again.
    std::ranges::sort(order);
    for (int pass = 0; pass < 3; ++pass)
      for (const auto& [size, v] : order)
        for (const auto t : mesh_.around(v))
          for (const auto w : mesh_.corners(t))
            size_[w] =
              std::min(size_[w], size_[v] + growth * norm(mesh_.point(w) - mesh_.point(v)));
  }

  std::vector<std::uint32_t> patches_at(vertex v) const {
    std::vector<std::uint32_t> found;
    for (const auto t : mesh_.around(v))
      found.push_back(mesh_.patch(t));
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    return found;
  }

  /// The length of an edge in terms of what is wanted.
  double relative_length(vertex a, vertex b) const {
    return norm(mesh_.point(b) - mesh_.point(a)) / (0.5 * (size_[a] + size_[b]));
  }

  // -- splitting --------------------------------------------------------------------

  /// The point of the surface at the middle of an edge; where that is so far off that halves would
  /// not be shorter, the middle itself.
  vec3 middle_of(vertex a, vertex b) const {
    constexpr double farthest = 0.25;
    const vec3 p = 0.5 * (mesh_.point(a) + mesh_.point(b));
    const double length = norm(mesh_.point(b) - mesh_.point(a));
    const auto two = mesh_.beside(a, b);
    const vec3 at = mesh_.is_line(a, b)
                      ? base_.on_line(p, mesh_.patch(two[0]), mesh_.patch(two[1]), 0.5 * length)
                      : base_.on_patch(p, mesh_.patch(two[0]), 0.5 * length);
    return norm(at - p) <= farthest * length ? at : p;
  }

  /// The longest first: halves of one are not looked at before all others.
  void split_long() {
    constexpr int most_rounds = 8;
    for (int round = 0; round < most_rounds; ++round) {
      std::vector<std::tuple<double, vertex, vertex>> edges;
      for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t)
        for (int k = 0; mesh_.is_live(t) && k < 3; ++k) {
          const auto a = mesh_.corners(t)[k];
          const auto b = mesh_.corners(t)[(k + 1) % 3];
          if (a < b && relative_length(a, b) > too_long)
            edges.emplace_back(-relative_length(a, b), a, b);
        }
      if (edges.empty())
        return;
      std::ranges::sort(edges);
      for (const auto& [length, a, b] : edges) {
        if (mesh_.beside(a, b).size() != 2)
          continue;
        const auto at = middle_of(a, b);
        mesh_.split(a, b, at);
        size_.push_back(0.5 * (size_[a] + size_[b]));
      }
    }
  }

  // -- contracting ------------------------------------------------------------------

  void contract_short() {
    std::vector<std::tuple<double, vertex, vertex>> edges;
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t)
      for (int k = 0; mesh_.is_live(t) && k < 3; ++k) {
        const auto a = mesh_.corners(t)[k];
        const auto b = mesh_.corners(t)[(k + 1) % 3];
        if (a < b && relative_length(a, b) < too_short)
          edges.emplace_back(relative_length(a, b), a, b);
      }
    std::ranges::sort(edges);
    for (const auto& [length, a, b] : edges) {
      if (mesh_.beside(a, b).size() != 2 || relative_length(a, b) >= too_short)
        continue;
      const int rank_a = rank(a);
      const int rank_b = rank(b);
      if (rank_a <= rank_b && contract(a, b))
        continue;
      if (rank_b <= rank_a)
        (void)contract(b, a);
    }
  }

  /// 0: within a patch; 1: on a line; 2: a corner.
  int rank(vertex v) const {
    return mesh_.line_neighbours(v).empty() ? 0 : mesh_.is_corner(v) ? 2 : 1;
  }

  bool contract(vertex gone, vertex kept) {
    if (!mesh_.may_merge(gone, kept) || !keeps_form(gone, kept))
      return false;
    mesh_.merge(gone, kept);
    return true;
  }

  /// No triangle turns over, none gets an edge that would be halved again.
  bool keeps_form(vertex gone, vertex kept) const {
    for (const auto t : mesh_.around(gone)) {
      auto c = mesh_.corners(t);
      if (std::ranges::find(c, kept) != c.end())
        continue;
      const vec3 before = mesh_.normal_of(c);
      const double quality = mesh_.quality_of(c);
      std::ranges::replace(c, gone, kept);
      if (!faces_outward(c, mesh_.patch(t), before, quality))
        return false;
      for (const auto v : c)
        if (v != kept && relative_length(v, kept) > too_long)
          return false;
    }
    return line_stays_near(gone, kept);
  }

  /// A line's vertex goes only where the line hardly bends, or there are more than are wanted.
  bool line_stays_near(vertex gone, vertex kept) const {
    const auto ends = mesh_.line_neighbours(gone);
    if (ends.size() != 2)
      return true;
    const auto other = ends[0] == kept ? ends[1] : ends[0];
    const vec3 in = normalized(mesh_.point(gone) - mesh_.point(kept));
    const vec3 out = normalized(mesh_.point(other) - mesh_.point(gone));
    const double turn = std::acos(std::clamp(dot(in, out), -1.0, 1.0));
    return turn <= 1.05 * std::numbers::pi / lengths_.on_circle;
  }

  // -- form -------------------------------------------------------------------------

  /// Along the shape's normal where there is one, else as before.
  bool faces_outward(const triangle_corners& c, std::uint32_t patch, vec3 before,
                     double quality_before) const {
    const vec3 n = normalized(mesh_.normal_of(c));
    const auto& shape = base_.part().shapes[patch];
    if (shape.form == surface_form::free)
      return quality_before < 0.02 ||
             dot(n, normalized(before)) > (quality_before < poor ? 0.3 : least_cosine);
    const vec3 middle = (mesh_.point(c[0]) + mesh_.point(c[1]) + mesh_.point(c[2])) / 3;
    return side_of(patch) * dot(n, shape.normal(middle)) > 0.5;
  }

  /// Whether a patch looks along the normals of its shape, or against them.
  double side_of(std::uint32_t patch) const {
    if (sides_.empty()) {
      std::vector<double> sums(base_.part().shapes.size(), 0);
      const auto& surface = base_.part().surface;
      for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& v = surface.triangles[t];
        const vec3 a = surface.points[v[0]];
        const vec3 b = surface.points[v[1]];
        const vec3 c = surface.points[v[2]];
        const auto patch_of = base_.part().patch_of[t];
        sums[patch_of] +=
          dot(cross(b - a, c - a), base_.part().shapes[patch_of].normal((a + b + c) / 3));
      }
      for (const double sum : sums)
        sides_.push_back(sum < 0 ? -1 : 1);
    }
    return sides_[patch];
  }

  /// How far the middle of an edge is off the surface, in terms of its length.
  double sagging(vertex a, vertex b, std::uint32_t patch) const {
    const vec3 p = 0.5 * (mesh_.point(a) + mesh_.point(b));
    const double length = norm(mesh_.point(b) - mesh_.point(a));
    return length > 0 ? norm(p - base_.on_patch(p, patch, 0.5 * length)) / length : 0;
  }

  // -- flipping ---------------------------------------------------------------------

  void flip_all() {
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t)
      for (int k = 0; mesh_.is_live(t) && k < 3; ++k)
        if (const auto a = mesh_.corners(t)[k], b = mesh_.corners(t)[(k + 1) % 3];
            mesh_.can_flip(a, b) && gains_by_flip(a, b))
          mesh_.flip(a, b);
  }

  bool gains_by_flip(vertex a, vertex b) const {
    const auto two = mesh_.beside(a, b);
    auto first = mesh_.corners(two[0]);
    auto second = mesh_.corners(two[1]);
    const double before = std::min(mesh_.quality_of(first), mesh_.quality_of(second));
    const auto c = mesh_.opposite(two[0], a, b);
    const auto d = mesh_.opposite(two[1], a, b);
    const vec3 normal = mesh_.normal_of(first) + mesh_.normal_of(second);
    std::ranges::replace(first, b, d);
    std::ranges::replace(second, a, c);
    const double after = std::min(mesh_.quality_of(first), mesh_.quality_of(second));
    const auto patch = mesh_.patch(two[0]);
    constexpr double least_gain = 1.01;
    if (after <= least_gain * before || !faces_outward(first, patch, normal, 1) ||
        !faces_outward(second, patch, normal, 1))
      return false;
    // As a chord of a quarter sags less than a fifth, a cut across a round wall is told by it.
    constexpr double may_sag = 0.1;
    return before < 0.05 || sagging(c, d, patch) <= std::max(may_sag, sagging(a, b, patch));
  }

  // -- smoothing --------------------------------------------------------------------

  void smooth() {
    for (vertex v = 0; v < mesh_.point_count(); ++v) {
      if (mesh_.around(v).empty())
        continue;
      const auto ends = mesh_.line_neighbours(v);
      if (ends.empty())
        smooth_inner(v);
      else if (ends.size() == 2 && !mesh_.is_corner(v))
        smooth_on_line(v, ends);
    }
  }

  void smooth_inner(vertex v) {
    vec3 sum;
    double weight = 0;
    double reach = 0;
    for (const auto t : mesh_.around(v)) {
      const auto& c = mesh_.corners(t);
      const vec3 middle = (mesh_.point(c[0]) + mesh_.point(c[1]) + mesh_.point(c[2])) / 3;
      const double size = (size_[c[0]] + size_[c[1]] + size_[c[2]]) / 3;
      const double share = norm(mesh_.normal_of(c)) / (size * size);
      sum += share * middle;
      weight += share;
      reach = std::max(reach, norm(middle - mesh_.point(v)));
    }
    if (weight > 0)
      try_to_move(v, base_.on_patch(sum / weight, mesh_.patch(mesh_.around(v).front()), reach));
  }

  void smooth_on_line(vertex v, const std::vector<vertex>& ends) {
    const vec3 middle = 0.5 * (mesh_.point(ends[0]) + mesh_.point(ends[1]));
    const auto two = mesh_.beside(v, ends[0]);
    const auto three = mesh_.beside(v, ends[1]);
    // Where other patches begin the line is another one, though it goes straight on.
    const auto key = key_of(mesh_.patch(two[0]), mesh_.patch(two[1]));
    if (key != key_of(mesh_.patch(three[0]), mesh_.patch(three[1])))
      return;
    const double reach = norm(middle - mesh_.point(ends[0]));
    try_to_move(v, base_.on_line(middle, key.first, key.second, reach));
  }

  /// Where no triangle around turns over, and the worst does not get worse.
  void try_to_move(vertex v, vec3 to) {
    const vec3 from = mesh_.point(v);
    double before = 1;
    std::vector<std::pair<vec3, double>> was;
    for (const auto t : mesh_.around(v)) {
      const double quality = mesh_.quality_of(mesh_.corners(t));
      was.emplace_back(mesh_.normal_of(mesh_.corners(t)), quality);
      before = std::min(before, quality);
    }
    for (const double share : {1.0, 0.5, 0.25}) {
      mesh_.move(v,
                 share == 1 ? to : back_on_surface(v, from + share * (to - from), norm(to - from)));
      double after = 1;
      bool sound = true;
      for (std::size_t i = 0; i < was.size(); ++i) {
        const auto t = mesh_.around(v)[i];
        after = std::min(after, mesh_.quality_of(mesh_.corners(t)));
        sound =
          sound && faces_outward(mesh_.corners(t), mesh_.patch(t), was[i].first, was[i].second);
      }
      if (sound && (after >= before || after > poor))
        return;
    }
    mesh_.move(v, from);
  }

  vec3 back_on_surface(vertex v, vec3 p, double reach) const {
    const auto ends = mesh_.line_neighbours(v);
    if (ends.empty())
      return base_.on_patch(p, mesh_.patch(mesh_.around(v).front()), reach);
    const auto two = mesh_.beside(v, ends[0]);
    return base_.on_line(p, mesh_.patch(two[0]), mesh_.patch(two[1]), reach);
  }

  cad::surface_mesh result() const {
    cad::surface_mesh made;
    std::vector<std::uint32_t> place(mesh_.point_count(), no_id);
    for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
      if (!mesh_.is_live(t))
        continue;
      auto corners = mesh_.corners(t);
      for (auto& v : corners) {
        if (place[v] == no_id) {
          place[v] = static_cast<std::uint32_t>(made.points.size());
          made.points.push_back(mesh_.point(v));
        }
        v = place[v];
      }
      made.triangles.push_back({corners, static_cast<int>(mesh_.patch(t)) + 1});
    }
    return made;
  }

  ground base_;
  const edge_lengths& lengths_;
  working_surface mesh_;
  std::vector<double> size_;  ///< The edge length that is wanted at each vertex.
  mutable std::vector<double> sides_;
};

}  // namespace

edge_lengths lengths_for(const cad::part_facts& facts, const cad::fineness& size) {
  edge_lengths lengths;
  lengths.thinnest_wall = HUGE_VAL;
  lengths.on_circle = size.on_circle;
  for (const auto& solid : facts.solids) {
    const double wall = 2 * solid.volume_mm3 / solid.area_mm2;
    lengths.of_solid.push_back(size.wall_share * wall);
    lengths.longest = std::max(lengths.longest, size.wall_share * wall);
    lengths.thinnest_wall = std::min(lengths.thinnest_wall, wall);
  }
  lengths.shortest = cad::least_share * size.wall_share * lengths.thinnest_wall;
  return lengths;
}

cad::surface_mesh remesh(const surface_part& part, const edge_lengths& lengths,
                         const std::function<void(double)>& stage) {
  return remesher(part, lengths).run(stage);
}

}  // namespace tedit::scan
