// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <utility>

#include "mesh/types.hpp"

namespace tedit {

/// A triangle by its corners in ascending order, and whether that took an odd number of swaps: the
/// two sides of a face have equal `v` and different `odd`.
struct face_key {
  std::array<vertex_id, 3> v;
  bool odd = false;
};

[[nodiscard]] constexpr face_key make_face_key(std::array<vertex_id, 3> v) {
  face_key key{v, false};
  const auto order = [&](int a, int b) {
    if (key.v[a] > key.v[b]) {
      std::swap(key.v[a], key.v[b]);
      key.odd = !key.odd;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return key;
}

/// The key of local face `face` (opposite corner `face`), seen from the tet's outside.
[[nodiscard]] constexpr face_key make_face_key(const tet& t, int face) {
  const auto& order = tet_faces[face];
  return make_face_key({t.v[order[0]], t.v[order[1]], t.v[order[2]]});
}

}  // namespace tedit
