// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/attachment.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// The closed surface in a file, in the file's own unit, by the suffix of its name: STL (text or
/// binary), OBJ, OFF, PLY, or the boundary of a Gmsh mesh. Equal corners are one; triangles of no
/// area are left out; a surface that looks inward is turned. Its faces are the mesh's surfaces, for
/// the other formats what hangs together over edges of less than 30 degrees. Errors:
/// `unsupported_format`, `bad_input` for what cannot be read, has more than 200,000 triangles or is
/// not closed, with the place. Cost: O(n log n).
[[nodiscard]] expected<tool_surface> read_surface(const attachment& file);

}  // namespace tedit::ops
