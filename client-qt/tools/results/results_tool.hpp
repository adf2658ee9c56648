// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class field_panel;
class live_preview;

/// Shows the head with its field, or what an operation would make of it: which quantity, its
/// legend, isolines, extremes; and the solver's commands.
class results_tool : public QObject {
  Q_OBJECT

public:
  results_tool(window_context& in, live_preview& preview);

  [[nodiscard]] field_panel& panel() { return *panel_; }

private:
  void wire();
  void add_commands();
  /// The field before an edit, on what the edit would make.
  struct carried {
    shared_field of;
    std::shared_ptr<const client::surface_model> to;
    shared_field result;
  };
  void show();
  [[nodiscard]] shared_field field_of_preview();
  void measure();
  void swing();
  void say_verdict();

  window_context& in_;
  live_preview& preview_;
  field_panel* panel_;
  carried carried_;
  shared_field measured_;  ///< By which the deformation row knows what there is to show.
};

}  // namespace tedit::desktop
