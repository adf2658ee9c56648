// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/edge_splitter.hpp"

#include <algorithm>

#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace tedit {

expected<split_report> edge_splitter::split_all() {
  for (std::uint32_t t = 0; t < mesh_.tet_slots(); ++t)
    if (mesh_.is_live(t))
      note_edges(mesh_.tet_at(t));
  for (std::size_t step = 0; !queue_.empty(); ++step) {
    if (step % 1024 == 0 && run_.cancel.cancelled())
      return fail(ec::cancelled, "the edit was cancelled");
    if (mesh_.tet_count() > most_tets_)
      return fail(ec::invalid_parameter,
                  "more than " + std::to_string(most_tets_) + " tets would come out",
                  "Take a larger size");
    const auto next = queue_.top();
    queue_.pop();
    mesh_.ring(next.a, next.b, ring_);
    if (!ring_.empty())
      split(longest_from(next));
  }
  return report_;
}

std::vector<surface_id> edge_splitter::walls_at(const splitter_edge& e) const {
  std::vector<std::uint32_t> ring;
  mesh_.ring(e.a, e.b, ring);
  return walls_at(e, ring);
}

std::vector<surface_id> edge_splitter::walls_at(const splitter_edge& e,
                                                const std::vector<std::uint32_t>& ring) const {
  std::vector<surface_id> result;
  for (const auto t : ring)
    for (const auto c : mesh_.tet_at(t).v)
      if (c != e.a && c != e.b)
        if (const auto* what = mesh_.skin_at({e.a, e.b, c});
            what && what->kind != skin_kind::border)
          result.push_back(what->surface);
  std::ranges::sort(result);
  result.erase(std::ranges::unique(result).begin(), result.end());
  return result;
}

void edge_splitter::note_edges(const tet& corners) {
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      note(corners.v[i], corners.v[j]);
}

void edge_splitter::note(std::uint32_t a, std::uint32_t b) {
  const splitter_edge e{mesh_.length(a, b), std::min(a, b), std::max(a, b)};
  if (rule_.is_too_long(*this, e))
    queue_.push(e);
}

splitter_edge edge_splitter::longest_around() const {
  splitter_edge longest;
  for (const auto t : ring_) {
    const auto& v = mesh_.tet_at(t).v;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        longest = std::max(longest, splitter_edge{mesh_.length(v[i], v[j]), std::min(v[i], v[j]),
                                                  std::max(v[i], v[j])});
  }
  return longest;
}

/// Over longer and longer edges to one that is the longest of all tets around; `ring_` is its.
splitter_edge edge_splitter::longest_from(splitter_edge e) {
  const auto first = e;
  for (;;) {
    const auto longest = longest_around();
    if (longest.a == e.a && longest.b == e.b)
      break;
    e = longest;
    mesh_.ring(e.a, e.b, ring_);
  }
  if (!(first.a == e.a && first.b == e.b))
    queue_.push(first);
  return e;
}

double edge_splitter::worst_with(const splitter_edge& e, vec3 place) const {
  double worst = 1;
  for (const auto t : ring_)
    for (const auto end : {e.a, e.b}) {
      auto p = mesh_.corners(t);
      p[static_cast<std::size_t>(std::ranges::find(mesh_.tet_at(t).v, end) -
                                 mesh_.tet_at(t).v.begin())] = place;
      worst = std::min(worst, orient3d(p[0], p[1], p[2], p[3]) > 0 ? radius_ratio(p) : 0);
    }
  return worst;
}

void edge_splitter::split(const splitter_edge& e) {
  const vec3 middle = 0.5 * (mesh_.at(e.a) + mesh_.at(e.b));
  vec3 place = middle;
  if (const auto walls = walls_at(e, ring_); !walls.empty())
    place = walls_.middle(mesh_.at(e.a), mesh_.at(e.b), walls);
  if (!(place == middle) && worst_with(e, place) < rule_.least_quality &&
      worst_with(e, place) < 0.5 * worst_with(e, middle))
    place = middle;
  const std::vector<std::uint32_t> ring = ring_;
  const auto fresh = mesh_.split(e.a, e.b, ring, place);
  rule_.added(place, e.a, e.b);
  ++report_.vertices;
  for (const auto t : mesh_.star(fresh))
    note_edges(mesh_.tet_at(t));
}

}  // namespace tedit
