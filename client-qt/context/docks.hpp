// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>

#include <map>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace tedit::desktop {

/// The panels round the view, by name: a person's layout is kept by it. Tools add theirs; the
/// window decides where they stand at first.
class docks {
public:
  explicit docks(QMainWindow& window) : window_(window) {}

  QDockWidget& add(const QString& name, const QString& title, QWidget* content);
  /// One that was added.
  [[nodiscard]] QDockWidget& of(const QString& name) const { return *all_.at(name); }
  /// To the front of those at its place.
  void raise(const QString& name) const;
  /// Whether what is typed goes to it.
  [[nodiscard]] bool has_focus(const QString& name) const;
  /// Whether nobody is about to share their room out anew: what pictures of the window wait for.
  [[nodiscard]] bool are_settled() const noexcept { return to_settle_ == 0; }
  void begin_settling() noexcept { ++to_settle_; }
  void end_settling() noexcept { --to_settle_; }

private:
  QMainWindow& window_;
  std::map<QString, QDockWidget*> all_;
  int to_settle_ = 0;
};

}  // namespace tedit::desktop
