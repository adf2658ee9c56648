// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/io/file_mesh.hpp"

namespace tedit {

/// Makes triangles and surface names of the sets of `file`, as `file_mesh::finish` says. `out` has
/// the tets already. Throws `file_failure` for a face whose node is not there.
void give_surfaces(file_mesh& file, read_mesh& out);

/// The file's name of a surface: the number at the end of `name` is its id. Takes ids for sets that
/// have none. Cost: O(n log n).
void number_sets(std::vector<file_mesh::face_set>& sets);

}  // namespace tedit
