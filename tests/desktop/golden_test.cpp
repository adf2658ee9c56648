// SPDX-License-Identifier: AGPL-3.0-or-later
// Pictures of the view against those that were looked at and kept (tests/data/golden/README.md).
#include "tests/desktop/picture_difference.hpp"
#include "tests/desktop/window_fixture.hpp"

#include "client-qt/tools/section/section_bar.hpp"

namespace tedit::desktop {
namespace {

// Other releases of the software renderer shade and cut edges a little differently.
constexpr double most_mean = 1.5;  ///< Of 255, over all channels.
constexpr double most_off = 0.01;  ///< Share of such pixels.
constexpr QSize picture_size{360, 240};

class Golden : public Window {
protected:
  /// The view alone: its words would differ with the fonts of a machine.
  [[nodiscard]] QImage take() {
    const QSize before = view().size();
    view().resize(picture_size);
    view().framing().look_from(
      camera::direction::isometric);  // Fitted for this size, not the window's.
    const QImage image = view().picture().convertToFormat(QImage::Format_RGB32);
    view().resize(before);
    return image;
  }

  void expect_golden(const QString& name) {
    QTest::qWait(300);  // A fast frame while something moved is made anew in full.
    const QImage seen = take();
    ASSERT_EQ(seen.size(), picture_size);
    const QString path = QString(TEDIT_GOLDEN) + "/" + name + ".png";
    if (qEnvironmentVariable("TEDIT_GOLDEN") == "write") {
      ASSERT_TRUE(seen.save(path)) << path.toStdString();
      return;
    }
    const QImage kept = QImage(path).convertToFormat(QImage::Format_RGB32);
    ASSERT_EQ(kept.size(), seen.size()) << path.toStdString();
    const auto d = compare(kept, seen);
    const QString wrong = QDir::tempPath() + "/tedit-golden-" + name + ".png";
    const bool fits = d.mean <= most_mean && d.off <= most_off;
    if (!fits)
      seen.save(wrong);
    EXPECT_TRUE(fits) << name.toStdString() << ": mean difference " << d.mean << " of 255, "
                      << 100 * d.off << " % of the pixels off; the picture is "
                      << wrong.toStdString();
  }

  void command(const char* id) { ASSERT_TRUE(window->context().all_commands.trigger(id)) << id; }
};

TEST_F(Golden, ThePlateIsDrawnAsItWas) {
  open_plate();
  window->context().look.set_dark(false);
  view().framing().set_left_margin(0);  // No legend is in these pictures.
  view().framing().fit();
  expect_golden("field");

  window->tools().results.panel().set_field(shown_field::none);
  expect_golden("surface");

  window->context().picked.set({1, 2, 98});
  expect_golden("selection");
  window->context().picked.clear();

  window->tools().results.panel().set_field(shown_field::von_mises);
  command("view.section");
  ASSERT_TRUE(
    wait([&] { return window->context().link.running() == 0 && view().section().has_value(); }));
  window->tools().section.bar().hide();  // It is not in these pictures either.
  expect_golden("section");
  command("view.section");

  window->context().look.set_dark(true);
  expect_golden("dark");
}

TEST(GoldenCompare, FindsWhatAPersonWouldSee) {
  QImage grey(100, 100, QImage::Format_RGB32);
  grey.fill(qRgb(100, 100, 100));
  QImage shade = grey;
  shade.fill(qRgb(101, 100, 100));
  QImage mark = grey;
  for (int i = 0; i < 200; ++i)
    mark.setPixel(i % 100, i / 100, qRgb(200, 100, 100));

  EXPECT_NEAR(compare(grey, shade).mean, 1.0 / 3, 1e-12);
  EXPECT_EQ(compare(grey, shade).off, 0);
  EXPECT_GT(compare(grey, mark).off, most_off);
}

}  // namespace
}  // namespace tedit::desktop
