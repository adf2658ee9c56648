// SPDX-License-Identifier: AGPL-3.0-or-later
// A copy that may start no program has one started by its caller.
#include "base/program_line.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/forked_call.hpp"
#include "tests/support/said.hpp"
#include "tests/support/scratch.hpp"

namespace tedit {
namespace {

using ::testing::HasSubstr;

/// A program of these lines of shell.
std::filesystem::path script(const test::scratch_folder& folder, const std::string& lines) {
  const auto file = folder.path() / "script";
  std::ofstream(file) << "#!/bin/sh\n" << lines << "\n";
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return file;
}

/// What `work` says in a copy for which `program` is started.
std::string said(const std::filesystem::path& program, const std::function<std::string()>& work) {
  forked_limits limits;
  limits.confine = []() -> expected<void> { return {}; };
  limits.programs = {program};
  const auto heard = test::said_in_copy(limits, work);
  EXPECT_TRUE(heard.has_value()) << render(heard.error());
  return heard.value_or("");
}

std::string run(const std::filesystem::path& program, const std::string& input,
                const child_limits& limits = {}) {
  const auto done = run_child({program.string()}, input, limits, {});
  return done ? std::string(done->begin(), done->end()) : done.error().message;
}

TEST(ProgramLine, TheProgramHasInputAndOutputOfWhoAsked) {
  const std::string large(std::size_t{3} << 20, 'x');

  EXPECT_EQ(said("/bin/cat", [&] { return run("/bin/cat", large); }), large);
}

TEST(ProgramLine, SeveralRunAtOnce) {
  EXPECT_EQ(
    said("/bin/cat",
         [] {
           std::array<std::string, 4> all;
           {
             std::vector<std::jthread> threads;
             for (std::size_t i = 0; i < all.size(); ++i)
               threads.emplace_back([&all, i] { all[i] = run("/bin/cat", std::to_string(i)); });
           }
           return all[0] + all[1] + all[2] + all[3];
         }),
    "0123");
}

/// More than a pipe holds: it is written when the program has ended.
TEST(ProgramLine, AProgramThatReadsNothingEndsNobodyElse) {
  signal(SIGPIPE, SIG_DFL);

  EXPECT_EQ(run("/bin/false", std::string(1 << 20, 'x')), "false gave up (exit status 1)");
}

TEST(ProgramLine, EachProgramOfTheListIsStarted) {
  forked_limits limits;
  limits.confine = []() -> expected<void> { return {}; };
  limits.programs = {"/bin/false", "/bin/cat"};
  const auto heard = test::said_in_copy(
    limits, [] { return run("/bin/cat", "one") + ", " + run("/bin/false", "two"); });

  EXPECT_EQ(heard.value_or(""), "one, false gave up (exit status 1)");
}

TEST(ProgramLine, NoOtherProgramIsStarted) {
  EXPECT_THAT(said("/bin/cat", [] { return run("/bin/true", ""); }),
              HasSubstr("may not start /bin/true"));
}

TEST(ProgramLine, HowItEndedIsHandedOn) {
  const test::scratch_folder folder;
  const auto gives_up = script(folder, "exit 7");
  EXPECT_EQ(said(gives_up, [&] { return run(gives_up, ""); }), "script gave up (exit status 7)");
  const auto crashes = script(folder, "kill -SEGV $$");
  EXPECT_EQ(said(crashes, [&] { return run(crashes, ""); }), "script crashed (signal 11)");
}

TEST(ProgramLine, OneThatIsNotWantedAnyMoreIsEnded) {
  const test::scratch_folder folder;
  const auto note = folder.path() / "pid";
  const auto hangs = script(folder, "echo $$ > " + note.string() + "; exec sleep 600");

  const auto text = said(hangs, [&] {
    auto ended = run(hangs, "", {std::chrono::milliseconds(300), 0});
    for (int i = 0; i < 1000 && !std::filesystem::exists(note); ++i)
      ended = run(hangs, "", {std::chrono::milliseconds(1000), 0});
    return ended;
  });

  EXPECT_THAT(text, HasSubstr("did not end within its time limit"));
  pid_t pid = 0;
  std::ifstream(note) >> pid;
  ASSERT_GT(pid, 0);
  EXPECT_NE(kill(pid, 0), 0) << "it was waited for, too";
}

TEST(ProgramLine, ACopyThatIsConfinedHasNoFileOfItsCaller) {
  const int open_here = open("/dev/null", O_RDONLY);
  EXPECT_EQ(said({}, [&] { return std::string(fcntl(open_here, F_GETFD) < 0 ? "no" : "yes"); }),
            "no");
  close(open_here);
}

TEST(ProgramLine, DescriptorsAreHandedOver) {
  auto ends = test::value(make_line());
  ASSERT_TRUE(send_descriptors(ends.ours.get(), {STDIN_FILENO, STDERR_FILENO}));
  bool ended = false;

  EXPECT_EQ(take_descriptors(ends.theirs.get(), ended).all.size(), 2U);
  EXPECT_FALSE(ended);
  EXPECT_TRUE(take_descriptors(ends.theirs.get(), ended).all.empty());
  EXPECT_FALSE(ended) << "nothing more was sent";
  ends.ours.reset();
  EXPECT_TRUE(take_descriptors(ends.theirs.get(), ended, true).all.empty());
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace tedit
