// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "cad/mesher/surface_mesh.hpp"

namespace tedit::cad {

/// Fills solids with tets by Gmsh's library, which must be initialized, and writes the mesh into
/// the folder (`mesh_file`). `faces_of`: the surfaces around each solid. False where Gmsh cannot, a
/// solid has no tets, or a face lost triangles; nothing is written then. Cost: Gmsh's.
[[nodiscard]] bool fill_solids(const surface_mesh& faces,
                               const std::map<int, std::vector<int>>& faces_of,
                               const std::filesystem::path& folder);

}  // namespace tedit::cad
