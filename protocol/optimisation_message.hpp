// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/optimize/improve.hpp"

namespace tedit::v1 {
class Optimisation;
}  // namespace tedit::v1

namespace tedit::protocol {

/// What a thorough optimisation did, with both figures of the mesh.
void to_message(const improve_report& report, v1::Optimisation* out);
[[nodiscard]] improve_report from_message(const v1::Optimisation& message);

}  // namespace tedit::protocol
