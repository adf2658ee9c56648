// SPDX-License-Identifier: AGPL-3.0-or-later
// Workers that are killed or frozen in the middle of their work: it is done again, nothing is lost.
#include <future>

#include "tests/scenarios/served.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

class WorkerDeath : public ::testing::Test {
protected:
  scratch_folder folder;
  std::unique_ptr<server> host = start(options_for(folder, true));
  std::unique_ptr<client::client> user = connect(host->url());
  std::unique_ptr<client::client> watcher = connect(host->url());
  client::committed imported;

  void SetUp() override {
    value(user->open("plate", true, true));
    imported = value(user->import_file(plate_mesh, "mm", {}));
    value(user->set_load_case(value(protocol::load_case_from_file(plate_loads))));
  }

  client::worker_status status_of(const std::string& role) {
    for (auto& worker : value(watcher->status()).workers)
      if (worker.role == role)
        return worker;
    return {};
  }

  /// Waits until the role's status satisfies `wanted`; the last status seen.
  client::worker_status wait_for(const std::string& role,
                                 const std::function<bool(const client::worker_status&)>& wanted) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    auto seen = status_of(role);
    while (!wanted(seen) && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      seen = status_of(role);
    }
    EXPECT_TRUE(wanted(seen)) << role << " is " << seen.state << ": " << seen.detail;
    return seen;
  }

  /// Freezes the role's process, so that `work` is surely in its hands, and kills it then.
  template <class Work>
  auto kill_in_the_middle(const std::string& role, Work work) {
    const auto ready = wait_for(role, [](const auto& w) { return w.state == "ready"; });
    const auto pid = static_cast<pid_t>(ready.pid);
    EXPECT_EQ(::kill(pid, SIGSTOP), 0);
    auto result = std::async(std::launch::async, work);
    wait_for(role, [](const auto& w) { return w.jobs == 1; });
    EXPECT_EQ(::kill(pid, SIGKILL), 0);
    auto done = result.get();
    const auto after = wait_for(role, [](const auto& w) { return w.state == "ready"; });
    EXPECT_NE(after.pid, ready.pid);
    EXPECT_GE(after.restarts, 1U);
    return done;
  }

  expected<client::committed> fill() { return user->edit("fill_hole", {1, 2}, {}, {}); }
};

TEST_F(WorkerDeath, AnEditWhoseModelingWorkerIsKilledIsDoneAgain) {
  const auto filled = value(kill_in_the_middle("modeling", [&] { return fill(); }));

  EXPECT_EQ(filled.head.parent, imported.head.number);
  EXPECT_EQ(value(user->get_history()).versions.size(), 2U);
}

TEST_F(WorkerDeath, AnEditWhoseOptimizerIsKilledIsDoneAgain) {
  const auto filled = value(kill_in_the_middle("optimizer", [&] { return fill(); }));

  EXPECT_EQ(value(user->get_history()).head, filled.head.number);
}

TEST_F(WorkerDeath, ASelectionWhoseModelingWorkerIsKilledIsDoneAgain) {
  const auto holes = value(kill_in_the_middle("modeling", [&] {
    return user->select({feature_kind::hole, {1}}, {});
  }));

  ASSERT_EQ(holes.size(), 1U);
  EXPECT_EQ(holes.front().surfaces, (std::vector<surface_id>{1, 2}));
}

TEST_F(WorkerDeath, ASolveWhoseWorkerIsKilledIsDoneAgain) {
  const auto report =
    value(kill_in_the_middle("solver", [&] { return user->solve({.device = "cpu"}, {}); }));

  EXPECT_EQ(report.version_id, imported.head.version_id);
  EXPECT_LT(report.true_relative_residual, 1e-6);
}

