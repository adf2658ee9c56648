// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "mesh/version.hpp"

namespace tedit {

/// What surfaces and regions are called in decks, whose names have few characters and no case.
[[nodiscard]] std::string surface_word(surface_id id);  ///< "SURFACE-12".
[[nodiscard]] std::string region_word(region_id id);    ///< "REGION-3".

/// The comments that `deck_builder::read_comment` reads: the unit, and ids and names as they are.
/// `comment` begins a comment line: "** ", "$ ".
void write_name_comments(std::ostream& out, std::string_view comment, const mesh_version& mesh,
                         std::string_view length_unit);

}  // namespace tedit
