// SPDX-License-Identifier: AGPL-3.0-or-later
// The list of figures, how it is copied and read by keys, and the report's file: no OpenGL.
#include "client-qt/tools/results_summary/results_summary_panel.hpp"

#include <gtest/gtest.h>

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QScrollBar>
#include <QShortcut>
#include <QTemporaryDir>
#include <QTreeWidget>

#include "client-qt/tools/results_summary/report_file.hpp"

namespace tedit::desktop {
namespace {

result_row stress(const QString& value) {
  result_row row;
  row.title = "Largest von Mises stress";
  row.value = {value, "MPa"};
  row.where = "Bore wall";
  row.warning = "Do not trust it.";
  row.at = vec3{1, 2, 3};
  row.compares = true;
  return row;
}

/// Two sections: one row with a place; a reaction with surfaces, a mass with neither, a hint.
results_summary two_sections(const QString& value = "13.4") {
  results_summary result;
  result.state = "Version 2: final";
  result.before = 1;
  result_row reaction;
  reaction.kind = figure::reaction;
  reaction.title = "Reaction: Fixed";
  reaction.value = {"500", "N"};
  reaction.surfaces = {7, 9};
  result_row mass;
  mass.kind = figure::mass;
  mass.title = "Mass";
  mass.value = {"120", "g"};
  mass.compares = true;
  mass.before = shown_quantity{"100", "g"};
  mass.change = "+20 %";
  result.sections = {{"up", "up", {stress(value)}, {}},
                     {"Part", {}, {reaction, mass}, {"No safety factor: give one."}}};
  return result;
}

class ResultsPanel : public testing::Test {
protected:
  ResultsPanel() {
    panel_.resize(900, 300);
    panel_.show();
    QObject::connect(&panel_, &results_summary_panel::row_wanted,
                     [this](const result_row& row, const QString& load_case) {
                       wanted_ << row.title + "/" + load_case;
                     });
  }
  void press(int key) {
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
    QApplication::sendEvent(panel_.tree(), &event);
  }
  template <class T>
  T* find(const char* name) {
    return panel_.findChild<T*>(name);
  }

