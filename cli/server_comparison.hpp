// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "cli/command.hpp"
#include "client/client.hpp"

namespace tedit::cli {

/// Two versions of the document that a client has open, and whose difference is wanted.
struct compared_versions {
  std::uint32_t before = 0;  ///< Their numbers.
  std::uint32_t after = 0;
  std::string load_case;  ///< Empty: no difference of fields, only figures.
};

/// What the server says of them. Errors: also `not_found`, with the remedy, when the fields of the
/// load case that was named cannot be compared.
[[nodiscard]] expected<client::comparison> compare_on_server(client::client& server,
                                                             const compared_versions& wanted,
                                                             session& s);

/// Writes the boundary of the version after with the difference at its vertices as VTU: mark and
/// differences under the names of files that "tedit compare" writes of meshes, m and Pa. Errors:
/// `io_error`; `invalid_argument` without a difference; those of `client::surface_of`.
[[nodiscard]] expected<void> write_difference(client::client& server,
                                              const client::comparison& made,
                                              const std::filesystem::path& file, session& s);

/// "version 0 -> version 3", and below it all that differs.
[[nodiscard]] std::string describe_comparison(const client::comparison& made);

}  // namespace tedit::cli
