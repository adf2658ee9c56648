// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <vector>

#include "client-qt/model/legend.hpp"
#include "client-qt/view/part_geometry.hpp"

namespace tedit::desktop {

/// One value for each point of a section; none when it has no such field.
[[nodiscard]] std::vector<float> values_of(const client::section& cap, shown_field wanted);

/// One value for each point of a part: the field's, SI; NaN where it has none. Cost: O(points).
[[nodiscard]] std::vector<float> values_of(const part_geometry& part,
                                           const client::field_event& field, shown_field wanted);

/// What the colours on a part say.
struct painted_values {
  /// Smallest and largest value, and where they are.
  struct range {
    double low = 0;
    double high = 0;
    vec3 low_at;
    vec3 high_at;
  };

  legend by;
  std::vector<float> values;      ///< One for each point of the geometry; none without a field.
  std::optional<range> extremes;  ///< Nothing without a field.

  void find_extremes(const part_geometry& part);
};

}  // namespace tedit::desktop
