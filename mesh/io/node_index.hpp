// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "mesh/types.hpp"

namespace tedit {

/// Places of nodes by their numbers in a file: a table where these are dense, else a hash table, so
/// that a large number takes no memory.
class node_index {
public:
  /// Gives the number that is there twice, if any. `numbers`: at least one. Cost: O(numbers).
  [[nodiscard]] std::optional<std::uint64_t> make(const std::vector<std::uint64_t>& numbers);

  [[nodiscard]] std::optional<vertex_id> find(std::uint64_t number) const;

private:
  std::vector<vertex_id> dense_;
  std::unordered_map<std::uint64_t, vertex_id> sparse_;
};

}  // namespace tedit
