// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/commands.hpp"

#include <algorithm>

namespace tedit::desktop {

namespace {

constexpr int at_word_start = 8;
constexpr int after_last = 5;
constexpr int anywhere = 1;

}  // namespace

std::optional<int> fuzzy_score(const QString& letters, const QString& title) {
  int score = 0;
  qsizetype at = 0;
  qsizetype last = -2;
  for (const QChar letter : letters) {
    if (letter.isSpace())
      continue;
    at = title.indexOf(letter, at, Qt::CaseInsensitive);
    if (at < 0)
      return std::nullopt;
    const bool starts = at == 0 || !title[at - 1].isLetterOrNumber();
    score += starts ? at_word_start : at == last + 1 ? after_last : anywhere;
    last = at++;
  }
  return score;
}

void commands::add(command what) {
  const auto same =
    std::ranges::find_if(all_, [&](const command& held) { return held.id == what.id; });
  if (same != all_.end())
    *same = std::move(what);
  else
    all_.push_back(std::move(what));
  emit changed();
}

void commands::remove_group(const QString& group) {
  if (std::erase_if(all_, [&](const command& held) { return held.group == group; }) > 0)
    emit changed();
}

const command* commands::find(const QString& id) const {
  const auto found = std::ranges::find_if(all_, [&](const command& held) { return held.id == id; });
  return found == all_.end() ? nullptr : &*found;
}

bool commands::is_enabled(const command& what) const {
  return !what.enabled || what.enabled();
}

bool commands::trigger(const QString& id) {
  const auto* found = find(id);
  if (!found || !is_enabled(*found))
    return false;
  const auto run = found->run;  // It may change the list.
  run();
  emit triggered(id);
  return true;
}

std::vector<const command*> commands::search(const QString& letters) const {
  struct hit {
    const command* what;
    int score;
  };
  std::vector<hit> hits;
  for (const auto& one : all_) {
    auto score = fuzzy_score(letters, one.title);
    if (!score)
      score = fuzzy_score(letters, one.group + " " + one.title);
    if (score)
      hits.push_back({&one, 2 * *score + (is_enabled(one) ? 1 : 0)});
  }
  std::ranges::stable_sort(hits, std::ranges::greater{}, &hit::score);
  std::vector<const command*> result;
  for (const auto& one : hits)
    result.push_back(one.what);
  return result;
}

}  // namespace tedit::desktop
