// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/cli/program.hpp"

namespace tedit::test {
namespace {

const std::string loaded_block = parts +
                                 "inch_block/inch_block.coarse.msh --device cpu --order 1 " +
                                 "--load-case " + parts + "inch_block/load_case.json";

TEST(Adapt, RefinesUntilTheEstimatedErrorIsWhatWasAskedFor) {
  const auto finer = scratch("finer.msh");
  const auto made = run("adapt --json " + loaded_block + " --error 11 -o " + finer.string());

  ASSERT_EQ(made.status, 0);
  const auto json = made.parsed();
  EXPECT_TRUE(json["reached"]);
  EXPECT_EQ(json["ended_by"], "reached");
  EXPECT_GT(json["relative_error_before"], 0.12);
  EXPECT_LE(json["relative_error_after"], 0.11);
  EXPECT_GT(json["tets_after"], json["tets_before"]);
  EXPECT_GE(json["rounds"].size(), 2u);
  // Solving what was written says the same.
  const auto solved =
    run("solve --json " + finer.string() + " --device cpu --order 1 --load-case " + parts +
        "inch_block/load_case.json");
  ASSERT_EQ(solved.status, 0);
  EXPECT_NEAR(solved.parsed()["relative_error_estimate"].get<double>(),
              json["relative_error_after"].get<double>(), 1e-4);
  const auto before = run("info --json " + parts + "inch_block/inch_block.coarse.msh").parsed();
  const auto after = run("info --json " + finer.string()).parsed();
  EXPECT_EQ(before["surfaces"].size(), after["surfaces"].size());
}

TEST(Adapt, EndsAtTheLimitOfTetsAndSaysSo) {
  const auto made = run("adapt --json " + loaded_block + " --error 3 --tets 12000");

  ASSERT_EQ(made.status, 0);
  const auto json = made.parsed();
  EXPECT_FALSE(json["reached"]);
  EXPECT_EQ(json["ended_by"], "tets");
  EXPECT_LE(json["tets_after"], 12000);
  EXPECT_LT(json["relative_error_after"], json["relative_error_before"]);
  EXPECT_THAT(run("adapt " + loaded_block + " --error 3 --tets 12000").out, HasSubstr("--tets"));
}

TEST(Adapt, WhatIsExactEnoughStaysAsItIs) {
  const auto made = run("adapt --json " + loaded_block + " --error 40").parsed();

  EXPECT_TRUE(made["reached"]);
  EXPECT_EQ(made["tets_after"], made["tets_before"]);
  EXPECT_EQ(made["volume_change_m3"], 0.0);
}

TEST(Adapt, ItsUsageErrorsAreNamed) {
  EXPECT_EQ(run("adapt " + parts + "inch_block/inch_block.coarse.msh").status, 2);
  EXPECT_EQ(run("adapt " + loaded_block + " --error 0").status, 2);
  EXPECT_EQ(run("adapt " + loaded_block + " -o x.nonsense").status, 2);
}

}  // namespace
}  // namespace tedit::test
