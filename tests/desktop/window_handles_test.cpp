// SPDX-License-Identifier: AGPL-3.0-or-later
// Handles of a form in the real window, dragged with the mouse.
#include "tests/desktop/window_fixture.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include <QPlainTextEdit>
#include <QToolButton>

#include "client-qt/tools/operations/operation_handles.hpp"
#include "mesh/box.hpp"

namespace tedit::desktop {
namespace {

class Handles : public Window {
protected:
  static constexpr surface_id top = 6;

  [[nodiscard]] operation_handles& handles() { return window->tools().operations.handles(); }
  [[nodiscard]] live_preview& preview() { return window->tools().operations.panel().preview(); }
  [[nodiscard]] operation_form& form() { return *window->tools().operations.panel().form(); }

  /// A block of an inch, from above, with an operation's form open for its top.
  void open_block(const char* operation, surface_id wall) {
    window->tools().documents.open_file(TEDIT_TEST_DATA "/parts/inch_block/inch_block.coarse.msh",
                                        {});
    ASSERT_TRUE(wait([&] { return shows_head() && !part().operations().operations.empty(); }));
    ASSERT_TRUE(window->context().all_commands.trigger("view.isometric"));
    window->context().picked.set({wall});
    window->tools().operations.panel().choose(operation);
    ASSERT_TRUE(wait([&] { return view().is_seen() && shows_preview(); }));
  }

  [[nodiscard]] bool shows_preview() {
    const auto& shown = preview().shown();
    return shown && !preview().is_busy() && view().is_settled() &&
           view().current().surface == shown->surface;
  }

  [[nodiscard]] laid_handle handle_of(const std::string& parameter) {
    for (const auto& one : handles().laid())
      if (one.of->parameter == parameter)
        return one;
    ADD_FAILURE() << "no handle " << parameter;
    return {};
  }

  [[nodiscard]] double number(const char* parameter) {
    return std::get<double>(form().values().at(parameter));
  }
  [[nodiscard]] vec3 point(const char* parameter) {
    return ops::vector_of(form().values(), parameter).value_or(vec3{NAN, NAN, NAN});
  }

