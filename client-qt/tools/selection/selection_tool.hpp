// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPoint>
#include <QRect>

#include <optional>
#include <set>
#include <vector>

#include "client-qt/context/window_context.hpp"

class QPushButton;

namespace tedit::desktop {

class surface_finder;

/// Surfaces under the pointer: picking them by clicks, boxes and words, what they are, their menu,
/// and hiding them.
class selection_tool : public QObject {
  Q_OBJECT

public:
  explicit selection_tool(window_context& in);

  /// Picks some surfaces and brings them into view.
  void highlight(const QList<qint64>& surfaces);
  /// Whether a click picks what is under it.
  void set_picking(bool on) { picks_ = on; }
  /// Surfaces that are not drawn.
  [[nodiscard]] const std::set<surface_id>& hidden() const noexcept { return hidden_; }
  void set_hidden(std::set<surface_id> surfaces);
  /// How many are hidden stands beside the cube, which turns the view, too.
  void place_count(const QRect& cube);

signals:
  void hidden_changed();

private:
  void wire();
  void add_hiding();
  void add_box();
  void add_finding();
  void set_boxing(bool on);
  void click(const std::optional<picked_point>& at, Qt::KeyboardModifiers modifiers);
  void take_box(const std::vector<surface_id>& found, bool add);
  void hide_selection();
  void isolate_selection();
  void show_tooltip(const std::optional<picked_point>& at, QPoint global);
  void show_menu(const std::optional<picked_point>& at, QPoint global);

  window_context& in_;
  surface_finder* finder_ = nullptr;  ///< Of the window.
  QPushButton* count_ = nullptr;      ///< Of the view.
  std::set<surface_id> hidden_;
  bool picks_ = true;
  bool boxing_ = false;
};

}  // namespace tedit::desktop
