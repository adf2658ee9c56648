// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/parameters.hpp"

namespace tedit::cli {

expected<ops::parameters> parse_parameters(const std::vector<std::string>& pairs) {
  ops::parameters result;
  for (const auto& pair : pairs) {
    const auto split = pair.find('=');
    if (split == std::string::npos || split == 0)
      return fail(ec::usage, "\"" + pair + "\" is no parameter", "Write NAME=VALUE");
    result[pair.substr(0, split)] = pair.substr(split + 1);
  }
  return result;
}

}  // namespace tedit::cli