  void move(QPointF to, Qt::MouseButtons held = Qt::LeftButton, Qt::KeyboardModifiers keys = {}) {
    QMouseEvent event(QEvent::MouseMove, to, view().mapToGlobal(to), Qt::NoButton, held, keys);
    QApplication::sendEvent(&view(), &event);
  }
  void press_at(QPointF at) {
    move(at, Qt::NoButton);
    QTest::mousePress(&view(), Qt::LeftButton, {}, at.toPoint());
  }
  void release_at(QPointF at) { QTest::mouseRelease(&view(), Qt::LeftButton, {}, at.toPoint()); }
};

TEST_F(Handles, DraggingTheDepthChangesTheFieldByWhatThePointerMoved) {
  open_block("drill", top);
  form().set_values({{"depth", 0.005}});
  const auto arrow = handle_of("depth");
  const lens by = lens_of(view());
  // Along the arrow as far as 4 mm are on the screen.
  const QPointF way =
    by.to_screen(arrow.root + 0.009 * arrow.along) - by.to_screen(arrow.root + 0.005 * arrow.along);
  press_at(arrow.knob);
  ASSERT_TRUE(handles().is_dragging());
  const auto camera = view().view().get();
  move(arrow.knob.toPoint() + way / 2);
  EXPECT_TRUE(handles().shows_ghost()) << "before the preview is there";
  move(arrow.knob.toPoint() + way);

  const double step = drag_step(by.metres_per_pixel(arrow.root));
  EXPECT_NEAR(number("depth"), 0.009, 1.01 * step);
  release_at(arrow.knob + way);
  EXPECT_EQ(view().view().get(), camera) << "the part is not turned";
  EXPECT_EQ(window->context().picked.surfaces(), std::vector<surface_id>{top});
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
  EXPECT_FALSE(handles().shows_ghost());
  const double radius = number("diameter") / 2;
  const double hole = std::numbers::pi * radius * radius * number("depth");
  EXPECT_NEAR(-preview().shown()->made.report.volume_change, hole, 0.02 * hole);
  auto* field = form().findChild<QWidget*>("depth");
  ASSERT_TRUE(field->hasFocus());
  QTest::keyClicks(field, "1/4 in");
  QTest::keyClick(field, Qt::Key_Tab);
  EXPECT_NEAR(number("depth"), 0.00635, 1e-12) << "the exact value is typed";
}

/// A bead along an edge of the block: the button, a click near the edge, and its preview.
TEST_F(Handles, APathIsPickedByAClickNearAnEdge) {
  window->tools().documents.open_file(TEDIT_TEST_DATA "/parts/inch_block/inch_block.coarse.msh",
                                      {});
  ASSERT_TRUE(wait([&] { return shows_head() && !part().operations().operations.empty(); }));
  ASSERT_TRUE(window->context().all_commands.trigger("view.isometric"));
  window->tools().operations.panel().choose("sweep");
  ASSERT_TRUE(wait([&] { return view().is_seen() && view().is_settled(); }));
  const auto& surface = *part().head()->surface;
  box wall;
  surface.facets().for_each([&](auto, const client::surface_facet& facet) {
    for (const auto v : facet.v)
      if (facet.surface == top)
        wall.add(*surface.positions().find(v));
  });
  const lens by = lens_of(view());
  // Two pixels from the middle of the edge towards the wall's middle.
  const vec3 middle = 0.5 * (wall.low + wall.high);
  const vec3 edge{middle.x, wall.low.y, middle.z};
  const vec3 near = edge + 2 * by.metres_per_pixel(edge) * normalized(middle - edge);

  form().findChild<QWidget*>("path")->findChild<QToolButton*>()->click();
  QTest::mouseClick(&view(), Qt::LeftButton, {}, by.to_screen(near).toPoint());

  const auto path = std::get<std::string>(form().values().at("path"));
  EXPECT_TRUE(path.starts_with("edge:6,")) << path;
  EXPECT_FALSE(form().picks());
  EXPECT_TRUE(window->context().picked.surfaces().empty()) << "nothing is selected by it";
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
  EXPECT_LT(preview().shown()->made.report.volume_change, 0);
}

TEST_F(Handles, EscDuringADragIsTheValueBefore) {
  open_block("drill", top);
  form().set_values({{"depth", 0.005}});
  const auto arrow = handle_of("depth");
  press_at(arrow.knob);
  move(arrow.knob + QPointF(0, 40));
  ASSERT_NE(number("depth"), 0.005);

  QTest::keyClick(window.get(), Qt::Key_Escape);

  EXPECT_EQ(number("depth"), 0.005);
  EXPECT_FALSE(handles().is_dragging());
  EXPECT_EQ(window->tools().operations.panel().chosen(), "drill") << "the form stays";
  move(arrow.knob + QPointF(0, 60));
  EXPECT_EQ(number("depth"), 0.005) << "though the button is still down";
  release_at(arrow.knob + QPointF(0, 60));
  EXPECT_EQ(window->context().picked.surfaces(), std::vector<surface_id>{top});
}

TEST_F(Handles, AnotherButtonNeitherEndsADragNorTurnsThePart) {
  open_block("drill", top);
  form().set_values({{"depth", 0.005}});
  const auto arrow = handle_of("depth");
  const auto camera = view().view().get();
  press_at(arrow.knob);
  QTest::mousePress(&view(), Qt::RightButton, {}, arrow.knob.toPoint());
  move(arrow.knob + QPointF(0, 40), Qt::LeftButton | Qt::RightButton);
  QTest::mouseRelease(&view(), Qt::RightButton, {}, arrow.knob.toPoint());
  EXPECT_TRUE(handles().is_dragging());
  EXPECT_GT(number("depth"), 0.005);
  EXPECT_EQ(view().view().get(), camera);
  release_at(arrow.knob);
  EXPECT_FALSE(handles().is_dragging());
}

TEST_F(Handles, ThePlaceIsDraggedOverThePartAndTakesHoldOfCentres) {
  open_block("drill", top);
  const auto ball = handle_of("at");
  const auto middle = ball.root;
  const lens by = lens_of(view());
  const QPointF away = by.to_screen(middle + vec3{0.004, 0.003, 0});
  press_at(ball.knob);
  move(away);
  EXPECT_NEAR(norm(point("at") - middle), 0.005, 3e-4);
  EXPECT_NEAR(point("at").z, middle.z, 1e-6);
  EXPECT_EQ(handles().snapped_to(), "");

  // Its centres are found aside; a move beside the middle takes hold as soon as they are.
  ASSERT_TRUE(wait([&] {
    move(away);
    move(by.to_screen(middle) + QPointF(4, 3));
    return !handles().snapped_to().isEmpty();
  }));
  EXPECT_EQ(handles().snapped_to(), QString("centre of surface %1").arg(top));
  EXPECT_NEAR(norm(point("at") - middle), 0, 1e-6);
  move(by.to_screen(middle) + QPointF(4, 3), Qt::LeftButton, Qt::ControlModifier);
  EXPECT_EQ(handles().snapped_to(), "") << "not with Ctrl";
  EXPECT_GT(norm(point("at") - middle), 1e-5);
  release_at(by.to_screen(middle));
}

TEST_F(Handles, PreviewsFollowWhileThePointerNeverRests) {
  open_block("drill", top);
  form().set_values({{"depth", 0.005}});
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
  const auto arrow = handle_of("depth");
  const lens by = lens_of(view());
  const QPointF way = by.to_screen(arrow.root + 0.008 * arrow.along) - by.to_screen(arrow.root);
  press_at(arrow.knob);
  std::set<const void*> seen;
  int i = 0;
  // Every 10 ms, which is far less than a form waits for rest.
  ASSERT_TRUE(wait([&] {
    const double share = 0.5 + 0.5 * std::sin(0.1 * ++i);
    move(arrow.knob + share * way);
    if (preview().shown())
      seen.insert(preview().shown().get());
    return seen.size() >= 4;
  }));
  release_at(arrow.knob);
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
}

TEST_F(Handles, DraftsAreShownWhileItIsDraggedAndTheWholePreviewAfterwards) {
  open_block("drill", top);
  form().set_values({{"depth", 0.005}});
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
  ASSERT_FALSE(preview().shown()->made.draft);
  const auto arrow = handle_of("depth");
  const lens by = lens_of(view());
  const QPointF way = by.to_screen(arrow.root + 0.003 * arrow.along) - by.to_screen(arrow.root);
  press_at(arrow.knob);
  const auto shows_draft = [&] { return preview().shown() && preview().shown()->made.draft; };
  int i = 0;
  ASSERT_TRUE(wait([&] {
    move(arrow.knob + (0.5 + 0.5 * std::sin(0.1 * ++i)) * way);
    return shows_draft();
  }));
  EXPECT_EQ(preview().shown()->made.tets, 0U);
  // The pointer is held still: the whole one comes.
  ASSERT_TRUE(wait([&] { return preview().shown() && !shows_draft() && !preview().is_busy(); }));
  ASSERT_TRUE(wait([&] {
    move(arrow.knob + (0.5 + 0.5 * std::sin(0.1 * ++i)) * way);
    return shows_draft();
  }));
  release_at(arrow.knob + way);
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
  EXPECT_FALSE(preview().shown()->made.draft);
  EXPECT_GT(preview().shown()->made.tets, 0U);
  const auto id = preview().shown()->surface->version_id();
  press("apply");
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));
  EXPECT_EQ(part().head()->info.version_id, id);
}

