// SPDX-License-Identifier: AGPL-3.0-or-later
// The window's menus, by the words that people see.
#include "tests/desktop/window_fixture.hpp"

#include <QMenuBar>

#include <set>

#include "client-qt/tools/loads/loads_panel.hpp"
#include "client-qt/tools/settings/settings_dialog.hpp"

namespace tedit::desktop {
namespace {

class Menus : public Window {
protected:
  /// As it is once it is open.
  [[nodiscard]] QMenu* menu(const QString& title) {
    for (auto* action : window->menuBar()->actions())
      if (action->text().remove('&') == title) {
        emit action->menu()->aboutToShow();
        return action->menu();
      }
    ADD_FAILURE() << "no menu " << title.toStdString();
    return nullptr;
  }

  [[nodiscard]] static QAction* entry(const QMenu* in, const QString& title) {
    for (auto* action : in->actions())
      if (action->text() == title)
        return action;
    return nullptr;
  }
};

TEST_F(Menus, EveryCommandStandsInOneMenuOnce) {
  open_plate(false);
  std::multiset<QString> found;
  std::function<void(const QMenu*)> walk = [&](const QMenu* in) {
    for (auto* action : in->actions())
      if (action->menu())
        walk(action->menu());
      else if (!action->isSeparator())
        found.insert(action->objectName());
  };
  for (const auto* title : {"File", "Edit", "Operation", "Loads", "View", "Help"})
    walk(menu(title));
  for (const auto& one : window->context().all_commands.all())
    EXPECT_EQ(found.count(one.id), 1U) << one.id.toStdString() << " in " << one.group.toStdString();
  EXPECT_NE(entry(menu("Operation"), "Fill hole"), nullptr);
}

TEST_F(Menus, WhatWouldDoNothingIsOffAndSaysWhy) {
  open_plate();
  const QString remove = "Remove the chosen load, support or load case";
  auto* stop = entry(menu("Edit"), "Stop the solver");
  EXPECT_FALSE(stop->isEnabled());
  EXPECT_TRUE(stop->toolTip().contains("No solve of this part runs"));
  auto* removes = entry(menu("Loads"), remove);
  EXPECT_FALSE(removes->isEnabled());
  EXPECT_TRUE(removes->toolTip().contains("Choose one in"));

  auto* tree = window->tools().loads.panel().tree();
  tree->setCurrentItem(tree->topLevelItem(0));
  EXPECT_TRUE(removes->isEnabled());
  EXPECT_FALSE(removes->toolTip().contains("Choose one in"));
  part().solver().solve();
  EXPECT_TRUE(stop->isEnabled());
  ASSERT_TRUE(wait([&] { return is_final(); }));
  EXPECT_FALSE(stop->isEnabled());
}

TEST_F(Menus, SettingsAndHelpAreFoundThere) {
  auto* settings = entry(menu("File"), "Settings");
  ASSERT_NE(settings, nullptr);
  settings->trigger();
  EXPECT_NE(window->findChild<settings_dialog*>(), nullptr);
  EXPECT_NE(entry(menu("Help"), "Keyboard shortcuts"), nullptr);
  // Without a part there is nothing to undo, and it says so.
  EXPECT_FALSE(entry(menu("Edit"), "Undo")->isEnabled());
}

TEST_F(Menus, CommandsOfOneKindShareASubmenu) {
  open_plate(false);
  auto* from = entry(menu("View"), "View from");
  ASSERT_NE(from, nullptr);
  ASSERT_NE(from->menu(), nullptr);
  EXPECT_NE(entry(from->menu(), "View from: Top"), nullptr);
}

class Units : public Window {
protected:
  /// A cube of 0.12, whatever that is.
  [[nodiscard]] QString cube() const {
    QFile in(TEDIT_EXAMPLES "/../tests/data/bad/good_six_tets_cube.msh");
    EXPECT_TRUE(in.open(QIODevice::ReadOnly));
    QStringList lines = QString::fromUtf8(in.readAll()).split('\n');
    for (int i = 5; i < 13; ++i) {  // Its nodes: a number and three coordinates, 0 or 1.
      auto words = lines[i].split(' ');
      for (int axis = 1; axis < 4; ++axis)
        words[axis] = words[axis] == "1" ? "0.12" : "0";
      lines[i] = words.join(' ');
    }
    QFile out(state.path() + "/cube.msh");
    EXPECT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(lines.join('\n').toUtf8());
    return out.fileName();
  }

  [[nodiscard]] double size() {
    const auto& box = view().geometry()->bounds;
    return box[1] - box[0];
  }
  [[nodiscard]] QFrame* question() { return window->findChild<QFrame*>("unit_question"); }
};

TEST_F(Units, APartSaysHowLargeItIs) {
  open_plate(false);
  const auto title = window->findChild<QLabel*>("title")->text();
  EXPECT_TRUE(title.contains("800 \u00d7 450 \u00d7 150 mm")) << title.toStdString();
  EXPECT_FALSE(window->findChild<QFrame*>("unit_question")->isVisible());
}

TEST_F(Units, AnOddSizeIsAskedAboutAndTheAnswerReadsThePartAnew) {
  window->tools().documents.open_file(cube(), {});
  ASSERT_TRUE(wait([&] { return shows_head() && question()->isVisible(); }));
  EXPECT_NEAR(size(), 0.12e-3, 1e-9);
  EXPECT_TRUE(question()->findChild<QLabel*>()->text().contains("0.12 \u00d7 0.12 \u00d7 0.12 mm"))
    << question()->findChild<QLabel*>()->text().toStdString();
  const auto name = part().name();

  question()->findChild<QPushButton*>("unit_m")->click();
  ASSERT_TRUE(wait([&] { return part().name() != name && shows_head(); }));
  EXPECT_NEAR(size(), 0.12, 1e-6);
  EXPECT_FALSE(question()->isVisible());
  EXPECT_EQ(part().versions().size(), 1U);
}

TEST_F(Units, WhoKeepsTheUnitKeepsThePart) {
  window->tools().documents.open_file(cube(), {});
  ASSERT_TRUE(wait([&] { return shows_head() && question()->isVisible(); }));
  const auto name = part().name();
  question()->findChild<QPushButton*>("unit_mm")->click();
  EXPECT_FALSE(question()->isVisible());
  EXPECT_EQ(part().name(), name);
  EXPECT_FALSE(part().foreground().current());
}

}  // namespace
}  // namespace tedit::desktop
