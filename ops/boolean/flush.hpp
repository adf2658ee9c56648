// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "ops/boolean/corefine.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// A face of the tool that lies in a plane with facets of the part, and shall lie there exactly.
struct flush_face {
  vec3 normal;                      ///< Unit, of the part's facets.
  double offset = 0;                ///< m.
  std::vector<vertex_id> part;      ///< The corners of those facets.
  std::vector<std::uint32_t> tool;  ///< Points of the tool.
};

struct flush_tool {
  tool_surface tool;
  std::vector<flush_face> faces;
};

/// Faces of the tool that are flush with facets of the part, within `tolerance` (m). Where the two
/// must not meet in a sheet of no thickness (a cut whose tool ends at the part's outside, an
/// addition that stands on it) the tool gets a layer of `layer` (m) there, if nothing of
/// the part reaches into it; the others are told. Cost: O(faces of the tool x facets near).
/// @param near all live facets that meet the tool's box grown by both; there may be more.
[[nodiscard]] flush_tool make_flush(const mesh_version& mesh, const tool_surface& tool,
                                    boolean_mode mode, const std::vector<facet_id>& near,
                                    double tolerance, double layer);

/// Those planes, for an exact boolean with points that are these vertices of the part.
[[nodiscard]] std::vector<shared_plane> planes_among(const flush_tool& flush,
                                                     const std::vector<vertex_id>& vertices);

}  // namespace tedit::ops
