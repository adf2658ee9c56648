// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/vec3.hpp"
#include "tedit/v1/load_case.pb.h"

namespace tedit::protocol {

/// A point or a vector of the wire; which unit is its field's to say. Nothing is checked here:
/// `check_numbers` has seen the message before.
[[nodiscard]] inline vec3 read_vector(const v1::Vector3& message) {
  return {message.x(), message.y(), message.z()};
}

inline void write_vector(const vec3& v, v1::Vector3* out) {
  out->set_x(v.x);
  out->set_y(v.y);
  out->set_z(v.z);
}

}  // namespace tedit::protocol
