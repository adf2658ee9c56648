// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/optimize/improve.hpp"

namespace tedit {

/// The thorough pass of `improve` over exactly these tets. The builder changes at the very end
/// only. Errors: those of `improve`.
[[nodiscard]] expected<improve_report> improve_thoroughly(mesh_builder& mesh,
                                                          std::vector<tet_id> tets,
                                                          const thorough_settings& settings,
                                                          const execution& run);

}  // namespace tedit
