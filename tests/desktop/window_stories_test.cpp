// SPDX-License-Identifier: AGPL-3.0-or-later
// The stories of the start page, done as they are written: by the words on cards and buttons.
#include "tests/desktop/window_fixture.hpp"

#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>

namespace tedit::desktop {
namespace {

class StartPageStory : public Window {
protected:
  /// Opens the part of the card that begins so, and gives the card's story.
  QString open_card(const QString& title) {
    for (auto* card : window->findChildren<QPushButton*>())
      if (card->isVisible() && card->accessibleName().startsWith(title)) {
        QString story;
        for (const auto* words : card->findChildren<QLabel*>())
          story += words->text() + "\n";
        QTest::mouseClick(card, Qt::LeftButton);
        EXPECT_TRUE(wait([&] { return is_final() && !part().operations().operations.empty(); }));
        return story;
      }
    ADD_FAILURE() << "no card says " << title.toStdString();
    return {};
  }

  /// Presses the tool with these words at the left, waits for the preview and applies it.
  void choose_and_apply(const QString& words) {
    QToolButton* tool = nullptr;
    for (auto* one : window->findChildren<QToolButton*>())
      if (one->isVisible() && one->text() == words)
        tool = one;
    ASSERT_NE(tool, nullptr) << words.toStdString();
    QTest::mouseClick(tool, Qt::LeftButton);
    const auto& preview = window->tools().operations.panel().preview();
    ASSERT_TRUE(wait([&] { return preview.shown() || preview.refusal(); }));
    ASSERT_FALSE(preview.refusal()) << render(*preview.refusal());
    press("apply");
    ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
    EXPECT_EQ(window->context().messages.text(), "");
  }

  /// One surface after the other, until the selection panel says that it is a bore.
  void click_a_bore() {
    for (const auto& [id, row] : part().head()->surface->surfaces()) {
      if (!view().visible_point(id))
        continue;
      window->context().picked.clear();
      click_surface(id);
      ASSERT_TRUE(wait([&] { return window->context().link.running() == 0; }));  // What it is.
      if (picked_words().contains("bore", Qt::CaseInsensitive))
        return;
    }
    FAIL() << "no surface is called a bore; the last: " << picked_words().toStdString();
  }

