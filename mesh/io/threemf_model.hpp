// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string_view>

#include "mesh/formats.hpp"
#include "mesh/io/zip_file.hpp"
#include "mesh/version.hpp"

namespace tedit {

/// The model of a 3MF file, packed as it is made. `unit_name` is the format's word for what has
/// `unit` metres. Cost: O(mesh); memory of the packed model and the faces.
[[nodiscard]] zipped_file threemf_model(const mesh_version& mesh, const file_terms& terms,
                                        std::string_view unit_name, double unit);

}  // namespace tedit
