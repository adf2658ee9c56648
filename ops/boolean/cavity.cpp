// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/boolean/cavity.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <unordered_map>

#include "ops/boolean/tets_in_box.hpp"

namespace tedit::ops {

namespace {

/// A tool that reaches less far into a tet, as a share of it, only touches it.
constexpr double reaches_in = 1e-6;

/// Where two regions have to agree, one that is no further off touches it, too: it may be put on
/// their interface.
constexpr double nearly_touches = 1e-3;

/// How far around the tool's box tets are looked at, as shares of it: those that it only touches
/// hang together outside of it, those that nearly touch it lie there.
constexpr double around = 1e-6;
constexpr double around_bonded = 0.05;

using points3 = std::array<vec3, 3>;
using points4 = std::array<vec3, 4>;

template <class Points>
std::pair<double, double> extent_along(const Points& points, vec3 axis) {
  double low = 1e300;
  double high = -1e300;
  for (const auto& p : points) {
    low = std::min(low, dot(p, axis));
    high = std::max(high, dot(p, axis));
  }
  return {low, high};
}

/// By separating axes. With a `share` of zero they meet where they only touch, too; with a positive
/// one they must reach into each other by that share of the tet along every axis, with a negative
/// one they may be so far apart.
bool meet(const points3& t, const points4& tet, double share = 0) {
  const auto apart = [&](vec3 axis) {
    const double length = norm(axis);
    if (length == 0)
      return false;
    const auto [low, high] = extent_along(t, axis);
    const auto [from, to] = extent_along(tet, axis);
    const double slack = 1e-12 * (std::abs(low) + std::abs(high)) - share * (to - from);
    return low > to + slack || high < from - slack;
  };
  const std::array edges{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  if (apart(cross(edges[0], edges[1])))
    return false;
  for (const auto& f : tet_faces)
    if (apart(cross(tet[f[1]] - tet[f[0]], tet[f[2]] - tet[f[0]])))
      return false;
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b)
      for (const auto& edge : edges)
        if (apart(cross(edge, tet[b] - tet[a])))
          return false;
  return true;
}

struct edge_key {
  std::uint64_t value;
  edge_key(std::uint32_t a, std::uint32_t b)
      : value((std::uint64_t{std::min(a, b)} << 32) | std::max(a, b)) {}
  [[nodiscard]] vertex_id first() const { return static_cast<vertex_id>(value >> 32); }
  [[nodiscard]] vertex_id second() const { return static_cast<vertex_id>(value); }
};

points3 corners_of(const tool_surface& tool, std::size_t triangle) {
  const auto& t = tool.triangles[triangle];
  return {tool.points[t[0]], tool.points[t[1]], tool.points[t[2]]};
}

std::vector<box> boxes_of(const tool_surface& tool) {
  std::vector<box> boxes;
  for (std::size_t i = 0; i < tool.triangles.size(); ++i)
    boxes.push_back(box_of(corners_of(tool, i)));
  return boxes;
}

bool holds(const tet& t, vertex_id v) {
  return std::ranges::find(t.v, v) != t.v.end();
}

/// One cavity under way: it grows until its surface has two triangles at each edge.
class growing_cavity {
public:
  growing_cavity(const mesh_version& mesh, const std::vector<tet_id>& first)
      : mesh_(mesh), is_in_(mesh.tet_slots()) {
    for (const auto t : first)
      add(t);
  }

  void add(tet_id t) {
    if (is_in_[t])
      return;
    is_in_[t] = 1;
    tets_.push_back(t);
  }

  [[nodiscard]] bool holds_tet(tet_id t) const { return is_in_[t] != 0; }
  [[nodiscard]] const std::vector<tet_id>& tets() const { return tets_; }

  template <class Takes>
  void add_ring(const Takes& takes) {
    std::vector<vertex_id> corners;
    for (const auto t : tets_)
      for (const auto v : mesh_.tet_at(t).v)
        corners.push_back(v);
    std::ranges::sort(corners);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const auto t : tets_around(mesh_, corners))
      if (takes(t))
        add(t);
  }

