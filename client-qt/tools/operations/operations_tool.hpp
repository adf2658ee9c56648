// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class context_panel;
class drag_figures;
class operation_handles;

/// What can be done with the selection: the rail's buttons, the operations' commands, and the
/// panel with the form of the one that is chosen.
class operations_tool : public QObject {
  Q_OBJECT

public:
  explicit operations_tool(window_context& in);

  [[nodiscard]] context_panel& panel() { return *panel_; }
  [[nodiscard]] operation_handles& handles() { return *handles_; }
  [[nodiscard]] const drag_figures& figures() const { return *figures_; }

private:
  void add_commands();
  void offer();
  window_context& in_;
  context_panel* panel_;
  operation_handles* handles_;
  drag_figures* figures_;
};

}  // namespace tedit::desktop
