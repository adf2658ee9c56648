// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/face_table.hpp"

#include <algorithm>
#include <tuple>

namespace tedit {

face_table::face_table(const std::vector<tet>& tets, std::size_t vertices)
    : first_(vertices + 1, 0), entries_(4 * tets.size()) {
  for (const auto& t : tets)
    for (int face = 0; face < 4; ++face)
      ++first_[make_face_key(t, face).v[0] + 1];
  for (std::size_t v = 1; v < first_.size(); ++v)
    first_[v] += first_[v - 1];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t t = 0; t < tets.size(); ++t) {
    for (std::uint32_t face = 0; face < 4; ++face) {
      const auto key = make_face_key(tets[t], static_cast<int>(face));
      entries_[next[key.v[0]]++] = {key.v[1], key.v[2],
                                    (key.odd ? entry::odd_flag : 0) | t << 2 | face};
    }
  }
  const auto order = [](const entry& e) {
    return std::tuple(e.middle, e.largest, e.slot & ~entry::odd_flag);
  };
  for (std::size_t v = 0; v + 1 < first_.size(); ++v)
    std::ranges::sort(entries_.begin() + static_cast<std::ptrdiff_t>(first_[v]),
                      entries_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]), {}, order);
}

std::span<const face_table::entry> face_table::find(const face_key& key) const {
  if (key.v[0] + 1 >= first_.size())
    return {};
  const auto bucket = std::span<const entry>(entries_).subspan(
    first_[key.v[0]], first_[key.v[0] + 1] - first_[key.v[0]]);
  const auto same = [&](const entry& e) { return e.middle == key.v[1] && e.largest == key.v[2]; };
  const auto begin = std::ranges::find_if(bucket, same);
  const auto end = std::find_if_not(begin, bucket.end(), same);
  return {begin, end};
}

}  // namespace tedit