  results_summary_panel panel_;
  QStringList wanted_;
};

TEST_F(ResultsPanel, WithoutFiguresSaysWhyAndOffersNothingToCopy) {
  results_summary none;
  none.missing = "There are no loads yet.";
  panel_.show_summary(two_sections());
  panel_.show_summary(none);

  EXPECT_TRUE(panel_.tree()->isHidden());
  EXPECT_EQ(panel_.tree()->topLevelItemCount(), 0);
  EXPECT_FALSE(find<QLabel>("results_missing")->isHidden());
  EXPECT_EQ(find<QLabel>("results_missing")->text(), none.missing);
  EXPECT_EQ(find<QLabel>("results_state")->text(), QString());
  EXPECT_FALSE(find<QPushButton>("results_copy")->isEnabled());
  QApplication::clipboard()->setText("before");
  panel_.copy();
  EXPECT_EQ(QApplication::clipboard()->text(), QString("before"));
}

TEST_F(ResultsPanel, ShowsEachRowUnderItsLoadCaseWithWhatItWasBefore) {
  panel_.show_summary(two_sections());

  EXPECT_EQ(find<QLabel>("results_state")->text(), QString("Version 2: final"));
  EXPECT_TRUE(find<QLabel>("results_missing")->isHidden());
  ASSERT_EQ(panel_.tree()->topLevelItemCount(), 2);
  const auto* up = panel_.tree()->topLevelItem(0);
  EXPECT_EQ(up->text(0), QString("up"));
  ASSERT_EQ(up->childCount(), 1);
  const QStringList expected{"Largest von Mises stress",
                             "13.4 MPa",
                             "-",
                             "-",
                             "Bore wall",
                             QString::fromUtf8("⚠ Do not trust it.")};
  for (int i = 0; i < expected.size(); ++i)
    EXPECT_EQ(up->child(0)->text(i), expected[i]) << i;
  const auto* part = panel_.tree()->topLevelItem(1);
  ASSERT_EQ(part->childCount(), 3);
  EXPECT_EQ(part->child(0)->text(2), QString());  // A reaction is not compared.
  EXPECT_EQ(part->child(1)->text(2), QString("100 g"));
  EXPECT_EQ(part->child(1)->text(3), QString("+20 %"));
  EXPECT_EQ(part->child(2)->text(0), QString("No safety factor: give one."));
  EXPECT_EQ(panel_.tree()->headerItem()->text(2), QString("Version 1"));
}

TEST_F(ResultsPanel, HeadsOfFiguresEndWhereTheFiguresDo) {
  panel_.show_summary(two_sections());
  auto* row = panel_.tree()->topLevelItem(0)->child(0);
  for (const int i : {1, 2, 3})
    EXPECT_EQ(panel_.tree()->headerItem()->textAlignment(i), row->textAlignment(i)) << i;
}

TEST_F(ResultsPanel, HasNoColumnsForAVersionBeforeWhenThereIsNone) {
  auto first = two_sections();
  first.before.reset();
  panel_.show_summary(first);

  EXPECT_TRUE(panel_.tree()->isColumnHidden(2));
  EXPECT_TRUE(panel_.tree()->isColumnHidden(3));
  panel_.show_summary(two_sections());
  EXPECT_FALSE(panel_.tree()->isColumnHidden(2));
}

TEST_F(ResultsPanel, PlacesHaveTheRoomThatNotesDoNotNeed) {
  auto some = two_sections();
  auto& row = some.sections[0].rows[0];
  row.where = "where Surface 66 and the wall of the long slot at the side meet";
  const auto where = [&] {  // Its words, and how much of its column they need.
    const QAbstractItemView* list = panel_.tree();
    return panel_.tree()->columnWidth(4) - list->sizeHintForColumn(4);
  };
  panel_.resize(1000, 300);
  row.warning = "short";
  panel_.show_summary(some);
  EXPECT_GE(where(), 0) << "beside a short note";

  row.warning.clear();
  panel_.show_summary(some);
  EXPECT_TRUE(panel_.tree()->isColumnHidden(5)) << "nothing has a note";
  EXPECT_GE(where(), 0);

  row.warning = QString("a very long warning ").repeated(9);
  panel_.show_summary(some);
  EXPECT_FALSE(panel_.tree()->isColumnHidden(5));
  EXPECT_LT(where(), 0);
  EXPECT_GE(panel_.tree()->columnWidth(4), 200) << "it keeps enough to be read";
}

TEST_F(ResultsPanel, WhereThereIsLittleRoomPlaceAndNoteHaveTheSame) {
  auto some = two_sections();
  auto& row = some.sections[0].rows[0];
  row.where = QString("where two surfaces meet ").repeated(5);
  row.warning = QString("a very long warning ").repeated(9);
  for (const int width : {1400, 700}) {
    panel_.resize(width, 300);
    panel_.show_summary(some);
    const int where = panel_.tree()->columnWidth(4);
    EXPECT_GE(panel_.tree()->columnWidth(5), where - 1) << width;
    EXPECT_GE(where, 120) << width;
  }
}

TEST_F(ResultsPanel, APlaceIsWrittenIntoTheRoomOfANoteThatIsNotThere) {
  auto some = two_sections();
  some.sections[0].rows[0].warning.clear();
  some.sections[1].rows[0].note = "along +z";
  const auto ink = [&](const QString& place) {  // In the note's cell of that row.
    some.sections[0].rows[0].where = place;
    panel_.show_summary(some);
    const auto cell = panel_.tree()->model()->index(0, 5, panel_.tree()->model()->index(0, 0));
    const auto drawn = panel_.tree()->viewport()->grab(panel_.tree()->visualRect(cell)).toImage();
    int dark = 0;
    for (int y = 0; y < drawn.height(); ++y)
      for (int x = 0; x < drawn.width(); ++x)
        dark += drawn.pixelColor(x, y).lightness() < 100 ? 1 : 0;
    return dark;
  };
  const QString place = "where Surface 66 and the wall of the long slot at the side meet";
  (void)ink(place);
  const QAbstractItemView* list = panel_.tree();
  for (int width = 1000; panel_.tree()->columnWidth(4) >= list->sizeHintForColumn(4); width -= 10) {
    ASSERT_GT(width, 300) << "the place has its room however narrow the list is";
    panel_.resize(width, 300);
    QApplication::processEvents();
  }

  EXPECT_EQ(ink("here"), 0);
  panel_.resize(panel_.width() - 60, 300);
  QApplication::processEvents();
  EXPECT_GT(ink(place), 10);
  EXPECT_EQ(panel_.tree()->horizontalScrollBar()->maximum(), 0);
}

TEST_F(ResultsPanel, KeysGoFromRowToRowAndEnterGoesToThePlace) {
  panel_.show_summary(two_sections());
  panel_.tree()->setCurrentItem(panel_.tree()->topLevelItem(0));

  press(Qt::Key_Return);  // A heading is no place.
  press(Qt::Key_Down);
  press(Qt::Key_Return);
  press(Qt::Key_Down);
  press(Qt::Key_Down);
  press(Qt::Key_Return);
  press(Qt::Key_Down);
  press(Qt::Key_Return);  // Nor is a mass,
  press(Qt::Key_Down);
  press(Qt::Key_Return);  // nor a hint.

  EXPECT_EQ(wanted_, (QStringList{"Largest von Mises stress/up", "Reaction: Fixed/"}));
}

TEST_F(ResultsPanel, ANewFieldLeavesTheCurrentRowWhereItWas) {
  panel_.show_summary(two_sections());
  panel_.tree()->setCurrentItem(panel_.tree()->topLevelItem(0)->child(0));

  panel_.show_summary(two_sections("20"));

  ASSERT_NE(panel_.tree()->currentItem(), nullptr);
  EXPECT_EQ(panel_.tree()->currentItem()->text(1), QString("20 MPa"));
}

TEST_F(ResultsPanel, IsCopiedAsTextAndAsHtml) {
  panel_.show_summary(two_sections());

  find<QPushButton>("results_copy")->click();

  const auto* data = QApplication::clipboard()->mimeData();
  ASSERT_TRUE(data->hasText());
  ASSERT_TRUE(data->hasHtml());
  EXPECT_TRUE(data->text().contains("up\tLargest von Mises stress\t13.4\tMPa\tBore wall\t"));
  EXPECT_TRUE(data->text().contains("Part\tMass\t120\tg\t\t\t100\tg\t+20 %\n"));
  EXPECT_TRUE(data->html().contains("<td>Mass</td><td>120</td><td>g</td>"));
  EXPECT_EQ(panel_.tree()->findChild<QShortcut*>()->key(), QKeySequence(QKeySequence::Copy));
}

// -- the report's file ---------------------------------------------------------------

class ReportFile : public testing::Test {
protected:
  ReportFile() {
    facts_.title = "bracket";
    facts_.document = "bracket-1";
    facts_.program = "TEdit";
    facts_.when = QDateTime::currentDateTime();
    facts_.figures = two_sections();
    facts_.surface_name = [](surface_id) { return QString("wall"); };
    QImage red(90, 60, QImage::Format_RGB32);
    red.fill(Qt::red);
    report_picture picture{"The part", {}, 90, 60};
    QBuffer buffer(&picture.png);
    buffer.open(QIODevice::WriteOnly);
    red.save(&buffer, "PNG");
    facts_.pictures = {picture};
  }
  [[nodiscard]] QString path(const char* name) const { return folder_.filePath(name); }
  static QByteArray content(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  QTemporaryDir folder_;
  report_facts facts_;
};

TEST_F(ReportFile, AWebPageHasItsPicturesInside) {
  ASSERT_TRUE(write_report_file(facts_, path("a.HTML")));

  const QByteArray html = content(path("a.HTML"));
  EXPECT_TRUE(html.contains("13.4&nbsp;MPa"));
  EXPECT_TRUE(html.contains("data:image/png;base64," + facts_.pictures[0].png.toBase64()));
}

TEST_F(ReportFile, APdfHasPagesAndThePicture) {
  ASSERT_TRUE(write_report_file(facts_, path("short.pdf")));
  const auto pages = [](const QByteArray& pdf) { return pdf.count("/Type /Page\n"); };
  const QByteArray without_rows = content(path("short.pdf"));
  EXPECT_TRUE(without_rows.startsWith("%PDF-"));
  EXPECT_TRUE(without_rows.contains("/Subtype /Image"));
  EXPECT_EQ(pages(without_rows), 1);

  for (int i = 0; i < 60; ++i)
    facts_.figures.sections.push_back(facts_.figures.sections.front());
  ASSERT_TRUE(write_report_file(facts_, path("long.pdf")));
  EXPECT_GT(pages(content(path("long.pdf"))), 2);
}

TEST_F(ReportFile, AnotherSuffixOrAFolderThatIsNotThereIsRefusedWithTheRemedy) {
  const auto other = write_report_file(facts_, path("a.docx"));
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, ec::invalid_argument);
  EXPECT_NE(other.error().remedy.find(".pdf"), std::string::npos);
  EXPECT_FALSE(QFile::exists(path("a.docx")));

  const auto nowhere = write_report_file(facts_, path("no/such/folder/a.pdf"));
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, ec::io_error);
}

}  // namespace
}  // namespace tedit::desktop
