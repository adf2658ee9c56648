// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client/recipe.hpp"
#include "client/recipes/values.hpp"

/// Who reads recipes shares this.
namespace tedit::client {

/// The text of a recipe's file. Errors: `io_error`, also for more than 64 MiB.
[[nodiscard]] expected<std::string> recipe_text(const std::filesystem::path& file);

/// The recipe that the JSON is. What is wrong is thrown, as by values.hpp.
recipe recipe_from(const json& body, const std::filesystem::path& folder);

}  // namespace tedit::client
