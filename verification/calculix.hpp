// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "base/execution.hpp"
#include "fem/problem.hpp"

/// CalculiX as a second opinion: an independent program solves the same problem.
namespace tedit::verification {

/// The Debian package of the program `ccx`.
constexpr auto calculix_package = "calculix-ccx";

/// What CalculiX found. Its text output has 7 digits, so each number is off by up to 5e-7 of
/// itself.
struct calculix_solution {
  std::vector<double> displacement;  ///< m, 3 per node.
  std::vector<double> reactions;     ///< N, 3 per node: K u - f on held directions, else zero.
  std::vector<double> stress;        ///< Pa, 6 per node as ours; empty where the deck has none.
  std::string program;               ///< "CalculiX 2.20", as it calls itself.
  double milliseconds = 0;           ///< Of the whole run, files included.
};

/// U and RF by node as they stand in a .dat file, zero where it has none.
struct calculix_table {
  std::vector<double> displacement;  ///< m, 3 per node.
  std::vector<double> forces;        ///< N, 3 per node: K u.
};

/// The program `ccx` in $PATH; empty when it is not installed.
[[nodiscard]] std::filesystem::path find_calculix();

/// Runs CalculiX on the deck NAME.inp of a folder, on one thread, within an hour. What it makes
/// stays there: NAME.dat, and NAME.frd where the deck asks for fields.
/// @param p the problem that the deck was written from.
/// Errors: `bad_input` when the results are not all there, those of `run_child`.
[[nodiscard]] expected<calculix_solution> run_calculix(const std::filesystem::path& program,
                                                       const std::filesystem::path& folder,
                                                       const std::string& name,
                                                       const fem::problem& p, const execution& run);

/// Solves with SPOOLES, a direct solver, on one thread in a temporary folder, within five minutes.
/// Errors: `io_error`, `bad_input` when the results are not all there, those of `run_child`.
[[nodiscard]] expected<calculix_solution> solve_with_calculix(const std::filesystem::path& program,
                                                              const fem::problem& p,
                                                              const execution& run);

/// Reads the result tables that a deck of `fem::write_calculix_deck` asks for. Rows of nodes that
/// the problem does not have are skipped. Errors: `bad_input` when a node has no displacement.
[[nodiscard]] expected<calculix_table> read_calculix_table(std::istream& dat,
                                                           std::size_t node_count);

/// Reads the stress of a results file (.frd), Pa, 6 per node in the order xx, yy, zz, xy, yz, zx.
/// Errors: `bad_input` when a node has none.
[[nodiscard]] expected<std::vector<double>> read_calculix_stress(std::istream& frd,
                                                                 std::size_t node_count);

}  // namespace tedit::verification
