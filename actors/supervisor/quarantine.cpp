// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/quarantine.hpp"

#include <nlohmann/json.hpp>

namespace tedit::actors {

bool quarantine::note(const std::string& operation, const std::string& how) {
  auto& r = rows_[operation];
  ++r.deaths;
  r.last = how;
  return is_off(r);
}

std::string quarantine::reason(const std::string& operation, const row& r) const {
  return "the operation " + operation +
         " is switched off: its plugin ended the process that ran it " +
         (r.deaths == 1 ? "once; it " : std::to_string(r.deaths) + " times; the last time it ") +
         r.last;
}

std::optional<error> quarantine::refusal(const std::string& operation) const {
  const auto found = rows_.find(operation);
  if (found == rows_.end() || !is_off(found->second))
    return std::nullopt;
  return error{
    ec::plugin_refused,
    reason(operation, found->second),
    "The part is unchanged. \"tedit plugin test\" finds what is wrong with a plugin; the "
    "server tries it again after a restart",
    {}};
}

std::string quarantine::apply_to(const std::string& catalogue) const {
  auto json = nlohmann::json::parse(catalogue, nullptr, false);
  if (!json.is_object() || !json.contains("operations"))
    return catalogue;
  auto kept = nlohmann::json::array();
  for (auto& operation : json["operations"]) {
    const auto id = operation.value("id", std::string());
    const auto found = rows_.find(id);
    if (found != rows_.end() && is_off(found->second))
      json["refused"].push_back({{"file", operation.value("plugin", id)},
                                 {"reason", reason(id, found->second)},
                                 {"operation", id},
                                 {"crashes", found->second.deaths},
                                 {"remedy", "start the server anew to have it tried again"}});
    else
      kept.push_back(std::move(operation));
  }
  json["operations"] = std::move(kept);
  return json.dump();
}

}  // namespace tedit::actors
