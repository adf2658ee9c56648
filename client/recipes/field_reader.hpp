// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/attachment.hpp"
#include "client/recipe.hpp"
#include "client/recipes/reference_json.hpp"
#include "client/recipes/values.hpp"
#include "protocol/convert.hpp"

namespace tedit::client {

/// Reads the fields of one object. Unknown ones are errors, so that a typing mistake does not pass
/// silently.
class field_reader {
public:
  field_reader(const json& body, std::string where, const std::filesystem::path& folder)
      : body_(body), where_(std::move(where)), folder_(folder) {}

  template <class T>
  void needed(const char* field, T& into) {
    if (!body_.contains(field))
      refuse(where_ + " needs \"" + field + "\"");
    other(field, into);
  }

  template <class T>
  void other(const char* field, T& into, const number_range& range = any_number()) {
    known_.insert(field);
    if (const auto found = body_.find(field); found != body_.end())
      read(*found, into, where_ + ": \"" + field + "\"", range);
  }

  /// One text of several that have names of their own.
  void one_of(const std::string& field, std::map<std::string, std::string>& into) {
    std::string value;
    other(field.c_str(), value);
    if (!value.empty())
      into[field] = std::move(value);
  }

  void one_word(const char* field, std::string& into, std::span<const std::string_view> words) {
    other(field, into);
    if (into.empty() || std::ranges::find(words, into) != words.end())
      return;
    std::string all;
    for (const auto& one : words)
      all += (all.empty() ? "" : ", ") + std::string(one);
    refuse(where_ + ": \"" + field + "\" must be one of " + all);
  }

  void cases(const char* field, solve_step& into) {
    known_.insert(field);
    const auto found = body_.find(field);
    const auto is_text = [](const json& one) { return one.is_string(); };
    into.all_load_cases = found != body_.end() && *found == "all";
    if (found == body_.end() || into.all_load_cases)
      return;
    if (!found->is_array() || !std::ranges::all_of(*found, is_text))
      refuse(where_ + ": \"load_cases\" must be a list of names, or \"all\"");
    into.load_cases = found->get<std::vector<std::string>>();
  }

  void surfaces(const char* field, std::vector<surface_id>& into,
                std::vector<surface_reference>& references) {
    known_.insert(field);
    const auto found = body_.find(field);
    if (found == body_.end())
      return;
    const auto what = where_ + ": \"" + field + "\"";
    auto list = list_from(*found, 0, most_ids, what);
    take_references(list, references, what);
    read(list, into, what, {});
  }

  /// A load case from another file, or the whole object.
  void whole(fem::load_case& into, std::vector<surface_reference>& references) {
    std::filesystem::path file;
    other("file", file);
    auto body = file.empty() ? std::optional(body_) : file_with_references(file);
    if (body)
      take_all_references(*body, references, where_);
    const auto read = body ? protocol::load_case_from_json(body->dump(), where_)
                           : protocol::load_case_from_file(file);
    if (!read)
      refuse(where_ + ": " + read.error().message + (file.empty() ? "" : " in " + file.string()),
             read.error().remedy);
    into = *read;
    for (const auto& [field, value] : body_.items())
      if (file.empty())
        known_.insert(field);
  }

  void ignore(const char* field) { known_.insert(field); }

  void finish() const {
    for (const auto& [field, value] : body_.items())
      if (!known_.contains(field))
        refuse(where_ + " has an unknown field \"" + field + "\"");
  }

private:
  using words = const std::string&;