  /// Calls visit(corners, tet or facet behind) for each triangle of a region's surface.
  template <class Visit>
  void for_each_side(region_id region, const Visit& visit) const {
    for (const auto t : tets_) {
      if (mesh_.region_of(t) != region)
        continue;
      const auto& corners = mesh_.tet_at(t).v;
      const auto& beside = mesh_.neighbours(t);
      for (int k = 0; k < 4; ++k) {
        if (!is_facet(beside[k]) && is_in_[beside[k]] && mesh_.region_of(beside[k]) == region)
          continue;
        const auto& f = tet_faces[k];
        visit(std::array{corners[f[0]], corners[f[1]], corners[f[2]]}, beside[k]);
      }
    }
  }

  /// With tets of these regions alone: against others the surface stays as it is. False where the
  /// part's own boundary is at fault.
  bool grow_until_clean(const std::vector<region_id>& regions) {
    for (int round = 0; round < 16; ++round) {
      const auto before = tets_.size();
      bool clean = true;
      for (const auto region : regions)
        clean &= add_at_poor_edges(region);
      if (clean)
        return true;
      if (tets_.size() == before)
        return false;
    }
    return false;
  }

private:
  /// True where each edge of the region's surface has two triangles.
  bool add_at_poor_edges(region_id region) {
    std::unordered_map<std::uint64_t, int> count;
    for_each_side(region, [&](const auto& v, std::uint32_t) {
      for (int k = 0; k < 3; ++k)
        ++count[edge_key(v[k], v[(k + 1) % 3]).value];
    });
    std::vector<std::uint64_t> poor;
    for (const auto& [edge, faces] : count)
      if (faces != 2)
        poor.push_back(edge);
    std::ranges::sort(poor);
    for (const auto value : poor) {
      edge_key edge(0, 0);
      edge.value = value;
      for (const auto t : tets_around(mesh_, std::array{edge.first()}))
        if (holds(mesh_.tet_at(t), edge.second()) && mesh_.region_of(t) == region)
          add(t);
    }
    return poor.empty();
  }

  const mesh_version& mesh_;
  std::vector<std::uint8_t> is_in_;
  std::vector<tet_id> tets_;
};

/// The closed surface of each region, and what is behind.
void add_shares(cavity& result, const mesh_version& mesh, const growing_cavity& grown,
                const std::vector<region_id>& regions, const auto& stays) {
  std::unordered_map<vertex_id, std::uint32_t> place;
  for (const auto region : regions) {
    const auto first = static_cast<std::uint32_t>(result.surface.triangles.size());
    grown.for_each_side(region, [&](const auto& v, std::uint32_t behind) {
      std::array<std::uint32_t, 3> t{};
      for (int k = 0; k < 3; ++k) {
        const auto [row, fresh] =
          place.try_emplace(v[k], static_cast<std::uint32_t>(result.vertices.size()));
        if (fresh) {
          result.vertices.push_back(v[k]);
          result.surface.points.push_back(mesh.position(v[k]));
        }
        t[k] = row->second;
      }
      result.surface.triangles.push_back(t);
      cavity::side side;
      if (is_facet(behind))
        side.facet = behind & ~facet_flag;
      else if (!grown.holds_tet(behind))
        side.behind = behind;
      result.sides.push_back(side);
    });
    const auto last = static_cast<std::uint32_t>(result.surface.triangles.size());
    if (last > first || result.shares.empty())
      result.shares.push_back({region, first, last, stays(region)});
  }
}

/// Triangles between two shares learn of each other, and of the interface that they are.
void join_twins(cavity& result, const mesh_version& mesh) {
  using key = std::array<vertex_id, 3>;
  const auto sorted = [](key v) {
    std::ranges::sort(v);
    return v;
  };
  std::map<key, std::uint32_t> first;
  for (std::uint32_t i = 0; i < result.sides.size(); ++i) {
    auto& side = result.sides[i];
    if (side.behind != no_id || side.facet != no_id)
      continue;
    const auto& t = result.surface.triangles[i];
    const auto [row, fresh] = first.try_emplace(
      sorted({result.vertices[t[0]], result.vertices[t[1]], result.vertices[t[2]]}), i);
    if (!fresh) {
      side.twin = row->second;
      result.sides[row->second].twin = i;
    }
  }
  for (std::uint32_t b = 0; b < mesh.data().interfaces.size(); ++b)
    if (const auto found = first.find(sorted(mesh.data().interfaces[b].v)); found != first.end()) {
      result.sides[found->second].bond = b;
      if (const auto twin = result.sides[found->second].twin; twin != no_id)
        result.sides[twin].bond = b;
    }
}

}  // namespace

