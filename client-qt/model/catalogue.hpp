// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include "client-qt/model/handle_plan.hpp"
#include "protocol/operation_message.hpp"

namespace tedit::desktop {

/// The operations that the server offers, as forms, menus and help show them.
struct catalogue : operation_catalogue {
  /// What the form of each is dragged by, by its id.
  std::map<std::string, handle_plan> handles = {};

  /// Null when there is none with this id.
  [[nodiscard]] const offered_operation* find(const QString& id) const;
};

/// What `icon` takes for an operation: its own drawing, or a general one.
[[nodiscard]] QString icon_of(const offered_operation& one);

/// All of them as a page of the manual, Markdown: what each is for, what to pick, its parameters.
[[nodiscard]] QString manual_page_of(const catalogue& all);

/// Names and texts of shipped operations in the person's language.
[[nodiscard]] catalogue translated(operation_catalogue all);

}  // namespace tedit::desktop
