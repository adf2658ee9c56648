// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "certs/authority.hpp"
#include "tests/scenarios/served.hpp"

namespace tedit::test {

/// "tedit worker --join", kept by a process of its own; each test has one authority for all.
class joined_worker {
public:
  explicit joined_worker(std::vector<std::string> command) : pid_(value(spawn_process(command))) {}
  joined_worker(const joined_worker&) = delete;
  joined_worker& operator=(const joined_worker&) = delete;
  ~joined_worker() {
    kill_worker();
    if (pid_ > 0)
      kill_process(pid_);
  }

  /// The process that is joined; 0 while none is.
  [[nodiscard]] pid_t worker() const {
    std::ifstream in("/proc/" + std::to_string(pid_) + "/task/" + std::to_string(pid_) +
                     "/children");
    pid_t child = 0;
    in >> child;
    return child;
  }
  void kill_worker() const {
    if (const auto child = worker())
      ::kill(child, SIGKILL);
  }
  void ask_to_leave() const { ::kill(pid_, SIGTERM); }

  /// How it ended; nothing when it has not within the patience of tests.
  std::optional<std::string> end() {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    std::optional<std::string> how;
    while (!how && std::chrono::steady_clock::now() < deadline) {
      how = reap_process(pid_);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    if (how)
      pid_ = 0;
    return how;
  }

private:
  pid_t pid_;
};

class Nodes : public ::testing::Test {
protected:
  void SetUp() override {
    value(certs::init(authority()).transform([](const auto&) {}));
    issue(certs::role::server, "office");
  }

  [[nodiscard]] std::filesystem::path authority() const { return folder.path() / "authority"; }
  [[nodiscard]] std::filesystem::path identity(const std::string& name) const {
    return folder.path() / name;
  }
  void issue(certs::role what, const std::string& name) const {
    value(certs::issue(authority(), {what, name, {"127.0.0.1"}}, identity(name))
            .transform([](const auto&) {}));
  }

  /// A server of which these kinds of work are done elsewhere.
  void serve(unsigned modeling, unsigned optimizer, unsigned solver) {
    auto options = options_for(folder, true);
    options.documents = folder.path() / "documents";
    options.modeling_workers = modeling;
    options.optimizer_workers = optimizer;
    options.solver_workers = solver;
    options.node_certificates = identity("office");
    options.retired_stay = std::chrono::milliseconds(500);
    host = start(options);
    user = connect(host->url());
    watcher = connect(host->url());
  }

  [[nodiscard]] std::vector<std::string> command(const std::string& name,
                                                 const std::string& role) const {
    return {TEDIT_BIN "/tedit", "worker",
            "--role",           role,
            "--join",           "127.0.0.1:" + std::to_string(*host->node_port()),
            "--certificates",   identity(name).string()};
  }

  std::unique_ptr<joined_worker> join(const std::string& role, const std::string& name) {
    issue(*certs::role_named(role), name);
    auto made = std::make_unique<joined_worker>(command(name, role));
    wait_for([&](const auto& all) { return std::ranges::count(all, name, &row::name) == 1; });
    return made;
  }

  using row = client::node_status;
  std::vector<row> wait_for(const std::function<bool(const std::vector<row>&)>& wanted) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    auto seen = value(watcher->status()).nodes;
    while (!wanted(seen) && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      seen = value(watcher->status()).nodes;
    }
    EXPECT_TRUE(wanted(seen)) << seen.size() << " nodes";
    return seen;
  }
  void wait_until(const std::string& name, const std::string& state) {
    wait_for([&](const auto& all) {
      const auto found = std::ranges::find(all, name, &row::name);
      return found != all.end() && found->state == state;
    });
  }

  void open_plate() {
    value(user->open("plate", true, true));
    value(user->import_file(plate_mesh, "mm", {}));
    value(user->set_load_case(value(protocol::load_case_from_file(plate_loads))));
  }
  expected<solve_report> solve() { return user->solve({.device = "cpu"}, {}); }

  scratch_folder folder;
  std::unique_ptr<server> host;
  std::unique_ptr<client::client> user;
  std::unique_ptr<client::client> watcher;
};

}  // namespace tedit::test
