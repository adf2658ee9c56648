// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "verification/suite.hpp"

namespace tedit::verification {

/// The convergence study as an SVG picture: relative error over cell size, both logarithmic, one
/// panel for each norm, with triangles of the slopes that theory promises. Needs two rows of each
/// order that it shows; fewer give an empty frame.
[[nodiscard]] std::string convergence_svg(std::span<const convergence_row> rows);

}  // namespace tedit::verification
