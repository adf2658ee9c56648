// SPDX-License-Identifier: AGPL-3.0-or-later
// Programs of others as nodes of a server: a solver of one's own and an observer, over mutual TLS.
#include <atomic>
#include <future>
#include <mutex>

#include "fem/solver.hpp"
#include "node/node.hpp"
#include "tests/scenarios/nodes_fixture.hpp"

namespace tedit::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Solves as the program does, and counts.
struct own_solver {
  std::atomic<int> solves{0};
  double off_by = 1;  ///< A factor of its displacement.

  expected<std::vector<double>> operator()(const fem::problem& p, const execution& run) {
    ++solves;
    auto device = fem::open_backend("cpu");
    if (!device)
      return fail(device.error());
    auto result = fem::solve(p, **device, {}, run);
    if (!result)
      return fail(result.error());
    for (auto& u : result->displacement)
      u *= off_by;
    return std::move(result->displacement);
  }
};

class OwnNodes : public Nodes {
protected:
  [[nodiscard]] node::place place_of(const std::string& name) const {
    return {"127.0.0.1", *host->node_port(), identity(name)};
  }

  /// Ends with the test at the latest.
  std::future<expected<void>> offer(const std::string& name, own_solver& solver) {
    issue(certs::role::solver, name);
    auto ended = std::async(std::launch::async, [this, name, &solver] {
      return node::serve_solver(
        place_of(name), {"mine", [&](const auto& p, const auto& run) { return solver(p, run); }},
        stop);
    });
    wait_for([&](const auto& all) { return std::ranges::count(all, name, &row::name) == 1; });
    return ended;
  }

  expected<solve_report> solve_on(const std::string& device) {
    return user->solve({.device = device}, {});
  }

  cancel_token stop;
};

TEST_F(OwnNodes, ASolverIsChosenByItsNameAndItsResultsAreLikeOthers) {
  serve(1, 1, 1);
  open_plate();
  own_solver mine;
  auto ended = offer("rack-1", mine);

  const auto there = value(solve_on("cpu"));
  EXPECT_EQ(mine.solves, 0) << "it is not asked to solve for others";
  const auto here = value(solve_on("Mine"));
  EXPECT_EQ(mine.solves, 1);
  EXPECT_EQ(here.device, "mine");
  EXPECT_FALSE(here.preview);
  EXPECT_NEAR(here.max_von_mises_pa, there.max_von_mises_pa, 1e-6 * there.max_von_mises_pa);
  EXPECT_NEAR(here.max_displacement_m, there.max_displacement_m, 1e-6 * there.max_displacement_m);
  EXPECT_LT(here.true_relative_residual, 1e-6);

  value(user->edit("fill_hole", {1, 2}, {}, {}));
  EXPECT_EQ(value(solve_on("mine")).device, "mine");
  const auto rows = value(watcher->status()).nodes;
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].device, "mine");
  EXPECT_EQ(rows[0].role, "solver");

  stop.cancel();
  EXPECT_TRUE(ended.get().has_value());
  EXPECT_EQ(value(solve_on("mine")).device, "mine") << "it is known";
  value(user->edit("fill_hole", {92, 93}, {}, {}));
  const auto refused = solve_on("mine");
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().message, HasSubstr("nobody who solves on \"mine\" is joined"));
  value(solve_on("cpu"));
}

TEST_F(OwnNodes, WhatIsNoSolutionReachesNobody) {
  serve(1, 1, 1);
  open_plate();
  own_solver mine;
  mine.off_by = 1.05;
  auto ended = offer("rack-1", mine);

  const auto refused = solve_on("mine");
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::not_converged);
  EXPECT_THAT(refused.error().message, HasSubstr("what the solver mine gave is no solution"));
  stop.cancel();
  EXPECT_TRUE(ended.get().has_value());
}

TEST_F(OwnNodes, ALostServerIsSaidAndCanBeJoinedAgain) {
  serve(1, 1, 1);
  own_solver mine;
  auto ended = offer("rack-1", mine);
  user.reset();
  watcher.reset();
  host.reset();
  const auto how = ended.get();
  ASSERT_FALSE(how.has_value());
  EXPECT_EQ(how.error().code, ec::service_unavailable);
}

/// What an observer heard, for a test to wait for.
class heard {
public:
  void add(const std::string& what) {
    const std::lock_guard lock(mutex_);
    all_.push_back(what);
    news_.notify_all();
  }
  std::vector<std::string> wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, patience, [&] { return all_.size() >= count; });
    return all_;
  }

private:
  std::mutex mutex_;
  std::condition_variable news_;
  std::vector<std::string> all_;
};

