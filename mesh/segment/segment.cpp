// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/segment/segment.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>

#include "mesh/box.hpp"
#include "mesh/segment/round_patches.hpp"

namespace tedit {

namespace {

constexpr double smooth_cosine = 0.766;  ///< 40 degrees.
/// A flat facet is a plane of its own when it is so much larger than what it goes over into.
constexpr double plane_share = 6;
/// After so many facets on nothing round the rest is taken to be free form, too: a scan.
constexpr int most_failures = 2000;
/// Small facets go with the shape beside them when they are that near, in terms of its radius and
/// of the tolerance.
constexpr double near_share = 0.01;
constexpr double near_tolerances = 50;
/// ... and that small, in terms of the patch.
constexpr double small_share = 0.1;

class segmenter {
public:
  segmenter(const triangle_surface& surface, const segment_limits& limits,
            const std::vector<std::uint32_t>& groups)
      : tolerance_(limits.tolerance),
        groups_(groups),
        net_(surface, limits.tolerance, groups),
        patch_of_(net_.facets().size(), no_id),
        finder_(surface, net_, limits.tolerance, groups, patch_of_) {}

  segmentation run() {
    take_round();
    give_back_rows();
    take_planes();
    take_free();
    absorb_small();
    return result();
  }

private:
  [[nodiscard]] const std::vector<flat_facet>& facets() const { return net_.facets(); }
  [[nodiscard]] double area(std::uint32_t f) const { return norm(facets()[f].area); }
  [[nodiscard]] bool same_group(std::uint32_t f, std::uint32_t g) const {
    return groups_.empty() ||
           groups_[facets()[f].triangles.front()] == groups_[facets()[g].triangles.front()];
  }

  std::uint32_t add(fitted_shape shape) {
    shapes_.push_back(shape);
    areas_.push_back(0);
    return static_cast<std::uint32_t>(shapes_.size() - 1);
  }

  void put(std::uint32_t facet, std::uint32_t patch) {
    patch_of_[facet] = patch;
    areas_[patch] += area(facet);
  }

  void take_round() {
    std::vector<std::uint32_t> order(facets().size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, [&](auto f, auto g) { return area(f) > area(g); });
    int failures = 0;
    for (const auto seed : order) {
      if (patch_of_[seed] != no_id || failures > most_failures)
        continue;
      const auto found = finder_.around(seed);
      failures = found ? 0 : failures + 1;
      if (!found)
        continue;
      const auto patch = add(found->shape);
      for (const auto f : found->facets)
        put(f, patch);
    }
  }

  // -- rows -------------------------------------------------------------------------

  /// Two round patches each of whose facets goes over into one of the other.
  struct row_pair {
    std::uint32_t other;
    double bend;
  };

  [[nodiscard]] std::vector<std::vector<row_pair>> pairs_of_rows() const {
    struct contact {
      std::size_t facets = 0;
      double bend = 0;
      double length = 0;
    };
    std::vector<std::size_t> count(shapes_.size(), 0);
    std::map<std::pair<std::uint32_t, std::uint32_t>, contact> contacts;
    for (std::uint32_t f = 0; f < facets().size(); ++f) {
      const auto mine = patch_of_[f];
      if (mine == no_id)
        continue;
      ++count[mine];
      std::set<std::uint32_t> met;
      for (const auto& link : facets()[f].links) {
        const auto other = patch_of_[link.other];
        if (other == no_id || other == mine || link.cosine < smooth_cosine)
          continue;
        auto& one = contacts[{mine, other}];
        one.facets += met.insert(other).second;
        one.bend += link.length * std::acos(std::min(1.0, link.cosine));
        one.length += link.length;
      }
    }
    std::vector<std::vector<row_pair>> pairs(shapes_.size());
    constexpr double most_of_them = 0.6;
    const auto along = [&](std::uint32_t a, std::uint32_t b) {
      return static_cast<double>(contacts[{a, b}].facets) >=
             most_of_them * static_cast<double>(count[a]);
    };
    for (const auto& [key, one] : std::map(contacts))
      if (along(key.first, key.second) && along(key.second, key.first))
        pairs[key.first].push_back({key.second, one.bend / one.length});
    return pairs;
  }

  /// Each row of a torus is a cone, too: three side by side that bend alike are free form.
  void give_back_rows() {
    constexpr double alike = 0.25;
    const auto pairs = pairs_of_rows();
    std::set<std::uint32_t> rows;
    for (std::uint32_t r = 0; r < pairs.size(); ++r)
      for (std::size_t i = 0; i < pairs[r].size(); ++i)
        for (std::size_t k = i + 1; k < pairs[r].size(); ++k)
          if (std::abs(pairs[r][i].bend - pairs[r][k].bend) <= alike * pairs[r][i].bend)
            rows.insert({r, pairs[r][i].other, pairs[r][k].other});
    for (auto& patch : patch_of_)
      if (patch != no_id && rows.contains(patch))
        patch = no_id;
  }

  // -- planes and free forms --------------------------------------------------------

  /// What a facet must be larger than to be a plane, of all that hang together without an edge:
  /// most of them, in terms of area. A free form of a scan has some large triangles, too.
  void find_usual_areas() {
    constexpr std::size_t few = 8;
    usual_area_.assign(facets().size(), -1);
    for (std::uint32_t seed = 0; seed < facets().size(); ++seed) {
      if (patch_of_[seed] != no_id || usual_area_[seed] >= 0)
        continue;
      std::vector<std::uint32_t> found{seed};
      usual_area_[seed] = 0;
      for (std::size_t i = 0; i < found.size(); ++i)
        for (const auto& link : facets()[found[i]].links)
          if (link.cosine >= smooth_cosine && patch_of_[link.other] == no_id &&
              usual_area_[link.other] < 0 && same_group(seed, link.other)) {
            usual_area_[link.other] = 0;
            found.push_back(link.other);
          }
      if (found.size() <= few)
        continue;
      std::vector<double> areas;
      for (const auto f : found)
        areas.push_back(area(f));
      const auto most = areas.begin() + static_cast<std::ptrdiff_t>(3 * areas.size() / 4);
      std::ranges::nth_element(areas, most);
      for (const auto f : found)
        usual_area_[f] = *most;
    }
  }

