// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <span>
#include <vector>

#include "base/error.hpp"

namespace tedit::fem {
struct problem;
}

/// The equations of one load case in a file, for programs that share no line with our solver.
///
/// K' u = f' in double precision, three unknowns a node, with K' = S K S + s (I - S), f' = S f, S
/// the filter of the supports and s the mean of K's diagonal at the node. Nodes that are held in
/// all directions are left out, so that a clamped part has just K's rows of its free nodes; a node
/// held in some directions keeps its block, in which the held ones stand alone. The solution of K'
/// u = f' is the displacement of the nodes that are left; the others do not move.
///
/// Layout, little endian: `system_header`; row_first (uint64, nodes + 1); f' (double, 3 a node);
/// positions (m, double, 3 a node); then row by row the columns (uint32, ascending, the diagonal
/// among them) and after them the 3x3 blocks (9 doubles each, by rows).
namespace tedit::bench {

struct system_header {
  std::uint64_t magic = 0;
  std::uint64_t element_order = 0;
  std::uint64_t tets = 0;
  std::uint64_t nodes = 0;   ///< That are not held in all directions.
  std::uint64_t blocks = 0;  ///< 3x3 blocks in all rows.
};

/// Writes the system of a problem, after it was compared with the operator by which `solve`
/// measures its residual. Cost: O(mesh), one thread; memory: one row at a time. Errors: `io_error`;
/// `invalid_argument` for prescribed displacements other than zero; `internal` when the comparison
/// fails.
[[nodiscard]] expected<system_header> write_system(const fem::problem& p,
                                                   const std::filesystem::path& path);

/// A written system. Rows are read one by one, so that the memory of a program is that of its
/// solver.
class system_file {
public:
  using row_sink = std::function<void(std::size_t row, std::span<const std::uint32_t> columns,
                                      std::span<const double> blocks)>;

  /// Errors: `io_error`; `bad_input` for what is no such file or is cut short.
  [[nodiscard]] static expected<system_file> open(const std::filesystem::path& path);

  [[nodiscard]] const system_header& header() const { return header_; }
  [[nodiscard]] std::size_t nodes() const { return header_.nodes; }
  [[nodiscard]] std::size_t unknowns() const { return 3 * header_.nodes; }
  /// Where each row's blocks begin, and where the last one's end.
  [[nodiscard]] const std::vector<std::uint64_t>& row_first() const { return row_first_; }
  [[nodiscard]] const std::vector<double>& load() const { return load_; }
  [[nodiscard]] const std::vector<double>& positions() const { return positions_; }

  /// Hands all rows to `sink`, in order; any number of times. Errors: `bad_input`.
  [[nodiscard]] expected<void> for_rows(const row_sink& sink);

private:
  system_header header_;
  std::vector<std::uint64_t> row_first_;
  std::vector<double> load_;
  std::vector<double> positions_;
  std::ifstream in_;
  std::streampos rows_at_;
  std::filesystem::path path_;
};

/// What a solution is worth.
struct system_check {
  double relative_residual = 0;  ///< |f' - K' u| / |f'|.
  double compliance = 0;         ///< f'.u, J.
  double max_displacement = 0;   ///< The longest of a node, m.
};

[[nodiscard]] expected<system_check> check_solution(system_file& system,
                                                    std::span<const double> displacement);

}  // namespace tedit::bench