TEST_F(WorkerDeath, ALoadCaseThatIsChangedEndsTheSolveOfTheOldOneAndIsSolvedItself) {
  auto loads = value(protocol::load_case_from_file(plate_loads));
  const auto ready = wait_for("solver", [](const auto& w) { return w.state == "ready"; });
  EXPECT_EQ(::kill(static_cast<pid_t>(ready.pid), SIGSTOP), 0);  // It will not end by itself.
  auto old = std::async(std::launch::async, [&] { return user->solve({.device = "cpu"}, {}); });
  wait_for("solver", [](const auto& w) { return w.jobs == 1; });
  value(watcher->open("plate", false, false));
  value(watcher->set_load_case(loads));  // The same again.
  loads.name = "another";
  value(watcher->set_load_case(loads));
  EXPECT_EQ(old.wait_for(std::chrono::milliseconds(100)), std::future_status::timeout);

  loads = value(protocol::load_case_from_file(plate_loads));
  loads.materials.front().young_modulus_pa *= 2;
  value(watcher->set_load_case(loads));

  const auto ended = old.get();
  ASSERT_FALSE(ended.has_value());
  EXPECT_EQ(ended.error().code, ec::superseded);
  EXPECT_THAT(ended.error().message, HasSubstr("was changed"));
  ::kill(static_cast<pid_t>(ready.pid), SIGCONT);
  const auto field = value(user->wait_field(imported.head.version_id, patience));
  const auto again = value(user->solve({.device = "cpu"}, {}));
  EXPECT_EQ(field.report.compliance_j, again.compliance_j);  // It was solved already.
  value(user->set_load_case(value(protocol::load_case_from_file(plate_loads))));
  const auto before = value(user->solve({.device = "cpu"}, {}));
  EXPECT_NEAR(2 * again.compliance_j, before.compliance_j, 1e-5 * before.compliance_j);
}

TEST_F(WorkerDeath, ANewerHeadEndsTheSolveOfTheOlderOneAndIsSolvedItself) {
  const auto ready = wait_for("solver", [](const auto& w) { return w.state == "ready"; });
  ASSERT_EQ(::kill(static_cast<pid_t>(ready.pid), SIGSTOP), 0);  // It will not end by itself.
  auto old = std::async(std::launch::async, [&] { return user->solve({.device = "cpu"}, {}); });
  wait_for("solver", [](const auto& w) { return w.jobs == 1; });

  value(watcher->open("plate", false, false));
  const auto filled = value(watcher->edit("fill_hole", {1, 2}, {}, {}));

  const auto ended = old.get();
  ASSERT_FALSE(ended.has_value());
  EXPECT_EQ(ended.error().code, ec::superseded) << render(ended.error());
  ::kill(static_cast<pid_t>(ready.pid), SIGCONT);
  const auto field = value(user->wait_field(filled.head.version_id, patience));
  EXPECT_EQ(field.report.version_id, filled.head.version_id);
}

TEST_F(WorkerDeath, KillsAtAnyMomentOfAnEditAndSolveLoseNothing) {
  // No freeze here: the moment of the kill is wherever the work happens to be.
  const std::array roles{"modeling", "optimizer", "solver"};
  std::string head = imported.head.version_id;
  for (const auto* role : roles)
    wait_for(role, [](const auto& w) { return w.state == "ready"; });
  for (int delay = 0; delay < 3; ++delay) {
    const auto* role = roles[static_cast<std::size_t>(delay)];
    const auto before = status_of(role);
    auto work = std::async(std::launch::async, [&] { return fill(); });
    auto solve = std::async(std::launch::async, [&] { return user->solve({.device = "cpu"}, {}); });
    std::this_thread::sleep_for(std::chrono::milliseconds(7 * delay));
    ASSERT_EQ(::kill(static_cast<pid_t>(before.pid), SIGKILL), 0);
    const auto filled = value(work.get());
    const auto solved = solve.get();
    if (solved) {
      // Whichever head it was asked for, it was really solved.
      EXPECT_THAT((std::array{head, filled.head.version_id}),
                  ::testing::Contains(solved->version_id));
      EXPECT_LT(solved->true_relative_residual, 1e-6);
    } else {
      EXPECT_EQ(solved.error().code, ec::superseded) << render(solved.error());
    }
    wait_for(role, [&](const auto& w) {
      return w.state == "ready" && w.pid != before.pid && w.restarts > before.restarts;
    });
    const auto versions = value(user->get_history());
    EXPECT_EQ(versions.head, filled.head.number);
    EXPECT_EQ(versions.versions.size(), 2U + static_cast<std::size_t>(delay));
    EXPECT_EQ(value(user->wait_field(filled.head.version_id, patience)).report.version_id,
              filled.head.version_id);
    EXPECT_EQ(value(user->undo()).head.version_id, head);
  }
}

