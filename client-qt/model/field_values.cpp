// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/field_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tedit::desktop {

namespace {

using enum shown_field;

/// A quantity of the stress at one place.
float of_stress(const float* s, shown_field wanted) {
  if (wanted >= stress_xx && wanted <= stress_zx)
    return s[static_cast<int>(wanted) - static_cast<int>(stress_xx)];
  const auto p = principal_values(s);
  if (wanted == max_shear)
    return static_cast<float>((p[0] - p[2]) / 2);
  return static_cast<float>(
    p[static_cast<std::size_t>(wanted) - static_cast<std::size_t>(principal_1)]);
}

float of_displacement(const float* u, shown_field wanted) {
  if (wanted == displacement)
    return static_cast<float>(norm({u[0], u[1], u[2]}));
  return u[static_cast<int>(wanted) - static_cast<int>(displacement_x)];
}

/// Fields and sections name their arrays alike.
template <class Arrays>
float value_of(const Arrays& from, std::size_t i, shown_field wanted) {
  const auto single = [i](const std::vector<float>& values) {
    return i < values.size() ? values[i] : NAN;
  };
  if (wanted == von_mises)
    return single(from.von_mises);
  if (wanted == relative_error)
    return single(from.relative_error);
  if (wanted == safety_factor) {
    const float value = single(from.safety_factor);
    return value == 0 ? NAN : value;  // 0: no yield strength is known there.
  }
  if (wanted >= displacement && wanted <= displacement_z)
    return 3 * i < from.displacement.size() ? of_displacement(&from.displacement[3 * i], wanted)
                                            : NAN;
  if (needs(wanted).stress)
    return 6 * i < from.stress.size() ? of_stress(&from.stress[6 * i], wanted) : NAN;
  return NAN;
}

}  // namespace

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

client::watched_quantities needs(shown_field wanted) {
  return {wanted >= principal_1 && wanted <= stress_zx, wanted == safety_factor,
          wanted == relative_error};
}

bool has(const client::field_event& field, shown_field wanted) {
  const auto needed = needs(wanted);
  return (!needed.stress || !field.stress.empty()) &&
         (!needed.safety_factor || !field.safety_factor.empty()) &&
         (!needed.relative_error || !field.relative_error.empty());
}

float value_in(const client::field_event& field, std::size_t i, shown_field wanted) {
  return value_of(field, i, wanted);
}

float value_in(const client::section& cut, std::size_t i, shown_field wanted) {
  return value_of(cut, i, wanted);
}

float value_at(const client::field_event& field, std::uint32_t slot, shown_field wanted) {
  const auto at = std::ranges::lower_bound(field.vertices, slot);
  if (at == field.vertices.end() || *at != slot)
    return NAN;
  return value_in(field, static_cast<std::size_t>(at - field.vertices.begin()), wanted);
}

}  // namespace tedit::desktop
