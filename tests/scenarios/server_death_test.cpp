// SPDX-License-Identifier: AGPL-3.0-or-later
// The server's own process is killed: what was acknowledged is there when it comes back.
#include <csignal>
#include <thread>

#include "tests/scenarios/served.hpp"

namespace tedit::test {
namespace {

/// kill -9 in a stream of edits; TEDIT_SERVER_KILLS=1000 is the long run.
TEST(ServerDeath, AcknowledgedVersionsAreThereAfterAKillAtAnyMoment) {
  const char* wanted = std::getenv("TEDIT_SERVER_KILLS");
  const int kills = wanted ? std::atoi(wanted) : 3;
  const scratch_folder folder;
  std::set<std::string> acknowledged;
  for (int round = 0; round < kills; ++round) {
    served host(folder);
    auto user = host.connect();
    const auto state = value(user->open("plate", false, false));
    if (round == 0)
      acknowledged.insert(value(user->import_file(plate_mesh, "mm", {})).head.version_id);
    else
      EXPECT_TRUE(state.head.has_value());
    std::set<std::string> there;
    for (const auto& version : value(user->get_history()).versions)
      there.insert(version.version_id);
    for (const auto& id : acknowledged)
      EXPECT_TRUE(there.contains(id)) << "round " << round << " lost " << id;
    const auto pids = workers_of(*user);
    std::thread killer([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(150 + 37 * round % 211));
      host.kill();
    });
    // Edits and undos until the connection breaks; each edit of another branch is a new version.
    while (true) {
      const auto filled = user->edit("fill_hole", {1, 2}, {}, {});
      if (!filled)
        break;
      acknowledged.insert(filled->head.version_id);
      if (!user->undo())
        break;
    }
    killer.join();
    EXPECT_TRUE(all_end(pids)) << "workers outlive their server";
  }
  served host(folder);
  auto user = host.connect();
  const auto state = value(user->open("plate", true, false));
  value(user->wait_surface(state.head->version_id, patience));
  value(user->set_load_case(value(protocol::load_case_from_file(plate_loads))));
  EXPECT_LT(value(user->solve({.device = "cpu"}, {})).true_relative_residual, 1e-6);
}

TEST(ServerDeath, CtrlCEndsServerAndWorkersInOrder) {
  const scratch_folder folder;
  served host(folder);
  auto user = host.connect();
  value(user->open("plate", false, false));
  const auto pids = workers_of(*user);

  EXPECT_EQ(host.interrupt(), "ended with status 0");

  EXPECT_TRUE(all_end(pids));
  EXPECT_FALSE(user->get_history().has_value());
  EXPECT_FALSE(user->connected());
}

TEST(ServerDeath, TwoServersDoNotShareADocument) {
  const scratch_folder folder;
  served one(folder);
  auto first = one.connect();
  value(first->open("plate", false, false));
  served two(folder);
  auto second = two.connect();

  const auto refused = second->open("plate", false, false);

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::conflict);
}

}  // namespace
}  // namespace tedit::test
