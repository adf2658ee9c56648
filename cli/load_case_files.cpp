// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/load_case_files.hpp"

#include <filesystem>
#include <set>

#include "protocol/convert.hpp"

namespace tedit::cli {

void name_apart(std::vector<fem::load_case>& load_cases) {
  std::set<std::string> names;
  for (auto& one : load_cases) {
    const auto name = one.name;
    for (int i = 2; !names.insert(one.name).second; ++i)
      one.name = name + " " + std::to_string(i);
  }
}

expected<std::vector<fem::load_case>> read_load_cases(const std::vector<std::string>& files) {
  std::vector<fem::load_case> cases;
  for (const auto& file : files) {
    auto one = protocol::load_case_from_file(file);
    if (!one)
      return fail(one.error());
    if (files.size() > 1 && one->name.empty())
      one->name = std::filesystem::path(file).stem().string();
    cases.push_back(std::move(*one));
  }
  name_apart(cases);
  return cases;
}

}  // namespace tedit::cli
