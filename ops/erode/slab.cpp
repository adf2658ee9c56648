// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/erode/slab.hpp"

#include <algorithm>
#include <cmath>

namespace tedit::ops {

namespace {

/// Facets that look down by more than this (cosine) are the wall's other side.
constexpr double underside = -0.5;
/// Facets that look up like the surface itself lie on a lower step.
constexpr double lower_step = 0.99;

std::string millimetres(double length) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g mm", 1e3 * length);
  return text;
}

}  // namespace

slab::slab(mesh_builder& mesh, surface_patch patch, double depth)
    : mesh_(mesh), patch_(std::move(patch)), depth_(depth), zero_(1e-7 * patch_.mean_edge) {
  walls_ = walls_of(mesh_, patch_);
}

double slab::below_floor(vertex_id v) const {
  const double f = patch_.depth(mesh_.position(v)) - depth_;
  return std::abs(f) <= zero_ ? 0 : f;
}

expected<void> slab::cut(const execution& run) {
  for (const auto& wall : walls_) {
    level_set_settings settings;
    settings.zero = zero_;
    for (const auto& sheet : sheets_)
      settings.sheets.push_back(&sheet);
    auto done = split_at_level(
      mesh_, tets_at(wall), [&](vertex_id v) { return wall.across(mesh_.position(v)); }, settings,
      run);
    if (!done)
      return fail(done.error());
    sheets_.push_back(std::move(done->on_level));
  }
  const auto found = flood(true);
  std::vector<tet_id> region(found.begin(), found.end());
  std::ranges::sort(region);
  level_set_settings settings;
  settings.zero = zero_;
  for (const auto& sheet : sheets_)
    settings.sheets.push_back(&sheet);
  const auto done = split_at_level(
    mesh_, region, [&](vertex_id v) { return below_floor(v); }, settings, run);
  if (!done)
    return fail(done.error());
  return {};
}

/// Does the tet's section with the wall's plane overlap the wall, by the box around the section?
bool slab::meets(const patch_wall& wall, tet_id t) const {
  double low[2] = {1e300, 1e300};
  double high[2] = {-1e300, -1e300};
  const auto add = [&](vec3 p) {
    const double place[2] = {wall.position(p), patch_.depth(p)};
    for (int i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], place[i]);
      high[i] = std::max(high[i], place[i]);
    }
  };
  const auto c = mesh_.corners(t);
  for (int i = 0; i < 4; ++i) {
    const double fi = wall.across(c[i]);
    if (std::abs(fi) <= zero_)
      add(c[i]);
    for (int j = i + 1; j < 4; ++j)
      if (const double fj = wall.across(c[j]);
          (fi < -zero_ && fj > zero_) || (fi > zero_ && fj < -zero_))
        add(c[i] + (fi / (fi - fj)) * (c[j] - c[i]));
  }
  // Where the neighbour goes straight down there is nothing to cut beside its ends.
  const double slack = wall.descends ? -zero_ : zero_;
  return low[0] <= wall.length + slack && high[0] >= -slack && low[1] < depth_ - zero_ &&
         high[1] > zero_;
}

std::vector<tet_id> slab::tets_at(const patch_wall& wall) const {
  std::vector<tet_id> found;
  std::unordered_set<tet_id> seen;
  const auto visit = [&](tet_id t) {
    if (seen.insert(t).second && meets(wall, t))
      found.push_back(t);
  };
  for (const auto& edge : patch_.border)
    for (const auto v : {edge.a, edge.b}) {
      const vec3 p = mesh_.position(v);
      if (std::abs(wall.across(p)) <= zero_ && wall.position(p) >= -zero_ &&
          wall.position(p) <= wall.length + zero_)
        std::ranges::for_each(mesh_.star(v), visit);
    }
  for (std::size_t next = 0; next < found.size(); ++next)
    for (const auto behind : mesh_.neighbours(found[next]))
      if (!is_facet(behind))
        visit(behind);
  std::ranges::sort(found);
  return found;
}

const patch_wall* slab::wall_of(const std::array<vertex_id, 3>& face) const {
  const vec3 centre =
    (mesh_.position(face[0]) + mesh_.position(face[1]) + mesh_.position(face[2])) / 3;
  for (const auto& wall : walls_) {
    const double place = wall.position(centre);
    if (place < 0 || place > wall.length || std::abs(wall.across(centre)) > zero_)
      continue;
    if (std::ranges::all_of(
          face, [&](vertex_id v) { return std::abs(wall.across(mesh_.position(v))) <= zero_; }))
      return &wall;
  }
  return nullptr;
}

