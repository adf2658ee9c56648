// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Groups of formats that have no ids of their own: "surface 12: Bore", "region 3: Steel".
namespace tedit {

struct group_name {
  std::int64_t id = 0;
  std::string name;      ///< Empty: none.
  std::size_t part = 1;  ///< Of a name that goes on in other groups, from 1.
};

/// What a group is called that stands for a surface ("surface") or region ("region").
[[nodiscard]] std::string name_of_group(std::string_view word, std::int64_t id,
                                        std::string_view name);

/// The same, no longer than `most` bytes each (at least 60): a longer name goes on in a second
/// group, "surface 12 (2): ...", and so on.
[[nodiscard]] std::vector<std::string> names_of_group(std::string_view word, std::int64_t id,
                                                      std::string_view name, std::size_t most);

/// The inverse for one group; nothing for a name that somebody else gave.
[[nodiscard]] std::optional<group_name> own_group(std::string_view group, std::string_view word);

}  // namespace tedit
