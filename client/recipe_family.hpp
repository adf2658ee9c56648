// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "client/csv_table.hpp"
#include "client/recipe.hpp"
#include "protocol/operation_message.hpp"

namespace tedit::client {

/// A recipe with places for the cells of a table: each row is a part. "{{column}}" in any text is
/// the row's cell; a value that is nothing but one such place is a number where the recipe needs a
/// number. "{{name}}" is the cell of the column "name", without one that of "id", else the number
/// of the row. Docs: docs/recipes.md.
class recipe_family {
public:
  /// Reads both; nothing is filled in yet. `offered` says which parameters of operations are
  /// numbers. Errors: those of `read_recipe` for what is no JSON, and of `read_csv`.
  [[nodiscard]] static expected<recipe_family> read(const std::filesystem::path& recipe,
                                                    const std::filesystem::path& table,
                                                    const operation_catalogue& offered);

  recipe_family(recipe_family&&) noexcept;
  ~recipe_family();

  [[nodiscard]] const csv_table& table() const noexcept { return table_; }
  /// What "{{name}}" is in this row, from 0.
  [[nodiscard]] std::string name_of(std::size_t row) const;

  /// The recipe of one row, from 0. Errors: `bad_input` naming row, column and step: no such
  /// column, a cell that is no number where one is needed, one that cannot be part of a file's name
  /// where it should be, and what `recipe_from_json` refuses. Cost: the recipe's size; files that
  /// it names are read.
  [[nodiscard]] expected<recipe> recipe_of(std::size_t row) const;

  /// All rows, before the first is carried out: those errors, and two rows that write the same
  /// file. Cost: that of `recipe_of` times the rows.
  [[nodiscard]] expected<void> check() const;

private:
  struct parts;
  recipe_family(std::unique_ptr<parts> made, csv_table table, std::filesystem::path folder);

  csv_table table_;
  std::filesystem::path folder_;  ///< Of the recipe.
  std::unique_ptr<parts> parts_;
};

/// The files that a recipe writes, as they stand in its steps: number of the step (from 1), name.
[[nodiscard]] std::vector<std::pair<std::size_t, std::string>> files_of(const recipe& what);

}  // namespace tedit::client
