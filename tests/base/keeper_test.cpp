// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/keeper.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/misdeed.hpp"
#include "base/process.hpp"
#include "base/program_line.hpp"
#include "tests/support/scratch.hpp"

namespace tedit {
namespace {

using ::testing::StartsWith;

/// A process that becomes a keeper, and what its child writes to its stdout.
class Keeper : public ::testing::Test {
protected:
  test::scratch_folder all_temporary;
  pid_t keeper = -1;
  unique_fd from_child;

  void SetUp() override { setenv("TMPDIR", all_temporary.path().c_str(), 1); }
  void TearDown() override { unsetenv("TMPDIR"); }

  void keep(const keeper_options& options, const std::function<int(keeper_gifts)>& child) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    from_child = unique_fd(ends[0]);
    const unique_fd to_test(ends[1]);
    keeper = fork();
    if (keeper == 0) {
      dup2(to_test.get(), STDOUT_FILENO);
      _exit(child(continue_in_child(options)));
    }
  }

  /// The next line of the child.
  std::string line() const {
    std::string text;
    for (char c = 0; read(from_child.get(), &c, 1) == 1 && c != '\n';)
      text += c;
    return text;
  }

  [[nodiscard]] std::string end() const {
    int status = 0;
    waitpid(keeper, &status, 0);
    return describe_end(status);
  }

  static void say(const std::string& text) {
    (void)!write(STDOUT_FILENO, (text + "\n").c_str(), text.size() + 1);
  }
};

keeper_options with_folder() {
  keeper_options options;
  options.temporary_folder = true;
  options.temporary_bytes = 1 << 20;
  return options;
}

/// A file of this size in the child's folder.
unique_fd fill(const std::filesystem::path& folder, std::size_t bytes) {
  unique_fd file(open((folder / "file").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
  const std::string text(bytes, 'x');
  (void)!write(file.get(), text.data(), text.size());
  return file;
}

TEST_F(Keeper, EndsAsItsChildDoes) {
  keep({}, [](auto) { return 7; });
  EXPECT_EQ(end(), "ended with status 7");
  keep({}, [](auto) { return raise(SIGKILL); });
  EXPECT_EQ(end(), "was killed by signal 9 (Killed)");
  keep({}, [](auto) { return status_of(misdeed::network); });
  EXPECT_EQ(end(), "tried to open a network connection");
}

TEST_F(Keeper, GivesAFolderThatGoesWithItsChild) {
  keep(with_folder(), [](const keeper_gifts& gifts) {
    say(std::getenv("TMPDIR"));
    return fill(gifts.temporary_folder, 1000) ? 0 : 1;
  });
  const std::filesystem::path folder = line();

  EXPECT_EQ(end(), "ended with status 0");
  EXPECT_EQ(folder.parent_path(), all_temporary.path());
  EXPECT_THAT(folder.filename().string(), StartsWith("tedit-worker-"));
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST_F(Keeper, AFullFolderEndsTheChild) {
  keep(with_folder(), [](const keeper_gifts& gifts) {
    fill(gifts.temporary_folder, 8 << 20);
    return static_cast<int>(sleep(600));
  });

  EXPECT_EQ(end(), "filled its folder for temporary files");
  EXPECT_TRUE(std::filesystem::is_empty(all_temporary.path()));
}

TEST_F(Keeper, AFileThatWasRemovedCountsWhileItIsOpen) {
  keep(with_folder(), [](const keeper_gifts& gifts) {
    const auto file = fill(gifts.temporary_folder, 8 << 20);
    std::filesystem::remove(gifts.temporary_folder / "file");
    return static_cast<int>(sleep(600));
  });

  EXPECT_EQ(end(), "filled its folder for temporary files");
}

TEST_F(Keeper, ThatWasKilledLeavesAFolderForOthersToRemove) {
  const auto wait = [](const keeper_gifts& gifts) {
    fill(gifts.temporary_folder, 1000);
    say(gifts.temporary_folder.string());
    return static_cast<int>(sleep(600));
  };
  keep(with_folder(), wait);
  const std::filesystem::path first = line();
  kill(keeper, SIGKILL);
  EXPECT_EQ(end(), "was killed by signal 9 (Killed)");
  EXPECT_TRUE(std::filesystem::exists(first));
  remove_temporary_folder(keeper);
  EXPECT_FALSE(std::filesystem::exists(first)) << "by its pool";

  keep(with_folder(), wait);
  const std::filesystem::path second = line();
  kill(keeper, SIGKILL);
  EXPECT_EQ(end(), "was killed by signal 9 (Killed)");
  keep(with_folder(), [](auto) { return 0; });
  EXPECT_EQ(end(), "ended with status 0");
  EXPECT_FALSE(std::filesystem::exists(second)) << "by the next keeper";
}

TEST_F(Keeper, HandsOnWhatItPrepared) {
  keeper_options options;
  options.prepare = [](int line) {
    return send_descriptors(line, {open("/proc/self/comm", O_RDONLY)}) ? 0 : 9;
  };
  keep(options, [](const keeper_gifts& gifts) {
    bool ended = false;
    const auto files = take_descriptors(gifts.line.get(), ended, true).all;
    char first = 0;
    return files.size() == 1 && read(files[0].get(), &first, 1) == 1 ? 3 : 4;
  });
  EXPECT_EQ(end(), "ended with status 3");

  options.prepare = [](int) { return 5; };
  keep(options, [](auto) { return static_cast<int>(sleep(600)); });
  EXPECT_EQ(end(), "ended with status 5");
}

TEST_F(Keeper, StartsTheOneProgram) {
  keeper_options options;
  options.programs = {"/bin/cat"};
  keep(options, [](keeper_gifts gifts) {
    start_programs_by(std::move(gifts.programs), {"/bin/cat"});
    const std::string text = "to and fro";
    const auto back = run_child({"/bin/cat"}, text, {}, {});
    return back && std::string(back->begin(), back->end()) == text ? 3 : 4;
  });
  EXPECT_EQ(end(), "ended with status 3");
}

}  // namespace
}  // namespace tedit
