// SPDX-License-Identifier: AGPL-3.0-or-later
// The preview of an edit in the real window, with the real server behind it.
#include "tests/desktop/window_fixture.hpp"

#include <QCheckBox>
#include <QComboBox>

namespace tedit::desktop {
namespace {

class PreviewWindow : public Window {
protected:
  [[nodiscard]] live_preview& preview() { return window->tools().operations.panel().preview(); }

  [[nodiscard]] bool shows_preview() {
    const auto& shown = preview().shown();
    return shown && !preview().is_busy() && view().is_settled() &&
           view().current().surface == shown->surface;
  }

  void choose(const std::vector<surface_id>& surfaces, const char* operation) {
    window->context().picked.set(surfaces);
    window->tools().operations.panel().choose(operation);
  }

  [[nodiscard]] QString label(const char* name) {
    const auto* found = window->findChild<QLabel*>(name);
    return found && found->isVisibleTo(window.get()) ? found->text() : QString();
  }

  /// Pixels of the view in the colour of what an edit would add, at any light.
  [[nodiscard]] int accent_pixels() {
    const QImage image = window->context().over.picture();
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor c = image.pixelColor(x, y);
        count += c.red() > 80 && c.hslHue() > 18 && c.hslHue() < 34 && c.hslSaturation() > 120;
      }
    return count;
  }
};

TEST_F(PreviewWindow, ShowsWhatTheFormWouldMakeAndEscGoesBackToTheHead) {
  open_plate();
  EXPECT_EQ(accent_pixels(), 0);
  const auto head = part().head()->info.version_id;

  choose({1, 2}, "fill_hole");
  ASSERT_TRUE(wait([&] { return shows_preview(); }));

  EXPECT_EQ(view().geometry()->version_id, preview().shown()->surface->version_id());
  EXPECT_NE(view().geometry()->version_id, head);
  // The stress as it is stays in sight where the edit leaves the part as it is.
  const auto& carried = view().current().field;
  ASSERT_TRUE(carried);
  EXPECT_EQ(carried->version_id(), preview().shown()->surface->version_id());
  EXPECT_LT(carried->vertices.size(), part().head()->fields.back()->vertices.size());
  EXPECT_GT(carried->vertices.size(), part().head()->fields.back()->vertices.size() / 2);
  EXPECT_TRUE(view().painted().extremes.has_value());
  EXPECT_TRUE(label("facts").contains("before it")) << label("facts").toStdString();
  EXPECT_EQ(label("verdict"), "preview of an edit, not applied");
  EXPECT_TRUE(label("preview_figures").contains("Volume"));
  EXPECT_GT(accent_pixels(), 20);
  EXPECT_EQ(version(), 0U);
  EXPECT_EQ(part().head()->info.version_id, head);

  QTest::keyClick(window.get(), Qt::Key_Escape);
  ASSERT_TRUE(wait([&] { return is_final(); }));
  EXPECT_TRUE(window->tools().operations.panel().chosen().isEmpty());
  window->context().picked.clear();  // It has the same colour.
  EXPECT_EQ(accent_pixels(), 0);
  EXPECT_EQ(label("verdict"), "final");
  EXPECT_EQ(part().versions().size(), 1U);
}

TEST_F(PreviewWindow, FollowsTheLastValueAndApplyMakesTheVeryThing) {
  open_plate(false);
  choose({7}, "thicken");
  for (const double thickness : {0.0005, 0.0015, 0.001})
    window->tools().operations.panel().form()->set_values({{"thickness", thickness}});
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
  EXPECT_NEAR(preview().shown()->made.report.volume_change, 5e-6, 1e-9);  // 5000 mm2 by 1 mm.
  const auto id = preview().shown()->surface->version_id();

  press("apply");
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));

  EXPECT_EQ(part().head()->info.version_id, id);
  EXPECT_EQ(preview().shown(), nullptr);
  EXPECT_FALSE(preview().is_busy()) << "not the same once more on what was made";
  EXPECT_EQ(label("preview_state"), "");
  EXPECT_TRUE(label("form_hint").startsWith("Select")) << "nothing runs any more";
}

TEST_F(PreviewWindow, WhatIsRefusedIsExplainedWhileTheHeadStays) {
  open_plate(false);
  choose({1, 2}, "fill_hole");
  ASSERT_TRUE(wait([&] { return shows_preview(); }));

  window->context().picked.set({5});
  ASSERT_TRUE(wait([&] { return preview().refusal().has_value() && shows_head(); }));

  EXPECT_TRUE(label("preview_fault").contains("flat")) << label("preview_fault").toStdString();
  EXPECT_TRUE(label("preview_fault").contains("Select the walls of a hole"));
  EXPECT_EQ(label("preview_figures"), "");
  EXPECT_FALSE(window->findChild<QPushButton*>("apply")->isEnabled());
  EXPECT_TRUE(window->context().messages.text().isEmpty());
  EXPECT_EQ(view().current().before, nullptr);
}

