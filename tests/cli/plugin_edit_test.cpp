// SPDX-License-Identifier: AGPL-3.0-or-later
// "tedit edit" and "tedit run" with a plugin that ends or harms the process that it runs in.
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "tests/cli/misdeed.hpp"

namespace tedit::test {
namespace {

struct deed_and_words {
  const char* deed;
  const char* words;
};

class HarmfulPlugin : public ::testing::TestWithParam<deed_and_words> {};

TEST_P(HarmfulPlugin, IsNamedWithWhatItDidAndLeavesNoFile) {
  const Misdeed misdeed(GetParam().deed);

  const auto result = run(misdeed.arguments);

  EXPECT_EQ(result.status, 1);
  const auto error = result.parsed()["error"];
  EXPECT_THAT(error.value("message", ""),
              HasSubstr("the operation \"rule_breaker\" of the plugin rule_breaker 1.0.0 " +
                        std::string(GetParam().words)));
  EXPECT_THAT(error.value("remedy", ""), HasSubstr("tedit plugin test"));
  EXPECT_FALSE(std::filesystem::exists(misdeed.output));
}

INSTANTIATE_TEST_SUITE_P(
  Each, HarmfulPlugin,
  ::testing::Values(
    deed_and_words{"every_surface_alone", "was killed by signal 11 (Segmentation fault)"},
    deed_and_words{"aborts", "was killed by signal 6 (Aborted)"},
    deed_and_words{"exits", "ended its process with status 0"},
    deed_and_words{"exits_politely", "ended its process with status 3"},
    deed_and_words{"closes_descriptors", "closed descriptors that are not its own"},
    deed_and_words{"writes_everywhere", "wrote to a descriptor that is not its own"},
    deed_and_words{"throws", "failed: out of luck"}),
  [](const auto& row) { return std::string(row.param.deed); });

TEST(PluginEdit, WhatItPrintsIsNotTakenForTheAnswer) {
  const Misdeed misdeed("quiet");

  const auto result = run(misdeed.arguments);

  EXPECT_EQ(result.status, 0);
  EXPECT_GT(result.parsed().value("tets_added", 0), 0) << result.out;
}

TEST(PluginEdit, AHangEndsAtTheLimit) {
  const Misdeed misdeed("hang");

  const auto result = run(misdeed.arguments + " --time-limit 0.3");

  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.parsed()["error"]["code"], "timeout");
  EXPECT_THAT(result.parsed()["error"].value("message", ""),
              HasSubstr("rule_breaker 1.0.0 did not end within 0.3 s"));
}

TEST(PluginEdit, AProcessThatItLeavesIsEnded) {
  const Misdeed misdeed("leaves_a_child");
  setenv("TEDIT_SANDBOX", "off", 1);

  const auto result = run(misdeed.arguments);  // Would wait for the end of what holds its pipe.

  unsetenv("TEDIT_SANDBOX");
  EXPECT_EQ(result.status, 0);
}

TEST(PluginEdit, ItStartsNoProcessAndIsNamed) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need processes";
#endif
  const Misdeed misdeed("leaves_a_child");

  const auto result = run(misdeed.arguments);

  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.parsed()["error"].value("message", ""),
            "the operation \"rule_breaker\" of the plugin rule_breaker 1.0.0 tried to start a "
            "process");
  EXPECT_THAT(result.parsed()["error"].value("remedy", ""),
              HasSubstr("docs/operating.md, What workers may do"));
}

TEST(PluginEdit, AnInterruptEndsAHangAtOnce) {
  const Misdeed misdeed("hang");
  const pid_t child = fork();
  if (child == 0) {
    (void)!freopen("/dev/null", "w", stderr);
    const auto command = "exec " + program + " " + misdeed.arguments + " >/dev/null";
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  // Until it runs the operation: a child with a process group of its own, unlike tedit-probe.
  const auto children =
    "/proc/" + std::to_string(child) + "/task/" + std::to_string(child) + "/children";
  const auto grandchild = [&] {
    pid_t found = 0;
    std::ifstream(children) >> found;
    return found > 0 && getpgid(found) == found ? found : 0;
  };
  pid_t operation = 0;
  for (int i = 0; i < 10000 && operation == 0; ++i, operation = grandchild())
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ASSERT_NE(operation, 0);

  kill(child, SIGINT);

  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_NE(kill(operation, 0), 0) << "the operation's process is gone, too";
}

TEST(PluginEdit, ARecipeTellsWhatThePluginDid) {
  const Misdeed misdeed("aborts");
  const auto recipe = scratch("recipe.json");
  std::ofstream(recipe) << json{{"steps",
                                 {{{"import", {{"mesh", block}}}},
                                  {{"edit", {{"operation", "rule_breaker"}, {"surfaces", {4}}}}}}}};

  const auto result = run("run --json " + recipe.string() + " --out " + scratch("out").string());

  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.parsed()["error"].value("message", ""),
              ::testing::AllOf(HasSubstr("rule_breaker"), HasSubstr("signal 6 (Aborted)")));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // They reserve terabytes.
TEST(PluginEdit, MemoryThatItEatsIsNotThatOfOthers) {
  const Misdeed misdeed("eats_memory");

  const auto [errors, ok] = errors_of("ulimit -v 1000000; " + program + " " + misdeed.arguments);

  EXPECT_FALSE(ok);
  EXPECT_THAT(errors, HasSubstr("of the plugin rule_breaker 1.0.0 ran out of memory"));
}
#endif

}  // namespace
}  // namespace tedit::test
