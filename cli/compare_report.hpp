// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "compare/comparison.hpp"

namespace tedit::cli {

/// The JSON object of `tedit compare` (docs/command_line.md). Keys of unknown values are left out.
[[nodiscard]] nlohmann::ordered_json to_json(const version_comparison& all);

/// The same for people, indented; surfaces that did not change are counted, not listed.
[[nodiscard]] std::string describe_comparison(const version_comparison& all);

}  // namespace tedit::cli