  [[nodiscard]] double displacement() {
    return part().head()->outcome->cases.front().max_displacement_m;
  }
  [[nodiscard]] QString picked_words() {
    return window->findChild<QLabel*>("selection_title")->text();
  }
  /// The largest visible surface among these, which a person would take.
  [[nodiscard]] std::optional<surface_id> largest_seen(const std::function<bool(surface_id)>& of) {
    std::optional<surface_id> best;
    double most = 0;
    for (const auto& [id, row] : part().head()->surface->surfaces())
      if (of(id) && row.area_m2 > most && view().visible_point(id)) {
        best = id;
        most = row.area_m2;
      }
    return best;
  }
};

TEST_F(StartPageStory, TheHeatSinksFinGetsSofterAndKeepsItsLoad) {
  const auto story = open_card("Heat sink");
  ASSERT_TRUE(story.contains("Click that fin, choose \"Erode\"")) << story.toStdString();
  const auto load = part().loads().all().front().loads.front();
  const auto pushed = load.surfaces;
  const auto fin = largest_seen([&](surface_id id) { return std::ranges::count(pushed, id) > 0; });
  ASSERT_TRUE(fin);
  const double before = displacement();

  click_surface(*fin);
  choose_and_apply("Erode");

  EXPECT_GT(displacement(), 1.5 * before);
  EXPECT_LT(displacement(), 6 * before);
  EXPECT_EQ(part().loads().all().front().loads.front().surfaces, pushed);
}

TEST_F(StartPageStory, TheBracketsWallGetsStiffer) {
  const auto story = open_card("Printed bracket");
  ASSERT_TRUE(story.contains("Look at principal stress 1")) << story.toStdString();
  ASSERT_TRUE(story.contains("Thicken the wall there")) << story.toStdString();
  auto* fields = window->findChild<QComboBox*>("field");
  const int place = fields ? fields->findText("principal stress 1", Qt::MatchContains) : -1;
  ASSERT_GE(place, 0);
  fields->setCurrentIndex(place);
  ASSERT_TRUE(wait([&] { return is_final() && view().painted().extremes.has_value(); }));
  const double before = displacement();
  const auto wall = largest_seen([](surface_id) { return true; });
  ASSERT_TRUE(wall);

  click_surface(*wall);
  choose_and_apply("Thicken");

  EXPECT_LT(displacement(), before);
  EXPECT_GT(displacement(), before / 3);
}

TEST_F(StartPageStory, TheTestPlatesBoreIsClosed) {
  const auto story = open_card("Test plate");
  ASSERT_TRUE(story.contains("Click a bore, choose \"Fill hole\"")) << story.toStdString();
  const double before = part().head()->outcome->cases.front().max_von_mises_pa;
  click_a_bore();

  choose_and_apply("Fill hole");

  const double after = part().head()->outcome->cases.front().max_von_mises_pa;
  EXPECT_GT(after, 0.3 * before);
  EXPECT_LT(after, 3 * before);
  EXPECT_GT(part().head()->report->volume_change, 0);
}

/// "At the desk" of the README's beginnings: the first five minutes.
class FirstFiveMinutes : public StartPageStory {
protected:
  static QString readme() {
    QFile file(TEDIT_EXAMPLES "/../README.md");
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return QString::fromUtf8(file.readAll()).simplified();
  }
  void key(Qt::Key what, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(window.get(), what, modifiers);
  }
  /// What the palette offers for these letters.
  [[nodiscard]] QString found_by_palette(const QString& letters) {
    key(Qt::Key_K, Qt::ControlModifier);
    auto* line = window->findChild<QLineEdit*>("palette_letters");
    EXPECT_TRUE(line && line->isVisible());
    QTest::keyClicks(line, letters);
    const auto* hits = window->findChild<QListWidget*>("palette_hits");
    const QString first = hits->count() > 0 ? hits->item(0)->text() : QString();
    QTest::keyClick(line, Qt::Key_Escape);
    return first;
  }
};

TEST_F(FirstFiveMinutes, AreDoneAsTheyAreWritten) {
  const auto text = readme();
  for (const auto* words :
       {"click the shipped plate; click a bore: it is picked whole; choose *Fill hole*, *Apply*",
        "The field follows by itself", "Ctrl+K finds every command and operation",
        "the line at the bottom says what the picture is worth", "Ctrl+Z takes a step back",
        "*Results* (R) says how strong the part is, *Report* (Ctrl+Shift+R) writes it down"})
    ASSERT_TRUE(text.contains(words)) << words;

  (void)open_card("Test plate");
  click_a_bore();
  EXPECT_GT(window->context().picked.surfaces().size(), 1U);
  choose_and_apply("Fill hole");
  EXPECT_TRUE(found_by_palette("thicken").contains("Thicken"));
  EXPECT_TRUE(found_by_palette("section").contains("section", Qt::CaseInsensitive));
  EXPECT_TRUE(window->findChild<QLabel*>("verdict")->text().contains("final"));

  key(Qt::Key_Escape);
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait([&] { return version() == 0 && is_final(); }));
  key(Qt::Key_R);
  auto* rows = window->findChild<QTreeWidget*>("results_list");
  ASSERT_NE(rows, nullptr);
  ASSERT_TRUE(wait([&] { return rows->isVisible() && rows->topLevelItemCount() > 0; }));

  key(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  auto* dialog = window->findChild<QFileDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  const QString path = state.filePath("report.pdf");
  dialog->findChild<QLineEdit*>()->setText(path);
  QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
  ASSERT_TRUE(wait([&] { return QFileInfo(path).size() > 20'000; }));
}

}  // namespace
}  // namespace tedit::desktop
