// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/documents/documents_dialog.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

namespace tedit::desktop {
namespace {

class DocumentsDialog : public testing::Test {
protected:
  DocumentsDialog() {
    dialog_.show_documents({{"bracket", 2'500'000, "2020-05-06T07:08:09Z", false, 0, {}, {}},
                            {"plate", 41'000, "2026-11-23T08:45:00Z", true, 3, 2, 1},
                            {"wing", 0, "", true, 1, 0, {}}},
                           "plate");
    const auto note = [this](const QString& what) {
      return [this, what](const QString& name, const QString& to) {
        asked_ << what + " " + name + " " + to;
      };
    };
    QObject::connect(&dialog_, &documents_dialog::copy_wanted, note("copy"));
    QObject::connect(&dialog_, &documents_dialog::rename_wanted, note("rename"));
    QObject::connect(&dialog_, &documents_dialog::delete_wanted,
                     [this](const QString& name) { asked_ << "delete " + name; });
    QObject::connect(&dialog_, &documents_dialog::open_wanted,
                     [this](const QString& name) { asked_ << "open " + name; });
    dialog_.show();
  }

  void choose(int row) { dialog_.list()->setCurrentItem(dialog_.list()->topLevelItem(row)); }
  void press(const char* button) { dialog_.findChild<QPushButton*>(button)->click(); }
  void type(const QString& name) { dialog_.findChild<QLineEdit*>("documents_name")->setText(name); }
  [[nodiscard]] QString text(int row, int column) {
    return dialog_.list()->topLevelItem(row)->text(column);
  }
  [[nodiscard]] QString words(const char* label) {
    const auto* found = dialog_.findChild<QLabel*>(label);
    return found->isVisible() ? found->text() : QString();
  }

  documents_dialog dialog_;
  QStringList asked_;
};

TEST_F(DocumentsDialog, EachHasItsSizeItsLastChangeAndWhoHasItOpenTheLatestFirst) {
  ASSERT_EQ(dialog_.list()->topLevelItemCount(), 3);
  EXPECT_EQ(text(0, 0), "wing");
  EXPECT_EQ(text(0, 1), "holds nothing yet");
  EXPECT_EQ(text(0, 2), "");
  EXPECT_EQ(text(0, 3), "elsewhere (1)");
  EXPECT_EQ(text(1, 0), "plate");
  EXPECT_EQ(text(1, 1), QLocale().formattedDataSize(41'000, 1, QLocale::DataSizeSIFormat));
  EXPECT_EQ(text(1, 3), "here and elsewhere (2)");
  EXPECT_EQ(text(2, 0), "bracket");
  EXPECT_TRUE(text(2, 2).contains("6")) << "5/6/20 or 6.5.20";
  EXPECT_EQ(text(2, 3), "");
}

TEST_F(DocumentsDialog, DeletionIsAskedAboutAndCanBeLeft) {
  choose(2);
  press("documents_delete");
  EXPECT_TRUE(words("documents_question").contains("Delete bracket with all its versions?"));
  press("documents_no");
  EXPECT_EQ(words("documents_question"), "");
  press("documents_delete");
  choose(1);
  EXPECT_EQ(words("documents_question"), "") << "it was not about this one";
  press("documents_yes");
  EXPECT_TRUE(asked_.isEmpty());

  choose(2);
  press("documents_delete");
  press("documents_yes");
  EXPECT_EQ(asked_, QStringList{"delete bracket"});
}

TEST_F(DocumentsDialog, CopiesAndNewNamesAreTypedAndARefusedOneStays) {
  choose(2);
  press("documents_copy");
  type("my  bracket");
  press("documents_yes");
  EXPECT_EQ(asked_, QStringList{"copy bracket my-bracket"});
  press("documents_yes");
  EXPECT_EQ(asked_.size(), 1) << "the server has not answered";
  dialog_.refuse(
    {ec::conflict, "there is a document my-bracket already", "Give this one another name", {}});
  EXPECT_TRUE(words("documents_words").contains("my-bracket"));
  type("bracket-3");
  press("documents_yes");
  EXPECT_EQ(asked_.back(), "copy bracket bracket-3");
  dialog_.settle("done");
  EXPECT_EQ(words("documents_question"), "");
  EXPECT_EQ(words("documents_words"), "done");

  press("documents_rename");
  press("documents_yes");
  EXPECT_EQ(asked_.size(), 2) << "it has that name";
  press("documents_rename");
  type("clamp");
  press("documents_yes");
  EXPECT_EQ(asked_.back(), "rename bracket clamp");
}

TEST_F(DocumentsDialog, SearchLeavesWhatFitsAndAnOpenedOneIsTheChosen) {
  dialog_.findChild<QLineEdit*>("documents_search")->setText("LAT");
  ASSERT_EQ(dialog_.list()->topLevelItemCount(), 1);
  press("documents_open");
  EXPECT_EQ(asked_, QStringList{"open plate"});
  dialog_.findChild<QLineEdit*>("documents_search")->setText("nothing like it");
  EXPECT_FALSE(dialog_.findChild<QPushButton*>("documents_open")->isEnabled());
  EXPECT_FALSE(dialog_.findChild<QPushButton*>("documents_delete")->isEnabled());
}

TEST_F(DocumentsDialog, EscLeavesAQuestionFirst) {
  choose(0);
  press("documents_delete");
  QKeyEvent esc(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
  QApplication::sendEvent(&dialog_, &esc);
  EXPECT_TRUE(dialog_.isVisible());
  EXPECT_EQ(words("documents_question"), "");
  QApplication::sendEvent(&dialog_, &esc);
  EXPECT_FALSE(dialog_.isVisible());
}

}  // namespace
}  // namespace tedit::desktop
