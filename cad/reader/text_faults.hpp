// SPDX-License-Identifier: AGPL-3.0-or-later
// What the text of a CAD file shows of why it could not be read. A reader takes much that a
// standard forbids, so the faults refuse no file: they are asked for once reading has failed. Only
// the two checks at the end come before it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace tedit::cad {

/// A fault of a text, for a person.
struct text_fault {
  std::size_t at = 0;  ///< Where in the text, in bytes; the line is told by it.
  std::string entity;  ///< What it is in: "#16 = CLOSED_SHELL"; may be empty.
  std::string cause;   ///< "it refers to #9999, which is not there".
  std::string remedy;
};

/// The first fault of a text that can be named. Memory: 48 bytes an entity, of four million at
/// most; what lies beyond is not looked at. Cost: O(bytes).
[[nodiscard]] std::optional<text_fault> fault_of_step(std::string_view text);
[[nodiscard]] std::optional<text_fault> fault_of_iges(std::string_view text);
[[nodiscard]] std::optional<text_fault> fault_of_brep(std::string_view text);

/// Why a file of the kind ("step", "iges", "brep") cannot be read, `where` being its path with line
/// and entity; nothing where its text shows no fault, or is larger than 1 GiB. Cost: O(bytes).
[[nodiscard]] std::optional<error> fault_of_text(const std::string& kind, const std::string& file);

/// Refuses a STEP or BREP file that has a word such as nan or inf where a number belongs: no CAD
/// program means it, OpenCASCADE takes it or works at it without an end, and meshers die of it. Not
/// IGES, whose texts stand among its numbers without quotes.
/// Errors: `bad_input` with the line, and with the entity where that is known. Cost: O(bytes).
[[nodiscard]] expected<void> check_finite(const std::string& kind, const std::string& file);

/// Refuses a BREP file that says that it has more of something than its bytes can hold, for
/// OpenCASCADE would read on and on. Errors: `bad_input` with the line. Cost: O(bytes).
[[nodiscard]] expected<void> check_brep_counts(const std::string& file);

/// Does a BREP file say behind its shapes which of them is the part? Where it is cut off before
/// that OpenCASCADE takes what its memory holds. Looks at its end alone.
[[nodiscard]] bool names_its_part(const std::string& brep_file);

}  // namespace tedit::cad
