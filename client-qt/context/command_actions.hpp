// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QHash>
#include <QObject>

class QAction;
class QMainWindow;
class QSettings;

namespace tedit::desktop {

class appearance;
class commands;

/// The action of each command, for menus, tool buttons and its shortcut in the window.
class command_actions : public QObject {
  Q_OBJECT

public:
  command_actions(commands& all, QSettings& settings, const appearance& look, QMainWindow& window);

  /// Made when it is asked for first.
  QAction* of(const QString& id);
  /// Gives every command its action, so that its shortcut works.
  void make_all();
  /// Ends the actions of commands of which there will be others.
  void forget_group(const QString& group);
  /// Enables those that can be run now; the hints of others say why not, where that is known.
  void refresh();
  /// Takes a person's own shortcuts, as they are kept.
  void take_shortcuts();

private:
  void paint();

  commands& all_;
  QSettings& settings_;
  const appearance& look_;
  QMainWindow& window_;
  QHash<QString, QAction*> made_;
};

}  // namespace tedit::desktop
