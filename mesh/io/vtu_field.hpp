// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace tedit {

/// A field of a file, a number at each of its points.
struct point_field {
  std::string name;            ///< "von_mises_pa".
  std::vector<double> values;  ///< In the order of the file; of vectors and tensors the length.
};

/// A field at the points of a VTU file, by its name with or without its unit ("von_mises"). Errors:
/// `invalid_argument` for a file of another format or without such a field, naming those that it
/// has; `bad_input`. Cost: O(file), memory of the field and the file's head.
[[nodiscard]] expected<point_field> read_point_field(std::span<const char> bytes,
                                                     std::string_view name);

}  // namespace tedit
