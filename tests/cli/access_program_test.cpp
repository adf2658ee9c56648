// SPDX-License-Identifier: AGPL-3.0-or-later
// A server that is reached by TLS, and its users, as people and scripts use them.
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "base/process.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::test {
namespace {

namespace fs = std::filesystem;

std::string text_in(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A running server with a certificate for 127.0.0.1.
class AccessProgram : public ::testing::Test {
protected:
  AccessProgram() {
    ::setenv("XDG_STATE_HOME", at("state").c_str(), 1);
    EXPECT_EQ(run("certs init " + at("ca")).status, 0);
    EXPECT_EQ(run("certs issue " + at("ca") + " --role server --name hall --host 127.0.0.1 -o " +
                  at("hall"))
                .status,
              0);
    pid_ = value(spawn_process({program, "serve", "--quiet", "--port", "0", "--device", "cpu",
                                "--documents", at("documents"), "--token-file", at("token"),
                                "--certificates", at("hall"), "--ready-file", at("ready")}));
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!fs::exists(at("ready")) && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    state_ = json::parse(text_in(at("ready")), nullptr, false);
  }
  ~AccessProgram() override {
    kill_process(pid_);
    ::unsetenv("XDG_STATE_HOME");
  }

  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder_.path() / name).string();
  }
  [[nodiscard]] std::string url() const { return state_["url"]; }
  [[nodiscard]] std::string fingerprint() const { return state_["certificate_sha256"]; }

  /// "tedit status" of this server.
  [[nodiscard]] outcome ask(const std::string& more, const std::string& token = "token") const {
    return run("status --json --server " + url() + " --token-file " + at(token) + " " + more);
  }

  json users(const std::string& arguments) const {
    const auto result = run("users " + arguments + " --json --users-file " + at("users.sqlite"));
    EXPECT_EQ(result.status, 0) << arguments << ": " << result.out;
    return result.parsed();
  }

private:
  scratch_folder folder_;
  pid_t pid_ = 0;
  json state_;
};

TEST_F(AccessProgram, AServerIsTrustedOnceAndKnownFromThenOn) {
  EXPECT_THAT(url(), HasSubstr("wss://127.0.0.1:"));
  const auto stranger = ask("");
  EXPECT_EQ(stranger.status, 69);
  EXPECT_EQ(stranger.parsed()["error"]["code"], "untrusted_server");
  EXPECT_THAT(stranger.out, HasSubstr(fingerprint()));

  const auto known = fs::path(at("state")) / "tedit/known_servers";
  const std::string wrong = "00" + fingerprint().substr(2);
  EXPECT_EQ(ask("--trust " + (wrong == fingerprint() ? "11" + wrong.substr(2) : wrong)).status, 69);
  EXPECT_FALSE(fs::exists(known));
  EXPECT_EQ(ask("--trust " + fingerprint()).status, 0);
  struct stat about {};
  ASSERT_EQ(::stat(known.c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777, 0600u);
  EXPECT_THAT(text_in(known), HasSubstr("127.0.0.1:"));
  EXPECT_EQ(ask("").status, 0);
  EXPECT_EQ(ask("--server-ca " + at("ca/ca.crt")).status, 0);

  EXPECT_EQ(run("certs renew " + at("ca") + " --name hall -o " + at("hall")).status, 0);

  const auto changed = ask("");
  EXPECT_EQ(changed.status, 69);
  EXPECT_THAT(changed.parsed()["error"]["message"].get<std::string>(),
              ::testing::AllOf(HasSubstr("shows another certificate"), HasSubstr(fingerprint())));
  EXPECT_THAT(changed.parsed()["error"]["remedy"].get<std::string>(), HasSubstr("operator"));
  EXPECT_EQ(ask("--server-ca " + at("ca/ca.crt")).status, 0);
}

TEST_F(AccessProgram, AUserIsMadeGivenATokenAndForgotten) {
  const std::string trusted = "--server-ca " + at("ca/ca.crt");
  const auto made = users("add anna --role view --expires 30d -o " + at("anna"));
  EXPECT_EQ(made["user"], "anna");
  EXPECT_FALSE(made.contains("token"));
  struct stat about {};
  ASSERT_EQ(::stat(at("anna").c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777, 0600u);
  EXPECT_EQ(ask(trusted, "anna").status, 0);
  EXPECT_TRUE(ask(trusted, "anna").parsed()["clients"].empty());
  const auto seen = ask(trusted).parsed()["clients"];
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0]["role"], "admin");

  const auto shown = users("token anna --expires never");
  EXPECT_EQ(shown["token"].get<std::string>().size(), 64u);
  EXPECT_TRUE(shown["until"].is_null());
  users("role anna --role edit");
  const auto all = users("list")["users"];
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0]["role"], "edit");
  EXPECT_EQ(all[0]["tokens"].size(), 2u);

  users("withdraw " + std::to_string(made["number"].get<int>()));
  EXPECT_EQ(ask(trusted, "anna").status, 1);
  std::ofstream(at("anna")) << shown["token"].get<std::string>();
  EXPECT_EQ(ask(trusted, "anna").status, 0);
  users("remove anna");
  EXPECT_EQ(ask(trusted, "anna").status, 1);
  EXPECT_TRUE(users("list")["users"].empty());
}

TEST_F(AccessProgram, UsersRefuseWhatCannotBe) {
  const std::string file = " --users-file " + at("users.sqlite");
  EXPECT_EQ(run("users").status, 2);
  EXPECT_EQ(run("users add anna --role owner" + file).status, 2);
  EXPECT_EQ(run("users add anna" + file).status, 2);
  for (const char* expires : {"0d", "d", "90", "90w", "-1d", "99999d", "1e3d", ""})
    EXPECT_EQ(
      run("users add anna --role view --expires '" + std::string(expires) + "'" + file).status, 2)
      << expires;
  EXPECT_EQ(run("users remove anna --json" + file).parsed()["error"]["code"], "not_found");
  EXPECT_EQ(run("users list" + file).out, "there are no users\n");
}

}  // namespace
}  // namespace tedit::test
