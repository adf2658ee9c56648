// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/session/change_log.hpp"

#include <algorithm>
#include <ctime>
#include <span>

#include <nlohmann/json.hpp>

#include "base/utc.hpp"

namespace tedit::actors {

namespace {

constexpr std::size_t longest_edit_id = 64;

std::string text_of(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string dump(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

hash128 asked_change::id() const {
  const auto text = what + " " + how;
  return hash_bytes(std::as_bytes(std::span(text)));
}

std::string past_change::to_details(const std::string& how) const {
  auto details = nlohmann::json::parse(how, nullptr, false);
  if (!details.is_object())
    details = nlohmann::json::object();
  details["client"] = client;
  details["time"] = time;
  if (version)
    details["head"] = *version;
  if (!warnings.empty())
    details["warnings"] = warnings;
  if (!edit_id.empty()) {
    details["edit_id"] = edit_id;
    details["request"] = to_hex(request);
  }
  return dump(details);
}

std::optional<past_change> past_change::from_log(const store::log_row& row) {
  const auto details = nlohmann::json::parse(row.details, nullptr, false);
  if (!details.is_object() || !details.contains("time"))
    return std::nullopt;
  past_change result;
  result.what = row.what;
  result.operation = text_of(details, "operation");
  result.client = text_of(details, "client");
  result.time = text_of(details, "time");
  result.edit_id = text_of(details, "edit_id");
  result.request = hash_from_hex(text_of(details, "request")).value_or(hash128{});
  if (const auto head = details.find("head"); head != details.end() && head->is_number_unsigned())
    result.version = head->get<std::uint32_t>();
  if (const auto list = details.find("warnings"); list != details.end() && list->is_array())
    for (const auto& one : *list)
      if (one.is_string())
        result.warnings.push_back(one.get<std::string>());
  return result;
}

std::string utc_now() {
  return utc_text(std::time(nullptr));
}

expected<void> check_edit_id(const std::string& id) {
  const bool odd = std::ranges::any_of(id, [](char c) { return c <= ' ' || c > '~'; });
  if (id.size() <= longest_edit_id && !odd)
    return {};
  return fail(ec::invalid_argument, "this is no edit_id",
              "Take at most " + std::to_string(longest_edit_id) +
                " printable ASCII characters without spaces, for example a UUID");
}

void tell_makers(const std::vector<store::log_row>& rows, std::vector<graph_node>& nodes) {
  constexpr std::size_t most_told = 20'000;
  for (const auto& row : std::span(rows).last(std::min(rows.size(), most_told))) {
    if (row.what != "edit" && row.what != "import")
      continue;
    const auto made = past_change::from_log(row);
    if (!made || !made->version || *made->version >= nodes.size())
      continue;
    nodes[*made->version].info.made_by = made->client;
    nodes[*made->version].info.made_at = made->time;
  }
}

change_log::change_log(const std::vector<store::log_row>& rows) {
  const auto last = std::span(rows).last(std::min(rows.size(), 2 * most_remembered));
  for (const auto& row : last)
    if (auto made = past_change::from_log(row))
      add(std::move(*made));
}

void change_log::add(past_change made) {
  if (made.version)
    last_move_ = made;
  if (made.edit_id.empty())
    return;
  with_id_.push_back(std::move(made));
  if (with_id_.size() > most_remembered)
    with_id_.pop_front();
}

const past_change* change_log::find(const std::string& edit_id) const {
  const auto found = std::ranges::find(with_id_, edit_id, &past_change::edit_id);
  return edit_id.empty() || found == with_id_.end() ? nullptr : &*found;
}

}  // namespace tedit::actors
