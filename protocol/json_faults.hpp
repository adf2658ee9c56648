// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace tedit::protocol {

/// What is wrong with a JSON text, for people.
struct json_fault {
  std::string message;  ///< "loads[0].force has no field \"total\"".
  std::string place;    ///< "line 3, column 7" or "loads[0].force"; empty where it is the whole.
};

/// Puts what the parser of Protocol Buffers says of a text into plain words. The place is only told
/// where it is certain: the parser shows some letters, which may be there several times. Words that
/// are not known stay as they are. Cost: O(json).
[[nodiscard]] json_fault json_fault_of(std::string_view json, std::string_view said);

}  // namespace tedit::protocol
