// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/supervisor/turns.hpp"

#include <algorithm>
#include <tuple>

namespace tedit::actors {

namespace {

constexpr std::size_t most_remembered = 4096;

std::uint64_t who(const turn& t) {
  return t.client != 0 ? t.client : t.document;
}

}  // namespace

turn_order::clock turn_order::served(std::uint64_t who) const {
  const auto found = served_.find(who);
  return found == served_.end() ? 0 : found->second;
}

/// The most urgent there is; that of files, when they were passed over often enough.
urgency turn_order::level_of(const std::vector<turn>& waiting) {
  const auto [most, least] = std::ranges::minmax(waiting, {}, &turn::what);
  const bool passes = most.what != least.what && least.what == urgency::file;
  if (passes && passed_ < others_between) {
    ++passed_;
    return most.what;
  }
  passed_ = 0;
  return passes ? urgency::file : most.what;
}

std::size_t turn_order::take(const std::vector<turn>& waiting) {
  const auto again = std::ranges::find(waiting, true, &turn::again);
  if (again != waiting.end())
    return static_cast<std::size_t>(again - waiting.begin());
  const auto level = level_of(waiting);
  // The first of the smallest: who came first, of those who were served at the same time.
  const auto next = std::ranges::min_element(waiting, {}, [&](const turn& t) {
    return std::tuple(t.what != level, served(who(t)), served(t.document));
  });
  if (waiting.size() == 1 || served_.size() > most_remembered)
    served_.clear();  // Of one alone: whoever comes next finds nobody to be fair to.
  ++now_;
  served_[who(*next)] = now_;
  served_[next->document] = now_;
  return static_cast<std::size_t>(next - waiting.begin());
}

}  // namespace tedit::actors
