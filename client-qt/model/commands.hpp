// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace tedit::desktop {

/// Something the user can do: the source of menus, tool buttons, shortcuts and the palette.
struct command {
  QString id;        ///< "edit.undo", stable: shortcuts are kept by it.
  QString title;     ///< "Undo".
  QString group;     ///< "Edit".
  QString shortcut;  ///< The one that it comes with; may be empty.
  std::function<void()> run;
  std::function<bool()> enabled;  ///< Empty: always.
  QString help;                   ///< One sentence; may be empty.
  QString icon;                   ///< Name of an icon, or an SVG; may be empty.
  QString why_off;                ///< Why it does nothing while it is not enabled; may be empty.
};

/// How well a person's letters fit a title: all must stand in it in their order; starts of words
/// and runs count more. Empty when they do not fit; higher is better.
[[nodiscard]] std::optional<int> fuzzy_score(const QString& letters, const QString& title);

/// All commands by the order in which they were added. Not thread-safe.
class commands : public QObject {
  Q_OBJECT

public:
  using QObject::QObject;

  /// Replaces the one with the same id.
  void add(command what);
  void remove_group(const QString& group);
  [[nodiscard]] const std::vector<command>& all() const noexcept { return all_; }
  [[nodiscard]] const command* find(const QString& id) const;
  [[nodiscard]] bool is_enabled(const command& what) const;
  /// Runs it if it is there and enabled; false otherwise.
  bool trigger(const QString& id);

  /// Those that fit, the best first; with equal fit enabled ones first, then by order.
  [[nodiscard]] std::vector<const command*> search(const QString& letters) const;

signals:
  void changed();
  /// A command was run by `trigger`.
  void triggered(const QString& id);

private:
  std::vector<command> all_;
};

}  // namespace tedit::desktop
