// SPDX-License-Identifier: AGPL-3.0-or-later
// Which job of a pool goes first, and which is ended for another.
#include "tests/states/pool_fixture.hpp"

namespace tedit::actors {
namespace {

TEST_F(Pool, AnEditGoesBeforePreviewsAndFiles) {
  start();
  const auto running = edit(1);
  const auto written = file(2);
  const auto preview = edit(3, "fill", 0, true);
  const auto wanted = edit(4);
  finish();
  ASSERT_EQ(worker().tasks.size(), 1U);
  EXPECT_EQ(worker().tasks.front().job.value, 4U);
  finish();
  ASSERT_EQ(worker().tasks.size(), 1U);
  EXPECT_EQ(worker().tasks.front().job.value, 3U);
  finish();
  EXPECT_EQ(worker().files.size(), 1U);
}

TEST_F(Pool, ClientsTakeTurns) {
  start();
  std::vector<answer<operation_result>> all;
  all.push_back(edit(1, "fill", 7));
  all.push_back(edit(2, "fill", 7));
  all.push_back(edit(3, "fill", 7));
  all.push_back(edit(4, "fill", 8));
  std::vector<std::uint64_t> order;
  while (!worker().tasks.empty()) {
    order.push_back(worker().tasks.front().job.value);
    finish();
  }
  EXPECT_THAT(order, ElementsAre(1U, 4U, 2U, 3U));
}

TEST_F(Pool, APreviewGivesWayToAnEdit) {
  start();
  const auto preview = edit(1, "fill", 0, true);
  EXPECT_TRUE(worker().cancelled.empty());
  const auto wanted = edit(2);
  EXPECT_THAT(worker().cancelled, ElementsAre(1U));
  refuse({ec::cancelled, "the work was cancelled", {}, {}});
  EXPECT_EQ(preview.refusal().code, ec::superseded);
  EXPECT_FALSE(preview.refusal().remedy.empty());
  finish();
  EXPECT_TRUE(wanted.is_success());
}

TEST_F(Pool, APreviewOfWhichAnotherWorkerIsFreeGoesOn) {
  pool_options options;
  options.workers = 2;
  start(options);
  const auto preview = edit(1, "fill", 0, true);
  const auto wanted = edit(2);
  EXPECT_TRUE(worker(0).cancelled.empty());
  EXPECT_TRUE(worker(1).cancelled.empty());
  EXPECT_EQ(worker(0).tasks.size() + worker(1).tasks.size(), 2U);
}

TEST_F(Pool, AJobThatWaitsIsCancelledAtOnce) {
  start();
  const auto first = edit(1);
  const auto second = edit(2);
  caf::anon_send(pool_, cancel_atom::value, job_id{2});
  pass(milliseconds(1));
  EXPECT_EQ(second.refusal().code, ec::cancelled);
  finish();
  EXPECT_TRUE(first.is_success());
  EXPECT_TRUE(worker().tasks.empty());
}

TEST_F(Pool, AJobThatRunsIsAskedToEndAndKilledWhenItDoesNot) {
  start();
  const auto got = edit(1);
  caf::anon_send(pool_, cancel_atom::value, job_id{1});
  pass(milliseconds(1));
  EXPECT_THAT(worker().cancelled, ElementsAre(1U));
  pass(milliseconds(4'000));
  EXPECT_FALSE(got.is_there());
  pass(milliseconds(2'000));
  EXPECT_EQ(got.refusal().code, ec::cancelled);
  EXPECT_TRUE(process(1).killed);
}

TEST_F(Pool, ACancelOfNobodysJobDoesNothing) {
  start();
  const auto got = edit(1);
  caf::anon_send(pool_, cancel_atom::value, job_id{77});
  pass(milliseconds(10'000));
  EXPECT_TRUE(worker().cancelled.empty());
  finish();
  EXPECT_TRUE(got.is_success());
}

}  // namespace
}  // namespace tedit::actors
