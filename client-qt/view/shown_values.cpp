// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/shown_values.hpp"

#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

#include "client-qt/model/field_values.hpp"

namespace tedit::desktop {

std::vector<float> values_of(const part_geometry& part, const client::field_event& field,
                             shown_field wanted) {
  std::vector<float> result;
  result.reserve(part.vertices.size());
  const value_reader value(field.values, wanted);
  for (const auto slot : part.vertices) {
    const auto at = std::ranges::lower_bound(field.vertices, slot);
    const bool known = at != field.vertices.end() && *at == slot;
    result.push_back(known ? value(static_cast<std::size_t>(at - field.vertices.begin())) : NAN);
  }
  return result;
}

std::vector<float> values_of(const client::section& cap, shown_field wanted) {
  std::vector<float> result;
  result.reserve(cap.positions.size() / 3);
  const value_reader value(cap.values, wanted);
  for (std::size_t i = 0; 3 * i < cap.positions.size(); ++i)
    result.push_back(value(i));
  if (std::ranges::none_of(result, [](float one) { return std::isfinite(one); }))
    result.clear();
  return result;
}

void painted_values::find_extremes(const part_geometry& part) {
  std::size_t low = values.size();
  std::size_t high = values.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]))
      continue;
    if (low == values.size() || values[i] < values[low])
      low = i;
    if (high == values.size() || values[i] > values[high])
      high = i;
  }
  const auto at = [&](std::size_t i) {
    std::array<double, 3> p{};
    part.faces->GetPoints()->GetPoint(static_cast<vtkIdType>(i), p.data());
    return vec3{p[0], p[1], p[2]};
  };
  if (low < values.size())
    extremes = range{values[low], values[high], at(low), at(high)};
}

}  // namespace tedit::desktop
