// SPDX-License-Identifier: AGPL-3.0-or-later
// One grid and one set of sizes: where fields end, how high they are, what is seen on which ground.
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>

#include <algorithm>
#include <set>

#include "client-qt/context/appearance.hpp"
#include "client-qt/model/operation_words.hpp"
#include "client-qt/tools/jobs/jobs_panel.hpp"
#include "client-qt/tools/loads/load_editor.hpp"
#include "client-qt/tools/operations/preview_box.hpp"
#include "client-qt/view/overlay.hpp"

namespace tedit::desktop {
namespace {

/// In the program's style, which others are not to have.
class Looks : public testing::Test {
protected:
  Looks() {
    QApplication::setStyle("Fusion");
    look_.set_dark(false);
  }
  ~Looks() override {
    qApp->setStyleSheet({});
    qApp->setPalette(before_);
  }

  QTemporaryDir folder_;
  QSettings settings_{folder_.filePath("settings.ini"), QSettings::IniFormat};
  const QPalette before_ = qApp->palette();
  appearance look_{settings_};
};

/// How many pixels tell themselves from the ground.
int seen_of_a_pin(const QColor& ground, const QColor& ink) {
  QImage image(60, 60, QImage::Format_RGB32);
  image.fill(ground);
  {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    paint_pin(painter, {20, 40}, {45, 15}, ink, 1);
  }
  int seen = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      seen += std::abs(image.pixelColor(x, y).lightness() - ground.lightness()) > 80 ? 1 : 0;
  return seen;
}

TEST_F(Looks, AMarkIsSeenOnEveryGround) {
  constexpr int enough = 30;
  for (const QColor ink : {QColor("#20262e"), QColor("#e6e9ee")})  // Light and dark looks.
    for (const QColor ground : {QColor(20, 24, 30), QColor(120, 120, 120), QColor(235, 235, 235)})
      EXPECT_GT(seen_of_a_pin(ground, ink), enough)
        << ink.name().toStdString() << " on " << ground.name().toStdString();
}

class MaterialForm : public Looks {
protected:
  MaterialForm() {
    editor_.edit("New material", fem::material{"Steel", 210e9, 0.3, 7850, 235e6, {}});
    editor_.resize(330, 420);
    editor_.show();
    QApplication::processEvents();
  }
  load_editor editor_{{}};
};

TEST_F(MaterialForm, FieldsWithAUnitEndBelowEachOther) {
  std::set<int> ends;
  for (const auto* name : {"young_modulus", "poisson_ratio", "density", "yield_strength"}) {
    const auto* one = editor_.findChild<QLineEdit*>(name);
    ends.insert(one->mapTo(&editor_, QPoint(one->width(), 0)).x());
  }
  EXPECT_EQ(ends.size(), 1U) << *ends.begin() << " to " << *ends.rbegin();
}

TEST_F(Looks, ASpinBoxHasAFrameInTheDark) {
  look_.set_dark(true);
  QSpinBox box;
  box.resize(90, 24);
  box.show();
  QApplication::processEvents();

  const auto image = box.grab().toImage();
  int lightest = 0;
  for (int y = 0; y < 4; ++y)
    lightest = std::max(lightest, image.pixelColor(image.width() / 3, y).lightness());
  constexpr int seen = 15;
  EXPECT_GE(lightest, look_.now().palette.color(QPalette::Window).lightness() + seen);
}

/// Where ink begins in what a label shows.
int begin_of_ink(const QWidget& panel, const QLabel& label) {
  const auto image = const_cast<QLabel&>(label).grab().toImage();
  const QColor ground = image.pixelColor(image.width() - 1, image.height() - 1);
  for (int x = 0; x < image.width(); ++x)
    for (int y = 0; y < image.height(); ++y)
      if (std::abs(image.pixelColor(x, y).lightness() - ground.lightness()) > 60)
        return label.mapTo(&panel, QPoint(x, 0)).x();
  return -1;
}

TEST_F(Looks, WhatTheJobsListSaysBeginsBelowItsTitles) {
  remote link;
  jobs work;
  jobs_button button(work, link);
  button.show();
  button.click();
  QApplication::processEvents();
  const auto* panel = button.findChild<jobs_panel*>();
  ASSERT_NE(panel, nullptr);

  std::set<int> begins;
  for (const auto* label : panel->findChildren<QLabel*>())
    if (label->isVisible())
      begins.insert(begin_of_ink(*panel, *label));
  ASSERT_FALSE(begins.empty());
  EXPECT_LE(*begins.rbegin() - *begins.begin(), 1) << "a letter's own room";
  constexpr int usual_margin = 12;
  EXPECT_LE(*begins.rbegin(), usual_margin + 3) << "with the frame";
}

TEST_F(Looks, FiguresOfAPreviewBeginLikeTheRowsBesideThem) {
  client::edit_preview made;
  made.report.figures = {{"volume_share", -0.0181, "%", "of the part's volume"}};

  EXPECT_TRUE(preview_details(made).contains("Of the part")) << preview_details(made).toStdString();
}

TEST_F(Looks, WhatComputedIsWrittenAsPeopleWriteIt) {
  EXPECT_EQ(device_words("cpu"), "CPU");
  EXPECT_EQ(device_words("NVIDIA H100"), "NVIDIA H100");
}

}  // namespace
}  // namespace tedit::desktop
