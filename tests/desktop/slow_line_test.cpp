// SPDX-License-Identifier: AGPL-3.0-or-later
// A server at the end of a bad line: 100 ms each way, 200 kB/s, and worse.
#include "tests/desktop/window_fixture.hpp"

#include <csignal>

#include "client-qt/model/stall_watch.hpp"
#include "client-qt/tools/section/section_bar.hpp"
#include "tests/support/slow_proxy.hpp"

namespace tedit::desktop {
namespace {

class SlowLine : public Window {
protected:
  std::unique_ptr<local_server> far;
  std::unique_ptr<test::slow_proxy> line;
  server_address address;

  void SetUp() override {
    Window::SetUp();
    far = std::make_unique<local_server>(state.path() + "/far");
    QObject::connect(far.get(), &local_server::ready, window.get(),
                     [this](const server_address& where) { address = where; });
    far->start();
    ASSERT_TRUE(wait([&] { return !address.url.isEmpty(); }));
    const auto port = QUrl(address.url).port();
    line = std::make_unique<test::slow_proxy>(static_cast<std::uint16_t>(port),
                                              test::slow_proxy::line{});
    ASSERT_NE(line->port(), 0);
    address.url.replace(QString::number(port), QString::number(line->port()));
    window->tools().connection.connect_to(address);
    ASSERT_TRUE(wait([&] { return window->context().link.current() == remote::state::connected; }));
  }

  void TearDown() override {
    Window::TearDown();
    line.reset();
    far.reset();
  }

  [[nodiscard]] QString label(const char* name) { return window->findChild<QLabel*>(name)->text(); }

  /// What the server has, on a connection of its own that is not slow.
  [[nodiscard]] client::history truth() {
    client::connect_options options;
    options.url = address.url.toStdString();
    options.token = address.token.toStdString();
    options.client_name = "test";
    auto other = client::client::connect(options, {});
    EXPECT_TRUE(other && (*other)->open(part().name().toStdString(), false, false));
    const auto all = (*other)->get_history();
    EXPECT_TRUE(all.has_value());
    return all.value_or(client::history{});
  }

  /// An edit that was on its way may still be told of.
  void expect_nothing_lost() {
    client::history all;
    ASSERT_NE(part().head(), nullptr);
    EXPECT_TRUE(wait([&] {
      all = truth();
      return part().head()->info.number == all.head && part().head()->surface != nullptr;
    }));
    ASSERT_LT(all.head, all.versions.size());
    EXPECT_EQ(part().head()->info.version_id, all.versions[all.head].version_id);
    EXPECT_EQ(part().head()->surface->total_facets(), all.versions[all.head].boundary_facets);
  }
};

TEST_F(SlowLine, TheWindowNeverWaitsAndSaysWhatIsSlow) {
  open_plate(false);
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && shows_head(); }));

  stall_watch watch;
  QElapsedTimer stalled;
  stalled.start();
  line->stall(true);
  ASSERT_TRUE(wait([&] { return label("server").contains("no answer for"); }));
  ASSERT_TRUE(wait([&] { return window->context().messages.text().contains("slow"); }));
  const auto waits = watch.take();
  const auto stall_ms = static_cast<double>(stalled.elapsed());
  line->stall(false);
  ASSERT_TRUE(wait([&] { return window->context().messages.text().isEmpty(); }));

  // The line stood still for more than four seconds; what waits for it would wait as long.
  EXPECT_GT(stall_ms, 4000);
  EXPECT_GT(waits.samples, 20U);
  EXPECT_LT(waits.worst_ms, stall_ms / 2);
  EXPECT_GE(window->context().link.latency_ms(), 200);
  expect_nothing_lost();
}

TEST_F(SlowLine, AnEditThatIsHeldUpCanBeCancelled) {
  open_plate(false);
  line->stall(true);
  part().edits().apply({"remove_surfaces", {3}, {}});
  ASSERT_TRUE(part().foreground().current().has_value());

  press("cancel");
  EXPECT_EQ(part().foreground().current()->stage, "cancelling");
  EXPECT_FALSE(window->findChild<QPushButton*>("cancel")->isEnabled());
  line->stall(false);
  ASSERT_TRUE(wait([&] { return !part().foreground().current() && shows_head(); }));

  EXPECT_TRUE(window->context().messages.text().isEmpty())
    << window->context().messages.text().toStdString();
  expect_nothing_lost();
}

