// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QAbstractItemView>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTextEdit>

#include "tests/desktop/window_fixture.hpp"

namespace tedit::desktop {

/// A person who knows only the words that stand on the screen, and has a mouse and keys. What is
/// out of sight cannot be pressed; what is looked for and not there fails the test with its words.
class ByWords : public Window {
protected:
  // -- what stands there ---------------------------------------------------------------

  [[nodiscard]] static bool is_in_sight(const QWidget& one) {
    return one.isVisible() && one.visibleRegion().contains(one.rect().center());
  }

  /// All words that are in sight, a line for each place.
  [[nodiscard]] QString screen() const {
    QStringList lines;
    for (const auto* one : window->findChildren<QWidget*>()) {
      if (!one->isVisible() || one->visibleRegion().isEmpty())
        continue;
      if (const auto* label = qobject_cast<const QLabel*>(one))
        lines << label->text();
      else if (const auto* button = qobject_cast<const QAbstractButton*>(one))
        lines << button->text();
      else if (const auto* text = qobject_cast<const QTextEdit*>(one))
        lines << text->toPlainText();
      else if (const auto* list = qobject_cast<const QAbstractItemView*>(one))
        lines << rows_of(*list);
    }
    return lines.join('\n');
  }
  [[nodiscard]] testing::AssertionResult reads(const QString& words) {
    if (QTest::qWaitFor([&] { return screen().contains(words); }, patience_ms))
      return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "nowhere on the screen: " << words.toStdString() << "\nthere is:\n"
           << screen().toStdString() << "\n"
           << state_now();
  }

  // -- hands ---------------------------------------------------------------------------

  void press_button(const QString& words) {
    QAbstractButton* found = nullptr;
    (void)comes([&] {
      found = in_sight<QAbstractButton>([&](const QAbstractButton& one) {
        return one.text().remove('&').replace('\n', ' ') == words;
      });
      return found != nullptr;
    });
    ASSERT_NE(found, nullptr) << "no button in sight says " << words.toStdString() << "\n"
                              << screen().toStdString();
    ASSERT_TRUE(found->isEnabled()) << words.toStdString();
    QTest::mouseClick(found, Qt::LeftButton);
  }

  void press_tab(const QString& words) {
    for (auto* bar : window->findChildren<QTabBar*>())
      for (int i = 0; bar->isVisible() && i < bar->count(); ++i)
        if (bar->tabText(i) == words)
          return QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(i).center());
    FAIL() << "no tab says " << words.toStdString();
  }

