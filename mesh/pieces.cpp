// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/pieces.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "mesh/quality.hpp"

namespace tedit {

namespace {

/// Pieces below this share of their body's volume are crumbs.
constexpr double crumb_share = 0.01;

/// What is wrong with the boundary around one vertex, seen as the directed edges of its link.
struct link_fault {
  bool pinched = false;             ///< More than one fan.
  std::vector<vertex_id> bad_ends;  ///< Edges to these have more than two facets.
};

link_fault fault_at(const mesh_builder& mesh, vertex_id v, const std::vector<tet_id>& star,
                    const std::unordered_set<tet_id>& removed) {
  std::map<vertex_id, vertex_id> next;
  link_fault fault;
  for (const auto t : star) {
    if (removed.contains(t))
      continue;
    const auto& corner = mesh.tet_at(t).v;
    for (int i = 0; i < 4; ++i) {
      const auto behind = mesh.neighbours(t)[i];
      if (corner[i] == v || !(is_facet(behind) || removed.contains(behind)))
        continue;
      const auto& order = tet_faces[i];
      const auto at = std::ranges::find(order, v, [&](int c) { return corner[c]; }) - order.begin();
      const auto from = corner[order[(at + 1) % 3]];
      if (!next.emplace(from, corner[order[(at + 2) % 3]]).second)
        fault.bad_ends.push_back(from);
    }
  }
  if (next.empty() || !fault.bad_ends.empty())
    return fault;
  std::size_t steps = 1;
  auto at = next.begin()->second;
  for (; at != next.begin()->first && steps <= next.size(); ++steps) {
    const auto row = next.find(at);
    if (row == next.end())
      break;
    at = row->second;
  }
  fault.pinched = steps != next.size();
  return fault;
}

/// Puts back the removed tets of the star that hold `other`, or all for no_id.
bool put_back(const mesh_builder& mesh, const std::vector<tet_id>& star, vertex_id other,
              std::unordered_set<tet_id>& removed, std::set<vertex_id>& suspects) {
  bool any = false;
  for (const auto t : star) {
    const auto& corner = mesh.tet_at(t).v;
    if (!removed.contains(t) || (other != no_id && !std::ranges::count(corner, other)))
      continue;
    removed.erase(t);
    suspects.insert(corner.begin(), corner.end());
    any = true;
  }
  return any;
}

/// All tets that hang together with `seed` over faces, without those in `taken`, which they join.
std::vector<tet_id> flood(const mesh_builder& mesh, tet_id seed,
                          std::unordered_set<tet_id>& taken) {
  std::vector<tet_id> found{seed};
  taken.insert(seed);
  for (std::size_t next = 0; next < found.size(); ++next)
    for (const auto behind : mesh.neighbours(found[next]))
      if (!is_facet(behind) && taken.insert(behind).second)
        found.push_back(behind);
  return found;
}

loose_piece measured(const mesh_builder& mesh, std::vector<tet_id> tets) {
  loose_piece piece;
  for (const auto t : tets) {
    const auto c = mesh.corners(t);
    const double volume = signed_volume(c);
    piece.volume += volume;
    piece.centre += 0.25 * volume * (c[0] + c[1] + c[2] + c[3]);
  }
  piece.centre = piece.centre / piece.volume;
  piece.tets = std::move(tets);
  return piece;
}

std::string cubic_mm(double volume) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g mm3", 1e9 * volume);
  return text;
}

tl::unexpected<error> refuse_split(const remaining_body& body) {
  std::string sizes;
  std::size_t parts = 0;
  for (const auto& piece : body.pieces)
    if (piece.volume >= crumb_share * body.volume_before) {
      sizes += (sizes.empty() ? "" : ", ") + cubic_mm(piece.volume);
      ++parts;
    }
  return fail(
    ec::invalid_argument,
    "the part would fall into " + std::to_string(parts) + " pieces of " + sizes,
    "Take less off, select fewer surfaces, or say what to keep (erode: parameter pieces)");
}

}  // namespace

std::size_t mend_hinges(const mesh_builder& mesh, std::unordered_set<tet_id>& removed) {
  std::set<vertex_id> suspects;
  for (const auto t : removed)
    suspects.insert(mesh.tet_at(t).v.begin(), mesh.tet_at(t).v.end());
  std::size_t mended = 0;
  while (!suspects.empty()) {
    const auto v = *suspects.begin();
    suspects.erase(suspects.begin());
    const auto star = mesh.star(v);
    const auto fault = fault_at(mesh, v, star, removed);
    for (const auto end : fault.bad_ends)
      mended += put_back(mesh, star, end, removed, suspects);
    if (fault.pinched)
      mended += put_back(mesh, star, no_id, removed, suspects);
  }
  return mended;
}

