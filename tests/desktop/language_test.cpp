// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/language.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

#include "client-qt/model/legend.hpp"
#include "client-qt/model/operation_words.hpp"
#include "client-qt/tools/operations/preview_box.hpp"

namespace tedit::desktop {
namespace {

class Language : public testing::Test {
protected:
  ~Language() override {
    qDeleteAll(qApp->findChildren<QTranslator*>());
    QLocale::setDefault(before_);
  }

  const QLocale before_;
};

TEST_F(Language, EnglishIsAlwaysThereAndTakenForWhatIsNot) {
  EXPECT_EQ(languages().front(), QString("en"));
  EXPECT_EQ(speak(*qApp, "tlh"), QString("en"));
  EXPECT_EQ(field_title(shown_field::safety_factor), QString("Safety factor"));
}

TEST_F(Language, GermanIsSpokenAlsoOfOperationsThatTheServerDescribes) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";

  EXPECT_EQ(speak(*qApp, "de"), QString("de"));

  EXPECT_EQ(field_title(shown_field::safety_factor), QString("Sicherheitsfaktor"));
  EXPECT_EQ(in_users_language("Fill hole"), "Loch schließen");
  EXPECT_EQ(in_users_language("What a plugin says"), "What a plugin says");
  EXPECT_EQ(field_value(shown_field::von_mises, 3.347e6), QString("3,347 MPa"));
}

TEST_F(Language, FiguresOfAnEditAreInTheWindowsLanguageToo) {
  if (!languages().contains("de"))
    GTEST_SKIP() << "built without qt6-l10n-tools";
  speak(*qApp, "de");
  client::edit_preview made;
  made.report.figures = {{"thickness_change_mm", 0.5, "mm", "thickness taken off"},
                         {"pieces", 3, "", "pieces, of 2 bodies"},
                         {"wobble", 7, "", "wobbles of 2.5 mm"}};

  const QString shown = preview_details(made);

  EXPECT_TRUE(shown.contains("abgetragene Dicke")) << shown.toStdString();
  EXPECT_TRUE(shown.contains("Stücke, aus 2 Körpern")) << shown.toStdString();
  EXPECT_TRUE(shown.contains("wobbles of 2,5 mm")) << "a plugin's own: " << shown.toStdString();
}

}  // namespace
}  // namespace tedit::desktop
