// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "cli/command.hpp"
#include "cli/embedded_server.hpp"
#include "client/recipe.hpp"

/// `tedit run RECIPE --table FILE.csv`: each row of the table is a part.
namespace tedit::cli {

inline constexpr unsigned most_family_jobs = 64;

struct family_options {
  std::string recipe;
  std::string table;
  std::string mesh;  ///< For a recipe that imports none; may be empty.
  std::string length_unit;
  std::string out;     ///< Folder of exported files.
  std::string device;  ///< Instead of the recipe's; may be empty.
  std::string report;  ///< HTML file; may be empty.
  unsigned jobs = 0;   ///< 0: as many as cores here, as solvers on a server of others.
  bool remote = false;
};

/// Gives a server with so many workers: one inside this program, started then, or a running one.
using server_source =
  std::function<expected<client::connect_options>(unsigned workers, embedded_server& own)>;

/// Checks all rows, carries them out, writes the report and prints the result. Returns the exit
/// status: 0 where all rows passed, 1 where one failed, 130 after a cancel, and what errors have
/// that end it before the first row.
int run_family(const family_options& options, const server_source& reach, session& s);

/// The mesh that is imported before the first step, if the recipe has none of its own. Errors:
/// `bad_input`. (run.cpp)
[[nodiscard]] expected<std::optional<client::import_step>> mesh_for(const client::recipe& steps,
                                                                    const std::string& mesh,
                                                                    const std::string& length_unit);

}  // namespace tedit::cli