TEST_F(Handles, WhatIsPointedAtIsMarkedAndNothingOfThePartUnderIt) {
  open_block("drill", top);
  std::optional<bool> over_part;
  const QObject here;  // Nobody listens when this test is over.
  QObject::connect(&view(), &viewport::hovered, &here,
                   [&](const std::optional<picked_point>& at) { over_part = at.has_value(); });
  const auto ring = handle_of("diameter");
  move(ring.knob, Qt::NoButton);
  EXPECT_EQ(view().cursor().shape(), Qt::PointingHandCursor);
  EXPECT_EQ(over_part, false);
  EXPECT_EQ(words_of(ring, form().values()), "Diameter 5 mm");

  move(ring.knob + QPointF(handle_reach + 1, 0), Qt::NoButton);
  EXPECT_EQ(view().cursor().shape(), Qt::ArrowCursor);
}

TEST_F(Handles, OtherFormsHaveTheirsByTheirDescriptions) {
  open_block("boss", top);
  const auto has = [&](const char* parameter) {
    const auto all = handles().laid();
    return std::ranges::any_of(all,
                               [&](const auto& one) { return one.of->parameter == parameter; });
  };
  for (const char* one : {"at", "direction", "size", "height", "along"})
    EXPECT_TRUE(has(one)) << one;

  window->tools().operations.panel().choose("plane_cut");
  EXPECT_TRUE(has("normal"));
  EXPECT_TRUE(has("offset"));
  EXPECT_FALSE(has("height"));
  window->tools().operations.panel().choose("thicken");
  EXPECT_TRUE(has("depth"));
  EXPECT_NEAR(dot(handle_of("depth").along, {0, 0, 1}), 1, 1e-9) << "out of the wall";
  window->tools().operations.panel().choose({});
  EXPECT_TRUE(handles().laid().empty());
}

