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

/// Of the parameters "profile" and "file": what `profile_from` gives, or with the profile "file"
/// the outlines in the file. Errors: those of both, `invalid_parameter` where no file is given.
[[nodiscard]] expected<profile> profile_or_file(const parameters& values, double size);

/// The parameter "file" for such a picture.
[[nodiscard]] parameter_description outline_file_parameter(const std::string& help);

/// `profile_parameters` with the profile "file" and that parameter.
[[nodiscard]] std::vector<parameter_description> profiles_with_file();

}  // namespace tedit::ops
