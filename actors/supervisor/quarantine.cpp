// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/quarantine.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace tedit::actors {

bool quarantine::note(const edit_origin& edit, const std::string& how) {
  auto& r = operations_[edit.operation][edit.document];
  ++r.edits;
  r.last_client = edit.client;
  r.last_end = how;
  return is_off(r);
}

bool quarantine::is_off_everywhere(const rows& of) const {
  const auto off = std::ranges::count_if(of, [&](const auto& one) { return is_off(one.second); });
  return limit_ > 0 && static_cast<unsigned>(off) >= limit_;
}

/// "in the document "plate" it failed 3 edits, the last of Anna: the process was killed ..."
std::string quarantine::reason(const std::string& operation, const rows& in) const {
  std::string text = "the operation " + operation + " is switched off";
  const char* lead = ": ";
  for (const auto& [document, r] : in) {
    if (!is_off(r))
      continue;
    text += lead;
    text += "in the document \"" + document + "\" its plugin failed " + std::to_string(r.edits) +
            (r.edits == 1 ? " edit" : " edits") +
            (r.last_client.empty() ? "" : ", the last asked for by " + r.last_client) +
            ": the process that ran it " + r.last_end;
    lead = "; ";
  }
  return text;
}

std::optional<error> quarantine::refusal(const edit_origin& edit) const {
  const auto found = operations_.find(edit.operation);
  if (found == operations_.end())
    return std::nullopt;
  const auto& all = found->second;
  constexpr auto remedy =
    "The part is unchanged. \"tedit plugin test\" finds what is wrong with a plugin; the server "
    "tries it again after a restart";
  if (is_off_everywhere(all))
    return error{ec::plugin_refused, reason(edit.operation, all), remedy, {}};
  const auto here = all.find(edit.document);
  if (here == all.end() || !is_off(here->second))
    return std::nullopt;
  return error{ec::plugin_refused, reason(edit.operation, {*here}), remedy, {}};
}

std::string quarantine::apply_to(const std::string& catalogue) const {
  auto json = nlohmann::json::parse(catalogue, nullptr, false);
  if (!json.is_object() || !json.contains("operations"))
    return catalogue;
  auto kept = nlohmann::json::array();
  for (auto& operation : json["operations"]) {
    const auto id = operation.value("id", std::string());
    const auto found = operations_.find(id);
    if (found == operations_.end() || !is_off_everywhere(found->second)) {
      kept.push_back(std::move(operation));
      continue;
    }
    unsigned edits = 0;
    for (const auto& [document, r] : found->second)
      edits += r.edits;
    json["refused"].push_back({{"file", operation.value("plugin", id)},
                               {"reason", reason(id, found->second)},
                               {"operation", id},
                               {"crashes", edits},
                               {"remedy", "start the server anew to have it tried again"}});
  }
  json["operations"] = std::move(kept);
  return json.dump();
}

}  // namespace tedit::actors
