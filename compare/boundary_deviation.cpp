// SPDX-License-Identifier: AGPL-3.0-or-later
#include "compare/boundary_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "mesh/box_tree.hpp"
#include "mesh/distances.hpp"

namespace tedit {

namespace {

std::array<vec3, 3> corners_of(const mesh_version& mesh, facet_id f) {
  const auto& v = mesh.facet(f).v;
  return {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
}

std::vector<facet_id> live_facets(const mesh_version& mesh) {
  std::vector<facet_id> result;
  for (facet_id f = 0; f < mesh.facet_slots(); ++f)
    if (mesh.is_live_facet(f))
      result.push_back(f);
  return result;
}

/// The boundary of a version, to be asked for distances.
class boundary_tree {
public:
  explicit boundary_tree(const mesh_version& mesh)
      : mesh_(mesh), facets_(live_facets(mesh)), boxes_(around(mesh, facets_)) {
    // nop
  }

  /// @param reach where it is looked first; any positive length gives the same.
  [[nodiscard]] double distance_to(const vec3& p, double reach) const {
    if (facets_.empty())
      return std::numeric_limits<double>::infinity();
    double found = nearest_in(p, reach);
    while (!std::isfinite(found))
      found = nearest_in(p, reach *= 2);
    // Within a box as wide as the reach there may be a nearer one than what a corner of it showed.
    return found > reach ? nearest_in(p, found) : found;
  }

private:
  static std::vector<box> around(const mesh_version& mesh, const std::vector<facet_id>& facets) {
    std::vector<box> result;
    result.reserve(facets.size());
    for (const auto f : facets)
      result.push_back(box_of(corners_of(mesh, f)));
    return result;
  }

  [[nodiscard]] double nearest_in(const vec3& p, double reach) const {
    double least = std::numeric_limits<double>::infinity();
    (void)boxes_.any_meeting(box{p, p}.grown(reach), [&](std::size_t i) {
      const auto [a, b, c] = corners_of(mesh_, facets_[i]);
      least = std::min(least, point_to_triangle(p, a, b, c));
      return least == 0;
    });
    return least;
  }

  const mesh_version& mesh_;
  std::vector<facet_id> facets_;
  box_tree boxes_;
};

/// Of the facets of one version that the other has not, the point that is farthest from it.
class farthest_point {
public:
  farthest_point(const mesh_version& from, const mesh_version& to, presence of)
      : from_(from), boundary_(to), of_(of) {
    // nop
  }

  void add(facet_id f, boundary_deviation& most) {
    const auto corners = corners_of(from_, f);
    const double size = std::max(norm(corners[1] - corners[0]), norm(corners[2] - corners[0]));
    for (std::size_t i = 0; i < 3; ++i)
      if (seen_.insert(from_.facet(f).v[i]).second)
        look(corners[i], size, most);
    look((1.0 / 3) * (corners[0] + corners[1] + corners[2]), size, most);
  }

private:
  void look(const vec3& p, double reach, boundary_deviation& most) const {
    const double apart = boundary_.distance_to(p, reach);
    if (std::isfinite(apart) && apart > most.distance_m)
      most = {apart, p, of_};
  }

  const mesh_version& from_;
  boundary_tree boundary_;
  presence of_;
  std::set<vertex_id> seen_;
};

expected<void> add_side(const mesh_version& from, const std::vector<facet_id>& facets,
                        const mesh_version& to, presence of, const execution& run,
                        boundary_deviation& most) {
  if (facets.empty())
    return {};
  farthest_point farthest(from, to, of);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (i % 1024 == 0 && run.cancel.cancelled())
      return fail(ec::cancelled, "the comparison was cancelled");
    farthest.add(facets[i], most);
  }
  return {};
}

}  // namespace

expected<boundary_deviation> deviation_of(const mesh_version& before, const mesh_version& after,
                                          const version_match& match, const execution& run) {
  boundary_deviation most;
  if (auto ok = add_side(after, match.facets_after, before, presence::only_after, run, most); !ok)
    return fail(ok.error());
  if (auto ok = add_side(before, match.facets_before, after, presence::only_before, run, most); !ok)
    return fail(ok.error());
  return most;
}

}  // namespace tedit
