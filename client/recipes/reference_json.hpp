// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "client/recipe.hpp"
#include "client/recipes/values.hpp"

/// References to surfaces in the JSON of a step. What is wrong is thrown, as by values.hpp.
namespace tedit::client {

/// Puts the numbers that stand for references where these are in a list of surfaces, and adds them.
void take_references(json& list, std::vector<surface_reference>& references,
                     const std::string& what);

/// The same for each list `surfaces` of the objects in an object.
void take_all_references(json& body, std::vector<surface_reference>& references,
                         const std::string& what);

/// A load case's file, where it is JSON in which any list `surfaces` has a reference; whatever else
/// is wrong with it is told by who reads it.
[[nodiscard]] std::optional<json> file_with_references(const std::filesystem::path& file);

/// A label stands for one edit, and is used after it.
void check_labels(const std::vector<recipe_step>& steps);

/// The reverse of taking them.
void put_references(nlohmann::ordered_json& list, const std::vector<surface_reference>& references);
void put_all_references(nlohmann::ordered_json& body,
                        const std::vector<surface_reference>& references);

}  // namespace tedit::client
