// SPDX-License-Identifier: AGPL-3.0-or-later
// Surfaces whose numbers are known, and files of them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "mesh/vec3.hpp"

namespace tedit::test {

/// Triangles by their corners: nothing says that two of them meet but equal places.
using soup = std::vector<std::array<vec3, 3>>;

/// A cube along the axes, outward: two triangles on each side, first those at low x, then high x.
inline soup cube_soup(double side, vec3 low = {}) {
  const auto at = [&](int x, int y, int z) { return low + side * vec3{1.0 * x, 1.0 * y, 1.0 * z}; };
  soup made;
  const auto quad = [&](vec3 a, vec3 b, vec3 c, vec3 d) {
    made.push_back({a, b, c});
    made.push_back({a, c, d});
  };
  quad(at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
  quad(at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
  quad(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
  quad(at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0));
  quad(at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0));
  quad(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
  return made;
}

/// A turned body along z: rings of (radius, z), from the lower end to the upper one, each of which
/// is on the axis where its radius is 0.
inline soup turned_soup(const std::vector<std::array<double, 2>>& rings, int corners) {
  soup made;
  for (std::size_t i = 0; i + 1 < rings.size(); ++i)
    for (int k = 0; k < corners; ++k) {
      const auto at = [&](std::size_t ring, int place) {
        const double angle = 2 * std::numbers::pi * (place % corners) / corners;
        return vec3{rings[ring][0] * std::cos(angle), rings[ring][0] * std::sin(angle),
                    rings[ring][1]};
      };
      if (rings[i][0] > 0)
        made.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      if (rings[i + 1][0] > 0)
        made.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
  return made;
}

inline soup cylinder_soup(double radius, double height, int corners) {
  return turned_soup({{0, 0}, {radius, 0}, {radius, height}, {0, height}}, corners);
}

inline soup joined(soup a, const soup& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

template <class T>
void put_bytes(std::string& text, T value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

inline std::string stl_of(const soup& triangles) {
  std::string text(80, ' ');
  put_bytes(text, static_cast<std::uint32_t>(triangles.size()));
  for (const auto& t : triangles) {
    text.append(12, '\0');
    for (const auto& p : t)
      for (const double x : {p.x, p.y, p.z})
        put_bytes(text, static_cast<float>(x));
    text.append(2, '\0');
  }
  return text;
}

inline std::string stl_text_of(const soup& triangles, const std::string& name) {
  std::string text = "solid " + name + "\n";
  for (const auto& t : triangles) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const auto& p : t)
      text += "  vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " +
              std::to_string(p.z) + "\n";
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

}  // namespace tedit::test
