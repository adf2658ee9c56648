// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/logging/logging.hpp"
#include "tedit/v1/session.pb.h"
#include "tests/simulation/world.hpp"

namespace tedit::simulation {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

class Simulation : public ::testing::Test {
protected:
  Simulation() { logging::set_level("off"); }
  ~Simulation() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ =
    std::filesystem::temp_directory_path() / ("tedit-simulation-" + std::to_string(::getpid()));
};

TEST_F(Simulation, KeepsItsPromisesForManySeeds) {
  std::uint64_t answers = 0;
  std::map<int, int> cad;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    const auto all = make_scenario(seed);
    const auto result = play(all, folder_);
    answers += result.answers;
    for (const auto& [status, count] : result.cad)
      cad[status] += count;
    ASSERT_THAT(result.faults, IsEmpty()) << describe(all);
  }
  EXPECT_GT(answers, 10'000U);  // A simulation in which nobody is answered finds nothing.
  EXPECT_GT(cad[v1::CadState::SAME], 200);
  EXPECT_GT(cad[v1::CadState::MESH_ONLY], 50);
  EXPECT_GT(cad[v1::CadState::FAILED], 5);
}

/// One client and these steps, with twenty orders of events.
std::vector<scenario> orders_of(const std::vector<scenario_step>& steps) {
  std::vector<scenario> result;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    result.push_back({seed, 1, 1, steps});
  return result;
}

constexpr std::size_t modeling = 0, solver = 2;

// Its fields were fetched from a worker that was no more, and the solve was refused.
TEST_F(Simulation, ASolveOutlivesItsWorkerThatDiesAfterTheAnswer) {
  using enum step_kind;
  for (const auto& one : orders_of({{milliseconds(0), import, 0, 1},
                                    {milliseconds(20000), set_load_case, 0, 0},
                                    {milliseconds(40000), worker_dies_after_answer, solver, 0},
                                    {milliseconds(40001), solve, 0, 0}})) {
    const auto result = play(one, folder_);
    EXPECT_THAT(result.faults, IsEmpty()) << "order " << one.seed;
    EXPECT_THAT(result.errors, IsEmpty()) << "order " << one.seed;
  }
}

TEST_F(Simulation, AFileOutlivesItsWorkerThatDiesAfterTheAnswer) {
  using enum step_kind;
  for (const auto& one : orders_of({{milliseconds(0), import, 0, 1},
                                    {milliseconds(40000), worker_dies_after_answer, modeling, 0},
                                    {milliseconds(40001), export_file, 0, 1}})) {
    const auto result = play(one, folder_);
    EXPECT_THAT(result.faults, IsEmpty()) << "order " << one.seed;
    EXPECT_THAT(result.errors, IsEmpty()) << "order " << one.seed;
  }
}

// The machine that joined has all the work while the server's own worker is started again, and its
// line is silent for five seconds, which is taken as cut: the own one does it then.
TEST_F(Simulation, AnEditAndASolveOutliveSilentLines) {
  using enum step_kind;
  for (const auto& one : orders_of({{milliseconds(0), import, 0, 1},
                                    {milliseconds(20'000), machine_joins, modeling, 0},
                                    {milliseconds(20'000), machine_joins, solver, 0},
                                    {milliseconds(20'000), set_load_case, 0, 0},
                                    {milliseconds(40'000), line_falls_silent, modeling, 1},
                                    {milliseconds(40'001), worker_dies, modeling, 0},
                                    {milliseconds(40'002), apply, 0, 1},
                                    {milliseconds(60'000), line_falls_silent, solver, 1},
                                    {milliseconds(60'001), worker_dies, solver, 0},
                                    {milliseconds(60'002), solve, 0, 0},
                                    {milliseconds(80'000), apply, 0, 1}})) {
    const auto result = play(one, folder_);
    EXPECT_THAT(result.faults, IsEmpty()) << "order " << one.seed;
    EXPECT_THAT(result.errors, IsEmpty()) << "order " << one.seed;
  }
}

// That two deaths are no reason to refuse is held against every seed. Of the seeds with three of
// one role a few (the first is 5200) have a job that met them all: it is refused with `internal`.
TEST_F(Simulation, AJobWhoseWorkersDieAgainAndAgainIsRefusedOnceAndByName) {
  using enum step_kind;
  std::vector<scenario_step> steps{{milliseconds(1000), import, 0, 1}};
  for (int at = 0; at < 20'000; at += 20)
    steps.push_back({milliseconds(at), worker_dies_with_job, modeling, 0});
  std::ranges::stable_sort(steps, {}, &scenario_step::at);
  for (const auto& one : orders_of(steps)) {
    const auto result = play(one, folder_);
    EXPECT_THAT(result.faults, IsEmpty()) << "order " << one.seed;
    EXPECT_THAT(result.errors, ElementsAre(Pair("internal", 1))) << "order " << one.seed;
  }
}

// The result that was kept had the name of before, by which no client knows the document.
TEST_F(Simulation, UndoShowsTheFieldThatWasSolvedUnderAnotherName) {
  using enum step_kind;
  for (const auto& one : orders_of({{milliseconds(0), import, 0, 1},
                                    {milliseconds(20'000), set_load_case, 0, 0},
                                    {milliseconds(40'000), solve, 0, 0},
                                    {milliseconds(60'000), apply, 0, 1},
                                    {milliseconds(100'000), rename, 0, 1},
                                    {milliseconds(120'000), undo, 0, 1}})) {
    const auto result = play(one, folder_);
    EXPECT_THAT(result.faults, IsEmpty()) << "order " << one.seed;
    EXPECT_THAT(result.errors, IsEmpty()) << "order " << one.seed;
  }
}

// Also when the session has ended meanwhile, with all that it held.
TEST_F(Simulation, AReopenedDocumentHasItsFieldsAndItsUndo) {
  using enum step_kind;
  for (const auto& one : orders_of({{milliseconds(0), import, 0, 1},
                                    {milliseconds(20'000), set_load_case, 0, 0},
                                    {milliseconds(40'000), solve, 0, 0},
                                    {milliseconds(60'000), apply, 0, 1},
                                    {milliseconds(100'000), reopen_document, 0, 1'000'000'900},
                                    {milliseconds(130'000), undo, 0, 1},
                                    {milliseconds(150'000), redo, 0, 1}})) {
    const auto result = play(one, folder_);
    EXPECT_THAT(result.faults, IsEmpty()) << "order " << one.seed;
    EXPECT_THAT(result.errors, IsEmpty()) << "order " << one.seed;
  }
}

// Its document is copied to c0 and that to c1; then the document goes, and c1.
TEST_F(Simulation, ACopyStaysWhenItsDocumentIsDeletedAndANewOneBegins) {
  using enum step_kind;
  for (const auto& one :
       orders_of({{milliseconds(0), import, 0, 1},
                  {milliseconds(20'000), apply, 0, 1},
                  {milliseconds(40'000), copy_document, 0, 3},
                  {milliseconds(50'000), copy_document, 0, 4},
                  {milliseconds(60'000), apply, 0, 1},
                  {milliseconds(80'000), list_documents, 0, 0},
                  {milliseconds(90'000), delete_document, 0, 0},
                  // Time may pass up to the next step while an actor has something
                  // to do: without one, the deletion took until the edit in an order.
                  {milliseconds(100'000), list_documents, 0, 0},
                  {milliseconds(120'000), apply, 0, 1},
                  {milliseconds(140'000), delete_document, 0, 1},
                  {milliseconds(150'000), copy_document, 0, 1}})) {
    const auto result = play(one, folder_);
    EXPECT_THAT(result.faults, IsEmpty()) << "order " << one.seed;
    EXPECT_THAT(result.errors, IsEmpty()) << "order " << one.seed;
  }
}

// A client that heard of no new name before the server died imported again, into another document.
TEST_F(Simulation, WhoComesBackWithANameOfBeforeFindsTheDocumentAlsoAfterARestart) {
  for (const std::uint64_t seed : {1913U, 5606U, 6818U}) {
    const auto all = make_scenario(seed);
    EXPECT_THAT(play(all, folder_).faults, IsEmpty()) << describe(all);
  }
}

// Two load cases are solved one after the other and the later one's loads change: the head has
// the earlier one's result, which its client was sent first.
TEST_F(Simulation, WhatAnEarlierSolveFoundHoldsWhereTheLoadsOfTheLastChanged) {
  const auto all = make_scenario(1837);

  EXPECT_THAT(play(all, folder_).faults, IsEmpty()) << describe(all);
}

TEST_F(Simulation, OneSeedIsOneReplay) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto all = make_scenario(seed);
    const auto once = play(all, folder_);
    const auto again = play(all, folder_);
    EXPECT_EQ(once.trace, again.trace) << "seed " << seed;
    EXPECT_EQ(once.steps, again.steps) << "seed " << seed;
  }
}

}  // namespace
}  // namespace tedit::simulation
