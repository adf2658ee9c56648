// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"
#include "client-qt/model/probes.hpp"

namespace tedit::desktop {

class field_panel;
class probe_panel;
class selection_tool;

/// Where a document's pins are kept among the settings.
[[nodiscard]] inline QString pins_key(const QString& document) {
  return "pins/" + document;
}

/// Values at numbered places: pins on the part, their list, and plots.
class probes_tool : public QObject {
  Q_OBJECT

public:
  probes_tool(window_context& in, field_panel& fields, selection_tool& selecting);

  [[nodiscard]] probes& pins() { return pins_; }
  [[nodiscard]] probe_panel& list() { return *list_; }

private:
  void add_pins();
  void add_commands();
  void keep_pins();
  void find_kept();
  void set_probing(bool on);

  window_context& in_;
  selection_tool& selecting_;
  probes pins_;
  probe_panel* list_;
  bool looks_for_kept_ = false;  ///< Until the surface is there on which they stand.
  bool probing_ = false;         ///< A click sets a probe and picks nothing.
};

}  // namespace tedit::desktop
