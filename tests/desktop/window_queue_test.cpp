// SPDX-License-Identifier: AGPL-3.0-or-later
// Several commands ahead: they wait in a queue that shows, each is made in its turn.
#include "tests/desktop/window_fixture.hpp"

#include <csignal>

namespace tedit::desktop {
namespace {

class Queue : public Window {
protected:
  std::vector<pid_t> held_;

  /// Edits do not get on until `let_go`.
  void hold_edits() {
    client::connect_options options;
    options.url = window->context().link.address().url.toStdString();
    options.token = window->context().link.address().token.toStdString();
    options.client_name = "test";
    auto other = client::client::connect(options, {});
    ASSERT_TRUE(other) << render(other.error());
    const auto ready = [&] {
      held_.clear();
      if (const auto status = (*other)->status())
        for (const auto& worker : status->workers)
          if (worker.role == "modeling" && worker.state == "ready")
            held_.push_back(static_cast<pid_t>(worker.pid));
      return !held_.empty();
    };
    ASSERT_TRUE(wait(ready));
    for (const auto pid : held_)
      ASSERT_EQ(::kill(pid, SIGSTOP), 0);
  }
  void let_go() {
    for (const auto pid : held_)
      ::kill(pid, SIGCONT);
    held_.clear();
  }
  void TearDown() override {
    let_go();
    Window::TearDown();
  }

  [[nodiscard]] QStringList waiting() { return part().edits().queue().waiting(); }
  void ask_for(const std::vector<surface_id>& surfaces) {
    window->context().picked.set(surfaces);
    window->tools().operations.panel().choose("fill_hole");
    press("apply");
  }
};

TEST_F(Queue, WhatIsAskedForMeanwhileIsMadeInItsTurn) {
  open_plate(false);
  hold_edits();
  part().edits().apply({"fill_hole", {1, 2}, {}});
  EXPECT_TRUE(waiting().isEmpty());

  ask_for({51, 52});
  EXPECT_TRUE(window->context().picked.surfaces().empty()) << "it is meant for the queue";
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  ask_for({92, 93});

  EXPECT_EQ(waiting(), (QStringList{"Fill hole", "Undo", "Fill hole"}));
  auto* shown = window->findChild<QLabel*>("queue");
  EXPECT_TRUE(shown->isVisible());
  EXPECT_EQ(shown->text(), "Then: Fill hole, Undo, Fill hole");
  EXPECT_EQ(window->findChild<QPushButton*>("apply")->text(), "Apply after this");

  let_go();
  ASSERT_TRUE(wait([&] { return version() == 3 && shows_head() && waiting().isEmpty(); }));
  const auto& surfaces = part().head()->surface->surfaces();
  EXPECT_FALSE(surfaces.contains(1));
  EXPECT_TRUE(surfaces.contains(51)) << "taken back before the last";
  EXPECT_FALSE(surfaces.contains(92));
  EXPECT_FALSE(shown->isVisible());
  EXPECT_EQ(window->findChild<QPushButton*>("apply")->text(), "Apply");
}

TEST_F(Queue, CanBeEmptiedWhileWhatRunsGoesOn) {
  open_plate(false);
  hold_edits();
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ask_for({51, 52});

  press("empty_queue");
  EXPECT_TRUE(waiting().isEmpty());

  let_go();
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));
  QTest::qWait(300);
  EXPECT_EQ(version(), 1U);
  EXPECT_TRUE(part().head()->surface->surfaces().contains(51));
}

TEST_F(Queue, WhatComesAfterAFailedChangeIsNotMadeAndThatIsSaid) {
  open_plate(false);
  hold_edits();
  part().edits().apply({"fill_hole", {5}, {}});  // A flat wall.
  ask_for({51, 52});
  ask_for({92, 93});

  let_go();
  ASSERT_TRUE(wait([&] { return waiting().isEmpty() && !part().foreground().current(); }));
  EXPECT_EQ(version(), 0U);
  EXPECT_TRUE(window->context().messages.text().contains("not made: Fill hole, Fill hole"))
    << window->context().messages.text().toStdString();
}

TEST_F(Queue, AFormThatWasFilledMeanwhileIsPreviewedOnceNothingRuns) {
  open_plate(false);
  hold_edits();
  part().edits().apply({"fill_hole", {1, 2}, {}});
  window->context().picked.set({51, 52});
  window->tools().operations.panel().choose("fill_hole");
  let_go();

  const auto& preview = window->tools().operations.panel().preview();
  ASSERT_TRUE(wait([&] { return version() == 1 && preview.shown() && !preview.is_busy(); }));
}

}  // namespace
}  // namespace tedit::desktop
