// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "base/error.hpp"
#include "fem/load_case.hpp"

namespace tedit::v1 {
class LoadCase;
class LoadCasesChanged;
}  // namespace tedit::v1

namespace tedit::protocol {

void to_message(const fem::load_case& loads, v1::LoadCase* out);

/// Errors: `bad_input` naming the field, the constraint or the load, also for a number that
/// `check_numbers` refuses and a name that is too long.
[[nodiscard]] expected<fem::load_case> from_message(const v1::LoadCase& message);

/// The same for each load case of a list, `Add`-ed to or read from a repeated field.
template <class List>
void to_messages(const std::vector<fem::load_case>& load_cases, List* out) {
  for (const auto& one : load_cases)
    to_message(one, out->Add());
}

template <class List>
[[nodiscard]] expected<std::vector<fem::load_case>> from_messages(const List& messages) {
  std::vector<fem::load_case> result;
  for (const auto& one : messages) {
    auto read = from_message(one);
    if (!read)
      return fail(read.error());
    result.push_back(std::move(*read));
  }
  return result;
}

/// A list as one message; the document and the version are not set.
void to_message(const std::vector<fem::load_case>& load_cases, v1::LoadCasesChanged* out);
[[nodiscard]] expected<std::vector<fem::load_case>> from_message(
  const v1::LoadCasesChanged& message);

}  // namespace tedit::protocol
