// SPDX-License-Identifier: AGPL-3.0-or-later
// Which worker gets a job, by the times of those before, and what those hear that wait.
#include "actors/supervisor/cost_model.hpp"
#include "tests/states/remote_pool_fixture.hpp"

namespace tedit::actors {
namespace {

using std::chrono::seconds;

TEST(CostModel, KnowsNothingOfAKindOfWhichNoneWasDone) {
  cost_model model;
  model.note({"check", 10}, 1);
  EXPECT_FALSE(model.seconds({"import", 10}));
  model.note({"", 10}, 1);
  EXPECT_FALSE(model.seconds({"", 10}));
}

TEST(CostModel, TakesTimeAsProportionalWhileAllWereOfOneSize) {
  cost_model model;
  for (int i = 0; i < 3; ++i)
    model.note({"check", 100}, .5);
  EXPECT_DOUBLE_EQ(*model.seconds({"check", 100}), .5);
  EXPECT_DOUBLE_EQ(*model.seconds({"check", 300}), 1.5);
  EXPECT_DOUBLE_EQ(*model.seconds({"check", 0}), .5) << "a size that is not known is the usual one";
}

TEST(CostModel, FindsWhatAJobTakesBesideItsSize) {
  cost_model model;  // t = 1 + .01 x
  for (int i = 0; i < 20; ++i)
    model.note({"solve", i % 2 ? 100. : 300.}, i % 2 ? 2 : 4);
  EXPECT_NEAR(*model.seconds({"solve", 200}), 3, 1e-9);
  EXPECT_NEAR(*model.seconds({"solve", 1000}), 11, 1e-9);
}

TEST(CostModel, NothingTakesLessForBeingLarger) {
  cost_model model;
  for (int i = 0; i < 20; ++i)
    model.note({"solve", i % 2 ? 100. : 300.}, i % 2 ? 4 : 2);
  EXPECT_GE(*model.seconds({"solve", 10000}), 2);
  EXPECT_LE(*model.seconds({"solve", 10000}), 4);
}

TEST(CostModel, FollowsAMachineThatBecameSlower) {
  cost_model model;
  model.note({"check", 1}, 1);
  for (int i = 0; i < 40; ++i)
    model.note({"check", 1}, 3);
  EXPECT_NEAR(*model.seconds({"check", 1}), 3, .05);
}

TEST(CostModel, LearnsNoMoreKindsThanItMay) {
  cost_model model;
  for (std::size_t i = 0; i <= cost_model::most_kinds; ++i)
    model.note({"kind " + std::to_string(i), 1}, 1);
  EXPECT_TRUE(model.seconds({"kind 0", 1}));
  EXPECT_FALSE(model.seconds({"kind " + std::to_string(cost_model::most_kinds), 1}));
}

/// Notes what a listener hears.
struct ear_state {
  std::vector<std::string> stages;
  static inline const char* name = "ear";
};
using ear_actor = caf::stateful_actor<ear_state>;

caf::behavior make_ear(ear_actor* self, int /*number*/) {
  return {[=](const job_progress& note) { self->state.stages.push_back(note.stage); }};
}

class Placement : public RemotePool {
protected:
  caf::actor ear() { return stage_.system().spawn(make_ear, 0); }
  static const std::vector<std::string>& heard(const caf::actor& by) {
    return dynamic_cast<ear_actor&>(*caf::actor_cast<caf::abstract_actor*>(by)).state.stages;
  }

