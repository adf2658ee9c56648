// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "base/error.hpp"

namespace tedit::cad {

/// Why OpenCASCADE could not read the text of a STEP file, with the line where it ends if it is cut
/// off. Cost: O(bytes).
[[nodiscard]] error step_fault(const std::string& file);

/// Refuses a BREP file that says that it has more of something than its bytes can hold, for
/// OpenCASCADE would read on and on. Errors: `bad_input` with the line. Cost: O(bytes).
[[nodiscard]] expected<void> check_brep_counts(const std::string& file);

}  // namespace tedit::cad
