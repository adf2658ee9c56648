// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/move/move.hpp"

#include "ops/shapes/features/fill_holes.hpp"
#include "ops/shapes/features/place_copies.hpp"
#include "ops/shapes/features/remove_protrusion.hpp"
#include "ops/shapes/improved.hpp"

namespace tedit::ops {

namespace {

/// The part without the features, as good a mesh as an edit of its own would leave.
expected<copy_source> without(const version_ptr& mesh, const picked_features& features,
                              context& ctx) {
  context first = ctx;
  first.run = ctx.run.part(0, 0.2);
  const auto gone = features.mode == boolean_mode::cut
                      ? fill_holes(mesh, features.surfaces, {.exact = true}, first)
                      : remove_protrusion(mesh, features.surfaces, true, first);
  if (!gone)
    return fail(gone.error());
  const auto rest = improved(*gone, first.run);
  if (!rest)
    return fail(rest.error());
  return copy_source{mesh, *rest, gone->volume_change, true};
}

}  // namespace

expected<edit_result> move_features(const version_ptr& mesh, const std::vector<surface_id>& picked,
                                    vec3 by, bool copy, context& ctx) {
  if (norm(by) == 0)
    return fail(ec::invalid_parameter, "it would stay where it is", "Give the way: by_mm=10,0,0");
  const auto features = pick_features(*mesh, picked, ctx);
  if (!features)
    return fail(features.error());
  const auto source =
    copy ? expected<copy_source>(copy_source{mesh, mesh}) : without(mesh, *features, ctx);
  if (!source)
    return fail(source.error());
  return place_copies(*source, *features, {shift_by(by)}, ctx);
}

}  // namespace tedit::ops
