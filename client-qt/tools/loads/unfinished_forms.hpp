// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include "client-qt/model/load_editing.hpp"
#include "client-qt/tools/loads/load_editor.hpp"

namespace tedit::desktop {

class document;
class selection;

/// What was typed in forms of a document's loads that were left for another one: it is there again
/// when the same form is opened, until it is applied or cancelled.
class unfinished_forms {
public:
  /// The form becomes that of an item, as it is now, or of a new one, instead of what it was.
  void open(const load_editor& form, const std::string& load_case, item_kind kind,
            const std::optional<load_item>& item);
  /// The open form is closed; what is typed in it is noted.
  void leave(const load_editor& form);
  /// The open form is done with: what is typed in it is forgotten,
  void forget();
  /// or in any.
  void clear();
  /// Fills in what was typed before. A new item is for what is selected meanwhile, else for what
  /// was selected then, as far as it is left.
  void take_up(load_editor& form, selection& picked, const document& part) const;

private:
  std::optional<std::string> open_;
  bool is_new_ = false;
  std::map<std::string, typed_item> typed_;
};

}  // namespace tedit::desktop
