// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class context_panel;
class help_panel;

/// The manual, the keyboard shortcuts, and what this program is.
class help_tool : public QObject {
  Q_OBJECT

public:
  help_tool(window_context& in, const context_panel& operations);

private:
  void add_dialogs();
  void open();
  /// The page of the manual for what is being done, and the heading to begin with.
  [[nodiscard]] std::pair<QString, QString> topic() const;

  window_context& in_;
  const context_panel& operations_;
  help_panel* panel_;
};

}  // namespace tedit::desktop
