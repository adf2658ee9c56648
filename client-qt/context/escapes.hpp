// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <map>

namespace tedit::desktop {

/// What Esc ends, in the order in which it is asked whether it is there to be ended.
enum class ends {
  handle_drag,
  drag_mode,
  click_mode,
  page,
  wait,
  list,
  load_form,
  form,
  selection,
  tour,
  solve
};

/// One Esc ends one thing. Tools say what they have to end.
class escapes {
public:
  /// `end`: ends it, or says false: there was nothing. Each place is taken once.
  void add(ends place, std::function<bool()> end) { all_[place] = std::move(end); }

  void run() const {
    for (const auto& [place, end] : all_)
      if (end())
        return;
  }

private:
  std::map<ends, std::function<bool()>> all_;
};

}  // namespace tedit::desktop
