// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/recent_documents.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>

namespace tedit::desktop {
namespace {

class Recent : public testing::Test {
protected:
  Recent() {
    QImage red(10, 10, QImage::Format_RGB32);
    red.fill(Qt::red);
    recent_.show_documents({{"plate-20260301-101500", QDateTime::currentDateTime(), red},
                            {"heatsink", {}, {}},
                            {"bracket", QDateTime(QDate(2020, 5, 6), QTime(7, 8)), {}}});
    QObject::connect(&recent_, &recent_documents::changed,
                     [this](const QStringList& names) { told_ << names.join(" "); });
    QObject::connect(&recent_, &recent_documents::document_wanted,
                     [this](const QString& name) { opened_ << name; });
    recent_.resize(700, 300);
    recent_.show();
  }

  void press(int key, Qt::KeyboardModifiers with = Qt::NoModifier) {
    QKeyEvent event(QEvent::KeyPress, key, with);
    QApplication::sendEvent(recent_.list(), &event);
  }
  [[nodiscard]] QPushButton* undo() { return recent_.findChild<QPushButton*>("recent_undo"); }

  recent_documents recent_;
  QStringList told_;
  QStringList opened_;
};

TEST_F(Recent, EachHasItsPictureItsNameAndWhenItWasUsed) {
  ASSERT_EQ(recent_.list()->count(), 3);
  auto* plate = recent_.list()->item(0);
  EXPECT_TRUE(plate->text().startsWith("plate\ntoday, ")) << plate->text().toStdString();
  const QImage shown = plate->icon().pixmap(132, 84).toImage();
  EXPECT_EQ(shown.pixelColor(shown.rect().center()), QColor(Qt::red));
  EXPECT_EQ(recent_.list()->item(1)->text(), "heatsink");
  EXPECT_TRUE(recent_.list()->item(2)->text().contains("6")) << "5/6/20 or 6.5.20";
}

TEST_F(Recent, DeleteTakesOneAwayAndUndoBringsItBackWhereItWas) {
  recent_.list()->setCurrentRow(1);
  press(Qt::Key_Delete);
  EXPECT_EQ(told_, QStringList{"plate-20260301-101500 bracket"});
  EXPECT_TRUE(undo()->isVisible());

  undo()->click();
  EXPECT_EQ(told_.last(), "plate-20260301-101500 heatsink bracket");
  EXPECT_FALSE(undo()->isVisible());

  press(Qt::Key_Delete);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(recent_.names().size(), 3);
  EXPECT_TRUE(opened_.isEmpty());
}

TEST_F(Recent, TheLastOneLeavesItsUndo) {
  recent_.list()->setCurrentRow(0);
  for (int i = 0; i < 3; ++i)
    press(Qt::Key_Delete);
  EXPECT_TRUE(recent_.names().isEmpty());
  EXPECT_TRUE(recent_.isVisible());
  undo()->click();
  EXPECT_EQ(recent_.names().size(), 1);
}

TEST_F(Recent, TheMenuOpensAndTakesAway) {
  const auto choose = [&](int row, int action) {
    const QPoint at = recent_.list()->visualItemRect(recent_.list()->item(row)).center();
    emit recent_.list()->customContextMenuRequested(at);
    auto* menu = recent_.findChild<QMenu*>();
    ASSERT_NE(menu, nullptr);
    menu->actions().at(action)->trigger();
    delete menu;
  };
  choose(2, 0);
  EXPECT_EQ(opened_, QStringList{"bracket"});
  choose(0, 1);
  EXPECT_EQ(recent_.names(), (QStringList{"heatsink", "bracket"}));
  recent_.list()->setCurrentRow(0);
  press(Qt::Key_Return);
  EXPECT_EQ(opened_.last(), "heatsink");
}

}  // namespace
}  // namespace tedit::desktop
