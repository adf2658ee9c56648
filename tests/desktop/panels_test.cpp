// SPDX-License-Identifier: AGPL-3.0-or-later
// The history with its names, the jobs and the help: widgets that need no OpenGL.
#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBlock>

#include "client-qt/model/catalogue.hpp"
#include "client-qt/tools/help/help_panel.hpp"
#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/history/version_editor.hpp"
#include "client-qt/tools/jobs/jobs_panel.hpp"
#include "client-qt/tools/operations/preview_box.hpp"
#include "client-qt/tools/receipt/receipt_panel.hpp"
#include "client-qt/widgets/truth_line.hpp"

namespace tedit::desktop {
namespace {

void press(QWidget* where, int key, Qt::KeyboardModifiers with = Qt::NoModifier) {
  QKeyEvent event(QEvent::KeyPress, key, with);
  QApplication::sendEvent(where, &event);
}

client::version_info version(std::uint32_t number, std::optional<std::uint32_t> parent) {
  client::version_info info;
  info.number = number;
  info.version_id = "v" + std::to_string(number);
  info.parent = parent;
  info.operation = number == 0 ? "import" : "fill_hole";
  return info;
}

// -- the history ---------------------------------------------------------------------

class History : public testing::Test {
protected:
  History() {
    part_.begin("part");
    // 0 - 1 - 2 and a branch 3 of 0, which is the head.
    for (const auto& [number, parent] :
         std::vector<std::pair<std::uint32_t, std::optional<std::uint32_t>>>{
           {0, {}}, {1, 0}, {2, 1}, {3, 0}}) {
      client::committed made;
      made.head = version(number, parent);
      emit link_.committed(made);
    }
    strip_.resize(900, 500);
    strip_.show();
    emit part_.history_changed();
    QCoreApplication::processEvents();
  }

  [[nodiscard]] QRect place(int number) {
    for (int i = 0; i < strip_.count(); ++i)
      if (strip_.item(i)->data(Qt::UserRole).toInt() == number)
        return strip_.visualItemRect(strip_.item(i));
    return {};
  }
  [[nodiscard]] int chosen() const { return strip_.currentItem()->data(Qt::UserRole).toInt(); }

  remote link_;
  document part_{link_};
  history_strip strip_{part_};
};

TEST_F(History, EditsGoToTheRightAndABranchStandsBelow) {
  ASSERT_EQ(strip_.count(), 4);
  EXPECT_GT(place(1).left(), place(0).right());
  EXPECT_GT(place(2).left(), place(1).right());
  EXPECT_EQ(place(1).top(), place(0).top());
  EXPECT_EQ(place(3).left(), place(1).left());
  EXPECT_GT(place(3).top(), place(1).bottom());
}

TEST_F(History, NamesAndNotesAreReadInATreeWithBranches) {
  auto named = version(3, 0);
  named.name = "thin ribs";
  named.note = "too weak at the bore\nsee the report";
  emit link_.annotated(named);
  QCoreApplication::processEvents();

  ASSERT_EQ(strip_.count(), 4);
  for (int i = 0; i < strip_.count(); ++i) {
    if (strip_.item(i)->data(Qt::UserRole).toInt() != 3)
      continue;
    const QString text = strip_.item(i)->text();
    EXPECT_TRUE(text.contains("thin ribs")) << text.toStdString();
    EXPECT_TRUE(text.contains("too weak")) << text.toStdString();
    const QRect words = strip_.visualItemRect(strip_.item(i)).adjusted(90, 0, 0, 0);
    const QFontMetrics metrics(strip_.item(i)->font());
    for (const auto& line : text.split('\n'))
      EXPECT_LE(metrics.horizontalAdvance(line), words.width()) << line.toStdString();
    EXPECT_GE(words.height(), 3 * metrics.height());
  }
}

TEST_F(History, KeysGoFromPlaceToPlaceAndEnterGoesToTheVersion) {
  QList<quint32> wanted;
  const QObject here;  // Nobody listens when this test is over.
  QObject::connect(&strip_, &history_strip::version_wanted, &here,
                   [&](quint32 number) { wanted << number; });
  EXPECT_EQ(chosen(), 3);  // The head.

  press(&strip_, Qt::Key_Up);
  EXPECT_EQ(chosen(), 1);
  press(&strip_, Qt::Key_Right);
  EXPECT_EQ(chosen(), 2);
  press(&strip_, Qt::Key_Return);

  EXPECT_EQ(wanted, (QList<quint32>{2}));
}

TEST_F(History, ANameFromAnyClientStandsInThePlaceOfTheOperation) {
  auto named = version(1, 0);
  named.name = "thin fin";
  named.note = "first line\nsecond line";
  emit link_.annotated(named);
  QCoreApplication::processEvents();

  const auto* row = strip_.findItems("v1", Qt::MatchStartsWith).value(0);
  ASSERT_NE(row, nullptr);
  EXPECT_TRUE(row->text().startsWith("v1  thin fin")) << row->text().toStdString();
  EXPECT_TRUE(row->toolTip().contains("first line\nsecond line"));
  EXPECT_EQ(chosen(), 3);  // What was chosen stays so.
}

// -- names and notes -----------------------------------------------------------------

class Words : public testing::Test {
protected:
  Words() {
    auto info = version(4, 3);
    info.name = "old";
    info.note = "note";
    editor_ = new version_editor(info);  // Deletes itself.
    QObject::connect(editor_, &version_editor::accepted,
                     [this](std::uint32_t number, const QString& name, const QString& note) {
                       told_ << QString::number(number) + "|" + name + "|" + note;
                     });
    editor_->open_beside(QRect(0, 0, 10, 10));
    name_ = editor_->findChild<QLineEdit*>("version_name");
    note_ = editor_->findChild<QPlainTextEdit*>("version_note");
  }
  ~Words() override { QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); }

