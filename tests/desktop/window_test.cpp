// SPDX-License-Identifier: AGPL-3.0-or-later
// The main job as a person does it: mouse and keys on the real window, a real server behind it.
#include "tests/desktop/window_fixture.hpp"

#include <QLineEdit>

#include <csignal>

#include "client-qt/tools/history/history_strip.hpp"
#include "client-qt/tools/recipes/window_player.hpp"

namespace tedit::desktop {
namespace {

TEST_F(Window, ABoreIsPickedByAClickFilledAndBroughtBack) {
  open_plate();
  const auto stress_before = view().painted().extremes->high;

  click_surface(1);
  ASSERT_TRUE(wait([&] { return window->context().picked.surfaces().size() == 2; }));
  EXPECT_EQ(window->findChild<QLabel*>("selection_title")->text(), QString("Bore, Ø 25 mm"));
  press("offer_fill_hole");
  press("apply");
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));

  EXPECT_FALSE(part().head()->surface->surfaces().contains(1));
  EXPECT_TRUE(window->context().picked.surfaces().empty());
  ASSERT_TRUE(part().head()->report.has_value());
  EXPECT_NE(view().painted().extremes->low, 0);
  EXPECT_NEAR(view().painted().extremes->high, stress_before, 0.05 * stress_before);

  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(wait([&] { return version() == 0 && is_final(); }));
  EXPECT_TRUE(part().head()->surface->surfaces().contains(1));
  EXPECT_TRUE(part().edits().can_redo());
}

TEST_F(Window, ASecondClickMeansTheSurfaceAloneAndShiftAdds) {
  open_plate(false);

  click_surface(1);
  ASSERT_TRUE(wait([&] { return window->context().picked.surfaces().size() == 2; }));
  click_surface(1);
  EXPECT_EQ(window->context().picked.surfaces(), (std::vector<surface_id>{1}));
  click_surface(98, Qt::ShiftModifier);
  ASSERT_TRUE(wait([&] {
    return window->context().picked.contains(98) && window->context().link.running() == 0;
  }));
  EXPECT_TRUE(window->context().picked.contains(1));

  QTest::mouseClick(&view(), Qt::LeftButton, {}, QPoint(3, 3));  // Beside the part.
  EXPECT_TRUE(window->context().picked.surfaces().empty());
}

TEST_F(Window, WhatCannotBeDoneIsSaidAndChangesNothing) {
  // A player that was not started hears nothing: its failure would end the program.
  window_player idle(window->context(), window->tools(), {});
  const QSignalSpy ended(&idle, &window_player::failed);
  open_plate(false);

  window->context().picked.set({98});
  window->tools().operations.panel().choose("erode");
  window->tools().operations.panel().form()->set_values({{"depth", 0.5}});
  window->tools().operations.panel().apply();
  ASSERT_TRUE(wait([&] { return !window->context().messages.text().isEmpty(); }));

  EXPECT_TRUE(window->context().messages.text().startsWith("Erode did not work"))
    << window->context().messages.text().toStdString();
  EXPECT_EQ(version(), 0U);
  EXPECT_FALSE(part().foreground().current().has_value());
  EXPECT_EQ(ended.count(), 0);
}

TEST_F(Window, ThePaletteFindsAndRunsByTheKeyboardAlone) {
  open_plate(false);
  window->context().picked.set({1, 2});

  QTest::keyClick(window.get(), Qt::Key_K, Qt::ControlModifier);
  auto* letters = window->findChild<QLineEdit*>("palette_letters");
  ASSERT_TRUE(letters->isVisible());
  QTest::keyClicks(letters, "fillh");
  QTest::keyClick(letters, Qt::Key_Return);

  EXPECT_EQ(window->tools().operations.panel().chosen(), "fill_hole");
  EXPECT_FALSE(letters->isVisible());
  QTest::keyClick(window.get(), Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));
}

TEST_F(Window, AKilledServerComesBackWithAllThatWasDone) {
  open_plate(false);
  window->context().picked.set({1, 2});
  window->tools().operations.panel().choose("fill_hole");
  window->tools().operations.panel().apply();
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));
  const auto id = part().head()->info.version_id;

  const auto pid = window->context().server.pid();
  const auto url = window->context().link.address().url;
  ASSERT_EQ(::kill(static_cast<pid_t>(pid), SIGKILL), 0);
  ASSERT_TRUE(wait([&] {
    return window->context().server.pid() != pid && window->context().link.address().url != url &&
           window->context().link.current() == remote::state::connected && shows_head();
  }));

  EXPECT_EQ(part().head()->info.version_id, id);
  EXPECT_TRUE(window->context().messages.text().isEmpty());
  part().edits().undo();
  ASSERT_TRUE(wait([&] { return version() == 0 && shows_head(); }));
}

