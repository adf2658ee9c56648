// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/recipes/recipe_reading.hpp"

namespace tedit::client {

expected<std::string> recipe_text(const std::filesystem::path& file) {
  auto text = text_of_file(file, 64UL << 20);
  if (!text)
    return fail(ec::io_error, "cannot read the recipe " + file.string(),
                "Check the path and its permissions; it may have 64 MiB", file.string());
  return text;
}

expected<recipe> read_recipe(const std::filesystem::path& file) {
  const auto text = recipe_text(file);
  if (!text)
    return fail(text.error());
  auto result = recipe_from_json(*text, file.parent_path());
  if (!result)
    result.error().where =
      file.string() + (result.error().where.empty() ? "" : ", " + result.error().where);
  return result;
}

bool is_recipe(const std::filesystem::path& file) {
  const auto text = recipe_text(file);
  const auto body = text ? json::parse(*text, nullptr, false) : json();
  return body.is_array() || (body.is_object() && body.contains("steps"));
}

}  // namespace tedit::client
