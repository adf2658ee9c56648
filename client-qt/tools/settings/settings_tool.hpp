// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"
#include "client-qt/model/preferences.hpp"

namespace tedit::desktop {

class field_panel;

/// What a person set once for all parts, and its dialog.
class settings_tool : public QObject {
  Q_OBJECT

public:
  settings_tool(window_context& in, field_panel& fields);

  /// Brings what is kept into effect. Once all tools are there: they follow the look.
  void apply_kept();

private:
  void apply(const preferences& wanted);
  void open();

  window_context& in_;
  field_panel& fields_;
  bool system_dark_;  ///< As it was when the program started.
};

}  // namespace tedit::desktop
