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

}  // namespace tedit::desktop
