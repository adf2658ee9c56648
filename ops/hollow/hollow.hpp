// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "ops/hollow/region_walls.hpp"

namespace tedit::ops {

struct hollow_settings {
  double thickness = 0;       ///< m: of the walls that stay.
  double drain_diameter = 0;  ///< m: through the middle of each selected wall; 0: these are open.
  std::vector<vec3> drains = {};         ///< m: places of walls that get a drain hole, too.
  std::optional<region_id> region = {};  ///< The only one that is hollowed; nothing: there is one.
};

/// What the parameters of the operation ask for. Errors: `invalid_parameter` for drains without a
/// diameter, those of `region_meant`.
[[nodiscard]] expected<hollow_settings> hollow_settings_of(const mesh_version& mesh,
                                                           const std::vector<surface_id>& picked,
                                                           const parameters& values);

/// Makes a shell of the part: what lies deeper below its walls than their thickness goes. Selected
/// walls are open or get a drain hole each; without any a closed void is left. What is thinner than
/// twice the thickness stays full. Of a part with several regions one is hollowed, to where the
/// others begin; these keep their shape. Errors: `invalid_argument` where nothing of the part is
/// thick enough, or it would fall into pieces; those of `isosurface` and of `services::boolean`.
[[nodiscard]] expected<edit_result> hollow(const version_ptr& mesh,
                                           const std::vector<surface_id>& picked,
                                           const hollow_settings& settings, context& ctx);

}  // namespace tedit::ops
