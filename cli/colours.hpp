// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "mesh/formats.hpp"
#include "mesh/version.hpp"

namespace tedit::cli {

/// How a part is coloured, and by what.
struct part_looks {
  file_colours colours;
  bool of_field = false;
  std::string by;    ///< "surface" or a field's name; empty: no colours.
  double least = 0;  ///< Of a field, where its first colour stands, and where its last one does.
  double most = 0;
};

/// "surface" gives each surface a colour, told apart from those of the ids beside it; else this is
/// a field of the file, in the colours of `tedit render` from its least to its largest value on the
/// boundary, that of a difference as far on both sides of zero. `mesh` came from `file`. Errors:
/// those of `read_point_field`, `io_error`.
[[nodiscard]] expected<part_looks> make_looks(const mesh_version& mesh,
                                              const std::filesystem::path& file,
                                              const std::string& by);

/// by, least, most.
[[nodiscard]] nlohmann::ordered_json to_json(const part_looks& looks);

/// ", coloured by von_mises_pa from 0 to 1.3e+07"; empty without colours.
[[nodiscard]] std::string describe(const part_looks& looks);

}  // namespace tedit::cli
