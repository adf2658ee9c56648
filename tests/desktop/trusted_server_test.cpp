// SPDX-License-Identifier: AGPL-3.0-or-later
// A server of wss://: the window is told what it shows, and knows it from then on.
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QThread>

#include <cstdlib>

#include <gtest/gtest.h>

#include "base/process.hpp"
#include "certs/authority.hpp"
#include "client-qt/net/remote.hpp"
#include "client/known_servers.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::desktop {
namespace {

using test::value;

class TrustedServer : public testing::Test {
protected:
  void SetUp() override {
    ::setenv("XDG_STATE_HOME", at("state").c_str(), 1);
    value(certs::init(at("ca")));
    value(certs::issue(at("ca"), {certs::role::server, "hall", {"127.0.0.1"}}, at("hall")));
    pid = value(spawn_process({TEDIT_BIN "/tedit", "serve", "--quiet", "--port", "0", "--device",
                               "cpu", "--documents", at("documents"), "--token-file", at("token"),
                               "--certificates", at("hall"), "--ready-file", at("ready")}));
    ASSERT_TRUE(wait([&] { return QFile::exists(QString::fromStdString(at("ready"))); }));
    const auto said = QJsonDocument::fromJson(read("ready")).object();
    address.url = said["url"].toString();
    fingerprint = said["certificate_sha256"].toString().toStdString();
    address.token = read("token").trimmed();
    QObject::connect(&link, &remote::untrusted, &link,
                     [this](const untrusted_server& what) { told.push_back(what); });
  }

  void TearDown() override {
    link.disconnect_now();
    kill_process(pid);
    ::unsetenv("XDG_STATE_HOME");
  }

  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder.path() / name).string();
  }

  [[nodiscard]] QByteArray read(const std::string& name) const {
    QFile file(QString::fromStdString(at(name)));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  [[nodiscard]] static bool wait(const std::function<bool()>& until) {
    QElapsedTimer clock;
    clock.start();
    while (!until() && clock.elapsed() < 60'000) {
      QCoreApplication::processEvents();
      QThread::msleep(2);
    }
    return until();
  }

  int count = 1;
  std::string name = "test";
  char* arguments[2] = {name.data(), nullptr};
  QCoreApplication application{count, arguments};
  test::scratch_folder folder;
  pid_t pid = 0;
  remote link;
  server_address address;
  std::string fingerprint;
  std::vector<untrusted_server> told;
};

TEST_F(TrustedServer, IsToldOfOnceAndAgainWhenItsCertificateChanges) {
  link.connect_to(address);
  ASSERT_TRUE(wait([&] { return told.size() == 1; }));
  EXPECT_EQ(told[0].certificate.fingerprint, fingerprint);
  EXPECT_EQ(told[0].known, "");
  EXPECT_EQ(link.current(), remote::state::offline);

  value(value(client::known_servers::of_user()).remember(told[0].place, fingerprint));
  link.connect_to(address);
  ASSERT_TRUE(wait([&] { return link.current() == remote::state::connected; }));

  value(certs::renew(at("ca"), "hall", certs::node_days, at("hall")));
  link.connect_to(address);
  ASSERT_TRUE(wait([&] { return told.size() == 2; }));
  EXPECT_EQ(told[1].known, fingerprint);
  EXPECT_NE(told[1].certificate.fingerprint, fingerprint);
}

}  // namespace
}  // namespace tedit::desktop
