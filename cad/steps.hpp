// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "cad/editing.hpp"
#include "edit/report.hpp"
#include "mesh/version.hpp"

namespace tedit::cad {

/// How an edit that was made on a mesh is made on the CAD model. @param description of the
/// operation; `report`: of the edit. What the edit made of the mesh is left to who asks. The other
/// outcome is why it is not, for a person. Cost: some rays.
[[nodiscard]] tl::expected<cad_step, std::string> step_of(
  const ops::operation_description& description, const mesh_version& before,
  const edit_request& wanted, const edit_report& report);

}  // namespace tedit::cad
