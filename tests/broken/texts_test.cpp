// SPDX-License-Identifier: AGPL-3.0-or-later
// Broken load cases, recipes and tables.
#include <gtest/gtest.h>

#include "client/csv_table.hpp"
#include "client/recipe.hpp"
#include "protocol/convert.hpp"
#include "tests/broken/table.hpp"

namespace tedit::test {
namespace {

/// A text of these kinds says nothing when it is taken.
template <class Result>
expected<std::string> nothing_told(const expected<Result>& read) {
  if (!read)
    return fail(read.error());
  return std::string();
}

TEST(BrokenTexts, LoadCasesAreRefusedWithPlaceCauseAndRemedy) {
  expect_told("load_case", [](std::span<const char> bytes) {
    return nothing_told(protocol::load_case_from_json({bytes.data(), bytes.size()}, "loads.json"));
  });
}

TEST(BrokenTexts, RecipesAreRefusedWithPlaceCauseAndRemedy) {
  expect_told("recipe", [](std::span<const char> bytes) {
    return nothing_told(client::recipe_from_json({bytes.data(), bytes.size()}));
  });
}

TEST(BrokenTexts, TablesAreRefusedWithPlaceCauseAndRemedy) {
  expect_told("csv", [](std::span<const char> bytes) {
    return nothing_told(client::csv_from_text({bytes.data(), bytes.size()}));
  });
}

}  // namespace
}  // namespace tedit::test
