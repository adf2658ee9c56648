// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/adapt/split_edges.hpp"
#include "mesh/optimize/improve.hpp"
#include "mesh/quality.hpp"

namespace tedit {

namespace {

constexpr double mended_below = 0.2;
constexpr double halved_below = 0.1;

}  // namespace

expected<void> mend_split(mesh_builder& mesh, double tolerance, const execution& run) {
  return mend_flat(mesh, mesh.touched(), tolerance, run);
}

expected<void> mend_flat(mesh_builder& mesh, std::span<const tet_id> tets, double tolerance,
                         const execution& run) {
  std::vector<tet_id> bad;
  for (const auto t : tets)
    if (radius_ratio(mesh.corners(t)) < mended_below)
      bad.push_back(t);
  if (bad.empty())
    return {};
  improve_settings settings;
  settings.thorough.emplace();
  settings.thorough->target = mended_below;
  settings.thorough->insert_below = halved_below;
  settings.thorough->harmonic = false;
  settings.thorough->tolerance.absolute = tolerance;
  execution quiet;
  quiet.cancel = run.cancel;
  const auto done = improve(mesh, bad, settings, quiet);
  return done ? expected<void>() : fail(done.error());
}

}  // namespace tedit
