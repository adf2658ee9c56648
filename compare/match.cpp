// SPDX-License-Identifier: AGPL-3.0-or-later
#include "compare/match.hpp"

#include <algorithm>
#include <cmath>

#include "base/hash.hpp"
#include "mesh/changes.hpp"
#include "mesh/facet_pages.hpp"

namespace tedit {

namespace {

using slot_list = std::vector<std::uint32_t>;

void sort_unique(slot_list& slots) {
  std::ranges::sort(slots);
  slots.erase(std::ranges::unique(slots).begin(), slots.end());
}

bool has_vertex(const mesh_version& mesh, vertex_id v) {
  return v < mesh.vertex_slots() && mesh.is_live_vertex(v);
}

bool has_tet(const mesh_version& mesh, tet_id t) {
  return t < mesh.tet_slots() && mesh.is_live_tet(t);
}

bool has_facet(const mesh_version& mesh, facet_id f) {
  return f < mesh.facet_slots() && mesh.is_live_facet(f);
}

/// Live slots that the other version has not, or otherwise.
struct differing {
  slot_list before;
  slot_list after;
};

/// Whether a slot is in use can only change with the page of `vertex_tet`.
differing differing_vertices(const mesh_version& before, const mesh_version& after) {
  slot_list touched;
  const auto note = [&](std::uint32_t slot) { touched.push_back(slot); };
  for_each_dirty_slot(before.data().positions, after.data().positions, note);
  for_each_dirty_slot(before.data().vertex_tet, after.data().vertex_tet, note);
  sort_unique(touched);
  differing result;
  for (const auto v : touched) {
    const bool was = has_vertex(before, v);
    const bool is = has_vertex(after, v);
    if (was && is && before.position(v) == after.position(v))
      continue;
    if (was)
      result.before.push_back(v);
    if (is)
      result.after.push_back(v);
  }
  return result;
}

/// Vertices by their place, to within a tolerance.
class place_table {
public:
  place_table(const mesh_version& mesh, const slot_list& vertices, double tolerance)
      : mesh_(mesh), tolerance_(tolerance) {
    cells_.reserve(vertices.size());
    for (const auto v : vertices)
      cells_.emplace(key_of(mesh.position(v), {0, 0, 0}), v);
  }

  /// The nearest vertex within the tolerance, or `no_id`.
  [[nodiscard]] vertex_id find(const vec3& p) const {
    vertex_id best = no_id;
    double least = tolerance_;
    // A cell is 4 tolerances wide: of two places so near one of these eight cells has the other.
    for (int corner = 0; corner < 8; ++corner) {
      const auto shift = [&](int bit) { return (corner & bit) != 0 ? tolerance_ : -tolerance_; };
      const auto [first, last] = cells_.equal_range(key_of(p, {shift(1), shift(2), shift(4)}));
      for (auto i = first; i != last; ++i)
        if (const double apart = norm(mesh_.position(i->second) - p); apart <= least) {
          least = apart;
          best = i->second;
        }
    }
    return best;
  }

private:
  [[nodiscard]] std::uint64_t key_of(const vec3& p, const vec3& shift) const {
    const auto cell = [&](double x) {
      // What lies farther out than the cells can count is far from all that is in the table.
      constexpr double farthest = 9e18;
      const double number = tolerance_ > 0 ? std::floor(x / (4 * tolerance_)) : 0;
      return static_cast<std::int64_t>(std::clamp(number, -farthest, farthest));
    };
    const vec3 at = p + shift;
    const std::array<std::int64_t, 3> cells{cell(at.x), cell(at.y), cell(at.z)};
    return hash_bytes(std::as_bytes(std::span(cells))).low;
  }

