// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/print/print_checks.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"
#include "mesh/box_tree.hpp"
#include "mesh/distances.hpp"
#include "mesh/predicates.hpp"
#include "mesh/print/print_places.hpp"

namespace tedit {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Sides of a wall may differ by this from facing each other's back.
const double facing = std::cos(30 * degree);
/// A wall of just the thickness, or just the lean, is none that is too thin or leans too much.
constexpr double ray_rounding = 1e-9;
/// What lies on the plate, as a share of the part's size.
constexpr double on_plate = 1e-6;
/// So that no ray slips through between two triangles.
constexpr double triangle_grown = 1e-9;
constexpr int most_parts = 4;  ///< Of a facet's edge.

struct live_facet {
  facet_id slot = 0;
  std::array<vec3, 3> corners;
  vec3 normal;
  double area = 0;
};

std::vector<live_facet> live_facets(const mesh_version& mesh) {
  std::vector<live_facet> result;
  result.reserve(mesh.facet_count());
  for (facet_id f = 0; f < mesh.facet_slots(); ++f) {
    if (!mesh.is_live_facet(f))
      continue;
    const auto& v = mesh.facet(f).v;
    const vec3 area = area_vector(mesh, mesh.facet(f));
    result.push_back({f,
                      {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])},
                      normalized(area),
                      norm(area)});
  }
  return result;
}

std::vector<box> boxes_of(const std::vector<live_facet>& facets) {
  std::vector<box> result;
  result.reserve(facets.size());
  for (const auto& facet : facets)
    result.push_back(box_of(facet.corners));
  return result;
}

/// The middles of the n x n equal triangles that a triangle can be parted into.
template <class Visit>
void for_each_middle(const std::array<vec3, 3>& p, int n, const Visit& visit) {
  const vec3 one = (p[1] - p[0]) / n;
  const vec3 two = (p[2] - p[0]) / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      visit(p[0] + (i + 1.0 / 3) * one + (j + 1.0 / 3) * two);
      if (i + j < n - 1)
        visit(p[0] + (i + 2.0 / 3) * one + (j + 2.0 / 3) * two);
    }
}

/// The thinnest place of a facet.
struct thin_spot {
  double thickness = infinite;
  double share = 0;  ///< Of its area that is thin.
  vec3 at;
  std::uint32_t behind = no_id;  ///< The facet on the other side.
};

class wall_meter {
public:
  wall_meter(const std::vector<live_facet>& facets, const box_tree& tree, double thinner_than)
      : facets_(facets), tree_(tree), most_(thinner_than * (1 - ray_rounding)) {}

  [[nodiscard]] thin_spot measure(std::uint32_t i) const {
    const auto& facet = facets_[i];
    const auto& p = facet.corners;
    const double longest = std::max({norm(p[1] - p[0]), norm(p[2] - p[1]), norm(p[0] - p[2])});
    const int parts =
      std::clamp(static_cast<int>(std::min(longest / most_, 1e3) / 2) + 1, 1, most_parts);
    thin_spot spot;
    int thin = 0;
    for_each_middle(p, parts, [&](vec3 at) {
      const auto [distance, behind] = depth(i, at);
      if (!(distance < most_))
        return;
      ++thin;
      if (distance < spot.thickness)
        spot = {distance, 0, at, behind};
    });
    spot.share = static_cast<double>(thin) / (parts * parts);
    return spot;
  }

private:
  /// How far it is straight in to where the material ends, and through which facet; infinite where
  /// that is no other side of a wall.
  [[nodiscard]] std::pair<double, std::uint32_t> depth(std::uint32_t i, vec3 at) const {
    const vec3 in = -facets_[i].normal;
    box reach;
    reach.add(at);
    reach.add(at + most_ * in);
    double nearest = infinite;
    std::uint32_t behind = no_id;
    (void)tree_.any_meeting(reach.grown(triangle_grown * most_), [&](std::size_t k) {
      if (k == i)
        return false;
      const auto& q = facets_[k].corners;
      const vec3 middle = (q[0] + q[1] + q[2]) / 3;
      std::array<vec3, 3> grown;
      for (std::size_t c = 0; c < 3; ++c)
        grown[c] = q[c] + triangle_grown * (q[c] - middle);
      const auto hit = ray_through(grown, at, in);
      if (hit && hit->leaves && hit->distance < nearest) {
        nearest = hit->distance;
        behind = static_cast<std::uint32_t>(k);
      }
      return false;
    });
    const bool is_wall = behind != no_id && dot(facets_[behind].normal, in) > facing;
    return {is_wall ? nearest : infinite, behind};
  }

  const std::vector<live_facet>& facets_;
  const box_tree& tree_;
  double most_;
};

class print_checker {
public:
  print_checker(const mesh_version& mesh, const print_settings& settings, const execution& run)
      : mesh_(mesh),
        settings_(settings),
        run_(run),
        facets_(live_facets(mesh)),
        tree_(boxes_of(facets_)) {}

