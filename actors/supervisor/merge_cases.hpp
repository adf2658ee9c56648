// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "actors/local_messages.hpp"

namespace tedit::actors {

/// The results of load cases that were solved in different places as one, with its envelope.
struct merged_cases {
  solve_result result;  ///< Without `source`; what only files have is listed and stays where it is.
  std::vector<page_ptr> pages;  ///< Of its fields, those that were brought.
};

/// The shown arrays of one part that the whole has, too: all but its envelope.
[[nodiscard]] std::vector<field_ref> arrays_of_cases(const solve_result& part);

/// `parts` in any order; their reports are put into that of `load_cases`.
/// @param pages those of `arrays_of_cases` of all parts, at least of what envelopes are made of.
/// Errors: `protocol_error` where parts do not have what they should. Cost: O(vertices) a case.
[[nodiscard]] expected<merged_cases> merge_cases(std::span<const solve_result> parts,
                                                 const std::vector<std::string>& load_cases,
                                                 const page_set& pages);

/// `load_cases` in at most `places` lists of about one length, those with the same supports
/// together: they share a system.
[[nodiscard]] std::vector<load_case_list> spread_cases(const load_case_list& load_cases,
                                                       std::size_t places);

}  // namespace tedit::actors