/// The bore 1, 2 of the plate: 25 mm wide around (-160, 45), a hexagon in this coarse mesh.
TEST_F(Handles, ABoreHasItsRingAroundItsAxisAndIsMovedOverItsWall) {
  open_plate(false);
  window->context().picked.set({1, 2});
  window->tools().operations.panel().choose("resize_bore");
  const auto ring = handle_of("diameter");
  EXPECT_NEAR(ring.root.x, -0.160, 1e-6);
  EXPECT_NEAR(ring.root.y, 0.045, 1e-6);

  window->tools().operations.panel().choose("move");
  const auto arrow = handle_of("by");
  press_at(arrow.knob);
  move(arrow.knob + QPointF(40, -25));
  const auto way = point("by");
  EXPECT_GT(way.x, 0.01);
  EXPECT_EQ(way.z, 0);
  release_at(arrow.knob + QPointF(40, -25));
}

/// From above there is nothing of the part where the bore's axis is.
TEST_F(Handles, ThePlaceTakesHoldOfABoresAxis) {
  open_plate(false);
  ASSERT_TRUE(window->context().all_commands.trigger("view.top"));
  window->context().picked.set({98});
  window->tools().operations.panel().choose("drill");
  ASSERT_TRUE(wait([&] { return view().is_seen(); }));
  const vec3 axis{-0.160, 0.045, 0};
  const auto ball = handle_of("at");
  press_at(ball.knob);
  ASSERT_TRUE(wait([&] {
    move(ball.knob);
    move(lens_of(view()).to_screen(axis) + QPointF(4, 2));
    return !handles().snapped_to().isEmpty();
  }));

  EXPECT_EQ(handles().snapped_to(), "centre of a round edge, Ø 25 mm");
  EXPECT_NEAR(norm(point("at") - axis), 0, 2e-6);
  EXPECT_EQ(window->context().picked.surfaces(), std::vector<surface_id>{98});
  release_at(ball.knob);
}

TEST_F(Handles, AreInNoPictureThatIsKept) {
  open_block("drill", top);
  handles().hover(handle_of("at").knob);
  const QImage with = window->grab().toImage();
  const QImage kept = window->context().over.picture();
  handles().layer().hide();
  EXPECT_NE(window->grab().toImage(), with);
  EXPECT_EQ(window->context().over.picture(), kept);
}

}  // namespace
}  // namespace tedit::desktop
