// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "fem/load_case.hpp"

namespace tedit::protocol {

/// Parses the canonical JSON of `tedit.v1.LoadCase`. Errors: `bad_input` naming the field, the
/// constraint or the load, also for a number that `check_numbers` refuses; `where` is `source`.
[[nodiscard]] expected<fem::load_case> load_case_from_json(std::string_view json,
                                                           const std::string& source);

/// The same from a file. Errors: also `io_error`.
[[nodiscard]] expected<fem::load_case> load_case_from_file(const std::filesystem::path& path);

/// Canonical JSON with the original field names, indented.
[[nodiscard]] std::string load_case_to_json(const fem::load_case& loads);

}  // namespace tedit::protocol
