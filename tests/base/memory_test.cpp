// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/memory.hpp"

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
