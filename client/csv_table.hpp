// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace tedit::client {

/// Largest tables that are read.
inline constexpr std::size_t most_table_bytes = std::size_t{16} << 20;
inline constexpr std::size_t most_table_rows = 10'000;
inline constexpr std::size_t most_table_columns = 200;
inline constexpr std::size_t most_cell_bytes = 4096;

struct csv_row {
  std::size_t line = 0;            ///< Where it begins in the file, from 1.
  std::vector<std::string> cells;  ///< As many as there are columns.

  friend bool operator==(const csv_row&, const csv_row&) = default;
};

/// Texts in rows and named columns.
struct csv_table {
  std::vector<std::string> columns;  ///< Each once, none empty.
  std::vector<csv_row> rows;         ///< At least one.

  friend bool operator==(const csv_table&, const csv_table&) = default;
};

/// Reads a table by RFC 4180: commas, cells in quotes with "" for a quote, line ends inside quotes;
/// LF and CRLF. A byte order mark is passed over, so are empty lines. The separator is ';' where
/// the first line has that and no comma, as programs write it where the comma is in numbers. Spaces
/// around the names of columns are left out, cells stay as they are. Errors: `bad_input` with the
/// line, for what is no such table, no UTF-8 or too large. Cost: O(bytes).
[[nodiscard]] expected<csv_table> csv_from_text(std::string_view text);

/// The same of a file, which the error names. Errors: also `io_error`.
[[nodiscard]] expected<csv_table> read_csv(const std::filesystem::path& file);

}  // namespace tedit::client
