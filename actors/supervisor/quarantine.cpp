// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/quarantine.hpp"

#include <algorithm>

#include "base/misdeed.hpp"

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

error refusal_of_misdeed(const edit_origin& work, const std::string& how,
                         const operation_catalogue* known) {
  const auto& id = work.operation;
  if (id.empty())
    return {ec::internal, "what read or wrote the file " + how, misdeed_remedy, {}};
  if (known)
    for (const auto& one : known->operations)
      if (one.about.id == id)
        return {ec::internal,
                "the operation " + id + " of the plugin " + one.plugin + " " + how,
                misdeed_remedy,
                {}};
  return {ec::internal, "the plugin of the operation " + id + " " + how, misdeed_remedy, {}};
}

operation_catalogue quarantine::apply_to(const operation_catalogue& all) const {
  operation_catalogue result{{}, all.refused};
  for (const auto& one : all.operations) {
    const auto& id = one.about.id;
    const auto found = operations_.find(id);
    if (found == operations_.end() || !is_off_everywhere(found->second)) {
      result.operations.push_back(one);
      continue;
    }
    unsigned edits = 0;
    for (const auto& [document, r] : found->second)
      edits += r.edits;
    result.refused.push_back({one.plugin, reason(id, found->second), id, edits,
                              "start the server anew to have it tried again"});
  }
  return result;
}

}  // namespace tedit::actors