  /// Is it much larger than most of what it goes over into without an edge, or is there nothing?
  /// `first`: nor is it plane where only little of its outline does.
  [[nodiscard]] bool is_plane(std::uint32_t f, bool first) const {
    constexpr double little = 0.3;
    std::vector<std::pair<double, double>> around;  // Area, length.
    double smooth = 0;
    double outline = 0;
    for (const auto& link : facets()[f].links) {
      outline += link.length;
      if (link.cosine < smooth_cosine || patch_of_[link.other] != no_id ||
          !same_group(f, link.other))
        continue;
      around.emplace_back(area(link.other), link.length);
      smooth += link.length;
    }
    if (around.empty())
      return true;
    if (area(f) <= plane_share * usual_area_[f])
      return false;
    if (first && smooth < little * outline)
      return true;
    std::ranges::sort(around);
    double so_far = 0;
    for (const auto& [other, length] : around)
      if (so_far += length; so_far >= 0.5 * smooth)
        return area(f) > plane_share * other;
    return false;
  }

  /// Again, as a strip between two planes is one, too.
  void take_planes() {
    find_usual_areas();
    for (bool first = true, again = true; again; first = false) {
      std::vector<std::uint32_t> planes;
      for (std::uint32_t f = 0; f < facets().size(); ++f)
        if (patch_of_[f] == no_id && is_plane(f, first))
          planes.push_back(f);
      for (const auto f : planes) {
        fitted_shape shape{surface_form::plane, {}};
        shape.wall.point = facets()[f].middle;
        shape.wall.axis = normalized(facets()[f].area);
        put(f, add(shape));
      }
      again = !planes.empty();
    }
  }

  void take_free() {
    for (std::uint32_t seed = 0; seed < facets().size(); ++seed) {
      if (patch_of_[seed] != no_id)
        continue;
      const auto patch = add({});
      put(seed, patch);
      std::vector<std::uint32_t> found{seed};
      for (std::size_t i = 0; i < found.size(); ++i)
        for (const auto& link : facets()[found[i]].links)
          if (link.cosine >= smooth_cosine && patch_of_[link.other] == no_id &&
              same_group(seed, link.other)) {
            put(link.other, patch);
            found.push_back(link.other);
          }
    }
  }

  /// A free form or plane next to nothing beside a shape on which it lies but for a mesher's
  /// rounding is a part of that.
  void absorb_small() {
    for (bool again = true; again;) {
      again = false;
      for (std::uint32_t f = 0; f < facets().size(); ++f)
        if (const auto into = absorbing(f); into != no_id) {
          areas_[patch_of_[f]] -= area(f);
          put(f, into);
          again = true;
        }
    }
  }

  [[nodiscard]] std::uint32_t absorbing(std::uint32_t f) const {
    const auto mine = patch_of_[f];
    const auto form = shapes_[mine].form;
    if (form != surface_form::free && form != surface_form::plane)
      return no_id;
    std::uint32_t best = no_id;
    double longest = 0;
    for (const auto& link : facets()[f].links) {
      const auto other = patch_of_[link.other];
      if (other == mine || !same_group(f, link.other) || link.length <= longest ||
          shapes_[other].form == surface_form::free || areas_[mine] > small_share * areas_[other])
        continue;
      const double most =
        std::max(near_tolerances * tolerance_, near_share * shapes_[other].wall.radius);
      if (!finder_.lies_on(shapes_[other], f, most))
        continue;
      best = other;
      longest = link.length;
    }
    return best;
  }

  /// Patches in the order of their first triangles.
  segmentation result() const {
    segmentation made;
    std::vector<std::uint32_t> place(shapes_.size(), no_id);
    for (const auto f : net_.facet_of()) {
      auto& at = place[patch_of_[f]];
      if (at == no_id) {
        at = static_cast<std::uint32_t>(made.shapes.size());
        made.shapes.push_back(shapes_[patch_of_[f]]);
      }
      made.patch_of.push_back(at);
    }
    return made;
  }

  double tolerance_;
  const std::vector<std::uint32_t>& groups_;
  facet_net net_;
  std::vector<std::uint32_t> patch_of_;  ///< Of each facet.
  round_finder finder_;
  std::vector<fitted_shape> shapes_;
  std::vector<double> areas_;       ///< Of each patch.
  std::vector<double> usual_area_;  ///< Of the facets around each facet.
};

}  // namespace

segment_limits limits_for(const triangle_surface& surface) {
  box extent;
  for (const auto& p : surface.points)
    extent.add(p);
  return {surface.points.empty() ? 0 : 2e-6 * norm(extent.high - extent.low)};
}

segmentation segment_surface(const triangle_surface& surface, const segment_limits& limits,
                             const std::vector<std::uint32_t>& groups) {
  return segmenter(surface, limits, groups).run();
}

std::string name_of(const fitted_shape& shape, surface_id id, double unit_mm) {
  auto name = std::string(name_of(shape.form)) + " " + std::to_string(id);
  if (shape.form == surface_form::cylinder || shape.form == surface_form::sphere) {
    char text[32];
    std::snprintf(text, sizeof(text), " d %.4g mm", 2 * shape.wall.radius * unit_mm);
    name += text;
  }
  return name;
}

}  // namespace tedit