TEST_F(PreviewWindow, TheMostThatWorksIsFoundAndBecomesTheValue) {
  open_plate(false);
  choose({7}, "erode");
  auto* form = window->tools().operations.panel().form();
  form->set_values({{"depth", 0.5}});
  ASSERT_TRUE(wait([&] { return preview().refusal().has_value(); }));

  press("find_most");
  ASSERT_TRUE(wait([&] { return shows_preview(); }));

  const double depth = std::get<double>(form->values().at("depth"));
  EXPECT_GT(depth, 1e-3);
  EXPECT_LT(depth, 0.1);
  EXPECT_FALSE(window->findChild<QPushButton*>("find_most")->isVisible());
  form->set_values({{"depth", 0.5}});
  ASSERT_TRUE(wait([&] { return preview().refusal().has_value(); }));
  EXPECT_TRUE(window->findChild<QPushButton*>("find_most")->isVisible()) << "another question";
}

TEST_F(PreviewWindow, WhatIsNoMatterOfSizeOffersNoSearch) {
  open_plate(false);
  choose({5}, "fill_hole");
  ASSERT_TRUE(wait([&] { return preview().refusal().has_value(); }));

  EXPECT_FALSE(window->findChild<QPushButton*>("find_most")->isVisible());
}

/// The bore 72, 73 is one of the plate's supports.
TEST_F(PreviewWindow, SupportsMoveOrForbidTheEditAsIsChosen) {
  open_plate();
  auto* row = [&] { return window->findChild<QWidget*>("policy_row"); }();
  EXPECT_EQ(row, nullptr);
  choose({1, 2}, "fill_hole");
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
  EXPECT_FALSE(window->findChild<QWidget*>("policy_row")->isVisible()) << "nothing acts there";

  choose({72, 73}, "fill_hole");
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
  auto* policy = window->findChild<QComboBox*>("load_policy");
  ASSERT_TRUE(policy->isVisible());
  const auto fate = [&] { return preview().shown()->made.report.receipt.at(0).fate; };
  EXPECT_EQ(fate(), fem::receipt_fate::reduced);

  policy->setCurrentIndex(policy->findText("forbid", Qt::MatchStartsWith));
  ASSERT_TRUE(wait([&] { return preview().refusal().has_value(); }));
  EXPECT_TRUE(label("preview_fault").contains("constraint 0 (fixed) acts on surfaces 72, 73"))
    << label("preview_fault").toStdString();

  policy->setCurrentIndex(policy->findText("move", Qt::MatchStartsWith));
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
  EXPECT_EQ(fate(), fem::receipt_fate::moved);
  press("apply");
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));
  ASSERT_TRUE(part().head()->report);
  EXPECT_EQ(part().head()->report->receipt.at(0).fate, fem::receipt_fate::moved);
}

TEST_F(PreviewWindow, CanBeTurnedOffWhichIsRememberedAndAskedForOnce) {
  open_plate(false);
  choose({1, 2}, "fill_hole");
  ASSERT_TRUE(wait([&] { return shows_preview(); }));

  window->findChild<QCheckBox*>("preview_follows")->click();
  ASSERT_TRUE(wait([&] { return shows_head(); }));
  EXPECT_FALSE(QSettings("tedit", "tedit-qt").value("preview").toBool());
  window->context().picked.set({51, 52});
  EXPECT_FALSE(preview().is_busy());

  press("preview_now");
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
  EXPECT_FALSE(preview().shown()->surface->surfaces().contains(51));
}

TEST_F(PreviewWindow, SlowOnesWaitToBeAskedFor) {
  open_plate(false);
  preview().set_slow_ms(-1);  // Every preview takes longer.
  choose({1, 2}, "fill_hole");
  ASSERT_TRUE(wait([&] { return shows_preview(); }));

  window->context().picked.set({51, 52});

  EXPECT_FALSE(preview().is_busy());
  EXPECT_EQ(preview().shown(), nullptr);
  EXPECT_TRUE(label("preview_state").contains("ask for it"));
  press("preview_now");
  ASSERT_TRUE(wait([&] { return shows_preview(); }));
}

}  // namespace
}  // namespace tedit::desktop
