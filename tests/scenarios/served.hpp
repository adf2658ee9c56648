// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "base/process.hpp"
#include "protocol/version.hpp"
#include "tedit/v1/envelope.pb.h"
#include "tests/scenarios/fixture.hpp"

namespace tedit::test {

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

  [[nodiscard]] pid_t pid() const { return pid_; }
  [[nodiscard]] const std::string& url() const { return options_.url; }

  /// The message that a client begins with.
  [[nodiscard]] std::string hello() const {
    v1::ClientMessage message;
    message.set_request_id(1);
    message.mutable_hello()->set_protocol_major(protocol::major_version);
    message.mutable_hello()->set_protocol_minor(protocol::minor_version);
    message.mutable_hello()->set_token(options_.token);
    return message.SerializeAsString();
  }

  std::unique_ptr<client::client> connect(client::events handlers = {}) {
    return value(client::client::connect(options_, std::move(handlers)));
  }

private:
  pid_t pid_ = 0;
  client::connect_options options_;
};

inline std::vector<pid_t> workers_of(client::client& user) {
  std::vector<pid_t> pids;
  for (const auto& worker : value(user.status()).workers)
    if (worker.pid != 0)
      pids.push_back(static_cast<pid_t>(worker.pid));
  return pids;
}

/// Whether a process runs; one that has ended and waits for its parent does not.
inline bool runs(pid_t pid) {
  std::ifstream in("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  if (!std::getline(in, line))
    return false;
  const char state = line[line.rfind(')') + 2];
  return state != 'Z' && state != 'X';
}

/// Waits until none of the processes runs.
inline bool all_end(const std::vector<pid_t>& pids) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (std::chrono::steady_clock::now() < deadline) {
    if (std::ranges::none_of(pids, runs))
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace tedit::test
