// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/node_index.hpp"

#include <algorithm>

namespace tedit {

std::optional<std::uint64_t> node_index::make(const std::vector<std::uint64_t>& numbers) {
  const auto largest = *std::ranges::max_element(numbers);
  const bool dense = largest / 4 <= numbers.size();
  if (dense)
    dense_.assign(largest + 1, no_id);
  else
    sparse_.reserve(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = numbers[i];
    const bool fresh =
      dense ? dense_[number] == no_id : sparse_.emplace(number, static_cast<vertex_id>(i)).second;
    if (!fresh)
      return number;
    if (dense)
      dense_[number] = static_cast<vertex_id>(i);
  }
  return std::nullopt;
}

std::optional<vertex_id> node_index::find(std::uint64_t number) const {
  if (!dense_.empty()) {
    if (number >= dense_.size() || dense_[number] == no_id)
      return std::nullopt;
    return dense_[number];
  }
  const auto found = sparse_.find(number);
  return found == sparse_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace tedit
