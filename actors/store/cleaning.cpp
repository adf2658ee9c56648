// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/cleaning.hpp"

#include <nlohmann/json.hpp>

namespace tedit::actors {

namespace {

using new_numbers = std::vector<std::optional<std::uint32_t>>;

/// Which versions stay, by number.
expected<std::vector<bool>> kept_by(const store::contents& rows, const cleaning& wanted) {
  const auto& all = rows.versions;
  std::vector<bool> kept(all.size(), !wanted.unreachable);
  // What has its parent is done: so has that one.
  const auto keep = [&](std::optional<std::uint32_t> from) {
    for (auto at = from; at && !kept[*at]; at = all[*at].parent)
      kept[*at] = true;
  };
  keep(rows.head);
  // Redo leads on from the head; a child has a larger number, so this ends.
  for (auto at = rows.head; at; at = all[*at].redo)
    keep(at);
  for (const auto& row : all)
    if (!row.name.empty() || !row.note.empty())
      keep(row.number);
  for (const auto number : wanted.keep) {
    if (number >= all.size())
      return fail(ec::not_found, "there is no version " + std::to_string(number) + " to keep",
                  all.empty() ? "The document has none"
                              : "The last one is " + std::to_string(all.size() - 1));
    keep(number);
  }
  return kept;
}

/// Brings one number of a line up to date; whether its version goes.
bool renumber(nlohmann::json& details, const char* key, const new_numbers& now) {
  const auto found = details.find(key);
  if (found == details.end() || !found->is_number_unsigned())
    return false;
  const auto before = found->get<std::uint64_t>();
  if (before >= now.size() || !now[before]) {
    details.erase(found);
    return true;
  }
  *found = *now[before];
  return false;
}

/// The lines that name versions by numbers that are others now.
std::vector<store::log_row> log_after(const std::vector<store::log_row>& before,
                                      const new_numbers& now) {
  std::vector<store::log_row> changed;
  for (const auto& line : before) {
    auto details = nlohmann::json::parse(line.details, nullptr, false);
    if (!details.is_object())
      continue;
    const auto as_it_was = details;
    renumber(details, "number", now);
    // Who asks for this change again is refused: no request has this hash.
    if (renumber(details, "head", now) && details.contains("request"))
      details["request"] = to_hex(hash128{});
    if (details != as_it_was)
      changed.push_back({line.sequence, line.what,
                         details.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)});
  }
  return changed;
}

}  // namespace

expected<cleaning_plan> plan_cleaning(const store::contents& rows, const cleaning& wanted) {
  const auto kept = kept_by(rows, wanted);
  if (!kept)
    return fail(kept.error());
  cleaning_plan plan;
  std::uint32_t next = 0;
  for (std::uint32_t number = 0; number < kept->size(); ++number)
    if ((*kept)[number]) {
      plan.what.numbers.emplace_back(next++);
    } else {
      plan.what.numbers.emplace_back();
      plan.dropped.push_back(number);
    }
  if (!plan.dropped.empty())
    plan.what.log = log_after(rows.log, plan.what.numbers);
  return plan;
}

}  // namespace tedit::actors
