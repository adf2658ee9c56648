// SPDX-License-Identifier: AGPL-3.0-or-later
// Tables of broken files: tests/data/broken/README.md.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace tedit::test {

/// One broken file, and what its reader must say of it.
struct broken_file {
  std::string name;
  std::string bytes;
  bool is_taken = false;  ///< It is read, and `message` is in what a person is told of it.
  std::string code;
  std::string where;  ///< The whole of it.
  std::string message;
  std::string remedy;
};

/// A table's rows, made from their good files. Throws where an edit finds nothing to edit.
[[nodiscard]] std::vector<broken_file> broken_files(const std::string& table);

/// Reads bytes as its program does; gives what a person is told of a file that is taken.
using told_reader = std::function<expected<std::string>(std::span<const char>)>;

/// Reads each file of a table and holds what is said against it, and the memory that it took
/// against its size.
void expect_told(const std::string& table, const told_reader& read);

}  // namespace tedit::test
