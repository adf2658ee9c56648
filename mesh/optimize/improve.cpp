// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/optimize/improve.hpp"

#include <cmath>

#include "mesh/optimize/lift.hpp"
#include "mesh/optimize/thorough.hpp"

namespace tedit {

namespace {

/// The region with its rings: the tets that may change.
std::unordered_set<tet_id> grow(const mesh_builder& mesh, const std::vector<tet_id>& region,
                                int rings) {
  std::unordered_set<tet_id> result;
  std::unordered_set<vertex_id> frontier;
  for (const auto t : region)
    if (t < mesh.tet_slots() && mesh.is_live_tet(t) && result.insert(t).second)
      frontier.insert(mesh.tet_at(t).v.begin(), mesh.tet_at(t).v.end());
  std::unordered_set<vertex_id> done;
  for (int ring = 0; ring < rings; ++ring) {
    std::unordered_set<vertex_id> next;
    for (const auto v : frontier) {
      if (!done.insert(v).second)
        continue;
      for (const auto t : mesh.star(v))
        if (result.insert(t).second)
          next.insert(mesh.tet_at(t).v.begin(), mesh.tet_at(t).v.end());
    }
    frontier = std::move(next);
  }
  return result;
}

}  // namespace

expected<void> validate(const thorough_settings& settings) {
  const auto share = [](double x) { return x >= 0 && x <= 1; };
  if (!share(settings.target) || !share(settings.insert_below))
    return fail(ec::invalid_parameter, "the target quality must be between 0 and 1");
  if (!(settings.tolerance.absolute >= 0) || !share(settings.tolerance.relative) ||
      !std::isfinite(settings.tolerance.absolute))
    return fail(ec::invalid_parameter, "the surface tolerance must be a length, 0 or more");
  return {};
}

expected<improve_report> improve(mesh_builder& mesh, const std::vector<tet_id>& region,
                                 const improve_settings& settings, const execution& run) {
  const auto grown = grow(mesh, region, settings.rings);
  std::vector<tet_id> tets(grown.begin(), grown.end());
  if (settings.thorough)
    return improve_thoroughly(mesh, std::move(tets), *settings.thorough, run);
  return improve_locally(mesh, std::move(tets), settings, run);
}

}  // namespace tedit
