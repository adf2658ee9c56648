// SPDX-License-Identifier: AGPL-3.0-or-later
// Solves that follow an edit by themselves are stopped from wherever a person looks for it.
#include "tests/desktop/window_fixture.hpp"

#include <QToolButton>

#include <csignal>

#include "client-qt/widgets/truth_line.hpp"

namespace tedit::desktop {
namespace {

class SolveStop : public Window {
protected:
  /// The process that solves; 0 while there is none.
  [[nodiscard]] pid_t solver() {
    client::connect_options options;
    options.url = window->context().link.address().url.toStdString();
    options.token = window->context().link.address().token.toStdString();
    options.client_name = "test";
    auto other = client::client::connect(options, {});
    const auto status = other ? (*other)->status() : expected<client::server_status>();
    if (other && status)
      for (const auto& worker : status->workers)
        if (worker.role == "solver" && worker.state == "ready")
          return static_cast<pid_t>(worker.pid);
    return 0;
  }

  /// An edit whose solve is surely not done: its worker stands still meanwhile.
  void stop_by(const std::function<void()>& means) {
    pid_t pid = 0;
    ASSERT_TRUE(wait([&] { return (pid = solver()) != 0; }));
    ASSERT_EQ(::kill(pid, SIGSTOP), 0);
    const auto next = static_cast<std::uint32_t>(part().versions().size());
    static const std::vector<std::vector<surface_id>> bores{{1, 2}, {51, 52}, {92, 93}};
    part().edits().apply({"fill_hole", bores.at(next - 1), {}});
    ASSERT_TRUE(
      wait([&] { return version() == next && shows_head() && part().solver().is_running(); }));
    means();
    EXPECT_TRUE(wait([&] { return part().solver().progress() == field_state::stopped; }));
    ::kill(pid, SIGCONT);
    EXPECT_FALSE(part().solver().is_running());
    EXPECT_TRUE(part().head()->fields.empty());
    EXPECT_EQ(window->findChild<truth_line*>()->verdict(), "solver stopped");
    EXPECT_FALSE(window->context().messages.text().contains("did not work"))
      << window->context().messages.text().toStdString();
  }
};

TEST_F(SolveStop, FromItsRowTheTruthLineAndTheKeyboardAndTheNextEditIsSolvedAgain) {
  open_plate();
  window->context().picked.clear();

  stop_by([&] {
    ASSERT_TRUE(window->context().all_commands.trigger("view.jobs"));
    auto* jobs = QApplication::activePopupWidget();
    auto* cancel = jobs->findChild<QPushButton*>("job_cancel");
    ASSERT_TRUE(cancel && cancel->isVisible());
    QTest::mouseClick(cancel, Qt::LeftButton);
    jobs->close();
  });
  auto* stop = window->findChild<QToolButton*>("stop_solve");
  stop_by([&] {
    ASSERT_TRUE(stop->isVisible());
    EXPECT_EQ(stop->text(), "Stop");
    QTest::mouseClick(stop, Qt::LeftButton);
  });
  stop_by([&] { QTest::keyClick(window.get(), Qt::Key_Escape); });

  EXPECT_EQ(stop->text(), "Solve");
  QTest::mouseClick(stop, Qt::LeftButton);
  ASSERT_TRUE(wait([&] { return is_final(); }));
  EXPECT_FALSE(stop->isVisible());
  ASSERT_FALSE(HasFatalFailure());
  part().edits().apply({"thicken", {7}, {{"depth", 0.001}}});
  const auto next = static_cast<std::uint32_t>(part().versions().size());
  ASSERT_TRUE(wait([&] { return version() == next && is_final(); }));
}

TEST_F(SolveStop, EscFirstEndsWhatIsNearer) {
  open_plate();
  window->context().picked.set({98});
  stop_by([&] {
    window->context().picked.set({98});
    window->tools().operations.panel().choose("erode");
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(window->tools().operations.panel().chosen().isEmpty());
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(window->context().picked.surfaces().empty());
    EXPECT_TRUE(part().solver().is_running());
    QTest::keyClick(window.get(), Qt::Key_Escape);
  });
}

}  // namespace
}  // namespace tedit::desktop
