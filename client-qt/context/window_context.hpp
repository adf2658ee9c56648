// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "client-qt/context/appearance.hpp"
#include "client-qt/context/command_actions.hpp"
#include "client-qt/context/docks.hpp"
#include "client-qt/context/escapes.hpp"
#include "client-qt/model/commands.hpp"
#include "client-qt/model/document.hpp"
#include "client-qt/model/selection.hpp"
#include "client-qt/net/local_server.hpp"
#include "client-qt/view/overlay.hpp"
#include "client-qt/view/viewport.hpp"
#include "client-qt/widgets/banner.hpp"
#include "client-qt/widgets/log_panel.hpp"
#include "client-qt/widgets/operation_rail.hpp"
#include "client-qt/widgets/truth_line.hpp"

class QMainWindow;
class QSettings;
class QStackedWidget;

namespace tedit::desktop {

/// What a tool is given of the window: the part, the view, and the places where it puts its
/// commands, docks and messages. All live as long as the window, so longer than any tool.
struct window_context {
  QMainWindow& window;  ///< The parent of dialogs and menus.
  QSettings& settings;
  remote& link;
  local_server& server;
  document& part;
  selection& picked;
  commands& all_commands;
  command_actions& buttons;  ///< Of the commands.
  escapes& esc;              ///< What Esc ends.
  docks& panels;
  operation_rail& rail;   ///< At the left: the operations.
  QStackedWidget& pages;  ///< The view, and what takes its place.
  viewport& view;
  overlay& over;
  appearance& look;
  banner& messages;
  log_panel& log;
  truth_line& truth;
  /// Takes a click on the part for what is open instead of for the selection: true if it did. May
  /// be empty.
  std::function<bool(const picked_point&, Qt::KeyboardModifiers)> takes_place = {};

  /// For commands that need a part.
  [[nodiscard]] std::function<bool()> has_part() const {
    return [&part = part] { return part.head() != nullptr; };
  }
};

}  // namespace tedit::desktop