  expected<print_report> run() {
    report_.volume = total_volume(mesh_);
    for (const auto& facet : facets_)
      report_.area += facet.area;
    report_.extent = tree_.extent();
    const shells parts(mesh_);
    report_.bodies = parts.outward;
    report_.closed_voids = parts.inward;
    report_.open_edges = parts.open_edges;
    report_.hinge_edges = parts.hinge_edges;
    report_.thickness.assign(mesh_.facet_slots(), infinite);
    report_.overhanging.assign(mesh_.facet_slots(), false);
    if (facets_.empty())
      return std::move(report_);
    run_.report(0.1, "looking for crossing facets");
    find_crossings();
    if (settings_.thinner_than > 0) {
      run_.report(0.5, "measuring walls");
      find_thin_walls();
    }
    run_.report(0.9, "looking for overhangs");
    find_overhangs();
    if (run_.cancel.cancelled())
      return fail(ec::cancelled, "the check was cancelled");
    return std::move(report_);
  }

private:
  /// On all cores; what is left is skipped after a cancel.
  void for_each_facet(const std::function<void(std::uint32_t)>& look) const {
    constexpr std::size_t at_once = 256;
    parallel_for(
      facets_.size(),
      [&](std::size_t first, std::size_t last, std::size_t) {
        if (run_.cancel.cancelled())
          return;
        for (auto i = first; i < last; ++i)
          look(static_cast<std::uint32_t>(i));
      },
      at_once);
  }

  void find_crossings() {
    std::atomic<std::size_t> count{0};
    for_each_facet([&](std::uint32_t i) {
      const auto& mine = mesh_.facet(facets_[i].slot).v;
      const bool crosses = tree_.any_meeting(box_of(facets_[i].corners), [&](std::size_t k) {
        const auto& other = mesh_.facet(facets_[k].slot).v;
        const bool share = std::ranges::any_of(
          mine, [&](vertex_id v) { return std::ranges::find(other, v) != other.end(); });
        return !share && triangles_intersect(facets_[i].corners, facets_[k].corners);
      });
      count += crosses;
    });
    report_.crossing_facets = count;
  }

  void find_thin_walls() {
    const wall_meter meter(facets_, tree_, settings_.thinner_than);
    std::vector<thin_spot> spots(facets_.size());
    for_each_facet([&](std::uint32_t i) { spots[i] = meter.measure(i); });
    place_finder places(mesh_, /*least_is_worst=*/true);
    for (std::size_t i = 0; i < spots.size(); ++i)
      if (spots[i].behind != no_id) {
        report_.thickness[facets_[i].slot] = spots[i].thickness;
        report_.thin_area += spots[i].share * facets_[i].area;
        places.add(facets_[i].slot, spots[i].share * facets_[i].area, spots[i].thickness,
                   spots[i].at);
      }
    for (std::size_t i = 0; i < spots.size(); ++i)
      if (spots[i].behind != no_id)
        places.join(facets_[i].slot, facets_[spots[i].behind].slot);
    report_.thin = places.places();
  }

  void find_overhangs() {
    double lowest = infinite;
    for (const auto& facet : facets_)
      for (const auto& p : facet.corners)
        lowest = std::min(lowest, dot(p, settings_.up));
    const double plate = lowest + on_plate * norm(report_.extent.high - report_.extent.low);
    const double most_down = std::sin(settings_.lean) + ray_rounding;
    place_finder places(mesh_, /*least_is_worst=*/false);
    for (const auto& facet : facets_) {
      const double down = -dot(facet.normal, settings_.up);
      const bool lies =
        std::ranges::all_of(facet.corners, [&](vec3 p) { return dot(p, settings_.up) <= plate; });
      if (lies && down > 0)
        report_.plate_area += facet.area;
      if (lies || down <= most_down)
        continue;
      report_.overhanging[facet.slot] = true;
      report_.overhang_area += facet.area;
      places.add(facet.slot, facet.area, std::asin(std::min(1.0, down)),
                 (facet.corners[0] + facet.corners[1] + facet.corners[2]) / 3);
    }
    report_.overhangs = places.places();
  }

  const mesh_version& mesh_;
  print_settings settings_;
  const execution& run_;
  std::vector<live_facet> facets_;
  box_tree tree_;
  print_report report_;
};

}  // namespace

print_mark mark_of(const print_report& report, facet_id facet) {
  const bool is_thin = std::isfinite(report.thickness[facet]);
  if (report.overhanging[facet])
    return is_thin ? print_mark::both : print_mark::overhang;
  return is_thin ? print_mark::thin : print_mark::sound;
}

expected<print_report> check_print(const mesh_version& mesh, const print_settings& settings,
                                   const execution& run) {
  auto asked = settings;
  asked.up = normalized(settings.up);
  if (!is_finite(asked.up) || norm(asked.up) == 0)
    return fail(ec::invalid_argument, "the build direction has no length",
                "Take three numbers that are not all zero, as 0,0,1");
  return print_checker(mesh, asked, run).run();
}

}  // namespace tedit