  void read(const json& value, std::string& into, words what, const number_range&) const {
    into = text_from(value, what);
  }
  void read(const json& value, std::filesystem::path& into, words what, const number_range&) const {
    into = folder_ / text_from(value, what);
  }
  void read(const json& value, std::map<std::string, double>& into, words what,
            const number_range& range) const {
    if (!value.is_object())
      refuse(what + " must be {\"name\": number, ...}");
    for (const auto& [name, number] : value.items())
      into[name] = number_from(number, range, what + ": \"" + name + "\"");
  }
  void read(const json& value, bool& into, words what, const number_range&) const {
    into = flag_from(value, what);
  }
  void read(const json& value, double& into, words what, const number_range& range) const {
    into = number_from(value, range, what);
  }
  void read(const json& value, int& into, words what, const number_range&) const {
    const auto given = whole_from(value, what);
    if (given != 1 && given != 2)
      refuse(what + " must be 1 (linear tets) or 2 (quadratic)");
    into = static_cast<int>(given);
  }
  void read(const json& value, std::uint32_t& into, words what, const number_range&) const {
    const auto given = whole_from(value, what);
    if (given < 0 || given > UINT32_MAX)
      refuse(what + " must be the number of a version, from 0 on");
    into = static_cast<std::uint32_t>(given);
  }
  void read(const json& value, std::optional<std::uint32_t>& into, words what,
            const number_range& range) const {
    read(value, into.emplace(), what, range);
  }
  void read(const json& value, std::vector<surface_id>& into, words what,
            const number_range&) const {
    for (const auto& id : list_from(value, 0, most_ids, what))
      into.push_back(whole_from(id, "each of " + what));
  }
  void read(const json& value, fem::load_policy& into, words what, const number_range&) const {
    const auto policy = fem::policy_from_name(text_from(value, what));
    if (!policy)
      refuse(what + ": " + policy.error().message, policy.error().remedy);
    into = *policy;
  }
  void read(const json& value, std::optional<std::pair<double, double>>& into, words what,
            const number_range& range) const {
    if (!value.is_array() || value.size() != 2)
      refuse(what + " must be [least, largest]");
    into.emplace(number_from(value[0], range, what), number_from(value[1], range, what));
    if (!(into->first < into->second))
      refuse(what + " must be [least, largest], the smaller one first");
  }
  void read(const json& value, ops::parameters& into, words what, const number_range& range) const {
    if (!value.is_object())
      refuse(what + " must be {\"name\": value, ...}");
    for (const auto& [id, given] : value.items()) {
      const auto name = where_ + ": parameter \"" + id + "\"";
      if (given.is_boolean())
        into[id] = given.get<bool>();
      else if (given.is_number_integer())
        into[id] = whole_from(given, name);
      else if (given.is_number())
        into[id] = number_from(given, range, name);
      else if (given.is_string())
        into[id] = text_from(given, name);
      else if (given.is_object() && given.size() == 1 && given.contains("file"))
        into[id] = content_of(text_from(given["file"], name + ": \"file\""), name);
      else if (given.is_array())
        into[id] = text_of_list(given, range, name);
      else
        refuse(name + " must be a number, a text, true or false, a list, or {\"file\": \"PATH\"}");
    }
  }

  /// Numbers, or points as lists of numbers, as the host reads them: "0, 0, 1; 0, 0, 1".
  static std::string text_of_list(const json& list, const number_range& range, words what,
                                  bool in_list = false) {
    std::string text;
    for (const auto& item : list_from(list, 1, 10'000, what)) {
      const bool one = !item.is_array() && !item.is_string();
      text += text.empty() ? "" : one ? ", " : "; ";
      if (one || in_list) {
        (void)number_from(item, range, "each of " + what);
        text += item.dump();
      } else {
        text += item.is_array() ? text_of_list(item, range, what, true) : text_from(item, what);
      }
    }
    return text;
  }

  /// A file's content goes with the recipe, as a load case in another file does.
  [[nodiscard]] std::string content_of(const std::string& path, words what) const {
    auto text = attach_file((folder_ / path).string());
    if (!text)
      refuse(what + ": " + text.error().message, text.error().remedy);
    return std::move(*text);
  }

  const json& body_;
  std::string where_;
  const std::filesystem::path& folder_;
  std::set<std::string> known_;
};

}  // namespace tedit::client
