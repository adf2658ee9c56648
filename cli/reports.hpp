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

/// The JSON object of `tedit solve`, but for the times that only the caller knows.
[[nodiscard]] nlohmann::ordered_json to_json(const solve_report& report);

/// The same for people, indented; without times.
[[nodiscard]] std::string describe(const solve_report& report);

}  // namespace tedit::cli
