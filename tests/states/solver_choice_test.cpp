// SPDX-License-Identifier: AGPL-3.0-or-later
// Solvers of their own kind beside those of the program: who solves what.
#include "actors/supervisor/solver_choice.hpp"

#include "actors/supervisor/pool.hpp"
#include "tests/states/fixture.hpp"

namespace tedit::actors {
namespace {

/// Stands for a pool: answers with its name, and remembers what else it was told.
struct made_up_pool_state {
  std::vector<std::uint64_t> cancelled;
  std::vector<std::string> joined;
  int retired = 0;
  static inline const char* name = "made_up_pool";
};
using made_up_pool = caf::stateful_actor<made_up_pool_state>;

caf::behavior make_pool(made_up_pool* self, const std::string& name) {
  return {[=](job_id, const solve_order&) {
            solve_result result;
            result.fields.push_back({name});
            return result;
          },
          [=](cancel_atom, job_id job) { self->state.cancelled.push_back(job.value); },
          [=](status_atom) {
            worker_status status{"solver", name == "common" ? "ready" : "degraded"};
            status.jobs = 2;
            status.nodes.push_back({name + "-1"});
            return status;
          },
          [=](const remote_worker& guest) {
            self->state.joined.push_back(guest.node.name);
            return true;
          },
          [=](const retirement&, const caf::actor_addr&) { ++self->state.retired; }};
}

class SolverChoice : public States {
protected:
  SolverChoice() {
    pools_["common"] = spawn_pool("common");
    choice_ = make_solver_choice(stage_.system(), solver(pools_["common"]),
                                 [this](caf::actor_system&, const std::string& device) {
                                   pools_[device] = spawn_pool(device);
                                   return solver(pools_[device]);
                                 });
  }
  ~SolverChoice() override {
    caf::anon_send_exit(choice_, caf::exit_reason::user_shutdown);
    for (const auto& [name, pool] : pools_)
      caf::anon_send_exit(pool, caf::exit_reason::user_shutdown);
    pass(milliseconds(1));
  }

  caf::actor spawn_pool(const std::string& name) { return stage_.system().spawn(make_pool, name); }
  static solver_actor solver(const caf::actor& pool) { return caf::actor_cast<solver_actor>(pool); }
  made_up_pool_state& of(const std::string& name) {
    return dynamic_cast<made_up_pool&>(*caf::actor_cast<caf::abstract_actor*>(pools_.at(name)))
      .state;
  }

  bool join(const std::string& node, const std::string& device) {
    remote_worker guest;
    guest.node.name = node;
    guest.node.own_device = device;
    const auto taken = ask<bool>(choice_, guest);
    pass(milliseconds(1));
    return taken.value();
  }

  std::string solved_by(const std::string& device) {
    solve_order order;
    order.device = device;
    const auto result = ask<solve_result>(choice_, job_id{1}, order);
    pass(milliseconds(1));
    return result.value().fields.at(0).name;
  }

  std::map<std::string, caf::actor> pools_;
  solver_actor choice_;
};

TEST_F(SolverChoice, WhoAsksForADeviceOfItsOwnKindGetsItAndNobodyElseDoes) {
  EXPECT_EQ(solved_by("calculix"), "common") << "which says what devices there are";
  EXPECT_TRUE(join("rack-1", "CalculiX"));
  EXPECT_TRUE(join("rack-2", "calculix"));
  EXPECT_TRUE(join("rack-3", ""));

  EXPECT_EQ(pools_.size(), 2u) << "one pool for both";
  EXPECT_THAT(of("CalculiX").joined, ElementsAre("rack-1", "rack-2"));
  EXPECT_THAT(of("common").joined, ElementsAre("rack-3"));
  EXPECT_EQ(solved_by("calculix"), "CalculiX");
  EXPECT_EQ(solved_by("CALCULIX"), "CalculiX");
  EXPECT_EQ(solved_by("auto"), "common");
  EXPECT_EQ(solved_by(""), "common");
}

TEST_F(SolverChoice, StandsForAllOfThem) {
  EXPECT_TRUE(join("rack-1", "calculix"));
  caf::anon_send(choice_, cancel_atom::value, job_id{7});
  const auto all = caf::actor_cast<caf::actor>(choice_);
  tell(all, retirement{"it is being stopped"}, pools_["common"].address());
  caf::anon_send(all, retirement{"says somebody of another node"}, pools_["common"].address());
  const auto status = ask<worker_status>(choice_, status_atom::value);
  pass(milliseconds(1));

  EXPECT_THAT(of("common").cancelled, ElementsAre(7u));
  EXPECT_THAT(of("calculix").cancelled, ElementsAre(7u));
  EXPECT_EQ(of("common").retired + of("calculix").retired, 2);
  EXPECT_EQ(status.value().state, "ready") << "a device that nobody offers degrades nothing";
  EXPECT_EQ(status.value().jobs, 4u);
  ASSERT_EQ(status.value().nodes.size(), 2u);
  EXPECT_EQ(status.value().nodes[1].name, "calculix-1");
}

TEST_F(SolverChoice, TakesSixteenKindsAndNoNamesThatMeanSomethingElse) {
  for (const auto* name : {"cpu", "Auto", "lavapipe", "a b", "../x", "\xC3\xA4"})
    EXPECT_FALSE(join("rack", name)) << name;
  EXPECT_FALSE(join("rack", std::string(64, 'a')));
  for (std::size_t i = 0; i < most_own_devices; ++i)
    EXPECT_TRUE(join("rack", "kind-" + std::to_string(i)));
  EXPECT_FALSE(join("rack", "one-more"));
  EXPECT_TRUE(join("rack", "kind-3")) << "which is known";
}

TEST_F(SolverChoice, ItsEndIsTheirs) {
  EXPECT_TRUE(join("rack-1", "calculix"));
  caf::anon_send_exit(choice_, caf::exit_reason::user_shutdown);
  pass(milliseconds(1));

  const auto refused = ask<worker_status>(pools_["calculix"], status_atom::value);
  pass(milliseconds(1));
  EXPECT_FALSE(refused.is_success());
}

TEST_F(SolverChoice, APoolOfOneKindSaysWhichOneIsMissing) {
  pool_options options;
  options.role = worker_role::solver;
  options.workers = 0;
  options.device = "calculix";
  const auto pool = make_solver_pool(stage_.system(), options);
  const auto refused = ask<solve_result>(pool, job_id{1}, solve_order{});
  pass(milliseconds(1));

  EXPECT_EQ(refused.refusal().code, ec::service_unavailable);
  EXPECT_EQ(refused.refusal().message,
            "nobody who solves on \"calculix\" is joined to this server now");
  EXPECT_THAT(refused.refusal().remedy, HasSubstr("choose another device"));
  caf::anon_send_exit(pool, caf::exit_reason::user_shutdown);
  pass(milliseconds(1));
}

}  // namespace
}  // namespace tedit::actors