TEST_F(Window, WhatWasOpenInACrashIsOpenedAgain) {
  open_plate(false);
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));
  const auto name = part().name();
  const auto id = part().head()->info.version_id;

  window.reset();  // Not closed by anybody.
  window = std::make_unique<main_window>(state.path());
  window->show();
  window->tools().documents.restore();
  ASSERT_TRUE(wait([&] { return part().head() && shows_head(); }));
  EXPECT_EQ(part().name(), name);
  EXPECT_EQ(part().head()->info.version_id, id);
  EXPECT_TRUE(part().edits().can_undo());

  window->close();
  window = std::make_unique<main_window>(state.path());
  window->tools().documents.restore();
  EXPECT_FALSE(part().is_open());
}

TEST_F(Window, AnyVersionOfTheHistoryCanBeGoneTo) {
  open_plate(false);
  for (const auto& hole : {std::vector<surface_id>{1, 2}, std::vector<surface_id>{51, 52}}) {
    const auto next = version() + 1;
    part().edits().apply({"fill_hole", hole, {}});
    ASSERT_TRUE(wait([&] { return version() == next && shows_head(); }));
  }

  part().edits().go_to(0);
  ASSERT_TRUE(wait([&] { return version() == 0 && shows_head(); }));
  EXPECT_TRUE(part().edits().can_redo());
  part().edits().redo();
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));
  part().edits().go_to(2);
  ASSERT_TRUE(wait([&] { return version() == 2 && shows_head(); }));
  EXPECT_FALSE(part().edits().can_redo());
  EXPECT_EQ(window->findChild<history_strip*>()->count(), 3);
}

TEST_F(Window, AVersionHasAPictureBeforeItHasAField) {
  open_plate(false);
  const auto& history = *window->findChild<history_strip*>();
  const auto id = part().head()->info.version_id;
  ASSERT_TRUE(wait([&] { return history.has_thumbnail(id, false); }));
  EXPECT_FALSE(history.has_thumbnail(id, true));

  window->tools().documents.open_file(plate(), {loads()});
  ASSERT_TRUE(wait([&] { return is_final() && history.has_thumbnail(id, true); }));
}

TEST_F(Window, ASectionShowsTheFieldInside) {
  open_plate();
  const auto before = window->context().over.picture();

  ASSERT_TRUE(window->context().all_commands.trigger("view.section"));
  ASSERT_TRUE(
    wait([&] { return window->context().link.running() == 0 && view().section().has_value(); }));
  QTest::qWait(50);
  const auto cut = window->context().over.picture();

  ASSERT_EQ(cut.size(), before.size());
  EXPECT_NE(cut, before);
  ASSERT_TRUE(window->context().all_commands.trigger("view.section"));
  QTest::qWait(50);
  EXPECT_EQ(window->context().over.picture(), before);
}

TEST_F(Window, LoadCasesAreThoseOfTheServer) {
  open_plate();
  ASSERT_EQ(part().loads().all().size(), 1U);

  auto harder = part().loads().all().front();
  std::get<fem::force>(harder.loads.front().kind).total_n.z *= 2;
  const auto before = view().painted().extremes->high;
  part().loads().set(harder);
  ASSERT_TRUE(wait([&] { return is_final() && view().painted().extremes->high > 1.5 * before; }));

  EXPECT_NEAR(view().painted().extremes->high, 2 * before, 1e-3 * before);
  EXPECT_EQ(std::get<fem::force>(part().loads().all().front().loads.front().kind).total_n.z,
            -40000);
}

TEST_F(Window, KeysTurnMoveAndZoomThePart) {
  open_plate(false);
  view().setFocus();
  const auto away = [](const camera::pose& p) { return p.position - p.focus; };
  const auto before = view().view().get();
  QTest::keyClick(&view(), Qt::Key_Right);
  const auto turned = view().view().get();
  EXPECT_EQ(turned.focus, before.focus);
  EXPECT_NEAR(away(turned).z, away(before).z, 1e-9);
  EXPECT_GT(std::abs(away(turned).x - away(before).x), 0.01);
  QTest::keyClick(&view(), Qt::Key_Left);
  EXPECT_NEAR(away(view().view().get()).x, away(before).x, 1e-9);

  QTest::keyClick(&view(), Qt::Key_Up, Qt::ShiftModifier);
  const auto moved = view().view().get();
  EXPECT_NE(moved.focus, before.focus);
  EXPECT_NEAR(away(moved).x, away(before).x, 1e-9);
  QTest::keyClick(&view(), Qt::Key_Plus);
  const auto near = away(view().view().get());
  EXPECT_LT(dot(near, near), dot(away(moved), away(moved)));
}

}  // namespace
}  // namespace tedit::desktop
