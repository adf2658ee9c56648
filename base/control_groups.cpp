// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/control_groups.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <string>

namespace tedit {

namespace {

namespace fs = std::filesystem;

/// Whether "cpu,cpuacct" has "cpu"; the empty list of version 2 has the empty name.
bool has(std::string_view list, std::string_view controller) {
  for (std::size_t first = 0;;) {
    const auto end = list.find(',', first);
    if (list.substr(first, end == std::string_view::npos ? end : end - first) == controller)
      return true;
    if (end == std::string_view::npos)
      return false;
    first = end + 1;
  }
}

/// The path behind "0::" or "4:memory:". In a container it may be the host's, which is not there
/// ("/../../docker/1234"): then the group is the top of what the container sees.
fs::path group_path(const fs::path& root, std::string_view controller) {
  std::ifstream in(root / "proc/self/cgroup");
  std::string line;
  while (std::getline(in, line)) {
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (second != std::string::npos &&
        has(std::string_view(line).substr(first + 1, second - first - 1), controller))
      return fs::path(line.substr(second + 1)).relative_path();
  }
  return {};
}

std::vector<fs::path> folders(const fs::path& top, const fs::path& path) {
  std::vector<fs::path> result{top};
  if (std::ranges::find(path, fs::path("..")) != path.end())
    return result;
  for (const auto& name : path)
    if (!name.empty())
      result.push_back(result.back() / name);
  return result;
}

}  // namespace

std::vector<fs::path> control_groups(const fs::path& root) {
  return folders(root / "sys/fs/cgroup", group_path(root, ""));
}

std::vector<fs::path> control_groups_v1(std::string_view controller, const fs::path& root) {
  return folders(root / "sys/fs/cgroup" / controller, group_path(root, controller));
}

std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::ifstream in(file);
  std::string word;
  in >> word;
  std::uint64_t value = 0;
  const auto [end, why] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = why == std::errc() && end == word.data() + word.size();
  return whole ? std::optional(value) : std::nullopt;
}

}  // namespace tedit
