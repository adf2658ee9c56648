// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/context/command_actions.hpp"

#include <QAction>
#include <QMainWindow>
#include <QSettings>

#include "client-qt/context/appearance.hpp"
#include "client-qt/model/commands.hpp"
#include "client-qt/model/preferences.hpp"

namespace tedit::desktop {

namespace {

QString hint_of(const command& what, const QString& keys, bool enabled) {
  const QString title = keys.isEmpty() ? what.title : what.title + "  (" + keys + ")";
  return enabled || what.why_off.isEmpty() ? title : title + "\n" + what.why_off;
}

}  // namespace

command_actions::command_actions(commands& all, QSettings& settings, const appearance& look,
                                 QMainWindow& window)
    : all_(all), settings_(settings), look_(look), window_(window) {
  connect(&look, &appearance::changed, this, &command_actions::paint);
}

QAction* command_actions::of(const QString& id) {
  if (const auto found = made_.find(id); found != made_.end())
    return *found;
  const auto* what = all_.find(id);
  auto* made = new QAction(&window_);
  made->setObjectName(id);
  if (what) {
    made->setText(what->title);
    const QString keys = shortcut_table(all_, settings_).keys(*what);
    made->setToolTip(hint_of(*what, keys, true));
    made->setShortcut(QKeySequence(keys));
    if (!what->icon.isEmpty())
      made->setIcon(icon(what->icon, look_.now().ink));
  }
  connect(made, &QAction::triggered, this, [this, id] { all_.trigger(id); });
  made_.insert(id, made);
  window_.addAction(made);
  return made;
}

void command_actions::make_all() {
  for (const auto& what : all_.all())
    (void)of(what.id);
  refresh();
}

void command_actions::forget_group(const QString& group) {
  for (const auto& what : all_.all())
    if (what.group == group)
      if (auto* old = made_.take(what.id))
        old->deleteLater();
}

void command_actions::refresh() {
  const shortcut_table table(all_, settings_);
  for (auto at = made_.begin(); at != made_.end(); ++at)
    if (const auto* what = all_.find(at.key())) {
      const bool on = all_.is_enabled(*what);
      at.value()->setEnabled(on);
      if (!what->why_off.isEmpty())
        at.value()->setToolTip(hint_of(*what, table.keys(*what), on));
    }
}

void command_actions::take_shortcuts() {
  const shortcut_table table(all_, settings_);
  for (auto at = made_.begin(); at != made_.end(); ++at)
    if (const auto* what = all_.find(at.key())) {
      const QString keys = table.keys(*what);
      at.value()->setShortcut(QKeySequence(keys));
      at.value()->setToolTip(hint_of(*what, keys, all_.is_enabled(*what)));
    }
}

void command_actions::paint() {
  for (auto at = made_.begin(); at != made_.end(); ++at)
    if (const auto* what = all_.find(at.key()); what && !what->icon.isEmpty())
      at.value()->setIcon(icon(what->icon, look_.now().ink));
}

}  // namespace tedit::desktop
