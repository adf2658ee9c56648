// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/window/menus.hpp"

#include <QMenuBar>

#include <algorithm>
#include <set>

#include "client-qt/context/command_actions.hpp"
#include "client-qt/context/command_groups.hpp"
#include "client-qt/model/commands.hpp"

namespace tedit::desktop {

namespace {

constexpr int least_submenu = 3;

/// A line before these: they begin another kind of things.
const std::set<QString> begin_section{"file.export",   "file.settings", "edit.solve", "help.about",
                                      "view.parallel", "file.quit",     "edit.cancel"};
/// Where everybody looks for them: at the end.
const std::set<QString> last{"file.quit", "help.about"};

/// "View from" of "View from: Top".
QString family_of(const command& one) {
  const auto colon = one.title.indexOf(": ");
  return colon > 0 ? one.title.left(colon) : QString();
}

void fill(QMenu& menu, const QString& group, const commands& all, command_actions& actions) {
  menu.clear();
  std::vector<const command*> some;
  for (const auto& one : all.all())
    if (one.group == group)
      some.push_back(&one);
  std::ranges::stable_partition(some, [](const command* one) { return !last.contains(one->id); });
  QHash<QString, QMenu*> submenus;
  for (const auto* one : some) {
    const QString family = family_of(*one);
    const auto relatives = std::ranges::count_if(
      some, [&](const command* other) { return family_of(*other) == family; });
    if (begin_section.contains(one->id))
      menu.addSeparator();
    auto* to = &menu;
    if (!family.isEmpty() && relatives >= least_submenu) {
      auto*& made = submenus[family];
      if (!made)
        made = menu.addMenu(family);
      to = made;
    }
    to->addAction(actions.of(one->id));
  }
  actions.refresh();
}

}  // namespace

void fill_menus(QMenuBar& bar, const commands& all, command_actions& actions) {
  for (const auto& group :
       {command_groups::file(), command_groups::edit(), command_groups::operation(),
        command_groups::loads(), command_groups::view(), command_groups::help()}) {
    auto* menu = bar.addMenu("&" + group);
    menu->setToolTipsVisible(true);
    QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, group, &all, &actions] {
      for (auto* old : menu->findChildren<QMenu*>(Qt::FindDirectChildrenOnly))
        old->deleteLater();
      fill(*menu, group, all, actions);
    });
  }
}

}  // namespace tedit::desktop
