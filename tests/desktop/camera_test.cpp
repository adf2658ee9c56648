// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/camera.hpp"

#include <gtest/gtest.h>

#include <vtkCamera.h>

#include <cmath>

namespace tedit::desktop {
namespace {

void expect_near(const vec3& a, const vec3& b, double within = 1e-9) {
  EXPECT_NEAR(a.x, b.x, within);
  EXPECT_NEAR(a.y, b.y, within);
  EXPECT_NEAR(a.z, b.z, within);
}

/// From z = 10 down on the origin, y up; 200 x 100 pixels, parallel rays: 50 pixels are 1 m.
class Camera : public ::testing::Test {
protected:
  camera eye;

  void SetUp() override {
    eye.set_size(200, 100);
    eye.set_box({-1, 1, -1, 1, -1, 1});
    eye.set({{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 1});
    eye.set_parallel(true);
  }

  /// Where the ray through a pixel meets z = 0.
  [[nodiscard]] vec3 ground(double x, double y) const {
    const auto [from, to] = eye.ray(x, y);
    return from + from.z / (from.z - to.z) * (to - from);
  }
};

TEST_F(Camera, PixelsCountFromTheLowerLeftOfTheView) {
  expect_near(ground(100, 50), {0, 0, 0});
  expect_near(ground(0, 0), {-2, -1, 0});
  expect_near(ground(150, 100), {1, 1, 0});
  EXPECT_NEAR(eye.to_pixel({1, 1, 0})[0], 150, 1e-9);
  EXPECT_NEAR(eye.to_pixel({1, 1, 0})[1], 100, 1e-9);
}

TEST_F(Camera, RaysReachAcrossTheBox) {
  const auto [from, to] = eye.ray(100, 50);

  EXPECT_GT(from.z, 1);
  EXPECT_LT(to.z, -1);
}

TEST_F(Camera, PanningMovesThePictureByAsManyPixels) {
  eye.pan(50, 25);

  expect_near(eye.get().focus, {-1, -0.5, 0});
  expect_near(eye.get().position, {-1, -0.5, 10});
  EXPECT_NEAR(eye.to_pixel({0, 0, 0})[0], 150, 1e-9);
  EXPECT_NEAR(eye.to_pixel({0, 0, 0})[1], 75, 1e-9);
}

TEST_F(Camera, WhatIsUnderThePointerStaysThereWhileZooming) {
  for (const bool parallel : {true, false}) {
    eye.set_parallel(parallel);
    const auto before = ground(150, 75);

    eye.zoom(2, 150, 75);

    const auto after = ground(150, 75);
    expect_near(after, before, 1e-6);
  }
}

TEST_F(Camera, APointOfSpaceAndItsPixelsRayAgreeInPerspective) {
  eye.set_parallel(false);
  eye.rotate(0.13, -0.07);
  const vec3 point{0.3, -0.2, 0.4};

  const auto [x, y] = eye.to_pixel(point);
  const auto [from, to] = eye.ray(x, y);

  const vec3 way = to - from;
  const vec3 nearest = from + dot(point - from, way) / dot(way, way) * way;
  expect_near(nearest, point);
}

TEST_F(Camera, FreeRoomAtTheLeftMovesThePictureNotTheFocus) {
  eye.set_left_margin(0.2);

  EXPECT_NEAR(eye.to_pixel({0, 0, 0})[0], 120, 1e-9);  // A fifth of half of 200 pixels.
  expect_near(eye.get().focus, {0, 0, 0});
}

TEST_F(Camera, FreeRoomBelowIsNotFilledByWhatIsMadeToFit) {
  for (const bool parallel : {true, false}) {
    eye.set_parallel(parallel);
    eye.set_lower_margin(0.2);

    eye.fit({-0.1, 0.1, -1, 1, 0, 0});

    EXPECT_NEAR(eye.to_pixel({0, -1, 0})[1], 20 + 80 * (1 - 1 / 1.12) / 2, 1e-6);
    EXPECT_NEAR(eye.to_pixel({0, 1, 0})[1], 100 - 80 * (1 - 1 / 1.12) / 2, 1e-6);
  }
}

TEST_F(Camera, WhatIsMadeToFitHasABorder) {
  eye.fit({-4, 4, -1, 1, 0, 0});  // Twice as wide as the view is, by its height.

  const auto [left, low] = eye.to_pixel({-4, -1, 0});
  const auto [right, high] = eye.to_pixel({4, 1, 0});
  EXPECT_NEAR(right - left, 200 / 1.12, 1e-6);
  EXPECT_NEAR(high - low, 50 / 1.12, 1e-6);
}

TEST_F(Camera, AViewerInsideTheBoxSeesFromWhereItStands) {
  eye.set_parallel(false);
  eye.set({{0, 0, 0.5}, {0, 0, 0}, {0, 1, 0}, 1});

  EXPECT_TRUE(eye.is_within({-1, 1, -1, 1, -1, 1}));
  EXPECT_LT(eye.ray(100, 50)[0].z, 0.5);
  EXPECT_GT(eye.ray(100, 50)[0].z, 0.49);
}

TEST_F(Camera, ACopyIsACameraOfItsOwn) {
  const auto copy = eye.copy();
  eye.pan(50, 0);

  EXPECT_EQ(copy->GetFocalPoint()[0], 0);
  EXPECT_EQ(copy->GetParallelScale(), 1);
}

TEST_F(Camera, ATurntableKeepsTheHorizonLevelWhateverIsDragged) {
  eye.look_from(camera::direction::isometric);
  for (int i = 0; i < 200; ++i) {
    eye.rotate(0.37 * std::sin(3.1 * i), 0.41 * std::cos(1.7 * i));
    const auto now = eye.get();
    EXPECT_NEAR(cross(now.up, now.position - now.focus).z, 0, 1e-9);
    EXPECT_GE(now.up.z, -1e-9);
    EXPECT_NEAR(std::sqrt(dot(now.position, now.position)), 10, 1e-9);
  }
}

TEST_F(Camera, ATurntableGoesAroundAndStopsAtThePoles) {
  eye.look_from(camera::direction::front);
  eye.rotate(0.5, 0);  // A quarter to the right: the left side comes to the front.
  expect_near(eye.get().position, {-10, 0, 0});
  expect_near(eye.get().up, {0, 0, 1});
  eye.rotate(1.5, 0);
  expect_near(eye.get().position, {0, -10, 0});

  eye.rotate(0, 0.25);  // Down: seen from above.
  expect_near(eye.get().position, {0, -10 * std::sqrt(0.5), 10 * std::sqrt(0.5)});
  eye.rotate(0, 3);
  expect_near(eye.get().position, {0, 0, 10});
  expect_near(eye.get().up, {0, 1, 0});
  eye.rotate(0, -0.5);
  expect_near(eye.get().position, {0, -10, 0});
}

TEST_F(Camera, AnOrbitGoesOverThePole) {
  eye.set_turning(camera::turning::orbit);
  eye.look_from(camera::direction::front);
  for (int i = 0; i < 3; ++i)
    eye.rotate(0, 0.25);
  EXPECT_GT(eye.get().position.y, 0);
  EXPECT_LT(eye.get().up.z, 0);

  eye.set_turning(camera::turning::turntable);
  eye.rotate(0, 0);  // Upright again, from the same side.
  expect_near(eye.get().position, {0, 10 * std::sqrt(0.5), 10 * std::sqrt(0.5)});
  EXPECT_GT(eye.get().up.z, 0);
}

TEST_F(Camera, APixelsLengthIsThatOfTheGround) {
  EXPECT_NEAR(eye.metres_per_pixel(), 0.02, 1e-12);
  eye.set_parallel(false);
  const auto step = ground(101, 50) - ground(100, 50);
  EXPECT_NEAR(eye.metres_per_pixel(), std::sqrt(dot(step, step)), 1e-9);
}

}  // namespace
}  // namespace tedit::desktop
