// SPDX-License-Identifier: AGPL-3.0-or-later
// The connection breaks while a change is on its way: it is made once, and the window knows.
#include <QCoreApplication>
#include <QTemporaryDir>
#include <QThread>
#include <QUrl>

#include <gtest/gtest.h>

#include "client-qt/model/document.hpp"
#include "client-qt/net/local_server.hpp"
#include "tests/support/slow_proxy.hpp"

namespace tedit::desktop {
namespace {

class LostAnswer : public testing::Test {
protected:
  void SetUp() override {
    QObject::connect(&far, &local_server::ready, &link,
                     [this](const server_address& where) { address = where; });
    QObject::connect(&part, &document::failed, &link, [this](const QString& what, const error& e) {
      failures += what + ": " + QString::fromStdString(render(e)) + "\n";
    });
    far.start();
    ASSERT_TRUE(wait([&] { return !address.url.isEmpty(); }));
    direct = address;
    const auto port = QUrl(address.url).port();
    line = std::make_unique<test::slow_proxy>(
      static_cast<std::uint16_t>(port),
      test::slow_proxy::line{std::chrono::milliseconds(20), 20'000'000});
    address.url.replace(QString::number(port), QString::number(line->port()));
    link.connect_to(address);
    ASSERT_TRUE(wait([&] { return link.current() == remote::state::connected; }));
    part.files().import(TEDIT_EXAMPLES "/ctc01_plate/ctc01_plate.coarse.msh", {});
    ASSERT_TRUE(wait([&] { return is_at(0); }));
  }

  void TearDown() override { link.disconnect_now(); }

  [[nodiscard]] static bool wait(const std::function<bool()>& until) {
    QElapsedTimer clock;
    clock.start();
    while (!until() && clock.elapsed() < 60'000) {
      QCoreApplication::processEvents();
      QThread::msleep(2);
    }
    return until();
  }

  /// Whether this version is the head and nothing is on its way.
  [[nodiscard]] bool is_at(std::uint32_t version) const {
    return part.head() && part.head()->info.number == version && !part.foreground().current() &&
           link.running() == 0 && link.current() == remote::state::connected;
  }

  [[nodiscard]] std::size_t versions() { return versions(link, {}); }

  /// @param name of a document that this connection has not opened yet.
  [[nodiscard]] static std::size_t versions(remote& by, const std::string& name) {
    std::size_t count = 0;
    by.run<client::history>(
      [name](client::client& c, const execution&) -> expected<client::history> {
        if (!name.empty())
          if (const auto opened = c.open(name, false, false); !opened)
            return fail(opened.error());
        return c.get_history();
      },
      [&](expected<client::history> all) { count = all ? all->versions.size() : 99; });
    EXPECT_TRUE(wait([&] { return count > 0; }));
    return count;
  }

  int words = 1;
  std::string name = "test";
  char* arguments[2] = {name.data(), nullptr};
  QCoreApplication application{words, arguments};
  QTemporaryDir folder;
  local_server far{folder.path()};
  remote link;
  document part{link};
  server_address address;
  server_address direct;  ///< The same, without the line that breaks.
  std::unique_ptr<test::slow_proxy> line;
  QString failures;
};

TEST_F(LostAnswer, AnEditThatNeverArrivedIsMadeOnTheNextConnection) {
  line->stall(true);
  part.edits().apply({"fill_hole", {1, 2}, {}});
  EXPECT_TRUE(wait([&] { return link.running() > 0; }));
  line->cut(false);
  line->stall(false);

  ASSERT_TRUE(wait([&] { return is_at(1); })) << failures.toStdString();
  EXPECT_EQ(versions(), 2u);
  EXPECT_EQ(failures, "");
}

TEST_F(LostAnswer, AnEditWhoseAnswerWasLostIsNotMadeTwice) {
  remote beside;
  beside.connect_to(direct);
  ASSERT_TRUE(wait([&] { return beside.current() == remote::state::connected; }));
  const auto document = part.name().toStdString();
  // The server hears of it; what it says from then on stays in a line that breaks later.
  QObject::connect(&part.foreground(), &foreground_work::changed, &link, [this] {
    if (part.foreground().current() && !part.foreground().current()->stage.isEmpty())
      line->stall(true);
  });
  part.edits().apply({"fill_hole", {1, 2}, {}});
  ASSERT_TRUE(wait([&] { return versions(beside, document) == 2; })) << "it is not made";
  EXPECT_FALSE(is_at(1)) << "the answer came";
  QObject::disconnect(&part.foreground(), &foreground_work::changed, &link, nullptr);
  line->cut(false);
  line->stall(false);

  ASSERT_TRUE(wait([&] { return is_at(1); })) << failures.toStdString();
  EXPECT_EQ(versions(), 2u);
  EXPECT_EQ(failures, "");
  part.edits().undo();
  ASSERT_TRUE(wait([&] { return is_at(0); })) << failures.toStdString();
  beside.disconnect_now();
}

TEST_F(LostAnswer, WithoutAWayBackTheLossIsTold) {
  line->stall(true);
  part.edits().apply({"fill_hole", {1, 2}, {}});
  EXPECT_TRUE(wait([&] { return link.running() > 0; }));
  line->cut(true);
  ASSERT_TRUE(wait([&] { return link.current() == remote::state::lost; }));
  EXPECT_EQ(failures, "");
  link.disconnect_now();

  EXPECT_TRUE(wait([&] { return failures.contains("connection"); })) << failures.toStdString();
}

}  // namespace
}  // namespace tedit::desktop
