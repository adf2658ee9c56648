// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class compare_view;
class field_panel;
class history_tool;

/// The shown version against its parent, or one that was dragged onto another in the history.
class compare_tool : public QObject {
  Q_OBJECT

public:
  compare_tool(window_context& in, const field_panel& fields, history_tool& history);

private:
  void wire(history_tool& history);
  void add_commands();
  void open(quint32 before, quint32 after);
  /// To the part; says whether there was a comparison to leave.
  bool leave();
  [[nodiscard]] bool is_open() const;

  window_context& in_;
  const field_panel& fields_;
  compare_view* page_;
};

}  // namespace tedit::desktop
