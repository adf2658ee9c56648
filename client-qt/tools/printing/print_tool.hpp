// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/context/window_context.hpp"
#include "client-qt/model/print_inspection.hpp"

namespace tedit::desktop {

class print_panel;
class selection_tool;

/// What hinders printing: a panel, and marks on the part for as long as it is open.
class print_tool : public QObject {
  Q_OBJECT

public:
  print_tool(window_context& in, selection_tool& selecting);

  /// Shows the panel and checks with what its form says.
  void open();
  void open(const print_settings& settings);
  void close();
  [[nodiscard]] const print_inspection& inspection() const noexcept { return inspection_; }
  [[nodiscard]] print_panel& panel() const { return *panel_; }

private:
  void wire(selection_tool& selecting);
  void show_panel();
  void show_place(const vec3& at, const std::vector<surface_id>& surfaces);

  window_context& in_;
  print_inspection inspection_;
  print_panel* panel_;
};

}  // namespace tedit::desktop