  const mesh_version& mesh_;
  double tolerance_;
  std::unordered_multimap<std::uint64_t, vertex_id> cells_;
};

/// What two files of one mesh in different units may round apart.
double tolerance_for(const mesh_version& mesh, const slot_list& vertices) {
  double largest = 0;
  for (const auto v : vertices) {
    const auto& p = mesh.position(v);
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return 1e-12 * largest;
}

/// The corners of something as vertices of before, ascending; the first is `no_id` where one of
/// them is not there.
template <std::size_t N>
using corner_key = std::array<vertex_id, N>;

template <std::size_t N>
corner_key<N> key_of(std::array<vertex_id, N> corners) {
  std::ranges::sort(corners);
  if (corners[N - 1] == no_id)
    corners.fill(no_id);
  return corners;
}

template <std::size_t N>
struct corner_hash {
  std::size_t operator()(const corner_key<N>& key) const {
    return hash_bytes(std::as_bytes(std::span(key))).low;
  }
};

/// Takes from both lists what has the same corners, and hands each pair to `found`.
template <std::size_t N, class Before, class After, class Found>
void take_common(slot_list& before, slot_list& after, const Before& corners_before,
                 const After& corners_after, const Found& found) {
  std::unordered_map<corner_key<N>, std::uint32_t, corner_hash<N>> known;
  known.reserve(before.size());
  for (const auto i : before)
    known.emplace(key_of(corners_before(i)), i);
  slot_list common;
  std::erase_if(after, [&](std::uint32_t i) {
    const auto key = key_of(corners_after(i));
    const auto match = key[0] == no_id ? known.end() : known.find(key);
    if (match == known.end())
      return false;
    found(match->second, i);
    common.push_back(match->second);
    known.erase(match);
    return true;
  });
  sort_unique(common);
  std::erase_if(before, [&](std::uint32_t i) { return std::ranges::binary_search(common, i); });
}

/// The tets that have one of the vertices. Where these are many, all are looked at: their stars
/// would be walked many times over.
void add_tets_at(const mesh_version& mesh, const slot_list& vertices, slot_list& result) {
  if (vertices.size() < mesh.vertex_count() / 16) {
    const auto around = tets_around(mesh, vertices);
    result.insert(result.end(), around.begin(), around.end());
    return;
  }
  std::vector<bool> wanted(mesh.vertex_slots());
  for (const auto v : vertices)
    wanted[v] = true;
  for (tet_id t = 0; t < mesh.tet_slots(); ++t)
    if (mesh.is_live_tet(t) &&
        std::ranges::any_of(mesh.tet_at(t).v, [&](vertex_id v) { return wanted[v]; }))
      result.push_back(t);
}

differing differing_tets(const mesh_version& before, const mesh_version& after,
                         const differing& vertices) {
  differing result;
  for_each_dirty_slot(before.data().tets, after.data().tets, [&](tet_id t) {
    const bool was = has_tet(before, t);
    const bool is = has_tet(after, t);
    if (was && is && before.tet_at(t) == after.tet_at(t))
      return;
    if (was)
      result.before.push_back(t);
    if (is)
      result.after.push_back(t);
  });
  add_tets_at(before, vertices.before, result.before);
  add_tets_at(after, vertices.after, result.after);
  sort_unique(result.before);
  sort_unique(result.after);
  return result;
}

/// Do the facets of a page, the same in both versions, have corners in pages of positions that
/// differ?
bool may_have_moved(const mesh_version& mesh, std::size_t page,
                    const std::vector<std::size_t>& positions) {
  const auto facts = facet_page_of(mesh, page);
  return std::ranges::any_of(facts->positions, [&](const auto& row) {
    return std::ranges::binary_search(positions, row.first);
  });
}

/// Facets that one version has otherwise in its slot; those of another surface alone are `moved`.
class facet_scan {
public:
  facet_scan(const mesh_version& before, const mesh_version& after, version_match& result)
      : before_(before), after_(after), result_(result) {}

  void look(facet_id f) {
    const bool was = has_facet(before_, f);
    const bool is = has_facet(after_, f);
    if (was && is && stays(before_.facet(f), after_.facet(f))) {
      if (before_.facet(f).surface != after_.facet(f).surface)
        result_.facets_moved.emplace_back(f, f);
      return;
    }
    if (was)
      result_.facets_before.push_back(f);
    if (is)
      result_.facets_after.push_back(f);
  }

private:
  [[nodiscard]] bool stays(const boundary_facet& was, const boundary_facet& is) const {
    return was.v == is.v &&
           std::ranges::all_of(is.v, [&](vertex_id v) { return !result_.elsewhere.contains(v); });
  }

  const mesh_version& before_;
  const mesh_version& after_;
  version_match& result_;
};

void scan_facets(const mesh_version& before, const mesh_version& after, version_match& result) {
  constexpr auto per_page = paged_array<boundary_facet>::items_per_page;
  facet_scan scan(before, after, result);
  for_each_dirty_slot(before.data().facets, after.data().facets, [&](facet_id f) { scan.look(f); });
  const auto changed = dirty_pages(before.data().facets, after.data().facets);
  const auto positions = dirty_pages(before.data().positions, after.data().positions);
  for (std::size_t p = 0; p < after.data().facets.pages().size(); ++p)
    if (!std::ranges::binary_search(changed, p) && may_have_moved(after, p, positions))
      for (std::size_t i = 0; i < after.data().facets.page_items(p).size(); ++i)
        scan.look(static_cast<facet_id>(p * per_page + i));
}

/// Corners of after as vertices of before.
template <std::size_t N>
std::array<vertex_id, N> twins_of(const version_match& match, std::array<vertex_id, N> corners) {
  for (auto& v : corners)
    v = match.twin_of(v);
  return corners;
}

void match_tets(const mesh_version& before, const mesh_version& after, const differing& vertices,
                version_match& result) {
  auto tets = differing_tets(before, after, vertices);
  take_common<4>(
    tets.before, tets.after, [&](tet_id t) { return before.tet_at(t).v; },
    [&](tet_id t) { return twins_of(result, after.tet_at(t).v); }, [](tet_id, tet_id) {});
  result.tets_before = std::move(tets.before);
  result.tets_after = std::move(tets.after);
}

void match_facets(const mesh_version& before, const mesh_version& after, version_match& result) {
  scan_facets(before, after, result);
  sort_unique(result.facets_before);
  sort_unique(result.facets_after);
  take_common<3>(
    result.facets_before, result.facets_after, [&](facet_id f) { return before.facet(f).v; },
    [&](facet_id f) { return twins_of(result, after.facet(f).v); },
    [&](facet_id was, facet_id is) { result.facets_moved.emplace_back(was, is); });
}

}  // namespace

expected<version_match> match_versions(const mesh_version& before, const mesh_version& after,
                                       const execution& run) {
  const auto vertices = differing_vertices(before, after);
  const place_table places(before, vertices.before, tolerance_for(before, vertices.before));
  version_match result;
  result.vertices = after.vertex_count();
  for (const auto v : vertices.after) {
    const auto twin = places.find(after.position(v));
    result.elsewhere.emplace(v, twin);
    result.vertices -= twin == no_id ? 1 : 0;
  }
  if (run.cancel.cancelled())
    return fail(ec::cancelled, "the comparison was cancelled");
  match_tets(before, after, vertices, result);
  if (run.cancel.cancelled())
    return fail(ec::cancelled, "the comparison was cancelled");
  match_facets(before, after, result);
  return result;
}

}  // namespace tedit
