// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ops/sdk/operation.hpp"

namespace tedit::cli {

/// "name=value" pairs to parameters. Errors: `usage`.
[[nodiscard]] expected<ops::parameters> parse_parameters(const std::vector<std::string>& pairs);

}  // namespace tedit::cli
