// SPDX-License-Identifier: AGPL-3.0-or-later
// What a plugin logs can be read wherever it runs.
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "tests/cli/misdeed.hpp"

namespace tedit::test {
namespace {

namespace fs = std::filesystem;

/// A recipe of one edit by the plugin.
std::string one_edit() {
  const auto recipe = scratch("recipe.json");
  const json edit{
    {"operation", "rule_breaker"}, {"surfaces", {4}}, {"parameters", {{"distance", 0.0001}}}};
  std::ofstream(recipe) << json{{"steps", {{{"import", {{"mesh", block}}}}, {{"edit", edit}}}}};
  return recipe;
}

/// "tedit serve" with the arguments that the window gives to a server of its own, and its log.
class served {
public:
  explicit served(const fs::path& folder) : folder_(folder) {
    fs::remove_all(folder);
    fs::create_directories(folder / "documents");
    child_ = fork();
    if (child_ == 0) {
      const int log = open(log_file().c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
      dup2(log, STDOUT_FILENO);
      dup2(log, STDERR_FILENO);
      execl(program.c_str(), program.c_str(), "serve", "--port", "0", "--documents",
            (folder / "documents").c_str(), "--token-file", token().c_str(), "--ready-file",
            ready().c_str(), nullptr);
      _exit(127);
    }
    for (int i = 0; i < 6000 && address_.empty(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      std::ifstream in(ready());
      const auto state = json::parse(in, nullptr, false);
      address_ = state.is_object() ? state.value("url", "") : "";
    }
  }
  served(const served&) = delete;
  served& operator=(const served&) = delete;
  ~served() {
    kill(child_, SIGTERM);
    waitpid(child_, nullptr, 0);
  }

  [[nodiscard]] const std::string& address() const { return address_; }
  [[nodiscard]] fs::path token() const { return folder_ / "token"; }
  [[nodiscard]] std::string log() const {
    std::ifstream in(log_file());
    return {std::istreambuf_iterator<char>(in), {}};
  }

private:
  [[nodiscard]] fs::path ready() const { return folder_ / "ready.json"; }
  [[nodiscard]] fs::path log_file() const { return folder_ / "server.log"; }

  fs::path folder_;
  pid_t child_ = -1;
  std::string address_;
};

TEST(PluginLog, ComesOnStderrOfTheCommandLine) {
  const Misdeed misdeed("logs");

  const auto [errors, ok] = errors_of(program + " " + misdeed.arguments);

  EXPECT_TRUE(ok);
  EXPECT_THAT(errors, HasSubstr("rule_breaker: two\nrule_breaker: lines of "));
}

TEST(PluginLog, ComesOnStderrOfARecipeWithItsOwnServer) {
  const Misdeed misdeed("logs");
  const auto recipe = one_edit();

  const auto [errors, ok] =
    errors_of(program + " run " + recipe + " --out " + scratch("out").string());

  EXPECT_TRUE(ok) << errors;
  EXPECT_THAT(errors, HasSubstr("rule_breaker: two\n"));
}

TEST(PluginLog, ComesInTheLogOfAServerAsTheWindowStartsIt) {
  const Misdeed misdeed("logs");
  const served server(scratch("server"));
  ASSERT_FALSE(server.address().empty()) << server.log();

  const auto [errors, ok] =
    errors_of(program + " run " + one_edit() + " --out " + scratch("out").string() + " --server " +
              server.address() + " --token-file " + server.token().string());

  EXPECT_TRUE(ok) << errors;
  EXPECT_THAT(server.log(), HasSubstr("rule_breaker: two\n"));
  EXPECT_THAT(server.log(), HasSubstr("rule_breaker: lines of "));
  EXPECT_THAT(errors, ::testing::Not(HasSubstr("rule_breaker: two"))) << "it ran in the server";
}

TEST(PluginLog, IsToldByTheConformanceKitWithEachCheck) {
  const Misdeed misdeed("logs");

  const auto tested =
    run("plugin test " TEDIT_RULE_BREAKER "/rule_breaker.so --json --check quiet");

  EXPECT_EQ(tested.status, 0) << tested.out;
  const auto last = tested.parsed()["checks"].back();
  ASSERT_EQ(last["check"], "quiet");
  ASSERT_GE(last["log"].size(), 2u) << last.dump();
  EXPECT_EQ(last["log"][0], "rule_breaker: two");
  EXPECT_THAT(last["log"][1].get<std::string>(), HasSubstr("rule_breaker: lines of "));
}

}  // namespace
}  // namespace tedit::test
