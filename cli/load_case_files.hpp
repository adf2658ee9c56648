// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"
#include "fem/load_case.hpp"

namespace tedit::cli {

/// Reads load cases of which each is a file. Several have names of their own: a case without one is
/// called after its file, and a name that was there before gets a number. Errors: those of
/// `protocol::load_case_from_file`.
[[nodiscard]] expected<std::vector<fem::load_case>> read_load_cases(
  const std::vector<std::string>& files);

/// Gives a name that was there before a number: "braking 2".
void name_apart(std::vector<fem::load_case>& load_cases);

}  // namespace tedit::cli