TEST_F(WorkerDeath, AFrozenWorkerIsReplaced) {
  const auto frozen = wait_for("modeling", [](const auto& w) { return w.state == "ready"; });
  ::kill(static_cast<pid_t>(frozen.pid), SIGSTOP);

  const auto filled = value(fill());  // The heartbeat notices after some seconds.

  EXPECT_EQ(filled.head.number, 1U);
  EXPECT_NE(status_of("modeling").pid, frozen.pid);
  EXPECT_TRUE(all_end({static_cast<pid_t>(frozen.pid)}));  // It does not come back.
}

TEST_F(WorkerDeath, ACancelledJobOfAFrozenWorkerEndsSoon) {
  const auto frozen = wait_for("modeling", [](const auto& w) { return w.state == "ready"; });
  ::kill(static_cast<pid_t>(frozen.pid), SIGSTOP);
  execution run;
  auto work = std::async(std::launch::async, [&] {
    return user->edit("fill_hole", {1, 2}, {}, run);
  });
  wait_for("modeling", [](const auto& w) { return w.jobs == 1; });
  run.cancel.cancel();

  const auto result = work.get();

  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ec::cancelled);
  EXPECT_EQ(value(user->get_history()).versions.size(), 1U);
  EXPECT_EQ(value(fill()).head.number, 1U);
}

TEST_F(WorkerDeath, ASolveThatFollowedAnEditIsEndedByAnyoneAndTheNextHeadIsSolvedAgain) {
  std::promise<std::string> ended;
  client::events handlers;
  handlers.on_solve_status = [&](const client::solve_status& status) {
    if (status.phase == client::solve_phase::cancelled)
      ended.set_value(status.version_id);
  };
  const auto other = connect(host->url(), handlers);
  value(other->open("plate", false, true));
  value(other->cancel_solve());  // None runs: nothing.
  value(user->solve({.device = "cpu"}, {}));
  const auto solver = wait_for("solver", [](const auto& w) { return w.state == "ready"; });
  ASSERT_EQ(::kill(static_cast<pid_t>(solver.pid), SIGSTOP), 0);
  const auto filled = value(fill());
  wait_for("solver", [](const auto& w) { return w.jobs == 1; });

  value(other->cancel_solve());
  auto told = ended.get_future();
  ASSERT_EQ(told.wait_for(patience), std::future_status::ready);
  EXPECT_EQ(told.get(), filled.head.version_id);
  ::kill(static_cast<pid_t>(solver.pid), SIGCONT);

  const auto next = value(user->edit("fill_hole", {51, 52}, {}, {}));
  EXPECT_EQ(value(user->wait_field(next.head.version_id, patience)).report.version_id,
            next.head.version_id);
}

/// Two connections wait for one solve, and the first or the second of them cancels.
class SharedSolve : public WorkerDeath, public ::testing::WithParamInterface<bool> {};

INSTANTIATE_TEST_SUITE_P(FirstOrSecondLeaves, SharedSolve, ::testing::Bool());

TEST_P(SharedSolve, ACancelEndsTheWaitOfOneAndTheOtherGetsTheResult) {
  value(watcher->open("plate", false, false));
  const auto solver = wait_for("solver", [](const auto& w) { return w.state == "ready"; });
  ASSERT_EQ(::kill(static_cast<pid_t>(solver.pid), SIGSTOP), 0);  // It will not end by itself.
  const std::array<client::client*, 2> who{user.get(), watcher.get()};
  std::array<execution, 2> runs;
  std::array<std::future<expected<solve_report>>, 2> answers;
  for (std::size_t i = 0; i < 2; ++i) {
    answers[i] =
      std::async(std::launch::async, [&, i] { return who[i]->solve({.device = "cpu"}, runs[i]); });
    wait_for("solver", [](const auto& w) { return w.jobs == 1; });
  }
  EXPECT_EQ(answers[1].wait_for(std::chrono::milliseconds(200)), std::future_status::timeout);
  const std::size_t leaves = GetParam() ? 0 : 1;

  runs[leaves].cancel.cancel();

  const auto ended = answers[leaves].get();
  ::kill(static_cast<pid_t>(solver.pid), SIGCONT);
  ASSERT_FALSE(ended.has_value());
  EXPECT_EQ(ended.error().code, ec::cancelled) << render(ended.error());
  EXPECT_LT(value(answers[1 - leaves].get()).true_relative_residual, 1e-6);
  // Who stayed has asked for every head.
  const auto next = value(fill());
  EXPECT_EQ(value(user->wait_field(next.head.version_id, patience)).report.version_id,
            next.head.version_id);
}

