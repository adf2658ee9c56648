// SPDX-License-Identifier: AGPL-3.0-or-later
// What is said over the view, and what is painted there: nothing covers what matters more.
#include "client-qt/widgets/banner.hpp"

#include <QCheckBox>
#include <QFontMetrics>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

#include <gtest/gtest.h>

#include "client-qt/view/overlay.hpp"
#include "client-qt/widgets/theme.hpp"

namespace tedit::desktop {
namespace {

class Banner : public ::testing::Test {
protected:
  QWidget window;
  banner message{&window};
  const error refused{ec::invalid_argument, "no such hole", "choose a wall", "surface 7"};

  void close() { message.findChild<QPushButton*>("close")->click(); }
  [[nodiscard]] QStringList lines() const { return message.text().split('\n'); }
};

TEST_F(Banner, AnErrorBesideALostConnectionLeavesItsWords) {
  message.show_standing("The connection is lost.");
  message.show_error("Fill hole", refused);

  EXPECT_EQ(lines()[0], "The connection is lost.");
  EXPECT_EQ(lines()[1], "Fill hole did not work");

  message.clear_standing();
  EXPECT_EQ(lines()[0], "Fill hole did not work");
  close();
  EXPECT_TRUE(message.text().isEmpty());
}

TEST_F(Banner, ALostConnectionLeavesAnErrorThatWasNotClosed) {
  message.show_error("Fill hole", refused);
  message.show_standing("The connection is lost.");

  EXPECT_EQ(lines()[0], "The connection is lost.");
  EXPECT_EQ(lines()[1], "Fill hole did not work");

  close();
  EXPECT_EQ(message.text(), "The connection is lost.");
  message.clear_standing();
  EXPECT_TRUE(message.isHidden());
}

TEST_F(Banner, AWarningLooksLikeOneAndLeavesAnErrorInPlace) {
  const auto look = make_theme(false);
  message.set_theme(look);
  message.show_warning("3 tets have zero volume");
  EXPECT_EQ(message.text(), "3 tets have zero volume");
  EXPECT_TRUE(message.styleSheet().contains(look.warning.name()));

  message.show_error("Solve", refused);
  message.show_warning("3 tets have zero volume");
  EXPECT_EQ(lines()[0], "Solve did not work");
}

TEST_F(Banner, NewsGivesWayToAllElse) {
  message.show_news("Version 2 is there.");
  message.show_standing("The connection is lost.");
  EXPECT_EQ(message.text(), "The connection is lost.");

  message.show_news("Version 3 is there.");
  EXPECT_EQ(message.text(), "The connection is lost.");

  message.clear_standing();
  message.show_error("Fill hole", refused);
  message.show_news("Version 3 is there.");
  EXPECT_EQ(lines()[0], "Fill hole did not work");
}

TEST_F(Banner, SaysWhenItNeedsOtherRoom) {
  int changes = 0;
  QObject::connect(&message, &banner::changed, &window, [&changes] { ++changes; });
  message.show_standing("The connection is lost.");
  EXPECT_EQ(changes, 1);
  message.show_error("Fill hole", refused);
  EXPECT_EQ(changes, 2);
  close();
  EXPECT_EQ(changes, 3);
}

TEST_F(Banner, AWordThatNoLineTakesIsElidedInItsMiddleAndNothingElseIs) {
  const QFontMetrics by = message.fontMetrics();
  const QString file = QString("ctc01_plate").repeated(9) + ".tedit";
  const QString words = "This is version 1 of /home/" + file + ", and it is safe.";
  const int width = by.horizontalAdvance(file) / 2;

  const auto shown = fitted(words, by, width);

  EXPECT_TRUE(shown.startsWith("This is version 1 of /home/ctc01")) << shown.toStdString();
  EXPECT_TRUE(shown.contains(QChar(0x2026)));
  EXPECT_TRUE(shown.endsWith("tedit, and it is safe.")) << shown.toStdString();
  EXPECT_EQ(fitted(words, by, 2 * by.horizontalAdvance(file)), words);
}

TEST_F(Banner, SaysAllOfALongNameToWhoAsks) {
  const QString words = "Wrote " + QString("x").repeated(400);
  message.resize(300, 100);
  message.show_news(words);

  EXPECT_EQ(message.text(), words);
  const auto labels = message.findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(
    labels, [&](const QLabel* one) { return one->toolTip() == words && one->text() != words; }));
}

TEST(Overlay, AMarkDoesNotCoverTheLegendWhereThereIsRoomBesideIt) {
  const QRectF legend(8, 100, 140, 200);
  const QRectF mark(100, 120, 150, 20);

  EXPECT_EQ(right_of(legend, mark, 4, 310), QRectF(152, 120, 150, 20));
  EXPECT_EQ(right_of(legend, mark, 4, 300), mark);  // It would leave the view.
  EXPECT_EQ(right_of(legend, QRectF(100, 310, 150, 20), 4, 400), QRectF(100, 310, 150, 20));
}

TEST(Tags, ABoxThatWouldCoverAnotherGoesAboveItOrBelow) {
  const QRectF other(10, 50, 60, 20);

  EXPECT_EQ(clear_of(other, {100, 50, 60, 20}, 4), QRectF(100, 50, 60, 20));
  EXPECT_EQ(clear_of(other, {30, 60, 60, 20}, 4), QRectF(30, 26, 60, 20));
  const QRectF at_the_top(10, 5, 60, 20);
  EXPECT_EQ(clear_of(at_the_top, {30, 10, 60, 20}, 4), QRectF(30, 29, 60, 20));
}

TEST(Overlay, WordsOfAMarkAreNotCutOff) {
  const QSizeF room(800, 400);
  const QRectF box(500, 200, 100, 20);
  EXPECT_EQ(kept_within(room, {490, 190}, box, 10), box);
  EXPECT_EQ(kept_within(room, {750, 190}, {760, 200, 100, 20}, 10), QRectF(640, 200, 100, 20));
  EXPECT_EQ(kept_within(room, {490, 390}, {500, 400, 100, 20}, 10), QRectF(500, 360, 100, 20));
  EXPECT_EQ(kept_within(room, {490, 10}, {500, -20, 100, 20}, 10), QRectF(500, 20, 100, 20));
}

TEST(Overlay, WordsOfAMarkCoverNeitherTheRingNorTheWordsOfAnother) {
  const QPointF ring(639, 332);
  const QRectF words(651, 342, 120, 20);
  const QRectF box = clear_of_mark(ring, words, {461, 358, 204, 20}, 4);

  EXPECT_FALSE(box.intersects(words));
  EXPECT_FALSE(box.contains(ring));
  EXPECT_EQ(box, QRectF(461, 302, 204, 20));
  const QRectF apart(10, 10, 50, 20);
  EXPECT_EQ(clear_of_mark(ring, words, apart, 4), apart);
}

/// Light and dark: Qt's own frame is nearly the window's colour in the dark.
TEST(Theme, ATickedBoxIsSeenInBothLooks) {
  for (const bool dark : {false, true}) {
    const auto look = make_theme(dark);
    QCheckBox box("Preview");
    box.setPalette(look.palette);
    box.setStyleSheet(look.style_sheet);
    box.setChecked(true);
    box.resize(box.sizeHint());
    const auto picture = box.grab().toImage();

    int filled = 0;
    int light = 0;
    for (int y = -3; y <= 3; ++y)  // Within the box: around it all is light in the light look.
      for (int x = 4; x < 11; ++x) {
        const auto at = picture.pixelColor(x, picture.height() / 2 + y);
        filled += at == look.palette.color(QPalette::Highlight);
        light += at.lightness() > 235;
      }

    EXPECT_GT(filled, 10) << "the box, dark: " << dark;
    EXPECT_GT(light, 4) << "its tick, dark: " << dark;
  }
}

}  // namespace
}  // namespace tedit::desktop
