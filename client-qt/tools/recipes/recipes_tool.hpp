// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include "client-qt/context/window_context.hpp"

namespace tedit::desktop {

class connection_tool;
class recipe_player;

/// Runs recipes, one at a time, and says how each went.
class recipes_tool : public QObject {
  Q_OBJECT

public:
  recipes_tool(window_context& in, connection_tool& connection);

  /// On the open part, or on the one that it imports.
  void run(const QString& path);
  [[nodiscard]] bool is_running() const;

private:
  window_context& in_;
  connection_tool& connection_;
  QPointer<recipe_player> player_;  ///< The one that runs.
};

}  // namespace tedit::desktop
