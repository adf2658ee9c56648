// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/metrics.hpp"

#include <regex>
#include <set>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedit::metrics {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Metrics, AreTheSameObjectsForTheSameNameAndLabels) {
  auto& edits = count_of("test_same_total", "Help.", {{"kind", "edit"}});
  edits.add(2);
  count_of("test_same_total", "Help.", {{"kind", "edit"}}).add();
  count_of("test_same_total", "Help.", {{"kind", "undo"}}).add();

  EXPECT_EQ(edits.get(), 3U);
  const auto text = to_text();
  EXPECT_THAT(text, HasSubstr("# HELP test_same_total Help.\n# TYPE test_same_total counter\n"
                              "test_same_total{kind=\"edit\"} 3\n"
                              "test_same_total{kind=\"undo\"} 1\n"));
}

TEST(Metrics, TimesAreCountedInBucketsThatHoldThoseBeforeThem) {
  auto& took = times_of("test_took_seconds", "Help.");
  for (const double s : {.0005, .001, .002, 700.})
    took.note(std::chrono::duration<double>(s));

  EXPECT_EQ(took.count(), 4U);
  EXPECT_NEAR(took.sum_s(), 700.0035, 1e-9);
  EXPECT_EQ(took.within(0), 2U);
  EXPECT_EQ(took.within(1), 3U);
  EXPECT_EQ(took.within(times::bounds_s.size() - 1), 3U);
  const auto text = to_text();
  EXPECT_THAT(text, HasSubstr("# TYPE test_took_seconds histogram\n"
                              "test_took_seconds_bucket{le=\"0.001\"} 2\n"
                              "test_took_seconds_bucket{le=\"0.003\"} 3\n"));
  EXPECT_THAT(text, HasSubstr("test_took_seconds_bucket{le=\"+Inf\"} 4\n"));
  EXPECT_THAT(text, HasSubstr("test_took_seconds_count 4\n"));
}

TEST(Metrics, LabelsAreEscaped) {
  level_of("test_level", "Help.", {{"what", "a\"b\\c\nd"}}).set(.5);
  EXPECT_THAT(to_text(), HasSubstr("test_level{what=\"a\\\"b\\\\c\\nd\"} 0.5\n"));
}

TEST(Metrics, OfTheProcessAreThereAndEveryLineIsOfTheFormat) {
  note_process();
  const auto text = to_text();
  for (const auto* name : {"process_resident_memory_bytes", "process_cpu_seconds_total",
                           "process_open_fds", "process_threads", "process_uptime_seconds"})
    EXPECT_THAT(text, HasSubstr(std::string("\n") + name + " "));
  EXPECT_GT(level_of("process_resident_memory_bytes", "Memory that is in use.").get(), 1e5);
  EXPECT_GE(level_of("process_threads", "Threads.").get(), 1);
  EXPECT_THAT(text, HasSubstr("# TYPE process_cpu_seconds_total counter\n"));

  const std::regex line(
    "(# (HELP|TYPE) [a-z_:]+ .+)|"
    "([a-z_]+(\\{([a-z]+=\"([^\"\\\\]|\\\\.)*\",?)+\\})? "
    "[-+0-9.eE]+)");
  std::istringstream in(text);
  for (std::string one; std::getline(in, one);)
    EXPECT_TRUE(std::regex_match(one, line)) << one;
}

TEST(Metrics, AreCountedFromManyThreads) {
  auto& all = count_of("test_threads_total", "Help.");
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      for (int i = 0; i < 10'000; ++i)
        all.add();
    });
  for (auto& one : threads)
    one.join();
  EXPECT_EQ(all.get(), 40'000U);
}

}  // namespace
}  // namespace tedit::metrics