bool is_inside(const tool_surface& tool, vec3 p) {
  double angle = 0;
  for (std::size_t i = 0; i < tool.triangles.size(); ++i) {
    const auto t = corners_of(tool, i);
    const vec3 a = t[0] - p;
    const vec3 b = t[1] - p;
    const vec3 c = t[2] - p;
    const double la = norm(a);
    const double lb = norm(b);
    const double lc = norm(c);
    // Van Oosterom and Strackee 1983.
    angle += 2 * std::atan2(dot(a, cross(b, c)),
                            la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return std::abs(angle) > 2 * std::numbers::pi;
}

cavity_finder::cavity_finder(const mesh_version& mesh, const tool_surface& tool, boolean_mode mode,
                             const std::vector<facet_id>& near_facets,
                             const std::vector<surface_id>& moved)
    : mesh_(mesh),
      tool_(tool),
      mode_(mode),
      bonded_(mesh.regions().size() > 1),
      tree_(boxes_of(tool)),
      is_crossed_(mesh.tet_slots()),
      is_inside_(mesh.tet_slots()) {
  const box extent = tree_.extent();
  auto near = tets_in_box(
    mesh, extent.grown((bonded_ ? around_bonded : around) * norm(extent.high - extent.low)),
    near_facets);
  std::erase_if(near, [&](tet_id t) { return !extent.meets(reach_of(mesh.corners(t))); });
  find_crossed(near);
  if (bonded_)
    stuck_ = facets_of_tool();
  find_owners(moved);
  sort_sides(near);
}

box cavity_finder::reach_of(const std::array<vec3, 4>& tet) const {
  const auto extent = box_of(tet);
  return bonded_ ? extent.grown(nearly_touches * norm(extent.high - extent.low)) : extent;
}

void cavity_finder::find_crossed(const std::vector<tet_id>& near) {
  const double share = bonded_ ? -nearly_touches : 0;
  for (const auto t : near) {
    const auto corners = mesh_.corners(t);
    if (tree_.any_meeting(reach_of(corners), [&](std::size_t i) {
          return meet(corners_of(tool_, i), corners, share);
        })) {
      crossed_.push_back(t);
      is_crossed_[t] = 1;
    }
  }
}

bool cavity_finder::is_within(tet_id t) const {
  const auto p = mesh_.corners(t);
  return is_inside(tool_, 0.25 * (p[0] + p[1] + p[2] + p[3]));
}

/// Tets that the tool's surface does not cross hang together on one side of it; those in the tool
/// have their boxes in the tool's, with all that hangs on them.
void cavity_finder::sort_sides(const std::vector<tet_id>& near) {
  std::vector<std::uint8_t> is_near(mesh_.tet_slots());
  for (const auto t : near)
    is_near[t] = 1;
  std::vector<std::uint8_t> seen(mesh_.tet_slots());
  for (const auto first : near) {
    if (is_crossed_[first] || seen[first])
      continue;
    std::vector<tet_id> piece{first};
    seen[first] = 1;
    bool leaks = false;
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (const auto n : mesh_.neighbours(piece[i])) {
        if (is_facet(n) || is_crossed_[n] || seen[n])
          continue;
        leaks |= !is_near[n];
        if (!is_near[n])
          continue;
        seen[n] = 1;
        piece.push_back(n);
      }
    if (leaks || !is_within(first))
      continue;
    for (const auto t : piece) {
      const bool kept = mode_ == boolean_mode::cut && stays(mesh_.region_of(t));
      is_inside_[t] = !kept;
      (kept ? kept_within_ : within_).push_back(t);
    }
  }
}

/// Those that the tool reaches into, or stands on with facets of its own; it may touch others, too,
/// and they have to agree where.
std::vector<region_id> cavity_finder::regions_of_edit(bool beyond) const {
  std::vector<region_id> regions;
  const auto note = [&](const std::vector<tet_id>& tets) {
    for (const auto t : tets)
      if (std::ranges::find(regions, mesh_.region_of(t)) == regions.end())
        regions.push_back(mesh_.region_of(t));
  };
  if (!bonded_ && !crossed_.empty())
    return {mesh_.region_of(crossed_.front())};
  note(changed());
  for (const auto f : stuck_)
    note({mesh_.facet(f).tet});
  if (bonded_)
    note(crossed_);
  note(kept_within_);
  if (beyond && bonded_)
    for (const auto t : crossed_)
      if (std::ranges::find(regions, mesh_.region_of(t)) != regions.end())
        for (const auto n : mesh_.neighbours(t))
          if (!is_facet(n))
            note({n});
  if (regions.empty())
    regions.push_back(crossed_.empty() ? region_id{0} : mesh_.region_of(crossed_.front()));
  std::ranges::sort(regions);
  return regions;
}

/// Tets that the tool reaches into.
std::vector<tet_id> cavity_finder::changed() const {
  std::vector<tet_id> result;
  if (mode_ == boolean_mode::add)
    result = within_;
  for (const auto t : crossed_) {
    const auto corners = mesh_.corners(t);
    if (tree_.any_meeting(box_of(corners), [&](std::size_t i) {
          return meet(corners_of(tool_, i), corners, reaches_in);
        }))
      result.push_back(t);
  }
  return result;
}

/// Facets whose corners are points of the tool.
std::vector<facet_id> cavity_finder::facets_of_tool() const {
  const auto less = [](vec3 a, vec3 b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::set<vec3, decltype(less)> points(tool_.points.begin(), tool_.points.end(), less);
  std::vector<facet_id> result;
  for (const auto t : crossed_)
    for (const auto n : mesh_.neighbours(t))
      if (is_facet(n) && std::ranges::all_of(mesh_.facet(n & ~facet_flag).v, [&](vertex_id v) {
            return points.contains(mesh_.position(v));
          }))
        result.push_back(n & ~facet_flag);
  return result;
}

void cavity_finder::find_owners(const std::vector<surface_id>& moved) {
  if (!bonded_)
    return;
  for (const auto f : stuck_) {
    const auto region = mesh_.region_of(mesh_.facet(f).tet);
    if (std::ranges::count(moved, mesh_.facet(f).surface) && !std::ranges::count(owners_, region))
      owners_.push_back(region);
  }
}

bool cavity_finder::stays(region_id region) const {
  return !owners_.empty() && !std::ranges::count(owners_, region);
}

expected<cavity> cavity_finder::find(int rings, const std::vector<tet_id>& also,
                                     bool beyond) const {
  const bool keeps_inside = mode_ == boolean_mode::keep;
  if (crossed_.empty() && (mode_ == boolean_mode::add || within_.empty()))
    return fail(ec::empty_selection, "the tool does not meet the part",
                "Place it so that it cuts the part's surface");
  const auto regions = regions_of_edit(beyond);
  const auto takes_part = [&](tet_id t) {
    return std::ranges::find(regions, mesh_.region_of(t)) != regions.end();
  };
  growing_cavity grown(mesh_, {});
  for (const auto t : crossed_)
    if (takes_part(t))
      grown.add(t);
  // What is added, or taken from one of two regions alone, ends at tets that stay.
  const auto is_beside_kept = [&](tet_id t) {
    return std::ranges::any_of(mesh_.neighbours(t),
                               [&](auto n) { return !is_facet(n) && stays(mesh_.region_of(n)); });
  };
  for (const auto t : within_)
    if (mode_ == boolean_mode::add || (!owners_.empty() && is_beside_kept(t)))
      grown.add(t);
  for (const auto t : kept_within_)
    grown.add(t);
  const auto stays_in = [&](tet_id t) {
    return (is_inside_[t] != 0) == keeps_inside && takes_part(t);
  };
  for (const auto t : also)
    if (stays_in(t))
      grown.add(t);
  for (int ring = 0; ring < rings; ++ring)
    grown.add_ring(stays_in);
  if (!grown.grow_until_clean(regions))
    return fail(ec::mesher_failed, "the part's boundary is no clean surface where the tool is",
                "Place the tool elsewhere");
  cavity result;
  result.tets = grown.tets();
  if (mode_ == boolean_mode::cut) {
    for (const auto t : within_)
      if (!grown.holds_tet(t))
        result.gone.push_back(t);
  } else if (keeps_inside) {
    for (tet_id t = 0; t < mesh_.tet_slots(); ++t)
      if (mesh_.is_live_tet(t) && !grown.holds_tet(t) && !is_inside_[t])
        result.gone.push_back(t);
  }
  add_shares(result, mesh_, grown, regions, [&](region_id region) { return stays(region); });
  if (result.shares.size() > 1)
    join_twins(result, mesh_);
  return result;
}

}  // namespace tedit::ops
