// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/paged_array.hpp"

namespace tedit {

enum class field_location { vertex, tet };

/// A named array over the vertex or tet slots of one version, `components` doubles per slot; free
/// slots hold zeros. Paged like a version, so that it is shared, sent and stored the same way.
struct field {
  std::string name;  ///< With its unit: "displacement_m", "von_mises_pa".
  field_location location = field_location::vertex;
  int components = 1;
  paged_array<double> values;

  [[nodiscard]] double at(std::size_t slot, int component = 0) const {
    return values[slot * static_cast<std::size_t>(components) +
                  static_cast<std::size_t>(component)];
  }
};

/// The field with this name, or null.
[[nodiscard]] inline const field* find_field(const std::vector<field>& fields,
                                             std::string_view name) {
  for (const auto& f : fields)
    if (f.name == name)
      return &f;
  return nullptr;
}

}  // namespace tedit
