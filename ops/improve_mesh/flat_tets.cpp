// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/improve_mesh/flat_tets.hpp"

#include <algorithm>
#include <map>
#include <unordered_set>

#include "mesh/flat.hpp"
#include "mesh/quality.hpp"

namespace tedit::ops {

namespace {

/// The least radius ratio of a tet meshed anew, where nothing worse was around that is not flat.
constexpr double sound = 1e-3;
constexpr int most_rings = 3;

using tet_set = std::unordered_set<tet_id>;

/// The faces of a cavity with its vertices as points, and what belongs to them.
struct cavity_shell {
  closed_surface surface;
  std::vector<vertex_id> vertices;
};

class flat_mender {
public:
  flat_mender(mesh_builder& mesh, context& ctx) : mesh_(mesh), ctx_(ctx) {}

  expected<flat_mending> mend(const std::vector<tet_id>& region) {
    flat_mending sum;
    for (const auto t : region) {
      if (!mesh_.is_live_tet(t) || !flat(t))
        continue;
      if (ctx_.run.cancel.cancelled())
        return fail(ec::cancelled, "the edit was cancelled");
      const auto place = flat_ones_around(t);
      sum.found += place.size();
      for (int rings = 1; rings <= most_rings; ++rings)
        if (mesh_anew(place, rings)) {
          sum.mended += place.size();
          break;
        }
    }
    return sum;
  }

private:
  [[nodiscard]] bool flat(tet_id t) const {
    const auto corners = mesh_.corners(t);
    return is_flat(corners, signed_volume(corners));
  }

  [[nodiscard]] std::vector<tet_id> around(const tet_set& tets) const {
    tet_set found;
    for (const auto t : tets)
      for (const auto v : mesh_.tet_at(t).v)
        for (const auto n : mesh_.star(v))
          found.insert(n);
    std::vector<tet_id> result(found.begin(), found.end());
    std::ranges::sort(result);
    return result;
  }

  /// Flat tets that share vertices belong together.
  [[nodiscard]] tet_set flat_ones_around(tet_id first) const {
    tet_set place{first};
    for (std::size_t before = 0; before != place.size();) {
      before = place.size();
      for (const auto t : around(place))
        if (flat(t))
          place.insert(t);
    }
    return place;
  }

  /// True when it was done; else nothing has changed.
  bool mesh_anew(const tet_set& place, int rings) {
    const auto region = mesh_.region_of(*std::ranges::min_element(place));
    tet_set hollow = place;
    for (int ring = 0; ring < rings; ++ring)
      for (const auto t : around(hollow))
        if (mesh_.region_of(t) == region)
          hollow.insert(t);
    std::vector<tet_id> removed(hollow.begin(), hollow.end());
    std::ranges::sort(removed);
    const auto shell = shell_of(removed, hollow);
    if (!shell)
      return false;
    const auto filling = ctx_.host->tetrahedralise(shell->surface, ctx_.run);
    return filling && replace(removed, region, *shell, *filling);
  }

  /// Nothing where an edge of it has more than two faces.
  [[nodiscard]] std::optional<cavity_shell> shell_of(const std::vector<tet_id>& removed,
                                                     const tet_set& hollow) const {
    cavity_shell shell;
    std::map<vertex_id, std::uint32_t> index;
    std::map<std::pair<vertex_id, vertex_id>, int> edges;
    for (const auto t : removed)
      for (int i = 0; i < 4; ++i) {
        const auto behind = mesh_.neighbours(t)[i];
        if (!is_facet(behind) && hollow.contains(behind))
          continue;
        std::array<std::uint32_t, 3> corners{};
        for (int k = 0; k < 3; ++k) {
          const auto v = mesh_.tet_at(t).v[tet_faces[i][k]];
          const auto next = mesh_.tet_at(t).v[tet_faces[i][(k + 1) % 3]];
          if (++edges[{v, next}] > 1)
            return std::nullopt;
          const auto [row, fresh] =
            index.try_emplace(v, static_cast<std::uint32_t>(shell.vertices.size()));
          if (fresh) {
            shell.vertices.push_back(v);
            shell.surface.points.push_back(mesh_.position(v));
          }
          corners[k] = row->second;
        }
        shell.surface.triangles.push_back(corners);
      }
    return shell;
  }

  bool replace(const std::vector<tet_id>& removed, region_id region, const cavity_shell& shell,
               const tet_filling& filling) {
    double least = sound;
    for (const auto t : removed)
      if (!flat(t))
        least = std::min(least, radius_ratio(mesh_.corners(t)));
    for (const auto& t : filling.tets)
      if (radius_ratio({filling.points[t[0]], filling.points[t[1]], filling.points[t[2]],
                        filling.points[t[3]]}) < least)
        return false;
    auto vertices = shell.vertices;
    for (std::size_t i = vertices.size(); i < filling.points.size(); ++i)
      vertices.push_back(mesh_.add_vertex(filling.points[i]));
    cavity_change change;
    change.removed = removed;
    for (const auto& t : filling.tets)
      change.added.push_back(
        {{{vertices[t[0]], vertices[t[1]], vertices[t[2]], vertices[t[3]]}}, region});
    return mesh_.apply(change).has_value();
  }

  mesh_builder& mesh_;
  context& ctx_;
};

}  // namespace

expected<flat_mending> mend_flat_tets(mesh_builder& mesh, const std::vector<tet_id>& region,
                                      context& ctx) {
  return flat_mender(mesh, ctx).mend(region);
}

}  // namespace tedit::ops
