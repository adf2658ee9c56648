// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/attachment.hpp"
#include "ops/tools/profiles.hpp"

namespace tedit::ops {

/// The filled shapes of an SVG picture (path, rect, circle, ellipse, polygon, polyline, with their
/// groups and transforms) as outlines around the origin, the picture's longer side `size` m long,
/// curves in edges of about `edge` m. What lies in another outline is a hole in it (even-odd),
/// whatever its colour; strokes, texts, clips and what `use` refers to are left out. All walls are
/// one side, "side". Errors: `bad_input` for what is no SVG, has no filled shape, or more than
/// 20,000 edges.
[[nodiscard]] expected<profile> svg_outlines(const attachment& file, double size, double edge);

}  // namespace tedit::ops
