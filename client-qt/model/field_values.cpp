// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/field_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tedit::desktop {

std::array<double, 3> principal_values(const float* s) {
  const double mean = (double{s[0]} + s[1] + s[2]) / 3;
  const std::array<double, 3> d{s[0] - mean, s[1] - mean, s[2] - mean};
  const double xy = s[3];
  const double yz = s[4];
  const double zx = s[5];
  const double p =
    std::sqrt((d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + 2 * (xy * xy + yz * yz + zx * zx)) / 6);
  if (!(p > 0))
    return {mean, mean, mean};
  const double det =
    d[0] * (d[1] * d[2] - yz * yz) - xy * (xy * d[2] - yz * zx) + zx * (xy * yz - d[1] * zx);
  const double angle = std::acos(std::clamp(det / (2 * p * p * p), -1.0, 1.0)) / 3;
  const double first = mean + 2 * p * std::cos(angle);
  const double last = mean + 2 * p * std::cos(angle + 2 * std::numbers::pi / 3);
  return {first, 3 * mean - first - last, last};
}

value_reader::value_reader(const client::named_arrays<float>& from, shown_field wanted) {
  if (!is_of_result(wanted))
    return;
  what_ = &quantity_of(wanted);
  array_ = &from.of(what_->array);
  const auto* form = fem::find_array(what_->array);
  components_ = static_cast<std::size_t>(form->components);
  zero_is_none_ = form->needs_yield;
}

float value_reader::operator()(std::size_t i) const {
  if (!array_ || components_ * i >= array_->size())
    return NAN;
  const float* row = &(*array_)[components_ * i];
  const auto index = static_cast<std::size_t>(what_->index);
  switch (what_->part) {
    case fem::shown_part::component:
      return zero_is_none_ && row[index] == 0 ? NAN : row[index];
    case fem::shown_part::size:
      return static_cast<float>(norm({row[0], row[1], row[2]}));
    case fem::shown_part::principal:
      return static_cast<float>(principal_values(row)[index]);
    case fem::shown_part::max_shear:
      const auto p = principal_values(row);
      return static_cast<float>((p[0] - p[2]) / 2);
  }
  return NAN;
}

client::watched_quantities needs(shown_field wanted) {
  if (!is_of_result(wanted))
    return {};
  const auto* array = fem::find_array(quantity_of(wanted).array);
  if (array->sent == fem::array_sent::always)
    return {};
  return {std::string(array->name)};
}

bool has(const client::field_event& field, shown_field wanted) {
  return std::ranges::none_of(needs(wanted),
                              [&](const auto& name) { return field.values.of(name).empty(); });
}

float value_in(const client::field_event& field, std::size_t i, shown_field wanted) {
  return value_reader(field.values, wanted)(i);
}

float value_in(const client::section& cut, std::size_t i, shown_field wanted) {
  return value_reader(cut.values, wanted)(i);
}

float value_at(const client::field_event& field, std::uint32_t slot, shown_field wanted) {
  const auto at = std::ranges::lower_bound(field.vertices, slot);
  if (at == field.vertices.end() || *at != slot)
    return NAN;
  return value_in(field, static_cast<std::size_t>(at - field.vertices.begin()), wanted);
}

}  // namespace tedit::desktop
