// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

namespace tedit {

/// A point or direction, in metres where it is a length. Plain data: pages hold it as it is.
struct vec3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend bool operator==(const vec3&, const vec3&) = default;
};

[[nodiscard]] constexpr vec3 operator+(vec3 a, vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] constexpr vec3 operator-(vec3 a, vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] constexpr vec3 operator-(vec3 a) {
  return {-a.x, -a.y, -a.z};
}
[[nodiscard]] constexpr vec3 operator*(double s, vec3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
[[nodiscard]] constexpr vec3 operator*(vec3 a, double s) {
  return s * a;
}
[[nodiscard]] constexpr vec3 operator/(vec3 a, double s) {
  return {a.x / s, a.y / s, a.z / s};
}
constexpr vec3& operator+=(vec3& a, vec3 b) {
  return a = a + b;
}
constexpr vec3& operator-=(vec3& a, vec3 b) {
  return a = a - b;
}

[[nodiscard]] constexpr double dot(vec3 a, vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

[[nodiscard]] constexpr vec3 cross(vec3 a, vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Never hides a component that is no number: libstdc++ calls the length of (0, 0, nan) 0.
[[nodiscard]] inline double norm(vec3 a) {
  const double length = std::hypot(a.x, a.y, a.z);
  return length == 0 ? std::abs(a.x) + std::abs(a.y) + std::abs(a.z) : length;
}

/// `a / |a|`; the zero vector stays zero.
[[nodiscard]] inline vec3 normalized(vec3 a) {
  const double length = norm(a);
  return length > 0 ? a / length : a;
}

[[nodiscard]] inline bool is_finite(vec3 a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace tedit