bool slab::on_floor(const std::array<vertex_id, 3>& face) const {
  return std::ranges::all_of(face, [&](vertex_id v) { return below_floor(v) == 0; });
}

/// The tets that hang together with the surface through the slab, without crossing a wall: those
/// wholly above the floor, or also those that it crosses.
std::unordered_set<tet_id> slab::flood(bool also_crossed) const {
  std::unordered_set<tet_id> inside;
  std::vector<tet_id> open;
  const auto visit = [&](tet_id t) {
    bool above = false;
    bool below = false;
    for (const auto v : mesh_.tet_at(t).v) {
      above = above || below_floor(v) < 0;
      below = below || below_floor(v) > 0;
    }
    if (above && (also_crossed || !below) && inside.insert(t).second)
      open.push_back(t);
  };
  for (facet_id f = 0; f < mesh_.facet_slots(); ++f)
    if (mesh_.is_live_facet(f) && mesh_.facet(f).surface == patch_.surface)
      visit(mesh_.facet(f).tet);
  while (!open.empty()) {
    const auto t = open.back();
    open.pop_back();
    for (int i = 0; i < 4; ++i) {
      const auto behind = mesh_.neighbours(t)[i];
      if (is_facet(behind) || inside.contains(behind))
        continue;
      const auto& v = mesh_.tet_at(t).v;
      const auto& order = tet_faces[i];
      const std::array<vertex_id, 3> face{v[order[0]], v[order[1]], v[order[2]]};
      const bool through_slab =
        std::ranges::any_of(face, [&](vertex_id u) { return below_floor(u) < 0; });
      if (through_slab && !wall_of(face))
        visit(behind);
    }
  }
  return inside;
}

expected<void> slab::check(const std::unordered_set<tet_id>& inside) const {
  std::unordered_set<surface_id> beside;
  for (const auto& edge : patch_.border)
    if (edge.convex() && mesh_.is_live_facet(edge.outer))
      beside.insert(mesh_.facet(edge.outer).surface);
  double thinnest = 1e300;
  for (const auto t : inside) {
    for (const auto v : mesh_.tet_at(t).v)
      if (patch_.depth(mesh_.position(v)) < -std::max(zero_, 10 * patch_.deviation))
        return fail(ec::cap_intersects, "the cut below surface " + std::to_string(patch_.surface) +
                                          " would run into material that rises beside it");
    for (const auto behind : mesh_.neighbours(t)) {
      if (!is_facet(behind))
        continue;
      const auto& facet = mesh_.facet(behind & ~facet_flag);
      if (facet.surface == patch_.surface)
        continue;
      double depth = 1e300;
      for (const auto v : facet.v)
        depth = std::min(depth, patch_.depth(mesh_.position(v)));
      const double cosine = dot(patch_.normal, normalized(area_vector(mesh_.position(facet.v[0]),
                                                                      mesh_.position(facet.v[1]),
                                                                      mesh_.position(facet.v[2]))));
      // A neighbour that goes back below the surface is trimmed like any other.
      if (cosine < (beside.contains(facet.surface) ? -lower_step : underside))
        thinnest = std::min(thinnest, depth);
      if (cosine > lower_step && depth > zero_)
        return fail(ec::invalid_argument, "the cut would take off surface " +
                                            std::to_string(facet.surface) + ", which lies " +
                                            millimetres(depth) + " below surface " +
                                            std::to_string(patch_.surface));
    }
  }
  if (thinnest < 1e300)
    return fail(ec::invalid_argument, "the wall below surface " + std::to_string(patch_.surface) +
                                        " is only " + millimetres(std::max(0.0, thinnest)) +
                                        " thick at its thinnest");
  return {};
}

expected<std::unordered_set<tet_id>> slab::tets() const {
  auto inside = flood(false);
  if (inside.empty())
    return fail(ec::empty_selection,
                "no material lies below surface " + std::to_string(patch_.surface),
                "Select surfaces of the outside");
  if (auto ok = check(inside); !ok)
    return fail(ok.error());
  return inside;
}

}  // namespace tedit::ops
