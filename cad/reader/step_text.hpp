// SPDX-License-Identifier: AGPL-3.0-or-later
// The text of a STEP file (ISO 10303-21) taken apart into its entities.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cad/reader/text_faults.hpp"

namespace tedit::cad {

/// `#16 = CLOSED_SHELL('',(#17,#18));`
struct step_entity {
  std::uint64_t id = 0;
  std::string_view type;    ///< Of one of several types: the first.
  std::string_view inside;  ///< Between the outermost parentheses.
  std::size_t at = 0;       ///< Of its "#" in the text.
};

struct step_text {
  std::vector<step_entity> entities;
  std::string_view schema;  ///< What stands behind FILE_SCHEMA; empty: none.
  std::size_t data_at = 0;  ///< Where the entities begin.
  bool is_whole = true;     ///< Otherwise there are more entities than are kept.
};

/// "#16 = CLOSED_SHELL".
[[nodiscard]] std::string title_of(const step_entity& entity);

/// Takes a text apart, up to the first fault of its grammar.
[[nodiscard]] std::optional<text_fault> take_apart(std::string_view text, step_text& into);

/// The first fault of entities that are well written: what they refer to, how many parameters they
/// have, and whether there is a solid.
[[nodiscard]] std::optional<text_fault> fault_of_entities(const step_text& step);

}  // namespace tedit::cad
