// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/version_lanes.hpp"

#include <algorithm>
#include <vector>

namespace tedit::desktop {

namespace {

/// A version and the first children that follow it, one after the other: they share a lane.
struct strand {
  std::vector<std::uint32_t> members;
  int column = 0;  ///< Of the first.
  int above = 0;   ///< The lane it hangs on.
};

}  // namespace

/// Strands that begin farther right are placed first, so that what hangs on an earlier version
/// passes below them.
std::map<std::uint32_t, version_place> lanes_of(
  const std::map<std::uint32_t, std::optional<std::uint32_t>>& parents) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> children;
  std::vector<std::uint32_t> roots;
  for (const auto& [number, parent] : parents)
    if (parent && parents.contains(*parent))
      children[*parent].push_back(number);
    else
      roots.push_back(number);
  std::map<std::uint32_t, version_place> result;
  std::vector<int> begins;  // The leftmost column in use, by lane.
  const auto place = [&](const strand& s) {
    const int end = s.column + static_cast<int>(s.members.size());  // Past the last column.
    auto lane = static_cast<std::size_t>(s.above);
    while (lane < begins.size() && begins[lane] < end)
      ++lane;
    begins.resize(std::max(begins.size(), lane + 1), 1 << 30);
    begins[lane] = s.column;
    int column = s.column;
    for (const auto number : s.members)
      result[number] = {column++, static_cast<int>(lane)};
    return static_cast<int>(lane);
  };
  const auto strand_from = [&](std::uint32_t first, int column, int above) {
    strand s{{first}, column, above};
    for (auto next = children.find(first); next != children.end();
         next = children.find(s.members.back()))
      s.members.push_back(next->second.front());
    return s;
  };
  for (const auto root : roots) {
    // A stack instead of a recursion: a document may have thousands of versions in a row.
    std::vector<strand> open{strand_from(root, 0, static_cast<int>(begins.size()))};
    while (!open.empty()) {
      const auto s = open.back();
      open.pop_back();
      const int lane = place(s);
      for (std::size_t i = 0; i < s.members.size(); ++i) {
        const auto all = children.find(s.members[i]);
        // What is pushed last is taken first: of several branches the oldest is the nearest.
        for (std::size_t k = all == children.end() ? 1 : all->second.size(); k-- > 1;)
          open.push_back(strand_from(all->second[k], s.column + static_cast<int>(i) + 1, lane + 1));
      }
    }
  }
  return result;
}

}  // namespace tedit::desktop