class Observer : public OwnNodes {
protected:
  std::future<expected<void>> watch(const std::string& document) {
    issue(certs::role::observer, "eye");
    node::observer told;
    told.on_version = [this](const node::version_event& now) {
      last_version = now.mesh;
      events.add(now.cause + " " + std::to_string(now.number) +
                 (now.operation.empty() ? "" : " " + now.operation) +
                 (now.report ? " with a report" : ""));
    };
    told.on_result = [this](const node::result_event& now) {
      last_result = now;
      events.add("result " + now.outcome->cases.front().load_case);
    };
    told.on_load_cases = [this](const std::string&, const load_case_list& all) {
      events.add(std::to_string(all.size()) + " load cases");
    };
    told.on_name = [this](const std::string& before, const std::string& now) {
      events.add(before + " is " + now);
    };
    told.on_end = [this](const std::string& of, const std::string&) { events.add("end of " + of); };
    return std::async(std::launch::async, [this, told, document] {
      return node::observe(place_of("eye"), {document}, told, stop);
    });
  }

  heard events;
  version_ptr last_version;  ///< Read after an event was waited for.
  node::result_event last_result;
};

TEST_F(Observer, HearsAllThatBecomesOfADocument) {
  serve(1, 1, 1);
  open_plate();
  auto ended = watch("plate");
  events.wait_for(1);
  const auto edited = value(user->edit("fill_hole", {1, 2}, {}, {}));
  const auto solved = value(solve_on("cpu"));
  events.wait_for(3);
  EXPECT_EQ(to_hex(last_version->id()), edited.head.version_id);
  EXPECT_EQ(last_version->tet_count(), edited.head.tets);
  EXPECT_EQ(to_hex(last_result.mesh->id()), edited.head.version_id);
  const auto* stress = find_field(last_result.fields, "von_mises_pa");
  ASSERT_NE(stress, nullptr);
  double most = 0;
  for (std::size_t i = 0; i < stress->values.size(); ++i)
    most = std::max(most, stress->at(i));
  EXPECT_EQ(most, solved.max_von_mises_pa);

  value(user->undo({}));
  value(user->rename_document("sheet"));
  auto other = connect(host->url());
  EXPECT_THAT(events.wait_for(5),
              ElementsAre("head 0 import", "edit 1 fill_hole with a report",
                          "result ctc01_plate static", "undo 0 import", "plate is sheet"));
  stop.cancel();
  EXPECT_TRUE(ended.get().has_value());
}

TEST_F(Observer, ADocumentThatIsNotThereIsSaidAndNotMade) {
  serve(1, 1, 1);
  open_plate();
  const auto how = watch("plane").get();
  ASSERT_FALSE(how.has_value());
  EXPECT_EQ(how.error().code, ec::not_found);
  EXPECT_THAT(how.error().message, HasSubstr("there is no document plane"));
  EXPECT_THAT(value(node::documents(place_of("eye"))), ElementsAre("plate"));
}

TEST_F(Observer, ACertificateOpensNothingElse) {
  serve(1, 1, 1);
  open_plate();
  issue(certs::role::observer, "eye");
  issue(certs::role::solver, "rack-1");
  issue(certs::role::client, "ann");
  own_solver mine;
  const auto solves = [&](const auto& p, const auto& run) { return mine(p, run); };
  const auto as_solver = node::serve_solver(place_of("eye"), {"mine", solves}, stop);
  ASSERT_FALSE(as_solver.has_value());
  EXPECT_EQ(as_solver.error().code, ec::invalid_argument);
  EXPECT_THAT(as_solver.error().message,
              HasSubstr("the certificate of eye is one of an observer, not of a worker"));
  const auto as_observer = node::observe(place_of("rack-1"), {"plate"}, {}, stop);
  ASSERT_FALSE(as_observer.has_value());
  EXPECT_EQ(as_observer.error().code, ec::invalid_argument);
  EXPECT_THAT(as_observer.error().message,
              HasSubstr("the certificate of rack-1 is one of a solver worker, not of an observer"));
  const auto as_client = node::documents(place_of("ann"));
  ASSERT_FALSE(as_client.has_value());
  EXPECT_EQ(as_client.error().code, ec::invalid_argument);
  const auto badly_named = node::serve_solver(place_of("rack-1"), {"cpu", solves}, stop);
  ASSERT_FALSE(badly_named.has_value());
  EXPECT_THAT(badly_named.error().message, HasSubstr("\"cpu\" cannot be the name of a solver"));
}

}  // namespace
}  // namespace tedit::test
