// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "protocol/report.hpp"

namespace tedit::cli {

/// The JSON object of `tedit edit`.
[[nodiscard]] nlohmann::ordered_json to_json(const edit_report& report);

/// The same for people, indented.
[[nodiscard]] std::string describe(const edit_report& report);

/// The JSON object of `tedit solve` (docs/results.md), but for the times that only the caller
/// knows. Keys of unknown values are left out. Numbers are as they were computed, noise included.
[[nodiscard]] nlohmann::ordered_json to_json(const solve_report& report);

/// The same for people, indented; without times and remarks.
[[nodiscard]] std::string describe(const solve_report& report);

/// What belongs below the times: the reactions when several surfaces hold the part, how it was
/// computed where that is not as asked for, and warnings about loads and about a largest stress
/// that says nothing about strength.
[[nodiscard]] std::string remarks(const solve_report& report);

/// The JSON object of `tedit solve` with several load cases, but for the times: `cases`, each as
/// above without times, and `envelope`. Of one load case: as above.
[[nodiscard]] nlohmann::ordered_json to_json(const solve_outcome& outcome);

/// The same for people: a table with a row for each case, the worst of all, and the warnings. Of
/// one load case: as above.
[[nodiscard]] std::string describe(const solve_outcome& outcome);

/// Only what says how strong the part is and how far that can be trusted, in few lines; of several
/// load cases the table and the worst of all.
[[nodiscard]] std::string summarize(const solve_report& report);
[[nodiscard]] std::string summarize(const solve_outcome& outcome);

/// Why the numbers are not final, as a line; empty when they are.
[[nodiscard]] std::string preview_text(const solve_outcome& outcome);

/// A number for people, 0 when it is at most `noise` of `scale`: next to 20 kN a reaction of 1e-5 N
/// is what the solver's tolerance left over, and reads as if it meant something.
[[nodiscard]] std::string without_noise(double value, double scale, int digits,
                                        double noise = 1e-5);

/// Three such numbers, "x, y, z".
[[nodiscard]] std::string components(vec3 v, int digits, double scale, double noise = 1e-5);

}  // namespace tedit::cli
