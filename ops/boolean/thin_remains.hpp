// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ops/boolean/boolean.hpp"
#include "ops/boolean/surface_mesh.hpp"

namespace tedit::ops {

/// What is thinner than this share of an edge is thin.
inline constexpr double thin_share = 0.3;

/// A vertex close behind a face that looks the other way: what is between both is thin.
struct thin_place {
  std::uint32_t vertex = 0;
  std::uint32_t face = 0;
  vec3 foot;       ///< Of the face, nearest to the vertex.
  double gap = 0;  ///< m
};

/// For each vertex the nearest face that looks away from it through the material, where that is
/// nearer than `thin_share` of the vertex's size. Left out are wedges, whose sides meet in an edge
/// not far away: there is no size at which triangles are as small as what is between them. Cost:
/// O(faces log faces).
[[nodiscard]] std::vector<thin_place> thin_places(const surface_mesh& mesh);

/// The thinnest of them where something is new, if less than a tenth of `size` (m) and more than
/// rounding.
[[nodiscard]] std::optional<thin_remain> thinnest(const surface_mesh& mesh, double size);

/// mm, two digits.
[[nodiscard]] std::string thickness_text(const thin_remain& thin);

/// Why no boolean with tets of such a radius ratio is taken.
[[nodiscard]] error too_flat(double quality, const std::optional<thin_remain>& thin);

/// Triangles there want edges no longer than `edges` times the gap, but not below `least` (m).
/// Sizes only get smaller; has any?
bool shrink_at(surface_mesh& mesh, const std::vector<thin_place>& places, double edges,
               double least);

}  // namespace tedit::ops
