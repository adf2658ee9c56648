// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/build_version.hpp"

namespace tedit {

struct read_mesh {
  raw_mesh mesh;
  std::vector<std::string> notices;
};

/// Reads Gmsh MSH 2.2 and 4.1, ASCII and binary (either byte order). Surface and region ids are the
/// CAD entity tags (2.2: second tag of an element); physical groups give names. Quadratic tets are
/// read as their corner tets with a notice. Points and lines are skipped. Other volume elements are
/// refused by name. Formats: Gmsh reference manual, "MSH file format". Errors: `bad_input`,
/// `unsupported_format`.
[[nodiscard]] expected<read_mesh> read_msh(std::span<const char> bytes);

}  // namespace tedit
