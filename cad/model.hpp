// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "cad/exchange.hpp"
#include "cad/program.hpp"

namespace tedit::cad {

/// The B-rep that belongs to a version of a mesh.
struct cad_model {
  std::shared_ptr<const std::string> shape;  ///< A BREP of OpenCASCADE, in mm.
  part_facts facts;                          ///< Of its faces and solids, in their order.
};

/// What a program left in its folder. Errors: `io_error`, `internal`.
[[nodiscard]] expected<cad_model> load_model(const std::filesystem::path& folder);

/// For a program to find it there. Errors: `io_error`.
[[nodiscard]] expected<void> save_model(const cad_model& model,
                                        const std::filesystem::path& folder);

/// Writes the model as a STEP file (AP214, mm), whole or not at all: names of solids and faces,
/// colours, and the surfaces of each face as the name of its layer. Errors:
/// `service_unavailable`, `io_error`, `timeout`, `cancelled`. Cost: a process of its own, some
/// 100 ms.
[[nodiscard]] expected<void> write_step(const cad_model& model, const std::filesystem::path& file,
                                        const program_limits& limits, const execution& run);

}  // namespace tedit::cad
