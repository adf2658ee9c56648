// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/builder.hpp"
#include "ops/boolean/cavity.hpp"
#include "ops/boolean/corefine.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// A part taken apart where a tool is: what goes, and what the exact boolean makes of it.
struct cut_cavity {
  cavity hollow;
  corefined cut;
};

/// By how much the exact boolean changes the part's volume, m^3. Cost: O(tets that go).
[[nodiscard]] double wanted_change(const mesh_version& part, const cut_cavity& opened);

/// Is it rounding alone? Cost: O(tool); where it may be, O(part).
[[nodiscard]] bool changes_nothing(const mesh_version& part, const tool_surface& tool,
                                   const cut_cavity& opened);

/// Is that volume (m^3) little beside what is cut or added? Of a `keep`, what is kept is no more
/// than the tool.
[[nodiscard]] bool is_small(double volume, const mesh_version& part, const tool_surface& tool,
                            const cut_cavity& opened);

/// What a filled part is. @param part as it was before all. @param mesh what was cut of it.
[[nodiscard]] boolean_result result_of(mesh_builder& builder, const mesh_version& part,
                                       const mesh_version& mesh);

/// The tets' volume is that of the exact boolean, but for what may be off.
/// @param put_on m^3: by how much vertices that were put on round walls have changed the surface.
/// @param size m: of the tets there. Errors: `mesher_failed`.
[[nodiscard]] expected<void> volume_fits(const mesh_version& part, double size,
                                         const cut_cavity& opened, double put_on,
                                         const boolean_result& result);

}  // namespace tedit::ops
