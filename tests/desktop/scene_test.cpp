// SPDX-License-Identifier: AGPL-3.0-or-later
// What can be read off the part: colours under a selection, and in the shade.
#include "client-qt/view/viewport.hpp"

#include <QtTest/QtTest>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "tests/desktop/colours.hpp"

namespace tedit::desktop {
namespace {

constexpr int patience_ms = 60'000;
constexpr int side = 400;  // Pixels of the view: 2 m.

/// Two squares of 2 m side by side in the plane z = 0, surfaces 1 and 2, met at x = 0, under a
/// field of one value.
shown_part two_squares(float von_mises_pa) {
  client::surface_update update;
  update.version_id = "v";
  update.surfaces = {{1, "left", 2, 4.0}, {2, "right", 2, 4.0}};
  update.vertices = {0, 1, 2, 3, 4, 5};
  update.positions = {-2, -1, 0, 0, -1, 0, 2, -1, 0, -2, 1, 0, 0, 1, 0, 2, 1, 0};
  update.facets = {0, 1, 2, 3};
  update.facet_vertices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  update.facet_surfaces = {1, 1, 2, 2};
  client::surface_model surface;
  EXPECT_TRUE(surface.apply(update));
  auto field = std::make_shared<client::field_event>();
  field->report.version_id = "v";
  field->vertices = update.vertices;
  field->values["von_mises_pa"].assign(6, von_mises_pa);
  return {std::make_shared<const client::surface_model>(surface), field, 0};
}

std::array<double, 3> channels(QRgb pixel) {
  return {qRed(pixel) / 255.0, qGreen(pixel) / 255.0, qBlue(pixel) / 255.0};
}

std::array<double, 3> channels(const rgb& c) {
  return {c[0], c[1], c[2]};
}

class Scene : public ::testing::Test {
protected:
  std::unique_ptr<viewport> view = std::make_unique<viewport>();
  legend by;

  void SetUp() override {
    by.mode = range_mode::manual;
    by.low = 0;
    by.high = 1e6;
    view->resize(side, side);
    view->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(view.get()));
    view->set_legend(by);
    view->framing().set_left_margin(0);
    view->show_edges(false);
  }

  /// From a direction, with parallel rays.
  void look_from(const vec3& direction) {
    view->view().set_parallel(true);
    view->view().set({10 * direction, {}, {0, 1, 0}, 1});
    view->redraw();
  }

  void show(float value, const vec3& from) {
    view->show_part(two_squares(value));
    ASSERT_TRUE(QTest::qWaitFor([&] { return view->is_seen(); }, patience_ms));
    look_from(from);
  }

  /// Of a point of the part.
  [[nodiscard]] std::array<double, 3> seen_at(const vec3& at) {
    const QImage image = view->picture();
    const auto place = (view->to_widget(at) * image.devicePixelRatio()).toPoint();
    return channels(image.pixel(place));
  }

  [[nodiscard]] static double hue(const std::array<double, 3>& c) {
    const auto lab = lab_of(c);
    return std::atan2(lab[2], lab[1]) * 180 / std::numbers::pi;
  }
};

TEST_F(Scene, TheFieldUnderASelectionKeepsItsHue) {
  for (const float value : {0.1e6F, 0.4e6F, 0.9e6F}) {
    show(value, {0, 0, 1});
    view->select({});
    const auto bare = seen_at({0.5, 0.3, 0});
    view->select({2});
    const auto selected = seen_at({0.5, 0.3, 0});

    EXPECT_NE(bare, selected) << "a tint is there";
    EXPECT_LT(delta_e(bare, selected), 30) << value;
    EXPECT_LT(std::abs(std::remainder(hue(bare) - hue(selected), 360)), 35) << value;
    EXPECT_EQ(seen_at({-0.5, 0.3, 0}), bare) << "the other surface stays as it is";
  }
}

TEST_F(Scene, ASelectionHasALineOfThreePixelsAroundItInTheAccentsColour) {
  show(0.4e6F, {0, 0, 1});
  view->select({2});
  const auto accent = channels(scene_colours{}.accent);
  const QImage image = view->picture();
  const double ratio = image.devicePixelRatio();

  const auto middle = view->to_widget({0, 0.3, 0}) * ratio;
  int wide = 0;
  for (int x = -10; x <= 10; ++x)
    wide += delta_e(channels(image.pixel(qRound(middle.x()) + x, qRound(middle.y()))), accent) < 12;
  EXPECT_NEAR(wide, 3 * ratio, 1);
  // No line inside: the edge between its two triangles.
  EXPECT_GT(delta_e(seen_at({0.5, -0.5, 0}), accent), 30);
}

TEST_F(Scene, WhatIsUnderThePointerIsTintedLessThanASelection) {
  show(0.4e6F, {0, 0, 1});
  const auto bare = seen_at({0.5, 0.3, 0});
  view->select({2});
  const double selected = delta_e(bare, seen_at({0.5, 0.3, 0}));
  view->select({});
  QTest::mouseMove(view.get(), view->to_widget({0.6, 0.2, 0}).toPoint());
  // What is under the pointer is looked for when there is nothing else to do.
  double hovered = 0;
  EXPECT_TRUE(QTest::qWaitFor(
    [&] {
      hovered = delta_e(bare, seen_at({0.5, 0.3, 0}));
      return hovered > 0.5;
    },
    patience_ms));

  EXPECT_LT(hovered, selected);
}

TEST_F(Scene, APictureThatIsKeptHasNoSelection) {
  show(0.4e6F, {0, 0, 1});
  const QImage bare = view->picture();
  view->select({2});
  ASSERT_NE(view->picture(), bare);

  QImage kept;
  view->plain_picture([&](const QImage& frame) { kept = frame; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !kept.isNull(); }, patience_ms));

  kept.setDevicePixelRatio(bare.devicePixelRatio());
  EXPECT_EQ(kept, bare);
  EXPECT_NE(view->picture(), bare) << "on the screen it stays";
}

/// Between two tenths of the legend lie 11 to 29: the eye finds the right one.
TEST_F(Scene, AFaceSixtyDegreesAwayHasTheColourThatTheLegendSays) {
  const double tilt = std::numbers::pi / 3;
  for (const float value : {0.05e6F, 0.5e6F, 0.95e6F})
    for (const vec3& from :
         {vec3{0, 0, 1}, vec3{std::sin(tilt), 0, std::cos(tilt)},
          vec3{-std::sin(tilt), 0, std::cos(tilt)}, vec3{0, std::sin(tilt), std::cos(tilt)},
          vec3{0, -std::sin(tilt), std::cos(tilt)}}) {
      show(value, from);
      const auto wanted = channels(by.colour_at(by.place(value)));

      EXPECT_LT(delta_e(seen_at({0.3, 0.3, 0}), wanted), 12)
        << value << " from " << from.x << ' ' << from.y << ' ' << from.z;
    }
}

}  // namespace
}  // namespace tedit::desktop
