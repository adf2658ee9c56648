// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/field_values.hpp"

#include <algorithm>
#include <cmath>

namespace tedit::desktop {

float value_in(const client::field_event& field, std::size_t i, shown_field wanted) {
  const auto component = [&](std::size_t c) {
    return field.displacement.empty() ? NAN : field.displacement[3 * i + c];
  };
  switch (wanted) {
    case shown_field::von_mises:
      return field.von_mises[i];
    case shown_field::displacement:
      return std::hypot(component(0), component(1), component(2));
    case shown_field::displacement_x:
      return component(0);
    case shown_field::displacement_y:
      return component(1);
    case shown_field::displacement_z:
      return component(2);
    case shown_field::safety_factor:
      return field.safety_factor.empty() || field.safety_factor[i] == 0 ? NAN
                                                                        : field.safety_factor[i];
    default:
      return NAN;
  }
}

float value_at(const client::field_event& field, std::uint32_t slot, shown_field wanted) {
  const auto at = std::ranges::lower_bound(field.vertices, slot);
  if (at == field.vertices.end() || *at != slot)
    return NAN;
  return value_in(field, static_cast<std::size_t>(at - field.vertices.begin()), wanted);
}

}  // namespace tedit::desktop
