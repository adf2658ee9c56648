// SPDX-License-Identifier: AGPL-3.0-or-later
// What a screen reader finds: a name for everything that can be worked with, also by the keyboard
// alone.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTextEdit>

#include "client-qt/tools/help/about_dialog.hpp"
#include "client-qt/tools/help/shortcuts_dialog.hpp"
#include "client-qt/tools/settings/settings_dialog.hpp"
#include "tests/desktop/window_fixture.hpp"

namespace tedit::desktop {
namespace {

/// Part of another widget, which has the name: the line of a spin box, the list of a combo
/// box, the button that clears a line.
bool is_inner(const QWidget& widget) {
  if (widget.objectName().startsWith("qt_"))
    return true;
  for (const auto* up = widget.parentWidget(); up; up = up->parentWidget())
    if (qobject_cast<const QAbstractSpinBox*>(up) || qobject_cast<const QComboBox*>(up) ||
        qobject_cast<const QLineEdit*>(up) ||
        (qobject_cast<const QAbstractItemView*>(up) && !qobject_cast<const QTextEdit*>(&widget)))
      return true;
  return qobject_cast<const QScrollBar*>(&widget) != nullptr;
}

bool can_be_worked_with(const QWidget& widget) {
  return qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
         qobject_cast<const QLineEdit*>(&widget) ||
         qobject_cast<const QAbstractSpinBox*>(&widget) ||
         qobject_cast<const QAbstractItemView*>(&widget) ||
         qobject_cast<const QAbstractSlider*>(&widget) || qobject_cast<const QTextEdit*>(&widget) ||
         qobject_cast<const QPlainTextEdit*>(&widget);
}

std::string nameless(QWidget& root) {
  std::string result;
  for (auto* widget : root.findChildren<QWidget*>()) {
    if (!can_be_worked_with(*widget) || is_inner(*widget) || !widget->isVisible())
      continue;
    auto* seen = QAccessible::queryAccessibleInterface(widget);
    if (seen && seen->text(QAccessible::Name).trimmed().isEmpty())
      result += std::string(widget->metaObject()->className()) + " \"" +
                widget->objectName().toStdString() + "\" in " +
                widget->parentWidget()->metaObject()->className() + "\n";
  }
  return result;
}

/// The fields in the order of the Tab key stand below each other.
void expect_tabs_go_down(const QWidget& root) {
  int lowest = -1;
  for (auto* widget = root.nextInFocusChain(); widget != &root;
       widget = widget->nextInFocusChain()) {
    if (!root.isAncestorOf(widget) || !widget->isVisibleTo(&root) || is_inner(*widget) ||
        !(widget->focusPolicy() & Qt::TabFocus) || !can_be_worked_with(*widget))
      continue;
    const int bottom = widget->mapTo(&root, QPoint(0, widget->height())).y();
    EXPECT_GE(bottom, lowest) << widget->objectName().toStdString();
    lowest = std::max(lowest, widget->mapTo(&root, QPoint()).y());
  }
}

TEST_F(Window, EverythingThatCanBeWorkedWithHasAName) {
  EXPECT_EQ(nameless(*window), "") << "on the start page";
  open_plate();
  window->context().picked.set({1, 2});
  window->tools().operations.panel().choose("erode");
  window->context().all_commands.trigger("view.section");
  EXPECT_EQ(nameless(*window), "") << "with a part and a form";
  for (auto* dock : window->findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    QApplication::processEvents();
    EXPECT_EQ(nameless(*window), "") << dock->objectName().toStdString();
  }
  for (const auto* id : {"loads.add_support", "loads.add_load", "loads.add_material"}) {
    window->context().all_commands.trigger(id);
    QTest::qWait(10);
    EXPECT_EQ(nameless(*window), "") << id;
  }
}

TEST_F(Window, DialogsHaveNamesAndTabsThatGoDown) {
  settings_dialog settings({});
  settings.show();
  EXPECT_EQ(nameless(settings), "");
  expect_tabs_go_down(settings);
  about_dialog about;
  about.show();
  EXPECT_EQ(nameless(about), "");
  QSettings kept(state.filePath("keys.ini"), QSettings::IniFormat);
  shortcuts_dialog keys({window->context().all_commands, kept});
  keys.show();
  EXPECT_EQ(nameless(keys), "");
}

}  // namespace
}  // namespace tedit::desktop