  /// A job of a document that takes so long on this worker.
  void do_one(const std::shared_ptr<made_up_line>& by, std::uint64_t id, milliseconds takes) {
    const auto done = edit(id);
    pass(takes);
    ASSERT_EQ(of(by).tasks.size(), 1u) << "job " << id;
    finish(by);
    ASSERT_TRUE(done.is_success());
  }
};

TEST_F(Placement, WhoWaitsHearsHowManyGoBeforeAndHowLong) {
  start();
  const auto quick = edit(1);
  pass(seconds(4));
  finish();  // An edit takes four seconds.
  const auto document = ear();
  const auto other = ear();
  const auto runs = edit(2);
  const auto next = edit_of(document, 3);
  const auto last = edit_of(other, 4);
  pass(milliseconds(300));
  EXPECT_THAT(heard(document), IsEmpty()) << "what is quick needs no words";
  pass(milliseconds(300));
  EXPECT_THAT(heard(document), ElementsAre("waiting for a free worker, about 4 s"));
  EXPECT_THAT(heard(other), ElementsAre("waiting for a free worker: 1 before it, about 8 s"));
  pass(seconds(2));
  EXPECT_EQ(heard(document).size(), 3u) << "once a second";
  EXPECT_EQ(heard(document).back(), "waiting for a free worker, about 2 s");
}

TEST_F(Placement, NobodySaysHowLongWhatWasNeverDoneTakes) {
  start();
  const auto first = edit(1);
  const auto document = ear();
  const auto second = edit_of(document, 2);
  pass(milliseconds(600));
  EXPECT_THAT(heard(document), ElementsAre("waiting for a free worker"));
}

TEST_F(Placement, WhoWaitsForAWorkerThatStartsHearsThat) {
  processes_->enlists = false;
  start();
  const auto document = ear();
  const auto first = edit_of(document, 1);
  pass(milliseconds(600));
  EXPECT_THAT(heard(document), ElementsAre("waiting for a worker to start"));
}

TEST_F(Placement, TheQuickerOfTwoFreeWorkersGetsTheJob) {
  start_with(0);
  const auto slow = join("slow");
  do_one(slow, 1, seconds(2));
  const auto quick = join("quick");
  do_one(quick, 2, seconds(1));  // It is tried, as nobody knows how quick it is.
  do_one(quick, 3, seconds(1));
  const auto both = edit(4);
  const auto too = edit(5);
  EXPECT_EQ(of(quick).tasks.size(), 1u);
  EXPECT_EQ(of(slow).tasks.size(), 1u) << "two seconds here are not worth the wait for two there";
}

TEST_F(Placement, AJobWaitsForAWorkerThatHasItDoneFarSoonerAndNoLonger) {
  start_with(0);
  const auto slow = join("slow");
  do_one(slow, 1, seconds(30));
  const auto quick = join("quick");
  do_one(quick, 2, seconds(1));
  const auto first = edit(3);
  const auto second = edit(4);
  EXPECT_EQ(of(quick).tasks.size(), 1u);
  EXPECT_THAT(of(slow).tasks, IsEmpty()) << "done in two seconds there, in thirty here";
  finish(quick);
  ASSERT_EQ(of(quick).tasks.size(), 1u);
  quick->end("lost its connection");
  pass(milliseconds(100));
  ASSERT_EQ(of(slow).tasks.size(), 1u) << "with the quick one gone it goes to whom there is";
  finish(slow);
  EXPECT_TRUE(second.is_success());
}

TEST_F(Placement, WhoTakesFarLongerThanUsualIsNotWaitedForAnyMore) {
  start_with(0);
  const auto slow = join("slow");
  do_one(slow, 1, seconds(30));
  const auto quick = join("quick");
  do_one(quick, 2, seconds(1));
  const auto first = edit(3);
  const auto second = edit(4);
  ASSERT_THAT(of(slow).tasks, IsEmpty());
  pass(milliseconds(3900));
  EXPECT_THAT(of(slow).tasks, IsEmpty());
  pass(milliseconds(400));
  ASSERT_EQ(of(slow).tasks.size(), 1u)
    << "one that should take a second has not answered after four";
  finish(slow);
  EXPECT_TRUE(second.is_success());
}

TEST_F(Placement, HalfAMinuteOfOthersIsNotWaitedFor) {
  start_with(0);
  const auto slow = join("slow");
  do_one(slow, 1, seconds(30));
  const auto quick = join("quick");
  do_one(quick, 2, seconds(10));
  const auto first = edit(3);
  const auto second = edit(4);
  EXPECT_EQ(of(quick).tasks.size(), 1u);
  EXPECT_EQ(of(slow).tasks.size(), 1u) << "20 s there and 30 s here: a free one is certain";
}

TEST_F(Placement, ADocumentStaysWhereItsLastJobWas) {
  start_with(0);
  const auto slow = join("slow");
  const auto document = ear();
  const auto first = edit_of(document, 1);
  pass(seconds(2));
  finish(slow);
  const auto quick = join("quick");
  do_one(quick, 2, seconds(1));
  const auto second = edit_of(document, 3);
  EXPECT_EQ(of(slow).tasks.size(), 1u);
}

}  // namespace
}  // namespace tedit::actors
