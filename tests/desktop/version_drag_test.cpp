// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QDropEvent>
#include <QListWidget>
#include <QMimeData>
#include <QMouseEvent>

#include "client-qt/tools/compare/compare_view.hpp"

namespace tedit::desktop {
namespace {

class VersionDrag : public testing::Test {
protected:
  VersionDrag() {
    for (const int number : {4, 7}) {
      auto* row = new QListWidgetItem(QString("v%1").arg(number), &list_);
      row->setData(Qt::UserRole, number);
    }
    list_.resize(200, 200);
    list_.show();
    QObject::connect(&drag_, &version_drag::dropped,
                     [this](quint32 dragged, quint32 onto) { drops_ << dragged << onto; });
  }

  [[nodiscard]] QPointF middle(int row) const {
    return list_.visualItemRect(list_.item(row)).center();
  }

  void press(int row) {
    QMouseEvent event(QEvent::MouseButtonPress, middle(row),
                      list_.viewport()->mapToGlobal(middle(row)), Qt::LeftButton, Qt::LeftButton,
                      Qt::NoModifier);
    QApplication::sendEvent(list_.viewport(), &event);
  }

  void drop(int row, const QMimeData& data) {
    // Qt drops where a drag was let in.
    QDragEnterEvent enter(middle(row).toPoint(), Qt::CopyAction, &data, Qt::LeftButton,
                          Qt::NoModifier);
    QApplication::sendEvent(list_.viewport(), &enter);
    QDropEvent event(middle(row), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(list_.viewport(), &event);
  }

  QListWidget list_;
  version_drag drag_{list_};
  QList<quint32> drops_;
};

TEST_F(VersionDrag, TellsWhichVersionWasDroppedOntoWhich) {
  QMimeData row;
  row.setData("application/x-qabstractitemmodeldatalist", "x");

  press(0);
  drop(1, row);

  EXPECT_EQ(drops_, (QList<quint32>{4, 7}));
  EXPECT_EQ(list_.count(), 2);  // Nothing was copied.
}

TEST_F(VersionDrag, DropsOntoItselfAndFilesAreNone) {
  QMimeData row;
  row.setData("application/x-qabstractitemmodeldatalist", "x");
  QMimeData file;
  file.setUrls({QUrl("file:///part.msh")});

  press(0);
  drop(0, row);
  drop(1, file);
  EXPECT_TRUE(drops_.isEmpty());

  drop(1, row);  // The same way, but onto another one.
  EXPECT_EQ(drops_.size(), 2);
}

}  // namespace
}  // namespace tedit::desktop
