// SPDX-License-Identifier: AGPL-3.0-or-later
// A pool whose workers do what a test says, in virtual time.
#include "tests/states/pool_fixture.hpp"

namespace tedit::actors {
namespace {

TEST_F(Pool, AJobIsAnsweredByItsWorkerOnce) {
  start();
  const auto got = edit(1);
  EXPECT_FALSE(got.is_there());
  finish();
  EXPECT_TRUE(got.is_success());
  EXPECT_EQ(got.count(), 1);
}

TEST_F(Pool, AWorkerHasOneJobAtATime) {
  start();
  const auto first = edit(1);
  const auto second = edit(2);
  EXPECT_EQ(worker().tasks.size(), 1U);
  finish();
  ASSERT_EQ(worker().tasks.size(), 1U);
  EXPECT_EQ(worker().tasks.front().job.value, 2U);
  finish();
  EXPECT_TRUE(first.is_success());
  EXPECT_TRUE(second.is_success());
}

TEST_F(Pool, ARefusalOfTheOperationIsPassedOnAndCostsNoWorker) {
  start();
  const auto got = edit(1);
  refuse({ec::invalid_argument, "surface 7 is not there", "Name another", {}});
  EXPECT_EQ(got.refusal().code, ec::invalid_argument);
  EXPECT_EQ(got.refusal().remedy, "Name another");
  EXPECT_EQ(processes_->all.size(), 1U);
}

TEST_F(Pool, AFailureThatIsNoneOfOursEndsTheWorkerAndTheJobRunsElsewhere) {
  start();
  const auto got = edit(1);
  auto promise = worker().tasks.front().promise;
  within(process().worker,
         [=]() mutable { promise.deliver(caf::make_error(caf::sec::runtime_error)); });
  pass(milliseconds(50));
  ASSERT_EQ(processes_->all.size(), 2U);
  EXPECT_TRUE(process(1).killed);
  finish();
  EXPECT_TRUE(got.is_success());
}

TEST_F(Pool, TheJobOfADeadWorkerIsDoneByTheNext) {
  start();
  const auto got = edit(1);
  crash();
  ASSERT_EQ(processes_->all.size(), 2U);
  EXPECT_FALSE(got.is_there());
  ASSERT_EQ(worker().tasks.size(), 1U);
  finish();
  EXPECT_TRUE(got.is_success());
  EXPECT_EQ(got.count(), 1);
  EXPECT_EQ(status().restarts, 1U);
}

TEST_F(Pool, TheJobOfADeadWorkerGoesBeforeThoseThatCameLater) {
  start();
  const auto first = edit(1);
  const auto second = edit(2);
  crash();
  EXPECT_EQ(worker().tasks.front().job.value, 1U);
}

TEST_F(Pool, AJobThatEndsEveryWorkerIsRefusedByName) {
  start();
  const auto got = edit(1, "emboss");
  crash();
  crash();
  EXPECT_FALSE(got.is_there());
  crash();
  EXPECT_EQ(got.refusal().code, ec::internal);
  EXPECT_THAT(got.refusal().message, HasSubstr("emboss"));
  EXPECT_THAT(got.refusal().message, HasSubstr("signal 11"));
  EXPECT_THAT(got.refusal().message, HasSubstr("3 times"));
  EXPECT_FALSE(got.refusal().remedy.empty());
  const auto next = edit(2, "fill");
  finish();
  EXPECT_TRUE(next.is_success()) << "others go on";
}

TEST_F(Pool, APreviewIsTriedTwiceOnly) {
  start();
  const auto got = edit(1, "emboss", 0, true);
  crash();
  EXPECT_FALSE(got.is_there());
  crash();
  EXPECT_EQ(got.refusal().code, ec::internal);
}

TEST_F(Pool, AnOperationThatFailsThreeEditsOfADocumentIsSwitchedOffThere) {
  start();
  for (std::uint64_t id = 1; id <= 3; ++id) {
    const auto got = edit(id, "emboss");
    for (int death = 0; death < 3; ++death)
      crash();
    ASSERT_TRUE(got.is_there()) << id;
  }
  const auto started = processes_->all.size();
  const auto got = edit(4, "emboss");
  EXPECT_THAT(got.refusal().message, HasSubstr("emboss"));
  EXPECT_EQ(processes_->all.size(), started) << "it was not tried";
  const auto other = edit(5, "fill");
  finish();
  EXPECT_TRUE(other.is_success());
}

TEST_F(Pool, PreviewsDoNotCountAgainstAnOperation) {
  start();
  for (std::uint64_t id = 1; id <= 4; ++id) {
    const auto got = edit(id, "emboss", 0, true);
    crash();
    crash();
    ASSERT_TRUE(got.is_there());
  }
  const auto got = edit(5, "emboss");
  finish();
  EXPECT_TRUE(got.is_success());
}

TEST_F(Pool, WorkersThatDieForNoReasonUseUpABudgetThatComesBack) {
  start();
  for (int i = 0; i < 4; ++i)
    crash();
  EXPECT_EQ(processes_->all.size(), 4U) << "one, and three restarts";
  const auto refused = edit(1);
  EXPECT_EQ(refused.refusal().code, ec::service_unavailable);
  EXPECT_THAT(refused.refusal().message, HasSubstr("signal 11"));
  EXPECT_FALSE(refused.refusal().remedy.empty());
  pass(milliseconds(61'000));
  EXPECT_EQ(processes_->all.size(), 5U);
  const auto got = edit(2);
  finish();
  EXPECT_TRUE(got.is_success());
}

TEST_F(Pool, WhatWaitsWhenTheBudgetIsUsedUpIsRefusedToo) {
  processes_->enlists = false;
  start();
  const auto waiting = edit(1);
  for (int i = 0; i < 4; ++i) {
    EXPECT_FALSE(waiting.is_there());
    crash();
  }
  EXPECT_EQ(waiting.refusal().code, ec::service_unavailable);
}

TEST_F(Pool, AProcessThatCannotBeStartedIsToldWithItsReason) {
  processes_->refusal = "fork: Resource temporarily unavailable";
  start();
  pass(milliseconds(1'000));
  const auto got = edit(1);
  pass(milliseconds(1'000));
  EXPECT_EQ(got.refusal().code, ec::service_unavailable);
  EXPECT_THAT(got.refusal().message, HasSubstr("Resource temporarily unavailable"));
  processes_->refusal.clear();
  pass(milliseconds(61'000));
  const auto later = edit(2);
  finish();
  EXPECT_TRUE(later.is_success());
  EXPECT_EQ(got.count(), 1);
}

TEST_F(Pool, AProcessThatDoesNotEnlistIsReplaced) {
  processes_->enlists = false;
  start();
  const auto got = edit(1);
  pass(milliseconds(19'000));
  EXPECT_EQ(processes_->all.size(), 1U);
  processes_->enlists = true;
  pass(milliseconds(2'000));
  EXPECT_TRUE(process(1).killed);
  finish();
  EXPECT_TRUE(got.is_success());
}

TEST_F(Pool, NobodyEnlistsInTheNameOfAnother) {
  start();
  const auto stranger = stage_.system().spawn(make_puppet, 0);
  const auto second = ask<bool>(process().enlister, enlistment{99, stranger});
  pass(milliseconds(10));
  EXPECT_FALSE(second.value());
  const auto got = edit(1);
  EXPECT_EQ(worker().tasks.size(), 1U);
}

TEST_F(Pool, WorkThatTakesTooLongIsEndedAndNamed) {
  pool_options options;
  options.job_limit = milliseconds(60'000);
  options.operation_limit = milliseconds(5'000);
  start(options);
  const auto plugin = edit(1, "emboss");
  pass(milliseconds(4'000));
  EXPECT_FALSE(plugin.is_there());
  pass(milliseconds(2'000));
  EXPECT_EQ(plugin.refusal().code, ec::timeout);
  EXPECT_THAT(plugin.refusal().message, HasSubstr("emboss did not end within 5 s"));
  EXPECT_TRUE(process(1).killed);
  const auto written = file(2);
  pass(milliseconds(50'000));
  EXPECT_FALSE(written.is_there()) << "a file has the longer limit";
  pass(milliseconds(11'000));
  EXPECT_EQ(written.refusal().code, ec::timeout);
}

TEST_F(Pool, EditsThatHangCountAgainstTheirOperation) {
  start();
  for (std::uint64_t id = 1; id <= 3; ++id) {
    const auto got = edit(id, "emboss");
    pass(milliseconds(121'000));
    ASSERT_EQ(got.refusal().code, ec::timeout) << id;
  }
  const auto got = edit(4, "emboss");
  EXPECT_THAT(got.refusal().message, HasSubstr("emboss"));
  const auto other = edit(5, "fill");
  finish();
  EXPECT_TRUE(other.is_success());
}

TEST_F(Pool, AWorkerThatRetiresFinishesItsJobAndGetsNoMore) {
  start();
  const auto first = edit(1);
  const caf::actor retired = process().worker;
  caf::send_as(retired, caf::actor_cast<caf::actor>(pool_),
               retirement{"it used up its descriptors"});
  pass(milliseconds(10));
  ASSERT_EQ(processes_->all.size(), 2U);
  const auto second = edit(2);
  EXPECT_EQ(worker(0).tasks.front().job.value, 2U);
  finish(1);
  EXPECT_TRUE(first.is_success());
  EXPECT_FALSE(process(1).killed) << "others fetch its last result";
  pass(milliseconds(31'000));
  EXPECT_TRUE(process(1).killed);
  EXPECT_EQ(processes_->all.size(), 2U);
}

TEST_F(Pool, AWorkerWhoseLinkIsDownAndThatDoesNotEndIsKilled) {
  start();
  const auto got = edit(1);
  simulation::cut_off(process().worker);  // Its process goes on.
  pass(milliseconds(900));
  EXPECT_EQ(processes_->all.size(), 1U);
  pass(milliseconds(300));
  EXPECT_TRUE(process(1).killed);
  finish();
  EXPECT_TRUE(got.is_success());
}

TEST_F(Pool, WhereMemoryRanOutWorkIsTriedTwiceAndToldSo) {
  start();
  const auto got = edit(1);
  for (int i = 0; i < 2; ++i) {
    ASSERT_FALSE(got.is_there()) << i;
    ++processes_->starved;
    processes_->end(process(), "was killed by signal 9 (Killed)");
    pass(milliseconds(300));
  }
  EXPECT_EQ(got.refusal().code, ec::out_of_memory);
  EXPECT_THAT(got.refusal().message, HasSubstr("memory ran out"));
  EXPECT_THAT(got.refusal().remedy, HasSubstr("more memory"));
}

TEST_F(Pool, AKillThatIsNotTheSystemsIsNoWantOfMemory) {
  processes_->starved = 7;  // Before this work.
  start();
  const auto got = edit(1);
  for (int i = 0; i < 3; ++i) {
    ASSERT_FALSE(got.is_there()) << i;
    processes_->end(process(), "was killed by signal 9 (Killed)");
    pass(milliseconds(300));
  }
  EXPECT_EQ(got.refusal().code, ec::internal);
  EXPECT_THAT(got.refusal().message, HasSubstr("was killed by signal 9"));
}

TEST_F(Pool, ALateAnswerOfADeadWorkerIsNobodys) {
  start();
  const auto got = edit(1);
  auto late = worker().tasks.front().promise;
  process().how = "was killed by signal 9 (Killed)";  // Its answer is on its way all the same.
  pass(milliseconds(300));
  ASSERT_EQ(processes_->all.size(), 2U);
  within(process(1).worker, [=]() mutable { late.deliver(operation_result{}); });
  EXPECT_FALSE(got.is_there());
  finish();
  EXPECT_EQ(got.count(), 1);
}

TEST_F(Pool, AtRestItLooksAfterItsWorkersEveryTwoSeconds) {
  start();
  pass(milliseconds(5'000));
  const auto before = time_.now();
  int steps = 0;
  while (stage_.step(before + milliseconds(60'000)))
    ++steps;
  EXPECT_LE(steps, 100) << "30 ticks, each one message and one step of time";
  crash();
  pass(milliseconds(2'100));
  EXPECT_EQ(processes_->all.size(), 2U);
}

TEST_F(Pool, SaysHowItIs) {
  processes_->enlists = false;
  start();
  EXPECT_EQ(status().role, "modeling");
  EXPECT_EQ(status().restarts, 0U);
  const auto waiting = edit(1);
  const auto enlisted = ask<bool>(process().enlister, enlistment{1, process().worker});
  pass(milliseconds(1));
  EXPECT_TRUE(enlisted.value());
  EXPECT_EQ(worker().tasks.size(), 1U);
}

TEST_F(Pool, WhoWaitsIsToldWhenTheServerStops) {
  start();
  const auto running = edit(1);
  const auto waiting = edit(2);
  caf::anon_send_exit(pool_, caf::exit_reason::user_shutdown);
  pass(milliseconds(10));
  EXPECT_EQ(waiting.refusal().code, ec::service_unavailable);
  EXPECT_THAT(waiting.refusal().message, HasSubstr("stopping"));
  EXPECT_EQ(running.refusal().code, ec::service_unavailable);
  EXPECT_TRUE(process().killed);
}

}  // namespace
}  // namespace tedit::actors