  QPointer<version_editor> editor_;
  QLineEdit* name_;
  QPlainTextEdit* note_;
  QStringList told_;
};

TEST_F(Words, EnterInTheNameKeepsBoth) {
  name_->setText("  new   name ");
  note_->setPlainText("two\nlines\n");
  press(name_, Qt::Key_Return);

  EXPECT_EQ(told_, (QStringList{"4|new name|two\nlines"}));
}

TEST_F(Words, AClickElsewhereKeepsThemToo) {
  note_->setPlainText("");
  editor_->close();

  EXPECT_EQ(told_, (QStringList{"4|old|"}));
}

TEST_F(Words, EscDropsAndTheSameWordsAreNoChange) {
  name_->setText("new");
  press(name_, Qt::Key_Escape);
  EXPECT_TRUE(told_.isEmpty());
}

TEST_F(Words, TheSameWordsAreNoChange) {
  press(note_, Qt::Key_Return, Qt::ControlModifier);
  EXPECT_TRUE(told_.isEmpty());
}

// -- jobs ----------------------------------------------------------------------------

// -- what an edit did ----------------------------------------------------------------

TEST(Receipt, SaysNoQualityWhereNoTetWasTouched) {
  client::edit_preview made;
  for (const auto& html : {receipt_html(made.report), preview_figures(made)})
    EXPECT_FALSE(html.contains("Worst tet here")) << html.toStdString();

  made.report.ratios = {0.5, 0.25, 0.75};

  EXPECT_TRUE(receipt_html(made.report).contains("0.5 before, 0.25 now"));
  EXPECT_TRUE(preview_figures(made).contains("0.5 before, 0.25 then"));
}

TEST(Receipt, TheVolumeIsThatOfTheChange) {
  client::edit_preview made;
  made.report.volume_change = 2.5e-6;
  for (const auto& html : {receipt_html(made.report), preview_figures(made)})
    EXPECT_TRUE(html.contains("+2500 mm³")) << html.toStdString();
}

TEST(Receipt, CountsNothingThatIsNotThereAndHasAProperMinus) {
  client::edit_preview made;
  made.report.figures = {{"hinges", 0, "", "hinges repaired"},
                         {"share", -0.0181, "%", "of the part's volume"},
                         {"off_mm", 0, "mm", "thickness taken off"}};
  for (const auto& html : {receipt_html(made.report), preview_details(made)}) {
    EXPECT_FALSE(html.contains("inges")) << html.toStdString();
    EXPECT_TRUE(html.contains("−0.0181 %")) << html.toStdString();
    EXPECT_TRUE(html.contains("0 mm")) << html.toStdString();
  }
}

TEST(Receipt, ShowsWhatShouldBeLookedAtInBold) {
  client::edit_preview made;
  fem::receipt_line line;
  line.fate = fem::receipt_fate::moved;
  line.text = "moved";
  line.warning = "it grew";
  made.report.receipt = {line};

  EXPECT_TRUE(receipt_html(made.report).contains("<b>it grew</b>"));
  EXPECT_TRUE(preview_details(made).contains("<b>it grew</b>"));
}

/// What stands in the window's middle must not hang on when a widget of the line was measured.
TEST(TruthLine, HasOneHeightWhateverIsPutIntoIt) {
  remote link;
  document part(link);
  truth_line line(part, link);
  const int height = line.minimumHeight();
  ASSERT_EQ(line.maximumHeight(), height);

  auto* large = new QWidget;
  large->setMinimumHeight(3 * height);
  line.add(large);
  large->show();
  line.adjustSize();

  EXPECT_EQ(line.height(), height);
  EXPECT_GE(height, QFontMetrics(line.font()).height());
}

/// The line at the window's foot, after a solve with such a load.
TEST(TruthLine, SaysThatTheLoadsWantALook) {
  remote link;
  document part(link);
  part.begin("part");
  truth_line line(part, link);
  client::committed made;
  made.head = version(0, {});
  emit link.committed(made);
  solve_report report;
  report.version_id = made.head.version_id;
  client::field_event field;
  field.report = report;

  const auto after = [&](const std::vector<std::string>& warnings) {
    field.report.warnings = warnings;
    emit link.field_arrived(std::make_shared<const client::field_event>(field));
    emit link.solved(solve_outcome{{field.report}, {}});
    return line.text().toStdString();
  };

  EXPECT_EQ(after({}).find("check the loads"), std::string::npos);
  EXPECT_NE(after({"it grew"}).find("check the loads"), std::string::npos);
}

TEST(JobsPanel, SaysWhatRunsAndCancelsOneOfThem) {
  remote link;
  jobs work;
  int cancelled = 0;
  const int edit = work.begin("Fill hole", [&] { ++cancelled; });
  work.begin("Solve", nullptr);
  work.progress(edit, 0.5, "removing");
  jobs_panel panel(work, link);

  EXPECT_TRUE(panel.text().contains("Fill hole"));
  EXPECT_TRUE(panel.text().contains("removing"));
  EXPECT_TRUE(panel.text().contains("Solve"));
  EXPECT_TRUE(panel.text().contains("not connected"));
  QPushButton* offered = nullptr;
  for (auto* button : panel.findChildren<QPushButton*>("job_cancel"))
    if (!button->isHidden()) {
      EXPECT_EQ(offered, nullptr);  // The other cannot be cancelled.
      offered = button;
    }
  ASSERT_NE(offered, nullptr);
  work.progress(edit, 0.6, "checking");
  EXPECT_TRUE(panel.text().contains("checking"));
  offered->click();  // The same button as before the progress.
  EXPECT_EQ(cancelled, 1);
  work.end(edit);
  EXPECT_FALSE(panel.text().contains("Fill hole"));
}

TEST(JobsPanel, WhatTheServerDoesForOthersIsNotCalledNothing) {
  client::server_status server;
  EXPECT_EQ(nothing_words(server), "Nothing runs.");
  server.workers.emplace_back();
  EXPECT_EQ(nothing_words(server), "Nothing runs.");

  server.workers.back().jobs = 1;

  EXPECT_EQ(nothing_words(server), "Nothing of yours runs.");
}

TEST(JobsPanel, ASolveThatGoesOnForADocumentThatWasLeftIsNamed) {
  remote link;
  document part(link);
  part.begin("plate_20260102_030405");
  part.solver().set_progress(field_state::solving);

  part.begin("other");

  EXPECT_TRUE(part.work().all().empty());
  client::server_status server;
  server.workers.push_back({"solver", "ready", 1, 0, 1, {}});
  const auto said = nothing_words(server, part.work().left());
  EXPECT_TRUE(said.startsWith("The server still solves plate")) << said.toStdString();
  server.workers.back().jobs = 0;
  EXPECT_EQ(nothing_words(server, part.work().left()), "Nothing runs.");
}

TEST(JobsButton, IsIdleWhenNothingRuns) {
  remote link;
  jobs work;
  const jobs_button button(work, link);

  EXPECT_EQ(button.text(), "idle");
  const int one = work.begin("Solve", nullptr);
  EXPECT_TRUE(button.text().startsWith("Solve"));
  work.end(one);
  EXPECT_EQ(button.text(), "idle");
}

// -- help ----------------------------------------------------------------------------

TEST(HelpPanel, ShowsThePageAndTheHeadingThatIsAskedFor) {
  help_panel help;
  help.resize(320, 400);
  help.show();

  // A plugin's operation is told of as a shipped one is.
  operation_catalogue all;
  for (const auto* name : {"Fill hole", "Erode", "Lift by a plugin"}) {
    ops::operation_description about;
    about.name = name;
    about.summary = "What it does.";
    about.guide = std::string(2000, 'x') + " When to use it.";
    about.parameters = {{"depth", "Depth", "How deep."}};
    all.operations.push_back({about, "plug 1.0.0"});
  }
  help.set_operations(manual_page_of(translated(all)));
  help.show_page("operations", "Lift by a plugin");

  EXPECT_EQ(help.shown(), QString("operations"));
  EXPECT_EQ(help.page()->textCursor().block().text(), QString("Lift by a plugin"));
  EXPECT_TRUE(help.page()->toPlainText().contains("When to use it."));
  EXPECT_TRUE(help.page()->toPlainText().contains("Depth: How deep."));
  EXPECT_GT(help.page()->verticalScrollBar()->value(), 0);
  help.show_page("results");
  EXPECT_EQ(help.page()->textCursor().position(), 0);
  help.show_page("no such page");
  EXPECT_EQ(help.shown(), QString("results"));
}

TEST(Help, IsTheManualAndFindsWords) {
  help_panel help;
  EXPECT_TRUE(help.page()->toPlainText().contains("Shift adds"));
  EXPECT_FALSE(help.page()->toPlainText().contains("|---|"));  // Tables are tables.

  help.search("undo");
  const int all = help.hits();
  EXPECT_GT(all, 1);
  EXPECT_EQ(help.page()->extraSelections().size(), all);
  const int first = help.page()->textCursor().position();
  help.step(false);
  EXPECT_GT(help.page()->textCursor().position(), first);
  help.step(true);
  EXPECT_EQ(help.page()->textCursor().position(), first);

  help.search("no such word in it");
  EXPECT_EQ(help.hits(), 0);
  EXPECT_TRUE(help.page()->extraSelections().isEmpty());
}

}  // namespace
}  // namespace tedit::desktop
