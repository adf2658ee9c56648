// SPDX-License-Identifier: AGPL-3.0-or-later
// The kit against a plugin that keeps all rules but one: it must name that one and no other.
#include "ops/conformance/conformance.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/checks.hpp"
#include "ops/conformance/meshes.hpp"

namespace tedit::ops {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::filesystem::path breaker = TEDIT_RULE_BREAKER "/rule_breaker.so";

conformance_report report_of(const std::string& broken, std::chrono::milliseconds limit,
                             const std::vector<std::string>& checks = {}) {
  setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
  setenv("TEDIT_BREAK", broken.c_str(), 1);
  conformance_settings settings;
  settings.file = breaker;
  settings.limit = limit;
  settings.checks = checks;
  auto report = test_plugin(settings, {});
  unsetenv("TEDIT_BREAK");
  return report;
}

std::vector<std::string> failures(const conformance_report& report) {
  std::vector<std::string> result;
  for (const auto& row : report.rows)
    if (row.outcome == verdict::fail)
      result.push_back(row.check);
  return result;
}

std::string what_failed(const conformance_report& report) {
  std::string result;
  for (const auto& row : report.rows)
    if (row.outcome == verdict::fail)
      result += row.check + ": " + row.seen + "\n";
  return result;
}

const conformance_row& row_of(const conformance_report& report, const std::string& check) {
  return *std::ranges::find(report.rows, check, &conformance_row::check);
}

TEST(Conformance, APluginThatKeepsTheRulesPasses) {
  const auto report = report_of("nothing", std::chrono::seconds(30));

  EXPECT_THAT(failures(report), ElementsAre());
  EXPECT_TRUE(report.ok());
  EXPECT_EQ(report.plugin, "rule_breaker 1.0.0");
  EXPECT_GE(report.rows.size(), 45u);
  for (const auto& row : report.rows)
    EXPECT_EQ(row.outcome, row.check == "part_mesh" ? verdict::not_run : verdict::pass)
      << row.check << ": " << row.seen;
}

TEST(Conformance, WhatThePluginLogsIsToldWithTheCheck) {
  const auto report = report_of("logs", std::chrono::seconds(30), {"every_surface_alone"});

  EXPECT_THAT(row_of(report, "every_surface_alone").log, ::testing::Contains("rule_breaker: two"));
  EXPECT_LE(row_of(report, "every_surface_alone").log.size(), 20u);
  EXPECT_TRUE(row_of(report, "entry").log.empty());
}

class BrokenRule : public ::testing::TestWithParam<const char*> {};

TEST_P(BrokenRule, IsNamed) {
  const auto report = report_of(GetParam(), std::chrono::seconds(30));

  EXPECT_THAT(failures(report), ElementsAre(GetParam())) << what_failed(report);
  EXPECT_FALSE(report.ok());
  const auto& row = row_of(report, GetParam());
  EXPECT_FALSE(row.seen.empty());
  EXPECT_FALSE(row.remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
  Each, BrokenRule,
  ::testing::Values("file_opens", "makes_operations", "ids", "texts", "version", "units",
                    "defaults", "same_description", "every_surface_alone", "result_complete",
                    "changes_something", "positive_tets", "adjacency", "surface_ids", "counts",
                    "regions_kept", "untouched_tets", "volume_claim", "no_void", "quality_floor",
                    "deterministic", "input_unchanged", "cancelled_at_start", "cancelled_anywhere",
                    "progress", "repeats", "duplicate_selection", "selection_order",
                    "refusals_explained", "parameters_guarded", "parameters_at_limits",
                    "hostile_parameters", "quiet", "no_files", "no_traces", "no_handles"),
  [](const auto& rule) { return std::string(rule.param); });

std::string seen_of(const std::string& broken, const std::string& check,
                    std::chrono::milliseconds limit = std::chrono::seconds(30)) {
  const auto report = report_of(broken, limit);
  EXPECT_EQ(row_of(report, check).outcome, verdict::fail);
  return row_of(report, check).seen;
}

TEST(Conformance, ACrashIsToldWithItsPlace) {
  EXPECT_THAT(seen_of("every_surface_alone", "every_surface_alone"),
              HasSubstr("crashed with signal 11 (Segmentation fault) while applying to surface 1 "
                        "of the box"));
}

TEST(Conformance, AHangIsEndedAndTold) {
  EXPECT_THAT(seen_of("hang", "every_surface_alone", std::chrono::seconds(2)),
              HasSubstr("did not end within 2000 ms while applying to surface 1 of the box"));
}

TEST(Conformance, AnExceptionIsNoError) {
  EXPECT_THAT(seen_of("throws", "every_surface_alone"), HasSubstr("out of luck"));
}

TEST(Conformance, EndingTheProcessIsNoAnswer) {
  EXPECT_THAT(seen_of("exits", "every_surface_alone"), HasSubstr("ended the process"));
}

TEST(Conformance, AMeshWithFreeSlotsIsTriedToo) {
  EXPECT_THAT(seen_of("free_slots", "every_surface_alone"), HasSubstr("of the edited block"));
}

TEST(Conformance, AWrongCodeForACancelIsNamed) {
  EXPECT_THAT(seen_of("cancel_code", "cancelled_at_start"), HasSubstr("code internal"));
}

TEST(Conformance, WhatTheHostRefusesIsNotTried) {
  const auto report = report_of("trusts_the_host", std::chrono::seconds(30));

  EXPECT_THAT(failures(report), ElementsAre()) << "it crashes on nothing and on unknown surfaces";
}

TEST(Conformance, HowOftenAnEditAsksMayDifferFromRunToRun) {
  for (int i = 0; i < 5; ++i) {
    const auto report =
      report_of("asks_by_the_clock", std::chrono::seconds(30), {"cancelled_anywhere"});

    EXPECT_THAT(failures(report), ElementsAre()) << row_of(report, "cancelled_anywhere").seen;
    EXPECT_EQ(row_of(report, "cancelled_anywhere").outcome, verdict::pass);
  }
}

TEST(Conformance, WorkWithoutAQuestionIsNamed) {
  const auto report = report_of("polls_often", std::chrono::seconds(30), {"polls_often"});

  EXPECT_THAT(failures(report), ElementsAre("polls_often"));
  EXPECT_THAT(row_of(report, "polls_often").seen, HasSubstr("ms of work"));
}

TEST(Conformance, OnlyTheChecksAskedForAndThoseTheyRestOnRun) {
  const auto report = report_of("nothing", std::chrono::seconds(30), {"progress"});

  EXPECT_TRUE(report.ok());
  std::vector<std::string> ran;
  for (const auto& row : report.rows)
    ran.push_back(row.check);
  EXPECT_EQ(ran.back(), "progress");
  EXPECT_LT(ran.size(), 15u);
}

TEST(Conformance, ACancelEndsTheCheckThatRuns) {
  setenv("TEDIT_BREAK", "hang", 1);
  conformance_settings settings;
  settings.file = breaker;
  settings.limit = std::chrono::hours(1);
  const auto checks = conformance_checks();
  const auto hangs = std::ranges::find(checks, "every_surface_alone", &conformance_row::check);
  std::thread later;

  const auto report = test_plugin(settings, [&](const conformance_row& row) {
    if (row.check == std::prev(hangs)->check)
      later = std::thread([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        settings.cancel.cancel();
      });
  });

  ASSERT_TRUE(later.joinable());
  later.join();
  unsetenv("TEDIT_BREAK");
  EXPECT_THAT(report.rows.back().seen, HasSubstr("was cancelled"));
  EXPECT_EQ(report.rows.back().check, "every_surface_alone");
}

TEST(Conformance, EveryOperationOfAPluginIsTested) {
  const auto report = report_of("second_operation", std::chrono::seconds(30));

  EXPECT_THAT(failures(report), ElementsAre("ids")) << "the second one's id is no snake_case";
  const auto failed = std::ranges::find(report.rows, verdict::fail, &conformance_row::outcome);
  EXPECT_EQ(failed->operation, 1u);
  EXPECT_EQ(std::ranges::count(report.rows, std::string("file_opens"), &conformance_row::check), 1);
}

TEST(Conformance, WhatIsNoLibraryIsNotRunFurther) {
  conformance_settings settings;
  settings.file = TEDIT_TEST_DATA "/parts/holes_block/features.json";

  const auto report = test_plugin(settings, {});

  EXPECT_THAT(failures(report), ElementsAre("file_opens"));
  EXPECT_THAT(row_of(report, "file_opens").seen, HasSubstr("no shared library"));
  EXPECT_THAT(row_of(report, "progress").seen, HasSubstr("see file_opens"));
  EXPECT_FALSE(report.ok());
}

TEST(KitMeshes, AreFaultlessAndHoldWhatTheyPromise) {
  const auto samples = kit_samples();

  ASSERT_EQ(samples.size(), 4u);
  for (const auto& s : samples)
    EXPECT_TRUE(check_version(*s.mesh).ok()) << s.name;
  EXPECT_EQ(samples[0].mesh->tet_count(), 4u * 3 * 3 * 6);
  EXPECT_EQ(samples[1].mesh->tet_count(), (6u * 5 * 3 - 3 - 2 + 1) * 6);
  EXPECT_EQ(samples[2].mesh->regions().size(), 2u);
  EXPECT_EQ(samples[2].mesh->data().interfaces.size() > 0, true);
  const auto& edited = *samples[3].mesh;
  EXPECT_EQ(edited.tet_count(), samples[1].mesh->tet_count() - 6);
  EXPECT_LT(edited.tet_count(), edited.tet_slots());
  EXPECT_LT(edited.facet_count(), edited.facet_slots());
  EXPECT_LT(edited.vertex_count(), edited.vertex_slots());
  EXPECT_EQ(edited.find_surface(21), nullptr);
}

}  // namespace
}  // namespace tedit::ops
