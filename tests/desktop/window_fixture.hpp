// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest/QtTest>

#include <sstream>

#include <gtest/gtest.h>

#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/view/overlay.hpp"
#include "client-qt/view/viewport.hpp"
#include "client-qt/widgets/banner.hpp"
#include "client-qt/window/main_window.hpp"

namespace tedit::desktop {

/// The real window with a server process of its own, driven as a person would.
class Window : public ::testing::Test {
protected:
  static constexpr int patience_ms = 120'000;  ///< The server gives way to whatever else runs.

  QTemporaryDir state;
  std::unique_ptr<main_window> window;

  void SetUp() override {
    ::setenv("TEDIT_CAD_PRIORITY", "normal", 1);  // The machine is never idle while tests run.
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, state.path());
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, state.path());
    window = std::make_unique<main_window>(state.path());
    // Where a preview took long nobody asks for the next by himself, and the tests would wait for
    // it on a machine that has much else to do.
    window->tools().operations.panel().preview().set_slow_ms(1e9);
    window->resize(1200, 800);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    QApplication::setActiveWindow(window.get());  // No window manager does it here.
  }

  void TearDown() override { window.reset(); }

  static QString plate() { return TEDIT_EXAMPLES "/ctc01_plate/ctc01_plate.coarse.msh"; }
  static QString loads() { return TEDIT_EXAMPLES "/ctc01_plate/load_case.json"; }

  [[nodiscard]] document& part() { return window->context().part; }
  [[nodiscard]] viewport& view() { return window->context().view; }

  [[nodiscard]] testing::AssertionResult wait(const std::function<bool()>& until) {
    if (QTest::qWaitFor(until, patience_ms))
      return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "waited " << patience_ms / 1000
           << " s; message: " << window->context().messages.text().toStdString() << "\n"
           << state_now();
  }

  /// For who reads that a wait was in vain.
  [[nodiscard]] std::string state_now() {
    const auto* head = part().head();
    const auto& shown = view().current();
    const auto version_of = [](const auto& what) { return what ? what->version_id() : "none"; };
    std::ostringstream out;
    out << "connection " << static_cast<int>(window->context().link.current()) << ", version "
        << version() << (head ? " " + head->info.version_id : "") << ", fields "
        << static_cast<int>(part().solver().progress()) << ", activity "
        << (part().foreground().current() ? part().foreground().current()->title.toStdString()
                                          : "none")
        << ", view " << (view().is_settled() ? "settled" : "at work") << "\nhead's surface "
        << version_of(head ? head->surface : nullptr) << "\nshown surface  "
        << version_of(shown.surface) << "\nshown field    " << version_of(shown.field);
    return out.str();
  }

  [[nodiscard]] bool shows_head() {
    const auto* head = part().head();
    return head && head->surface && view().is_settled() && !part().foreground().current() &&
           view().current().surface == head->surface;
  }

  [[nodiscard]] bool is_final() {
    const auto field = view().current().field;
    return shows_head() && part().solver().progress() == field_state::converged && field &&
           field->version_id() == part().head()->info.version_id;
  }

  void open_plate(bool with_loads = true) {
    window->tools().documents.open_file(plate(), with_loads ? QStringList{loads()} : QStringList{});
    ASSERT_TRUE(wait([&] {
      return (with_loads ? is_final() : shows_head()) && !part().operations().operations.empty();
    }));
  }

  /// A click where the surface can be seen.
  void click_surface(surface_id id, Qt::KeyboardModifiers modifiers = {}) {
    const auto place = view().visible_point(id);
    ASSERT_TRUE(place.has_value()) << "surface " << id << " is not in sight";
    QTest::mouseClick(&view(), Qt::LeftButton, modifiers, view().to_widget(*place).toPoint());
  }

  void press(const char* button) {
    auto* found = window->findChild<QPushButton*>(button);
    ASSERT_NE(found, nullptr) << button;
    ASSERT_TRUE(found->isEnabled()) << button;
    QTest::mouseClick(found, Qt::LeftButton);
  }

  [[nodiscard]] std::uint32_t version() { return part().head() ? part().head()->info.number : 99; }
};

}  // namespace tedit::desktop
