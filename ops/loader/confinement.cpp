// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/loader/confinement.hpp"

#include <algorithm>

namespace tedit::ops {

sandbox::reach reach_of_plugins(const std::vector<std::filesystem::path>& files) {
  sandbox::reach result;
  result.readable = sandbox::system_files();
  for (const auto& file : files) {
    std::error_code code;
    auto folder = std::filesystem::absolute(file, code).parent_path();
    if (!code && std::ranges::find(result.readable, folder) == result.readable.end())
      result.readable.push_back(std::move(folder));
  }
  return result;
}

expected<void> confine_to(const sandbox::reach& reach) {
  if (!sandbox::is_wanted())
    return {};
  if (auto ok = sandbox::confine_files(reach); !ok)
    return ok;
  return sandbox::confine_calls();
}

}  // namespace tedit::ops
