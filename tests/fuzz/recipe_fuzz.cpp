// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/csv_table.hpp"
#include "client/recipe.hpp"
#include "client/recipe_family.hpp"
#include "tests/fuzz/promise.hpp"

namespace {

using namespace tedit;

void check_refused(const error& failure) {
  fuzz::require_reason(failure);
  fuzz::require(!failure.remedy.empty(), "a refusal has a remedy:", render(failure));
  fuzz::require(failure.code == ec::bad_input || failure.code == ec::io_error,
                "a refusal is about the text:", render(failure));
}

void check_recipe(std::string_view text) {
  const auto read = client::recipe_from_json(text, "/nowhere");
  if (!read)
    return check_refused(read.error());
  const auto again = client::recipe_from_json(client::to_json(*read), "/nowhere");
  if (!again)
    fuzz::require(false, "a recipe that is written can be read:", render(again.error()));
  fuzz::require(client::to_json(*again) == client::to_json(*read), "it is the same again");
}

void check_table(std::string_view text) {
  const auto table = client::csv_from_text(text);
  if (!table)
    return check_refused(table.error());
  fuzz::require(!table->rows.empty() && table->rows.size() <= client::most_table_rows,
                "there are rows, not too many");
  for (const auto& row : table->rows) {
    fuzz::require(row.cells.size() == table->columns.size(), "a row has a cell for each column");
    for (const auto& cell : row.cells)
      fuzz::require(cell.size() <= client::most_cell_bytes, "cells are short");
  }
}

/// A line with a zero byte parts the table from the recipe.
void check_family(std::string_view bytes) {
  const auto part = bytes.find('\0');
  if (part == bytes.npos)
    return;
  const auto as_bytes = [](std::string_view text) {
    return std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  };
  const fuzz::memory_file table(as_bytes(bytes.substr(0, part)));
  const fuzz::memory_file recipe(as_bytes(bytes.substr(part + 1)));
  const auto family = client::recipe_family::read(recipe.path(), table.path(), {});
  if (!family)
    return check_refused(family.error());
  if (const auto ok = family->check(); !ok)
    check_refused(ok.error());
}

}  // namespace

/// The first byte says what the others are: "r" a recipe, "t" a table, "f" both.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0)
    return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] == 't')
    check_table(bytes);
  else if (data[0] == 'f')
    check_family(bytes);
  else
    check_recipe(bytes);
  return 0;
}