TEST_F(SlowLine, ASectionThatIsHeldUpCanBeCancelledAndItsLateAnswerIsDropped) {
  open_plate(false);
  line->stall(true);
  window->tools().section.bar().set_plane({0, 0, 0.001}, {0, 0, 1});  // Its cap is seen from here.
  ASSERT_TRUE(window->context().all_commands.trigger("view.jobs"));
  auto* jobs = QApplication::activePopupWidget();
  ASSERT_NE(jobs, nullptr);
  auto* cancel = jobs->findChild<QPushButton*>("job_cancel");
  ASSERT_NE(cancel, nullptr);

  QTest::mouseClick(cancel, Qt::LeftButton);
  EXPECT_TRUE(part().work().all().empty());
  jobs->close();
  line->stall(false);
  ASSERT_TRUE(wait([&] { return window->context().link.running() == 0; }));
  const auto hollow = window->context().over.picture();
  EXPECT_TRUE(window->context().messages.text().isEmpty())
    << window->context().messages.text().toStdString();

  window->tools().section.bar().set_on(true);  // Asks anew.
  ASSERT_TRUE(
    wait([&] { return window->context().link.running() == 0 && part().work().all().empty(); }));
  EXPECT_NE(window->context().over.picture(), hollow);
}

TEST_F(SlowLine, ALineThatBreaksInTheMiddleOfAStreamLosesNothing) {
  window->tools().documents.open_file(plate(), {});
  ASSERT_TRUE(wait([&] { return part().head() != nullptr; }));
  EXPECT_EQ(part().head()->surface, nullptr) << "its 300 kB are on their way";

  line->cut(true);
  ASSERT_TRUE(wait([&] { return window->context().link.current() == remote::state::lost; }));
  EXPECT_TRUE(window->context().messages.text().contains("lost"));
  emit part().failed("Fill hole", {ec::invalid_argument, "no such hole", "choose a wall", "here"});
  const auto& said = window->context().messages;
  EXPECT_TRUE(said.text().contains("lost")) << "an error does not take its place";
  EXPECT_TRUE(said.text().contains("Choose a wall."));
  EXPECT_TRUE(wait([&] { return said.height() == said.heightForWidth(said.width()); }))
    << "all of it can be read";
  said.findChild<QPushButton*>("close")->click();
  line->mend();
  ASSERT_TRUE(wait([&] { return shows_head(); }));
  EXPECT_TRUE(window->context().messages.text().isEmpty());
  expect_nothing_lost();

  // Once more while an edit is on its way: it is made, and once.
  part().edits().apply({"fill_hole", {1, 2}, {}});
  QTest::qWait(150);
  line->cut(false);
  ASSERT_TRUE(wait([&] {
    return window->context().link.current() == remote::state::connected &&
           !part().foreground().current() && version() == 1 && shows_head() &&
           window->context().link.running() == 0;
  }));
  expect_nothing_lost();
  EXPECT_EQ(truth().versions.size(), 2U);
}

TEST_F(SlowLine, FieldsThatAreHereDoNotComeAgain) {
  window->tools().documents.open_file(plate(), {loads()});
  ASSERT_TRUE(wait([&] { return is_final(); }));
  window->tools().results.panel().set_field(shown_field::safety_factor);
  ASSERT_TRUE(wait([&] { return view().painted().extremes.has_value(); }));
  const auto before = part().head()->fields;
  ASSERT_EQ(before.size(), 1U);

  line->cut(false);
  ASSERT_TRUE(wait([&] { return window->context().link.current() != remote::state::connected; }));
  ASSERT_TRUE(wait([&] {
    return window->context().link.current() == remote::state::connected &&
           window->context().link.running() == 0 && is_final();
  }));
  EXPECT_EQ(part().head()->fields, before);
  // An edit is solved as before, and its field has what is shown.
  part().edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return version() == 1 && is_final(); }));
  EXPECT_FALSE(part().head()->fields.front()->values.of("safety_factor").empty());
}

TEST_F(SlowLine, PreviewsFollowTheLastValueOverIt) {
  open_plate(false);
  window->context().picked.set({7});
  window->tools().operations.panel().choose("thicken");
  for (const double depth : {0.0005, 0.0015, 0.001}) {
    window->tools().operations.panel().form()->set_values({{"depth", depth}});
    QTest::qWait(live_preview::quiet_ms + 50);  // Each is asked for.
  }
  auto& preview = window->tools().operations.panel().preview();

  ASSERT_TRUE(wait([&] { return preview.shown() && !preview.is_busy(); }));
  EXPECT_NEAR(preview.shown()->made.report.volume_change, 5e-6, 1e-9);
  EXPECT_EQ(version(), 0U);
  expect_nothing_lost();
}

}  // namespace
}  // namespace tedit::desktop
