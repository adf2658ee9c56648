// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ops/sdk/operation.hpp"

namespace tedit::cli {

/// "name=value" pairs to parameters. Errors: `usage`.
[[nodiscard]] expected<ops::parameters> parse_parameters(const std::vector<std::string>& pairs);

/// The same where the paths of files are replaced by what is in them. Errors: those of
/// `attach_file`.
[[nodiscard]] expected<ops::parameters> with_files(const ops::operation_description& about,
                                                   ops::parameters given);

}  // namespace tedit::cli
