// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/shown_values.hpp"

#include <algorithm>
#include <cmath>

#include "client-qt/model/field_values.hpp"

namespace tedit::desktop {

std::vector<float> values_of(const part_geometry& part, const client::field_event& field,
                             shown_field wanted) {
  std::vector<float> result;
  result.reserve(part.vertices.size());
  for (const auto slot : part.vertices)
    result.push_back(desktop::value_at(field, slot, wanted));
  return result;
}

std::vector<float> values_of(const client::section& cap, shown_field wanted) {
  std::vector<float> result;
  result.reserve(cap.positions.size() / 3);
  for (std::size_t i = 0; 3 * i < cap.positions.size(); ++i)
    result.push_back(value_in(cap, i, wanted));
  if (std::ranges::none_of(result, [](float value) { return std::isfinite(value); }))
    result.clear();
  return result;
}

}  // namespace tedit::desktop