TEST_F(WorkerDeath, TooManyDeathsDegradeTheRoleAndOthersGoOn) {
  for (int death = 0; death < 4; ++death) {
    const auto ready =
      wait_for("modeling", [](const auto& w) { return w.state == "ready" && w.pid != 0; });
    ::kill(static_cast<pid_t>(ready.pid), SIGKILL);
    wait_for("modeling", [&](const auto& w) { return w.pid != ready.pid; });
  }
  wait_for("modeling", [](const auto& w) { return w.state == "degraded"; });

  const auto refused = fill();

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::service_unavailable);
  EXPECT_THAT(render(refused.error()), HasSubstr("signal 9"));
  value(user->solve({.device = "cpu"}, {}));
}

// As a large process ends, or any on a busy machine: its link is down well before its end is known.
TEST(WorkerEnd, OfOneThatTakesItsTimeIsToldAsItWas) {
  const scratch_folder folder;
  auto options = options_for(folder, true);
  options.program = folder.path() / "slow_end";
  std::ofstream(options.program) << "#!/bin/bash\n" TEDIT_BIN "/tedit \"$@\" &\nexec 3<&-\n"
                                 << "wait $!\nhow=$?\nsleep 0.3\nkill -$((how - 128)) $$\n";
  std::filesystem::permissions(options.program, std::filesystem::perms(0700));
  const auto host = start(options);
  const auto user = connect(host->url());
  const auto modeling = [&] { return value(user->status()).workers.front(); };
  const auto wait_until = [&](const auto& wanted) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!wanted(modeling()) && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  wait_until([](const auto& w) { return w.state == "ready" && w.pid != 0; });
  ASSERT_EQ(modeling().role, "modeling");

  ASSERT_EQ(::kill(static_cast<pid_t>(modeling().pid), SIGKILL), 0);

  wait_until([](const auto& w) { return !w.detail.empty(); });
  EXPECT_THAT(modeling().detail, HasSubstr("signal 9"));
}

TEST(WorkerStart, WhoAsksForTheOperationsBeforeItGetsThemAfterIt) {
  const scratch_folder folder;
  auto options = options_for(folder, true);
  const auto gate = folder.path() / "gate";
  options.program = folder.path() / "slow_tedit";
  std::ofstream(options.program) << "#!/bin/sh\nuntil [ -e " << gate.string()
                                 << " ]; do sleep 0.05; done\nexec " TEDIT_BIN "/tedit \"$@\"\n";
  std::filesystem::permissions(options.program, std::filesystem::perms(0700));
  const auto host = start(options);
  const auto user = connect(host->url());

  auto asked = std::async(std::launch::async, [&] { return user->operations(); });
  EXPECT_EQ(asked.wait_for(std::chrono::milliseconds(200)), std::future_status::timeout);
  std::ofstream(gate).close();

  EXPECT_FALSE(value(asked.get()).operations.empty());
}

TEST(WorkerStart, WhenItFailsWhoAsksForTheOperationsHearsWhy) {
  const scratch_folder folder;
  auto options = options_for(folder, true);
  options.program = "/bin/false";
  const auto host = start(options);

  const auto refused = connect(host->url())->operations();

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::service_unavailable);
  EXPECT_THAT(refused.error().message, HasSubstr("no modeling worker runs: process"));
}

}  // namespace
}  // namespace tedit::test
