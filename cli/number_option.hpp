// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include "base/number_range.hpp"

namespace tedit::cli {

/// What an option takes that is a number with a fraction: CLI11's own checks let nan pass. Here,
/// for the program that draws pictures knows no other file of cli/.
[[nodiscard]] inline CLI::Validator number_in(const number_range& range) {
  const auto text = number_text(range.least) + " to " + number_text(range.most);
  return {[range](std::string& given) -> std::string {
            double value = 0;
            if (!CLI::detail::lexical_cast(given, value))
              return "\"" + given + "\" is no number";
            const auto ok = check_number(value, range, "it");
            return ok ? std::string{} : ok.error().message + ". " + ok.error().remedy;
          },
          text, "number"};
}

}  // namespace tedit::cli
