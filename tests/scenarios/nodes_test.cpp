// SPDX-License-Identifier: AGPL-3.0-or-later
// Workers that join a server over mutual TLS, as processes that have nothing else of it: they are
// killed, frozen and asked to leave, and their server dies.
#include <cstdio>
#include <future>

#include "certs/authority.hpp"
#include "tests/scenarios/served.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

/// "tedit worker --join", kept by a process of its own; each test has one authority for all.
class node {
public:
  explicit node(std::vector<std::string> command) : pid_(value(spawn_process(command))) {}
  node(const node&) = delete;
  node& operator=(const node&) = delete;
  ~node() {
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

  std::unique_ptr<node> join(const std::string& role, const std::string& name) {
    issue(*certs::role_named(role), name);
    auto made = std::make_unique<node>(command(name, role));
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

TEST_F(Nodes, AllWorkIsDoneElsewhereAndComesToTheSame) {
  serve(1, 1, 1);
  open_plate();
  const auto edited_here = value(user->edit("fill_hole", {1, 2}, {}, {}));
  const auto solved_here = value(solve());

  serve(0, 0, 0);
  const auto refused = user->open("other", true, true).and_then([&](const auto&) {
    return user->import_file(plate_mesh, "mm", {});
  });
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::service_unavailable);
  EXPECT_THAT(refused.error().message, HasSubstr("no modeling worker has joined this server"));
  EXPECT_THAT(refused.error().remedy, HasSubstr("tedit worker --join"));

  const auto modeling = join("modeling", "rack-1");
  const auto optimizer = join("optimizer", "rack-2");
  const auto solver = join("solver", "rack-3");
  value(user->import_file(plate_mesh, "mm", {}));
  value(user->set_load_case(value(protocol::load_case_from_file(plate_loads))));
  const auto edited = value(user->edit("fill_hole", {1, 2}, {}, {}));
  const auto solved = value(solve());

  EXPECT_EQ(edited.head.version_id, edited_here.head.version_id);
  EXPECT_EQ(solved.max_von_mises_pa, solved_here.max_von_mises_pa);
  EXPECT_EQ(solved.max_displacement_m, solved_here.max_displacement_m);
  for (const auto& one : value(watcher->status()).nodes) {
    EXPECT_GE(one.jobs_done, 1U) << one.name;
    EXPECT_EQ(one.state, "idle") << one.name;
    EXPECT_THAT(one.address, HasSubstr("127.0.0.1:"));
    EXPECT_GT(one.threads, 0U);
    EXPECT_GT(one.memory_bytes, 0U);
    EXPECT_FALSE(one.version.empty());
  }
}

TEST_F(Nodes, TheWorkOfAKilledOneIsDoneByAnotherAndItComesBack) {
  serve(1, 1, 0);
  open_plate();
  const auto first = join("solver", "rack-1");
  const auto frozen = first->worker();
  ASSERT_GT(frozen, 0);
  ASSERT_EQ(::kill(frozen, SIGSTOP), 0);
  auto result = std::async(std::launch::async, [&] { return solve(); });
  wait_until("rack-1", "working");
  const auto second = join("solver", "rack-2");
  ASSERT_EQ(::kill(frozen, SIGKILL), 0);

  EXPECT_LT(value(result.get()).true_relative_residual, 1e-6);
  wait_until("rack-1", "idle");
  EXPECT_NE(first->worker(), frozen) << "kept, it has joined again";
  EXPECT_LT(value(solve()).true_relative_residual, 1e-6);
}

TEST_F(Nodes, AFrozenOneIsNoticedAndCutOff) {
  serve(1, 1, 0);
  open_plate();
  const auto first = join("solver", "rack-1");
  ASSERT_EQ(::kill(first->worker(), SIGSTOP), 0);
  auto result = std::async(std::launch::async, [&] { return solve(); });
  wait_until("rack-1", "working");
  const auto second = join("solver", "rack-2");

  EXPECT_LT(value(result.get()).true_relative_residual, 1e-6);
  wait_for([](const auto& all) { return all.size() == 1 && all[0].name == "rack-2"; });
}

TEST_F(Nodes, OneThatIsAskedToLeaveEndsItsWorkFirst) {
  serve(1, 1, 0);
  open_plate();
  const auto leaving = join("solver", "rack-1");
  const auto worker = leaving->worker();
  ASSERT_EQ(::kill(worker, SIGSTOP), 0);  // The work is surely in its hands.
  auto result = std::async(std::launch::async, [&] { return solve(); });
  wait_until("rack-1", "working");

  leaving->ask_to_leave();
  ASSERT_EQ(::kill(worker, SIGCONT), 0);

  EXPECT_LT(value(result.get()).true_relative_residual, 1e-6);
  EXPECT_EQ(leaving->end(), "ended with status 0");
  wait_for([](const auto& all) { return all.empty(); });
}

TEST_F(Nodes, AServerThatIsStartedAnewIsJoinedAgain) {
  serve(1, 1, 0);
  const auto port = *host->node_port();
  const auto solver = join("solver", "rack-1");
  host.reset();

  auto options = options_for(folder, true);
  options.documents = folder.path() / "documents";
  options.solver_workers = 0;
  options.node_certificates = identity("office");
  options.node_port = port;
  host = start(options);
  user = connect(host->url());
  watcher = connect(host->url());
  open_plate();
  wait_until("rack-1", "idle");

  EXPECT_LT(value(solve()).true_relative_residual, 1e-6);
}

TEST_F(Nodes, WhoCannotJoinIsToldWhyAndDoesNotTryForEver) {
  serve(1, 1, 0);
  issue(certs::role::solver, "rack-1");
  const auto said = [](const std::vector<std::string>& words) {
    std::string line = "timeout 60";
    for (const auto& word : words)
      line += " '" + word + "'";
    FILE* pipe = popen((line + " 2>&1 >/dev/null").c_str(), "r");
    std::string text;
    for (int c = 0; (c = std::fgetc(pipe)) != EOF;)
      text += static_cast<char>(c);
    return std::pair(WEXITSTATUS(pclose(pipe)), text);
  };
  {
    const auto [status, text] = said(command("rack-1", "modeling"));
    EXPECT_EQ(status, 1);
    EXPECT_THAT(text, HasSubstr("is one of a solver worker, not of modeling"));
    EXPECT_THAT(text, HasSubstr("--role solver"));
  }
  auto nowhere = command("rack-1", "solver");
  nowhere[5] = "somewhere";
  const auto [bad_place, why] = said(nowhere);
  EXPECT_EQ(bad_place, 2);
  EXPECT_THAT(why, HasSubstr("\"somewhere\" is no place to join"));
  auto without = command("missing", "solver");
  EXPECT_EQ(said(without).first, 65);
}

}  // namespace
}  // namespace tedit::test
