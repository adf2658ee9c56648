// SPDX-License-Identifier: AGPL-3.0-or-later
// The server's own process is killed: what was acknowledged is there when it comes back.
#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "base/process.hpp"
#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

/// `tedit serve` as a process of its own.
class served {
public:
  explicit served(const scratch_folder& folder) {
    const auto ready = folder.path() / "ready";
    std::filesystem::remove(ready);
    const auto documents = (folder.path() / "documents").string();
    const auto token = (folder.path() / "token").string();
    pid_ = value(spawn_process({TEDIT_BIN "/tedit", "serve", "--quiet", "--port", "0",
                                "--documents", documents, "--token-file", token, "--ready-file",
                                ready.string(), "--device", "cpu"}));
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!std::filesystem::exists(ready) && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::ifstream in(ready);
    const auto state = nlohmann::json::parse(in);
    options_.url = state["url"];
    std::ifstream(token) >> options_.token;
    options_.client_name = "test";
    struct stat about {};
    EXPECT_EQ(::stat(token.c_str(), &about), 0);
    EXPECT_EQ(about.st_mode & 0777, 0600U);
  }
  served(const served&) = delete;
  served& operator=(const served&) = delete;
  ~served() { kill(); }

  void kill() {
    if (pid_ > 0)
      kill_process(pid_);
    pid_ = 0;
  }

  /// Ends it as Ctrl-C does; its last words.
  std::string interrupt() {
    ::kill(pid_, SIGINT);
    std::optional<std::string> how;
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!how && std::chrono::steady_clock::now() < deadline) {
      how = reap_process(pid_);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    if (how)
      pid_ = 0;
    return how.value_or("still runs");
  }

  std::unique_ptr<client::client> connect() { return value(client::client::connect(options_, {})); }

private:
  pid_t pid_ = 0;
  client::connect_options options_;
};

std::vector<pid_t> workers_of(client::client& user) {
  std::vector<pid_t> pids;
  for (const auto& worker : value(user.status()).workers)
    if (worker.pid != 0)
      pids.push_back(static_cast<pid_t>(worker.pid));
  return pids;
}

/// Whether a process runs; one that has ended and waits for its parent does not.
bool runs(pid_t pid) {
  std::ifstream in("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  if (!std::getline(in, line))
    return false;
  const char state = line[line.rfind(')') + 2];
  return state != 'Z' && state != 'X';
}

/// Waits until none of the processes runs.
bool all_end(const std::vector<pid_t>& pids) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (std::chrono::steady_clock::now() < deadline) {
    if (std::ranges::none_of(pids, runs))
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

TEST(ServerDeath, AcknowledgedVersionsAreThereAfterAKillAtAnyMoment) {
  const scratch_folder folder;
  std::set<std::string> acknowledged;
  for (int round = 0; round < 3; ++round) {
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
      std::this_thread::sleep_for(std::chrono::milliseconds(150 + 37 * round));
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
