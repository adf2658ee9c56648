// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class context_panel;

/// What can be done with the selection: the rail's buttons, the operations' commands, and the
/// panel with the form of the one that is chosen.
class operations_tool : public QObject {
  Q_OBJECT

public:
  explicit operations_tool(window_context& in);

  [[nodiscard]] context_panel& panel() { return *panel_; }

private:
  void add_commands();
  void offer();
  [[nodiscard]] bool take_place(const picked_point& at);

  window_context& in_;
  context_panel* panel_;
};

}  // namespace tedit::desktop