std::vector<remaining_body> remaining_bodies(const mesh_builder& mesh,
                                             const std::unordered_set<tet_id>& removed) {
  std::vector<tet_id> order(removed.begin(), removed.end());
  std::ranges::sort(order);
  std::vector<remaining_body> bodies;
  std::unordered_set<tet_id> whole;
  auto parted = removed;
  for (const auto seed : order) {
    if (whole.contains(seed))
      continue;
    auto& body = bodies.emplace_back();
    for (const auto t : flood(mesh, seed, whole)) {
      body.volume_before += signed_volume(mesh.corners(t));
      if (!parted.contains(t))
        body.pieces.push_back(measured(mesh, flood(mesh, t, parted)));
    }
    std::ranges::stable_sort(body.pieces, std::ranges::greater{}, &loose_piece::volume);
  }
  return bodies;
}

expected<removal_report> settle_removal(const mesh_builder& mesh,
                                        std::unordered_set<tet_id>& removed, piece_policy policy) {
  removal_report report;
  report.hinges_mended = mend_hinges(mesh, removed);
  if (removed.empty())
    return fail(ec::empty_selection,
                "nothing can be taken off: the rest would hang together by edges or corners only",
                "Select more surfaces, or take off a metric depth (parameter depth)");
  for (const auto& body : remaining_bodies(mesh, removed)) {
    if (body.pieces.empty())
      return fail(ec::empty_selection,
                  "the whole body of " + cubic_mm(body.volume_before) + " would vanish",
                  "Take less off");
    ++report.bodies;
    ++report.pieces;
    for (std::size_t i = 1; i < body.pieces.size(); ++i) {
      const auto& piece = body.pieces[i];
      const bool crumb = piece.volume < crumb_share * body.volume_before;
      if (!crumb && policy == piece_policy::refuse)
        return refuse_split(body);
      if (!crumb && policy == piece_policy::allow) {
        ++report.pieces;
        continue;
      }
      ++(crumb ? report.crumbs : report.dropped);
      (crumb ? report.crumb_volume : report.dropped_volume) += piece.volume;
      removed.insert(piece.tets.begin(), piece.tets.end());
    }
  }
  return report;
}

double boundary_volume_change(const mesh_version& before, const mesh_version& after) {
  double change = 0;
  vec3 origin;
  bool placed = false;
  const auto cone = [&](const mesh_version& mesh, const boundary_facet& facet) {
    const auto& v = facet.v;
    if (!placed)
      origin = mesh.position(v[0]);
    placed = true;
    return dot(mesh.position(v[0]) - origin, area_vector(mesh, facet)) / 3;
  };
  const auto same = [&](facet_id f) {
    if (!(before.facet(f).v == after.facet(f).v))
      return false;
    return std::ranges::all_of(
      before.facet(f).v, [&](vertex_id v) { return before.position(v) == after.position(v); });
  };
  for (facet_id f = 0; f < std::max(before.facet_slots(), after.facet_slots()); ++f) {
    const bool was = f < before.facet_slots() && before.is_live_facet(f);
    const bool is = f < after.facet_slots() && after.is_live_facet(f);
    if (was && is && same(f))
      continue;
    if (was)
      change -= cone(before, before.facet(f));
    if (is)
      change += cone(after, after.facet(f));
  }
  return change;
}

void drop_bare_interfaces(mesh_builder& mesh) {
  std::vector<interface_facet> kept;
  const auto rows = mesh.interfaces().to_vector();
  for (const auto& row : rows) {
    std::size_t sides = 0;
    const bool live =
      std::ranges::all_of(row.v, [&](vertex_id v) { return mesh.is_live_vertex(v); });
    if (live)
      for (const auto t : mesh.edge_ring(row.v[0], row.v[1]))
        sides += static_cast<std::size_t>(std::ranges::count(mesh.tet_at(t).v, row.v[2]));
    if (sides == 2)
      kept.push_back(row);
  }
  if (kept.size() < rows.size())
    mesh.set_interfaces(kept);
}

}  // namespace tedit
