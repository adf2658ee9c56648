// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/memory.hpp"
#include "base/processors.hpp"

#include <fstream>

#include <gtest/gtest.h>

namespace tedit {
namespace {

/// A root folder with files that a test writes.
class Memory : public ::testing::Test {
protected:
  void SetUp() override { std::filesystem::remove_all(root_); }
  void TearDown() override { std::filesystem::remove_all(root_); }

  void write(const std::string& path, const std::string& text) const {
    std::filesystem::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }

  std::filesystem::path root_ = std::filesystem::path(::testing::TempDir()) /
                                ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(Memory, WhatTheMachineHasCounts) {
  write("proc/meminfo", "MemTotal:  4000 kB\nMemFree: 10 kB\nMemAvailable:    2048 kB\n");

  const auto room = available_memory(root_);

  EXPECT_EQ(room.bytes, 2048u << 10);
  EXPECT_EQ(room.limit, "the machine");
}

TEST_F(Memory, TheTightestGroupOnTheWayUpCounts) {
  write("proc/meminfo", "MemAvailable: 999999 kB\n");
  write("proc/self/cgroup", "0::/a/b\n");
  write("sys/fs/cgroup/a/memory.max", "1000000\n");
  write("sys/fs/cgroup/a/memory.current", "400000\n");
  write("sys/fs/cgroup/a/memory.stat", "anon 1\ninactive_file 100000\n");
  write("sys/fs/cgroup/a/b/memory.max", "max\n");
  write("sys/fs/cgroup/a/b/memory.current", "300000\n");

  const auto room = available_memory(root_);

  EXPECT_EQ(room.bytes, 700000);
  EXPECT_EQ(room.limit, "the control group");
}

TEST_F(Memory, GroupsOfTheFirstVersionCountToo) {
  write("proc/self/cgroup", "9:cpu:/\n4:memory:/job\n");
  write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "5000\n");
  write("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "2000\n");

  EXPECT_EQ(available_memory(root_).bytes, 3000);
}

TEST_F(Memory, AGroupThatIsFullLeavesNothing) {
  write("proc/self/cgroup", "0::/\n");
  write("sys/fs/cgroup/memory.max", "5000\n");
  write("sys/fs/cgroup/memory.current", "6000\n");

  EXPECT_EQ(available_memory(root_).bytes, 0);
}

TEST_F(Memory, TheSmallestGroupIsAllThereCanBe) {
  const auto machine = whole_memory(root_);
  EXPECT_GT(machine, std::uint64_t{64} << 20);
  write("proc/self/cgroup", "0::/a/b\n");
  write("sys/fs/cgroup/memory.max", "9000000\n");
  write("sys/fs/cgroup/a/memory.max", "1000000\n");
  write("sys/fs/cgroup/a/b/memory.max", "max\n");
  EXPECT_EQ(whole_memory(root_), 1000000U);
}

TEST_F(Memory, AGroupOfTheFirstVersionThatMayHaveAllIsNoLimit) {
  const auto machine = whole_memory(root_);
  write("proc/self/cgroup", "4:memory:/job\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(whole_memory(root_), machine);
  write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "5000\n");
  EXPECT_EQ(whole_memory(root_), 5000U);
}

/// A container sees its own group as the top, whatever path the host has for it.
TEST_F(Memory, TheTopOfAContainerCounts) {
  write("proc/self/cgroup", "0::/../../docker/1234\n");
  write("sys/fs/cgroup/memory.max", "5000\n");
  EXPECT_EQ(whole_memory(root_), 5000U);
}

class Processors : public Memory {};

TEST_F(Processors, AShareOfTimeIsRoundedUp) {
  const auto all = processors(root_);
  EXPECT_GE(all, 1U);
  write("proc/self/cgroup", "0::/a/b\n");
  write("sys/fs/cgroup/a/cpu.max", "50000 100000\n");
  write("sys/fs/cgroup/a/b/cpu.max", "max 100000\n");
  EXPECT_EQ(processors(root_), 1U);
  write("sys/fs/cgroup/a/cpu.max", "150000 100000\n");
  EXPECT_EQ(processors(root_), std::min(all, 2U));
}

TEST_F(Processors, WhatSaysNothingOrIsNonsenseIsNoLimit) {
  const auto all = processors(root_);
  write("proc/self/cgroup", "0::/\n");
  for (const auto* line : {"max 100000\n", "", "50000\n", "50000 0\n", "0 100000\n", "-1 100000\n",
                           "99999999999999999999 100000\n", "a lot\n"}) {
    write("sys/fs/cgroup/cpu.max", line);
    EXPECT_EQ(processors(root_), all) << line;
  }
}

TEST_F(Processors, GroupsOfTheFirstVersionCountToo) {
  const auto all = processors(root_);
  write("proc/self/cgroup", "5:cpu,cpuacct:/job\n4:memory:/\n");
  write("sys/fs/cgroup/cpu/cpu.cfs_quota_us", "-1\n");
  write("sys/fs/cgroup/cpu/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(processors(root_), all);
  write("sys/fs/cgroup/cpu/job/cpu.cfs_quota_us", "10000\n");
  write("sys/fs/cgroup/cpu/job/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(processors(root_), 1U);
}

TEST_F(Memory, HowManyProcessesTheSystemEnded) {
  EXPECT_EQ(memory_kills(root_), 0U) << "it does not say";
  write("proc/vmstat", "nr_free_pages 5\noom_kill 3\n");
  EXPECT_EQ(memory_kills(root_), 3U);
}

TEST(MemoryCheck, ARefusalNamesBothSizesAndTheLimit) {
  const auto refused = check_memory(300u << 20, {200u << 20, "the machine"}, "the solve");

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::out_of_memory);
  EXPECT_EQ(refused.error().message, "the solve needs about 300 MiB, the machine has 200 MiB left");
  EXPECT_FALSE(refused.error().remedy.empty());
  EXPECT_TRUE(check_memory(200u << 20, {200u << 20, "the machine"}, "the solve").has_value());
}

}  // namespace
}  // namespace tedit