  void choose_in_menu(const QString& title, const QString& words) {
    auto* bar = window->menuBar();
    for (auto* one : bar->actions())
      if (one->text().remove('&') == title) {
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(one).center());
        return choose_in(*one->menu(), words);
      }
    FAIL() << "no menu is called " << title.toStdString();
  }

  void choose_in(QMenu& menu, const QString& words) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return menu.isVisible(); }, 5000));
    for (auto* one : menu.actions())
      if (one->text().remove('&') == words) {
        ASSERT_TRUE(one->isEnabled()) << words.toStdString();
        return QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(one).center());
      }
    FAIL() << "the menu has no " << words.toStdString();
  }

  void click_row(const QString& words) {
    const auto [list, row] = find_row(words);
    ASSERT_NE(list, nullptr) << "no list has " << words.toStdString() << "\n"
                             << screen().toStdString();
    list->scrollTo(row);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(row).center());
  }

  /// What the right button offers for a row.
  void choose_for_row(const QString& row_words, const QString& words) {
    const auto [list, row] = find_row(row_words);
    ASSERT_NE(list, nullptr) << row_words.toStdString();
    list->scrollTo(row);
    const auto at = list->visualRect(row).center();
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, list->viewport()->mapToGlobal(at));
    QApplication::sendEvent(list->viewport(), &event);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_NE(menu, nullptr);
    choose_in(*menu, words);
  }

  /// The field that stands to the right of these words.
  template <class Field>
  [[nodiscard]] Field* beside(const QString& words) {
    const auto* label = in_sight<QLabel>([&](const QLabel& one) { return one.text() == words; });
    if (!label)
      return nullptr;
    const QRect from(label->mapTo(window.get(), QPoint()), label->size());
    Field* best = nullptr;
    int nearest = window->width();
    for (auto* one : window->findChildren<Field*>()) {
      const QRect to(one->mapTo(window.get(), QPoint()), one->size());
      const int way = to.left() - from.left();
      const bool same_line = to.top() <= from.center().y() && from.center().y() <= to.bottom();
      if (is_in_sight(*one) && same_line && way > 0 && way < nearest) {
        nearest = way;
        best = one;
      }
    }
    return best;
  }

  void type_beside(const QString& words, const QString& typed) {
    QLineEdit* field = nullptr;
    (void)comes([&] { return (field = beside<QLineEdit>(words)) != nullptr; });
    ASSERT_NE(field, nullptr) << "no field stands beside " << words.toStdString() << "\n"
                              << screen().toStdString();
    ASSERT_TRUE(field->isEnabled()) << words.toStdString();
    QTest::mouseDClick(field, Qt::LeftButton);
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, typed);
  }

  void choose_beside(const QString& words, const QString& choice) {
    QComboBox* box = nullptr;
    (void)comes([&] { return (box = beside<QComboBox>(words)) != nullptr; });
    ASSERT_NE(box, nullptr) << "no choice stands beside " << words.toStdString();
    QTest::mouseClick(box, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return box->view()->isVisible(); }, 5000));
    const int row = box->findText(choice, Qt::MatchContains);
    ASSERT_GE(row, 0) << choice.toStdString();
    QTest::keyClick(box->view(), Qt::Key_Home);
    for (int i = 0; i < box->count() && box->view()->currentIndex().row() != row; ++i)
      QTest::keyClick(box->view(), Qt::Key_Down);
    QTest::keyClick(box->view(), Qt::Key_Return);
    EXPECT_EQ(box->currentIndex(), row);
  }

  /// By the list of all commands, where a few letters are enough.
  void find_and_run(const QString& letters) {
    QTest::keyClick(window.get(), Qt::Key_K, Qt::ControlModifier);
    QLineEdit* line = nullptr;
    (void)comes([&] {
      line = in_sight<QLineEdit>([](const QLineEdit& one) {
        return one.placeholderText() == "Search commands and operations";
      });
      return line != nullptr;
    });
    ASSERT_NE(line, nullptr);
    QTest::keyClicks(line, letters);
    QTest::keyClick(line, Qt::Key_Return);
  }

  /// Into the dialog that asks for a file.
  void give_file(const QString& path) {
    auto* dialog = window->findChild<QFileDialog*>();
    ASSERT_TRUE(dialog && dialog->isVisible());
    auto* line = dialog->findChild<QLineEdit*>();
    line->setText(path);  // As it is pasted: what is typed is completed by what is there.
    QTest::keyClick(line, Qt::Key_Return);
    ASSERT_TRUE(wait([&] { return !window->findChild<QFileDialog*>(); }));
    QApplication::setActiveWindow(window.get());  // No window manager does it here.
  }

  /// For who wants to look at what the person sees: into the folder that TEDIT_SHOTS names.
  void look(const QString& what, QWidget* at = nullptr) {
    const QString folder = qEnvironmentVariable("TEDIT_SHOTS");
    if (folder.isEmpty())
      return;
    (void)QTest::qWaitFor([this] { return view().is_settled(); }, 5000);
    QTest::qWait(300);
    QDir().mkpath(folder);
    (at ? at : window.get())
      ->grab()
      .save(QString("%1/%2-%3.png").arg(folder).arg(++looks_, 2, 10, QChar('0')).arg(what));
  }

private:
  /// What a layout still has to place is there a moment later.
  [[nodiscard]] static bool comes(const std::function<bool()>& until) {
    return QTest::qWaitFor(until, 5000);
  }

  template <class Widget>
  [[nodiscard]] Widget* in_sight(const std::function<bool(const Widget&)>& is_meant) const {
    for (auto* one : window->findChildren<Widget*>())
      if (is_in_sight(*one) && is_meant(*one))
        return one;
    return nullptr;
  }

  static QStringList rows_of(const QAbstractItemView& list) {
    QStringList rows;
    walk(list, {}, [&](const QModelIndex& row) {
      rows << row.data().toString();
      return false;
    });
    return rows;
  }

  /// Until it is the one.
  static bool walk(const QAbstractItemView& list, const QModelIndex& below,
                   const std::function<bool(const QModelIndex&)>& is_it) {
    const auto* model = list.model();
    for (int i = 0; i < model->rowCount(below); ++i)
      for (int j = 0; j < model->columnCount(below); ++j) {
        const auto row = model->index(i, j, below);
        if (is_it(row) || (j == 0 && walk(list, row, is_it)))
          return true;
      }
    return false;
  }

  [[nodiscard]] std::pair<QAbstractItemView*, QModelIndex> find_row(const QString& words) {
    for (auto* list : window->findChildren<QAbstractItemView*>()) {
      QModelIndex found;
      if (list->isVisible() && !list->visibleRegion().isEmpty() &&
          walk(*list, {}, [&](const QModelIndex& row) {
            found = row;
            return row.data().toString().contains(words);
          }))
        return {list, found};
    }
    return {nullptr, {}};
  }

  int looks_ = 0;
};

}  // namespace tedit::desktop
