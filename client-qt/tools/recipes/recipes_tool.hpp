// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include "client-qt/context/window_context.hpp"
#include "client/recipe.hpp"

namespace tedit::desktop {

struct toolbox;
class window_player;

/// Runs recipes for a person, one at a time, as rows of what runs, and says how each went. They
/// write no files.
class recipes_tool : public QObject {
  Q_OBJECT

public:
  /// `tools` may still be made.
  recipes_tool(window_context& in, toolbox& tools);

  /// On the open part, or on the one that it imports.
  void run(const QString& path);
  [[nodiscard]] bool is_running() const;

private:
  void play(const QString& what, const client::recipe& recipe);

  window_context& in_;
  toolbox& tools_;
  QPointer<window_player> player_;  ///< The one that runs.
};

}  // namespace tedit::desktop
