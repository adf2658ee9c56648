// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/part_size.hpp"

#include <QStringList>

#include <algorithm>
#include <cmath>

#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

namespace {

constexpr double smallest_usual = 1e-3;
constexpr double largest_usual = 5;

}  // namespace

double part_size::diagonal() const {
  return std::hypot(edges[0], edges[1], edges[2]);
}

bool part_size::is_odd() const {
  const double largest = std::ranges::max(edges);
  return largest < smallest_usual || largest > largest_usual;
}

QString part_size::words() const {
  const auto unit = shown_as("m");
  QStringList numbers;
  for (const double edge : edges)
    numbers << number(edge * unit.scale);
  return numbers.join(QString::fromUtf8(" \u00d7 ")) + " " + unit.name;
}

part_size size_of(const client::surface_model& surface) {
  vec3 low{INFINITY, INFINITY, INFINITY};
  vec3 high = -low;
  surface.positions().for_each([&](std::uint32_t, const vec3& at) {
    low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
  });
  if (low.x > high.x)
    return {};
  return {{high.x - low.x, high.y - low.y, high.z - low.z}};
}

}  // namespace tedit::desktop
