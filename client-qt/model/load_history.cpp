// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/load_history.hpp"

#include <utility>

namespace tedit::desktop {

const load_history::steps* load_history::standing(std::uint32_t version,
                                                  const load_cases& now) const {
  const auto found = of_version_.find(version);
  const bool stands = found != of_version_.end() && found->second.states[found->second.at] == now;
  return stands ? &found->second : nullptr;
}

void load_history::changed(std::uint32_t version, load_cases before, load_cases after) {
  if (before == after)
    return;
  if (!standing(version, before))
    of_version_[version] = {{std::move(before)}, 0};
  auto& [states, at] = of_version_[version];
  states.resize(at + 1);
  states.push_back(std::move(after));
  ++at;
}

const load_history::load_cases* load_history::to_undo(std::uint32_t version,
                                                      const load_cases& now) const {
  const auto* found = standing(version, now);
  return found && found->at > 0 ? &found->states[found->at - 1] : nullptr;
}

const load_history::load_cases* load_history::to_redo(std::uint32_t version,
                                                      const load_cases& now) const {
  const auto* found = standing(version, now);
  return found && found->at + 1 < found->states.size() ? &found->states[found->at + 1] : nullptr;
}

void load_history::undone(std::uint32_t version) {
  const auto found = of_version_.find(version);
  if (found != of_version_.end() && found->second.at > 0)
    --found->second.at;
}

void load_history::redone(std::uint32_t version) {
  const auto found = of_version_.find(version);
  if (found != of_version_.end() && found->second.at + 1 < found->second.states.size())
    ++found->second.at;
}

}  // namespace tedit::desktop
