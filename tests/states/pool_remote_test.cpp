// SPDX-License-Identifier: AGPL-3.0-or-later
// A pool whose workers come from other machines, alone or beside its own.
#include "actors/node/remote.hpp"
#include "tests/states/remote_pool_fixture.hpp"

namespace tedit::actors {
namespace {

using std::chrono::seconds;

TEST_F(RemotePool, WithoutWorkersOfItsOwnItSaysWhatIsMissingUntilOneJoins) {
  start_with(0);

  const auto refused = edit(1).refusal();
  EXPECT_EQ(refused.code, ec::service_unavailable);
  EXPECT_THAT(refused.message, HasSubstr("no modeling worker has joined this server"));
  EXPECT_THAT(refused.remedy, HasSubstr("tedit worker --join"));
  EXPECT_EQ(status().state, "degraded");

  const auto node = join("rack-2");
  const auto done = edit(2);
  EXPECT_EQ(status().nodes.at(0).state, "working");
  finish(node);

  EXPECT_TRUE(done.is_success());
  EXPECT_EQ(status().state, "ready");
  const auto shown = status().nodes.at(0);
  EXPECT_EQ(shown.name, "rack-2");
  EXPECT_EQ(shown.address, "10.0.0.7");
  EXPECT_EQ(shown.role, "modeling");
  EXPECT_EQ(shown.state, "idle");
  EXPECT_EQ(shown.jobs_done, 1u);
  EXPECT_THAT(processes_->all, IsEmpty());
}

TEST_F(RemotePool, TheJobOfALostConnectionIsDoneOnceByAnother) {
  start_with(0);
  const auto first = join("a");
  const auto second = join("b");
  const auto done = edit(1);
  ASSERT_EQ(of(first).tasks.size(), 1u);

  first->end("lost its connection");
  pass(seconds(1));

  EXPECT_FALSE(done.is_there());
  ASSERT_EQ(of(second).tasks.size(), 1u);
  finish(second);
  EXPECT_TRUE(done.is_success());
  EXPECT_EQ(done.count(), 1);
  EXPECT_EQ(status().nodes.size(), 1u);
}

TEST_F(RemotePool, TheJobOfTheOnlyOneWaitsForItToJoinAgain) {
  start_with(0);
  const auto first = join("a");
  const auto done = edit(1);
  first->end("lost its connection");
  pass(seconds(5));
  EXPECT_FALSE(done.is_there());
  const auto later = edit(2);
  EXPECT_FALSE(later.is_there()) << "it waits, too";

  const auto again = join("a");
  ASSERT_EQ(of(again).tasks.size(), 1u);
  finish(again);
  finish(again);
  EXPECT_TRUE(done.is_success());
  EXPECT_TRUE(later.is_success());
}

TEST_F(RemotePool, WhoDoesNotComeBackWithinTenSecondsIsWaitedForNoLonger) {
  start_with(0);
  const auto only = join("a");
  const auto waits = edit(1);
  only->end("lost its connection");
  pass(milliseconds(9900));
  EXPECT_FALSE(waits.is_there());
  pass(milliseconds(300));
  EXPECT_EQ(waits.refusal().code, ec::service_unavailable);
  EXPECT_THAT(waits.refusal().message, HasSubstr("no modeling worker has joined this server"));
  EXPECT_EQ(edit(2).refusal().code, ec::service_unavailable) << "at once";
}

TEST_F(RemotePool, OneThatLeftIsNotWaitedFor) {
  start_with(0);
  const auto only = join("a");
  tell(caf::actor_cast<caf::actor>(pool_), retirement{"it is being stopped"},
       only->worker.address());
  pass(seconds(31));
  EXPECT_EQ(edit(1).refusal().code, ec::service_unavailable);
}

TEST_F(RemotePool, ProcessesOfItsOwnAreStartedAsIfNobodyHadJoined) {
  start_with(1);
  const auto node = join("a");
  EXPECT_EQ(processes_->all.size(), 1u);
  EXPECT_EQ(status().pid, 1) << "of its own one";

  crash();
  EXPECT_EQ(processes_->all.size(), 2u) << "its own is started anew";
  node->end("lost its connection");
  pass(seconds(5));
  EXPECT_EQ(processes_->all.size(), 2u) << "nobody can start one elsewhere";
  EXPECT_EQ(status().restarts, 1u);
  EXPECT_THAT(status().nodes, IsEmpty());
}

TEST_F(RemotePool, WhatTakesTooLongIsCutOff) {
  pool_options options;
  options.workers = 0;
  options.job_limit = seconds(10);
  start(std::move(options));
  const auto node = join("a");
  const auto late = edit(1);

  pass(seconds(11));

  EXPECT_EQ(late.refusal().code, ec::timeout);
  EXPECT_EQ(node->how, "was cut off");
  EXPECT_THAT(status().nodes, IsEmpty());
}

TEST_F(RemotePool, OneThatLeavesEndsItsWorkAndGetsNoMore) {
  start_with(0);
  const auto leaving = join("a");
  const auto staying = join("b");
  const auto first = edit(1);
  ASSERT_EQ(of(leaving).tasks.size(), 1u);

  const auto pool = caf::actor_cast<caf::actor>(pool_);
  caf::anon_send(pool, retirement{"says somebody of another node"}, leaving->worker.address());
  pass(milliseconds(1));
  EXPECT_EQ(status().nodes.at(0).state, "working");
  tell(pool, retirement{"it is being stopped"}, leaving->worker.address());
  const auto second = edit(2);
  EXPECT_EQ(of(leaving).tasks.size(), 1u);
  EXPECT_EQ(of(staying).tasks.size(), 1u);
  EXPECT_EQ(status().nodes.at(0).state, "leaving");
  finish(leaving);
  EXPECT_TRUE(first.is_success());
  EXPECT_EQ(leaving->how, "") << "others still fetch its result";

  pass(seconds(31));
  EXPECT_EQ(leaving->how, "was cut off");
  EXPECT_EQ(status().nodes.size(), 1u);
}

TEST_F(RemotePool, OneThatLeavesWithoutHavingWorkedIsNotKept) {
  start_with(0);
  const auto leaving = join("a");
  join("b");
  tell(caf::actor_cast<caf::actor>(pool_), retirement{"it is being stopped"},
       leaving->worker.address());
  pass(milliseconds(200));
  EXPECT_EQ(leaving->how, "was cut off") << "nobody fetches anything of it";
  EXPECT_EQ(status().nodes.size(), 1u);
}

TEST_F(RemotePool, ADocumentsWorkGoesWhereItsLastWorkWas) {
  start_with(0);
  const auto first = join("a");
  const auto second = join("b");
  const auto bracket = stage_.system().spawn(make_puppet, 0);
  const auto plate = stage_.system().spawn(make_puppet, 0);
  edit_of(bracket, 1);
  edit_of(plate, 2);
  finish(first);
  finish(second);

  edit_of(plate, 3);
  EXPECT_THAT(of(first).tasks, IsEmpty());
  ASSERT_EQ(of(second).tasks.size(), 1u);
  edit_of(plate, 4);
  EXPECT_EQ(of(first).tasks.size(), 1u) << "rather elsewhere than later";
}

class NodeEnlister : public RemotePool {
protected:
  answer<node_answer> enlist(const std::string& role, const std::string& version) {
    const worker_set pools{pool_, {}, {}};
    const auto line = std::make_shared<made_up_line>("rack-2");
    line->worker = stage_.system().spawn(make_puppet, 0);
    const auto enlister = make_node_enlister(
      stage_.system(), pools, {"rack-2", "10.0.0.7", worker_role::modeling, line}, "1.4.2");
    node_facts facts;
    facts.name = "somebody else";
    facts.version = version;
    facts.device = "a\nb" + std::string(1000, 'x');
    const auto got = ask<node_answer>(enlister, node_enlistment{role, facts, line->worker});
    pass(milliseconds(1));
    end_enlister(enlister);
    return got;
  }
};

TEST_F(NodeEnlister, TakesInWhoseRoleAndVersionFit) {
  start_with(0);

  EXPECT_TRUE(enlist("modeling", "1.5.0").value().accepted);

  const auto node = status().nodes.at(0);
  EXPECT_EQ(node.name, "rack-2") << "as the certificate says, whatever it calls itself";
  EXPECT_EQ(node.device.size(), 200u);
  EXPECT_EQ(node.device.substr(0, 3), "abx") << "no line breaks in logs";
}

TEST_F(NodeEnlister, TurnsOthersAwayByName) {
  start_with(0);

  const auto role = enlist("solver", "1.4.2").value();
  EXPECT_FALSE(role.accepted);
  EXPECT_EQ(role.reason, "the certificate of rack-2 is one of a modeling worker, not of solver");
  EXPECT_THAT(role.remedy, HasSubstr("--role modeling"));

  const auto version = enlist("modeling", "1.6.0").value();
  EXPECT_FALSE(version.accepted);
  EXPECT_EQ(version.reason, "the worker is TEdit 1.6.0, the server 1.4.2");
  EXPECT_THAT(version.remedy, HasSubstr("at most one apart"));
  EXPECT_THAT(status().nodes, IsEmpty());
}

TEST_F(NodeEnlister, HearsOneWorkerAndLetsNobodyRetireAnothers) {
  start_with(0);
  const auto mine = std::make_shared<made_up_line>("rack-2");
  mine->worker = stage_.system().spawn(make_puppet, 0);
  const auto others = join("rack-1");
  const auto enlister = make_node_enlister(
    stage_.system(), {pool_, {}, {}}, {"rack-2", "10.0.0.7", worker_role::modeling, mine}, "1.4.2");
  // Before it has named a worker it has none that could leave.
  caf::anon_send(enlister, retirement{"it is being stopped"});
  node_facts facts;
  facts.version = "1.4.2";
  const node_enlistment who{"modeling", facts, mine->worker};
  const auto first = ask<node_answer>(enlister, who);
  pass(milliseconds(1));
  caf::anon_send(enlister, retirement{"it is being stopped"});
  pass(milliseconds(1));

  EXPECT_TRUE(first.value().accepted);
  EXPECT_EQ(status().nodes.at(0).state, "idle") << "of rack-1";
  EXPECT_EQ(status().nodes.at(1).state, "leaving");
  const auto second = ask<node_answer>(enlister, who);
  pass(milliseconds(1));
  EXPECT_FALSE(second.value().accepted);
  EXPECT_THAT(second.value().reason, HasSubstr("a second one"));
}

TEST(NodeVersions, OfTwoNeighbouringMinorsWorkTogether) {
  EXPECT_TRUE(work_together("1.4.2", "1.4.0"));
  EXPECT_TRUE(work_together("1.4.2", "1.5.0"));
  EXPECT_TRUE(work_together("1.4", "1.3.9"));
  EXPECT_FALSE(work_together("1.4.2", "1.6.0"));
  EXPECT_FALSE(work_together("1.4.2", "2.4.2"));
  for (const auto* none : {"", "1", "1.", "x.4", "1.4x", "-1", "1.99999999999"})
    EXPECT_FALSE(work_together(none, none)) << none;
}

}  // namespace
}  // namespace tedit::actors
