// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/recipes/reference_json.hpp"

#include <algorithm>
#include <set>

namespace tedit::client {

namespace {

constexpr feature_kind features[] = {feature_kind::hole, feature_kind::protrusion,
                                     feature_kind::smooth};

feature_kind feature_from(const json& value, const std::string& what) {
  const auto name = text_from(value, what);
  const auto* found = std::ranges::find(features, name, kind_name);
  if (found == std::end(features))
    refuse(what + " must be hole, protrusion or smooth");
  return *found;
}

vec3 point_from(const json& value, const std::string& what) {
  const number_range lengths{-1e9, 1e9, "mm"};
  list_from(value, 3, 3, what);
  return {number_from(value[0], lengths, what), number_from(value[1], lengths, what),
          number_from(value[2], lengths, what)};
}

surface_reference reference_from(const json& value, const std::string& what) {
  surface_reference result;
  for (const auto& [key, given] : value.items()) {
    const auto field = what + ": \"" + key + "\"";
    if (key == "name")
      result.name = text_from(given, field);
    else if (key == "made_by")
      result.made_by = text_from(given, field);
    else if (key == "at_mm")
      result.at_mm = point_from(given, field);
    else if (key == "within_mm")
      result.within_mm = number_from(given, {1e-6, 1e9, "mm"}, field);
    else if (key == "as")
      result.feature = feature_from(given, field);
    else
      refuse(what + " has an unknown field \"" + key + "\"",
             "The fields are name, made_by, at_mm, within_mm, as");
  }
  if (result.name.empty() && result.made_by.empty() && !result.at_mm)
    refuse(what + " says no surface", "Give its name, made_by or at_mm");
  if (result.within_mm > 0 && !result.at_mm)
    refuse(what + ": \"within_mm\" is for a point", "Give at_mm, too");
  return result;
}

/// Calls `visit` with each list `surfaces` of the objects below.
template <class Json, class Visit>
void for_each_list(Json& body, const Visit& visit) {
  if (!body.is_structured())
    return;
  for (const auto& [key, value] : body.items())
    if (body.is_object() && key == "surfaces" && value.is_array())
      visit(value);
    else
      for_each_list(value, visit);
}

nlohmann::ordered_json to_json(const surface_reference& one) {
  nlohmann::ordered_json result;
  if (!one.name.empty())
    result["name"] = one.name;
  if (!one.made_by.empty())
    result["made_by"] = one.made_by;
  if (one.at_mm)
    result["at_mm"] = {one.at_mm->x, one.at_mm->y, one.at_mm->z};
  if (one.within_mm > 0)
    result["within_mm"] = one.within_mm;
  if (one.feature)
    result["as"] = kind_name(*one.feature);
  return result;
}

}  // namespace

void take_references(json& list, std::vector<surface_reference>& references,
                     const std::string& what) {
  for (auto& item : list) {
    if (!item.is_object())
      continue;
    references.push_back(reference_from(item, "each of " + what));
    item = place_of_reference(references.size() - 1);
  }
}

void take_all_references(json& body, std::vector<surface_reference>& references,
                         const std::string& what) {
  for_each_list(body,
                [&](json& list) { take_references(list, references, what + ": \"surfaces\""); });
}

namespace {

bool has_references(const json& body) {
  bool result = false;
  for_each_list(body, [&](const json& list) {
    result = result || std::ranges::any_of(list, [](const json& one) { return one.is_object(); });
  });
  return result;
}

}  // namespace

std::optional<json> file_with_references(const std::filesystem::path& file) {
  const auto text = text_of_file(file, 64UL << 20);
  auto body = text ? json::parse(*text, nullptr, false) : json();
  return body.is_object() && has_references(body) ? std::optional(std::move(body)) : std::nullopt;
}

/// A label stands for one edit, and is used after it.
void check_labels(const std::vector<recipe_step>& steps) {
  std::set<std::string> known;
  const auto check = [&](const std::vector<surface_reference>& references,
                         const std::string& where) {
    for (const auto& one : references)
      if (!one.made_by.empty() && !known.contains(one.made_by))
        refuse(where + ": no edit before it has the label \"" + one.made_by + "\"",
               "Give the edit that makes these surfaces \"label\": \"" + one.made_by + "\"");
  };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto where =
      "step " + std::to_string(i + 1) + " (" + std::string(kind_of(steps[i])) + ")";
    if (const auto* loads = std::get_if<load_case_step>(&steps[i]))
      check(loads->references, where);
    if (const auto* edit = std::get_if<edit_step>(&steps[i])) {
      check(edit->references, where);
      if (!edit->label.empty() && !known.insert(edit->label).second)
        refuse(where + ": another edit has the label \"" + edit->label + "\"",
               "Give each edit a label of its own");
    }
  }
}

void put_references(nlohmann::ordered_json& list,
                    const std::vector<surface_reference>& references) {
  // Numbers of 64 bits are texts where Protocol Buffers has written them.
  for (auto& item : list)
    for (std::size_t k = 0; k < references.size(); ++k)
      if (item == place_of_reference(k) || item == std::to_string(place_of_reference(k))) {
        item = to_json(references[k]);
        break;
      }
}

void put_all_references(nlohmann::ordered_json& body,
                        const std::vector<surface_reference>& references) {
  for_each_list(body, [&](nlohmann::ordered_json& list) { put_references(list, references); });
}

}  // namespace tedit::client
