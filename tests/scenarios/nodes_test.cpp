// SPDX-License-Identifier: AGPL-3.0-or-later
// Workers that join a server over mutual TLS, as processes that have nothing else of it: they are
// killed, frozen and asked to leave, and their server dies.
#include <cstdio>
#include <future>

#include "tests/scenarios/nodes_fixture.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

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

// Its keeper holds key and connection.
TEST_F(Nodes, APluginThereReachesNeitherKeyNorNetwork) {
  if (const auto can = sandbox::check(); !can)
    GTEST_SKIP() << render(can.error());
  setenv("TEDIT_PLUGIN_PATH", TEDIT_ESCAPE, 1);
  serve(0, 1, 1);
  const auto modeling = join("modeling", "rack-1");
  unsetenv("TEDIT_PLUGIN_PATH");
  open_plate();
  const auto attempt = [&](const std::string& way, const std::filesystem::path& path) {
    const auto done = user->edit("escape", {1}, {{"way", way}, {"path", path.string()}}, {});
    return done ? "an edit" : done.error().message;
  };

  std::size_t files = 0;
  for (const auto& item : std::filesystem::directory_iterator(identity("rack-1"))) {
    EXPECT_THAT(attempt("read", item.path()), StartsWith("refused: ")) << item.path();
    ++files;
  }
  EXPECT_GE(files, 3U);
#ifndef TEDIT_SANITIZED
  EXPECT_THAT(attempt("read_environment", {}), StartsWith("refused: "));
  EXPECT_THAT(attempt("inet", {}), Not(HasSubstr("GOT OUT")));
  wait_until("rack-1", "idle");
#endif
  const auto honest = user->edit("fill_hole", {1, 2}, {}, {});
  EXPECT_TRUE(honest.has_value()) << render(honest.error());
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

TEST_F(Nodes, LoadCasesAreSharedOutAmongMachinesAndComeToTheSame) {
  const auto open = [&] {
    value(user->open("plate", true, true));
    value(user->import_file(plate_mesh, "mm", {}));
    for (int i = 1; i <= 6; ++i) {
      auto loads = value(protocol::load_case_from_file(plate_loads));
      loads.name = "case " + std::to_string(i);
      loads.loads.front().kind = fem::force{{1000. * i, 0, i == 3 ? -40000. : -5000.}};
      if (i % 2 == 0)
        loads.constraints.front().surfaces = {72, 73, 90, 91};
      value(user->set_load_case(loads));
    }
  };
  client::solve_settings all;
  all.device = "cpu";
  all.element_order = 1;
  all.all_load_cases = true;
  serve(1, 1, 1);
  open();
  const auto together = value(user->solve_cases(all, {}));

  serve(1, 1, 0);
  const auto first = join("solver", "rack-1");
  const auto second = join("solver", "rack-2");
  open();
  const auto apart = value(user->solve_cases(all, {}));
  for (const auto& one : value(watcher->status()).nodes)
    EXPECT_EQ(one.jobs_done, 1U) << one.name << ": three cases each";

  ASSERT_EQ(apart.cases.size(), 6U);
  for (std::size_t c = 0; c < 6; ++c) {
    const auto& a = apart.cases[c];
    const auto& b = together.cases[c];
    EXPECT_EQ(a.load_case, b.load_case);
    EXPECT_NEAR(a.max_von_mises_pa, b.max_von_mises_pa, 1e-5 * b.max_von_mises_pa);
    EXPECT_NEAR(a.compliance_j, b.compliance_j, 1e-6 * b.compliance_j);
  }
  EXPECT_EQ(apart.envelope->max_von_mises.load_case, together.envelope->max_von_mises.load_case);
  EXPECT_EQ(apart.envelope->load_cases, together.envelope->load_cases);
  const auto fields = value(user->wait_fields(apart.version_id(), patience));
  ASSERT_EQ(fields.size(), 7U) << "the envelope, too";
  const auto& worst = fields.back().values.of("von_mises_pa");
  ASSERT_EQ(worst.size(), fields.front().vertices.size());
  for (std::size_t v = 0; v < worst.size(); ++v) {
    float largest = 0;
    for (std::size_t c = 0; c < 6; ++c)
      largest = std::max(largest, fields[c].values.of("von_mises_pa")[v]);
    ASSERT_EQ(worst[v], largest) << v;
  }
  // What only files have is fetched from where it stayed: nobody solves once more.
  const auto file = value(user->export_file("vtu", {}, "mm", {}));
  const std::string text(file.begin(), file.end());
  EXPECT_THAT(text, HasSubstr("strain (case 1)"));
  EXPECT_THAT(text, HasSubstr("strain (case 6)"));
  for (const auto& one : value(watcher->status()).nodes)
    EXPECT_EQ(one.jobs_done, 1U) << one.name;
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
