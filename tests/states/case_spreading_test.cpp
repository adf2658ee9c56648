// SPDX-License-Identifier: AGPL-3.0-or-later
// Load cases of one solve on several machines, which do what a test says.
#include "actors/supervisor/case_spreading.hpp"

#include "actors/pages/page_store.hpp"
#include "actors/supervisor/merge_cases.hpp"
#include "actors/versions.hpp"
#include "fem/fields.hpp"
#include "tests/states/far_store.hpp"
#include "tests/states/remote_pool_fixture.hpp"

namespace tedit::actors {
namespace {

using names = std::vector<std::string>;

fem::load_case named(const std::string& name, surface_id held = 1) {
  fem::load_case result;
  result.name = name;
  fem::constraint support;
  support.surfaces = {held};
  result.constraints = {support};
  return result;
}

names names_of(const load_case_list& list) {
  names result;
  for (const auto& one : list)
    result.push_back(one.name);
  return result;
}

TEST(SpreadCases, SharesThemOutEvenlyAndKeepsThoseOfOneSystemTogether) {
  const load_case_list four{named("a", 1), named("b", 2), named("c", 1), named("d", 2)};
  const auto two = spread_cases(four, 2);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(names_of(two[0]), (names{"a", "c"}));
  EXPECT_EQ(names_of(two[1]), (names{"b", "d"}));
  const auto three = spread_cases(four, 3);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_EQ(three[0].size() + three[1].size() + three[2].size(), 4U);
  EXPECT_EQ(spread_cases(four, 9).size(), 4U) << "no machine without work";
  EXPECT_EQ(spread_cases(four, 1).front().size(), 4U);
}

/// What a solver would send of some cases: stress `first + i` at vertex i, a displacement.
struct made_result {
  solve_result result;
  std::vector<page_ptr> pages;
};

void add(made_result& to, const std::string& name, std::vector<double> values) {
  const field f{name, field_location::vertex, 1, paged_array<double>::from(values)};
  to.result.fields.push_back(make_ref(f));
  to.pages.insert(to.pages.end(), f.values.pages().begin(), f.values.pages().end());
}

made_result result_of(const std::map<std::string, std::vector<double>>& stresses) {
  made_result made;
  solve_outcome outcome;
  for (const auto& [name, values] : stresses) {
    solve_report report;
    report.version_id = "v";
    report.load_case = name;
    report.max_von_mises_pa = std::ranges::max(values);
    outcome.cases.push_back(report);
    add(made, fem::case_field("von_mises_pa", name), values);
  }
  if (stresses.size() > 1)
    add(made, "envelope_von_mises", {0, 0, 0});
  made.result.outcome = wire_value(outcome);
  made.result.more.push_back({fem::case_field("strain", stresses.begin()->first)});
  return made;
}

page_set set_of(const std::vector<made_result>& results) {
  auto map = std::make_shared<page_map>();
  for (const auto& one : results)
    for (const auto& p : one.pages)
      map->emplace(p->id(), p);
  return {map, 0};
}

std::vector<double> values_of(const merged_cases& merged, const std::string& name) {
  auto map = std::make_shared<page_map>();
  for (const auto& p : merged.pages)
    map->emplace(p->id(), p);
  const auto found = std::ranges::find(merged.result.fields, name, &field_ref::name);
  return found == merged.result.fields.end()
           ? std::vector<double>()
           : open_field(*found, {map, 0}).value().values.to_vector();
}

TEST(MergeCases, TheWorstOfAllPartsInTheOrderThatWasAskedFor) {
  const std::vector parts{result_of({{"b", {1, 5, 3}}}),
                          result_of({{"a", {2, 4, 3}}, {"c", {0, 9, 1}}})};
  const std::vector results{parts[0].result, parts[1].result};
  const auto merged = merge_cases(results, {"a", "b", "c"}, set_of(parts)).value();
  const auto& outcome = **merged.result.outcome.get();
  ASSERT_EQ(outcome.cases.size(), 3U);
  EXPECT_EQ(outcome.cases[1].load_case, "b");
  EXPECT_EQ(outcome.envelope->max_von_mises.load_case, "c");
  EXPECT_EQ(outcome.envelope->max_von_mises.value, 9);
  EXPECT_THAT(values_of(merged, "envelope_von_mises"), ElementsAre(2, 9, 3));
  EXPECT_THAT(values_of(merged, "envelope_case"), ElementsAre(0, 2, 0));
  EXPECT_THAT(values_of(merged, "von_mises_pa (b)"), ElementsAre(1, 5, 3));
  EXPECT_THAT(values_of(merged, "envelope_safety_factor"), IsEmpty());
  EXPECT_EQ(merged.result.more.size(), 2U);
}

TEST(MergeCases, PartsThatDoNotBelongTogetherAreRefused) {
  const std::vector parts{result_of({{"a", {1, 2}}}), result_of({{"b", {1, 2, 3}}})};
  const std::vector results{parts[0].result, parts[1].result};
  EXPECT_EQ(merge_cases(results, {"a", "b"}, set_of(parts)).error().code, ec::protocol_error);
  const auto missing = merge_cases(results, {"a", "b", "c"}, set_of(parts));
  EXPECT_THAT(missing.error().message, HasSubstr("\"c\""));
  const auto no_array = result_of({{"a", {1}}});
  auto without = no_array.result;
  without.fields.clear();
  const std::vector one_lacks{without, parts[1].result};
  EXPECT_FALSE(merge_cases(one_lacks, {"a", "b"}, set_of(parts)));
}

/// All machines with solvers.
struct machines_state {
  struct task {
    job_id job;
    names load_cases;
    bool of_several = false;
    caf::actor listener;
    caf::typed_response_promise<solve_result> promise;
  };
  std::deque<task> tasks;
  std::vector<std::uint64_t> cancelled;
  std::uint32_t free_machines = 2;
  static inline const char* name = "machines";
};
using machines_actor = caf::stateful_actor<machines_state>;

caf::behavior make_machines(machines_actor* self, int /*number*/) {
  return {[=](job_id job, const solve_order& order) {
            auto promise = self->make_response_promise<solve_result>();
            self->state.tasks.push_back({job, names_of(**order.load_cases.get()), order.of_several,
                                         order.base.listener, promise});
            return promise;
          },
          [=](cancel_atom, job_id job) { self->state.cancelled.push_back(job.value); },
          [=](status_atom) {
            worker_status status{"solver", "ready"};
            status.free_machines = self->state.free_machines;
            return status;
          },
          [](const doing& that) { that.what(); }};
}

struct notes_state {
  std::vector<job_frame> frames;
  std::vector<job_preview> previews;
  static inline const char* name = "notes";
};
using notes_actor = caf::stateful_actor<notes_state>;

caf::behavior make_notes(notes_actor* self, int /*number*/) {
  return {[=](const job_frame& one) { self->state.frames.push_back(one); },
          [=](const job_preview& one) { self->state.previews.push_back(one); }};
}

template <class Actor>
auto& state_of(const caf::actor& one) {
  return dynamic_cast<Actor&>(*caf::actor_cast<caf::abstract_actor*>(one)).state;
}

class CaseSpreading : public States {
protected:
  CaseSpreading() {
    machines_ = stage_.system().spawn(make_machines, 0);
    notes_ = stage_.system().spawn(make_notes, 0);
    pages_ = stage_.system().spawn(make_page_store, cache_);
    spreading_ = make_case_spreading(stage_.system(), caf::actor_cast<solver_actor>(machines_),
                                     pages_, cache_);
    auto pages = std::make_shared<manifest>();
    pages->arrays.resize(3);
    pages->arrays[2].size = 60'000;  // Tets.
    order_.version.pages = pages;
    order_.load_cases = wire_value(load_case_list{named("a"), named("b")});
    order_.base.listener = notes_;
  }
  ~CaseSpreading() override {
    caf::anon_send_exit(spreading_, caf::exit_reason::user_shutdown);
    pass(milliseconds(1));
  }

  machines_state& machines() { return state_of<machines_actor>(machines_); }

  answer<solve_result> solve(std::uint64_t id) {
    auto result = ask<solve_result>(spreading_, job_id{id}, order_);
    pass(milliseconds(1));
    return result;
  }

  /// The pages are here already: where they come from is another test's.
  void finish(const made_result& with) {
    for (const auto& p : with.pages)
      cache_->put(p);
    auto promise = machines().tasks.front().promise;
    machines().tasks.pop_front();
    within(machines_, [=, result = with.result]() mutable { promise.deliver(result); });
  }

  void refuse(const error& why) {
    auto promise = machines().tasks.front().promise;
    machines().tasks.pop_front();
    within(machines_, [=]() mutable { promise.deliver(to_caf(why)); });
  }

  std::shared_ptr<page_cache> cache_ = std::make_shared<page_cache>(std::size_t{1} << 20);
  page_store_actor pages_;
  caf::actor machines_;
  caf::actor notes_;
  solver_actor spreading_;
  solve_order order_;
};

/// A pool of solvers of other machines.
class SolverPlaces : public RemotePool {
protected:
  SolverPlaces() {
    pool_options options;
    options.role = worker_role::solver;
    options.workers = 0;
    solvers_ = make_solver_pool(stage_.system(), std::move(options));
    auto pages = std::make_shared<manifest>();
    pages->arrays.resize(3);
    pages->arrays[2].size = 1'000'000;  // Tets: two gigabytes with quadratic ones.
    order_.version.pages = pages;
    order_.load_cases = wire_value(load_case_list{named("a")});
  }
  ~SolverPlaces() override {
    caf::anon_send_exit(solvers_, caf::exit_reason::user_shutdown);
    pass(milliseconds(1));
  }

  caf::actor add(const std::string& machine, std::uint64_t memory) {
    auto line = std::make_shared<made_up_line>(machine);
    line->worker = stage_.system().spawn(make_machines, 0);
    node_facts facts;
    facts.name = machine;
    facts.memory_bytes = memory;
    ask<bool>(solvers_, remote_worker{line->worker, facts, line});
    pass(milliseconds(1));
    return line->worker;
  }

  void solve(job_id id) {
    ask<solve_result>(solvers_, id, order_);
    pass(milliseconds(1));
  }

  static std::size_t jobs_of(const caf::actor& worker) {
    return state_of<machines_actor>(worker).tasks.size();
  }

  solver_actor solvers_;
  solve_order order_;
};

TEST_F(SolverPlaces, AMachineWithTooLittleMemorySolvesOnlyWhereThereIsNoOther) {
  const auto small = add("small", std::uint64_t{1} << 30);
  const auto large = add("large", std::uint64_t{8} << 30);
  solve({1});
  EXPECT_EQ(jobs_of(small), 0U);
  EXPECT_EQ(jobs_of(large), 1U);
  solve({2});
  EXPECT_EQ(jobs_of(small), 1U) << "nobody else is free";
}

TEST_F(SolverPlaces, LinearTetsNeedLess) {
  const auto small = add("small", std::uint64_t{1} << 30);
  const auto large = add("large", std::uint64_t{8} << 30);
  order_.element_order = 1;
  solve({1});
  EXPECT_EQ(jobs_of(small), 1U) << "650 MB";
}

TEST_F(SolverPlaces, PartsOfOneJobAreDoneOnDifferentMachines) {
  const auto first = add("rack-1", 0);
  const auto beside = add("rack-1", 0);
  const auto other = add("rack-2", 0);
  solve(part_of({7}, 0));
  solve(part_of({7}, 1));
  EXPECT_EQ(jobs_of(first), 1U);
  EXPECT_EQ(jobs_of(beside), 0U);
  EXPECT_EQ(jobs_of(other), 1U);
  solve(part_of({7}, 2));
  EXPECT_EQ(jobs_of(beside), 1U) << "there is no other machine left";
}

TEST_F(CaseSpreading, EachMachineGetsItsShareAndWhoAskedOneResult) {
  const auto got = solve(7);
  ASSERT_EQ(machines().tasks.size(), 2U);
  EXPECT_EQ(machines().tasks[0].load_cases, names{"a"});
  EXPECT_EQ(machines().tasks[1].load_cases, names{"b"});
  EXPECT_TRUE(machines().tasks[0].of_several);
  EXPECT_TRUE(are_parts_of_one(machines().tasks[0].job, machines().tasks[1].job));
  finish(result_of({{"a", {1, 2}}}));
  EXPECT_FALSE(got.is_there());
  finish(result_of({{"b", {3, 1}}}));
  ASSERT_TRUE(got.is_success());
  EXPECT_EQ(got.count(), 1);
  EXPECT_EQ((**got.value().outcome.get()).envelope->max_von_mises.load_case, "b");
}

TEST_F(CaseSpreading, OneCaseOneMachineOrLittleWorkGoesOnAsItIs) {
  machines().free_machines = 1;
  solve(1);
  ASSERT_EQ(machines().tasks.size(), 1U);
  EXPECT_EQ(machines().tasks[0].job.value, 1U);
  EXPECT_EQ(machines().tasks[0].load_cases, (names{"a", "b"}));
  machines().free_machines = 2;
  order_.in_one_place = true;
  solve(2);
  EXPECT_EQ(machines().tasks.back().load_cases, (names{"a", "b"}));
  order_.in_one_place = false;
  auto few = std::make_shared<manifest>(*order_.version.pages);
  few->arrays[2].size = 40'000;
  order_.version.pages = few;
  solve(3);
  EXPECT_EQ(machines().tasks.back().load_cases, (names{"a", "b"}));
  order_.load_cases = wire_value(load_case_list{named("a")});
  solve(4);
  EXPECT_EQ(machines().tasks.size(), 4U);
}

TEST_F(CaseSpreading, AFailureOfOnePartEndsTheOthers) {
  const auto got = solve(7);
  const auto other = machines().tasks[1].job.value;
  refuse({ec::not_converged, "it does not converge", "Support it", {}});
  EXPECT_EQ(got.refusal().code, ec::not_converged);
  EXPECT_EQ(got.refusal().remedy, "Support it");
  EXPECT_THAT(machines().cancelled, ::testing::Contains(other));
  finish(result_of({{"b", {3, 1}}}));
  EXPECT_EQ(got.count(), 1);
}

TEST_F(CaseSpreading, WhenFieldsAreGoneWithTheirMachineAllIsSolvedOnceMoreInOnePlace) {
  const auto got = solve(7);
  auto gone = stage_.system().spawn(make_notes, 0);
  auto lost = result_of({{"a", {1, 2}}});
  lost.result.source = gone;
  lost.pages.clear();  // They are nowhere.
  finish(lost);
  simulation::cut_off(gone);
  finish(result_of({{"b", {3, 1}}}));
  pass(milliseconds(50));
  ASSERT_EQ(machines().tasks.size(), 1U);
  EXPECT_EQ(machines().tasks.front().job.value, 7U);
  EXPECT_EQ(machines().tasks.front().load_cases, (names{"a", "b"}));
  EXPECT_FALSE(machines().tasks.front().of_several);
  finish(result_of({{"a", {1, 2}}, {"b", {3, 1}}}));
  EXPECT_TRUE(got.is_success());
  EXPECT_EQ(got.count(), 1);
}

/// Parts whose pages lie with two machines at the end of slow lines.
class FarCases : public CaseSpreading {
protected:
  FarCases() {
    for (auto& one : machine_)
      one = stage_.system().spawn(make_far, 0);
  }

  far_state& far(std::size_t i) { return simulation::state_of<far_state>(machine_[i]); }

  void finish_far(std::size_t i, made_result with) {
    add(with, fem::case_field("stress_pa", i == 0 ? "a" : "b"), {7, 7, 1. * i});
    for (const auto& p : with.pages)
      far(i).pages.emplace(p->id(), p);
    simulation::state_of<page_store_state>(pages_).lines[machine_[i].address()].rate = 1e6;
    with.result.source = machine_[i];
    with.pages.clear();
    finish(with);
  }

  std::array<caf::actor, 2> machine_;
};

TEST_F(FarCases, WhatOnlyWatchersNeedStaysWithItsMachineAndComesWhenItIsAskedFor) {
  const auto got = solve(7);
  finish_far(0, result_of({{"a", {1, 2, 0}}}));
  finish_far(1, result_of({{"b", {3, 1, 0}}}));
  pass(milliseconds(50));
  ASSERT_TRUE(got.is_success());
  EXPECT_EQ(far(0).sent, 1U) << "von Mises stress";
  EXPECT_EQ(far(1).sent, 1U);
  const auto& fields = got.value().fields;
  const auto left = std::ranges::find(fields, "stress_pa (b)", &field_ref::name);
  ASSERT_NE(left, fields.end());
  const auto later = ask<page_set>(pages_, fetch_atom::value, got.value().source, left->pages);
  pass(milliseconds(1));
  ASSERT_TRUE(later.is_success());
  EXPECT_EQ(open_field(*left, later.value()).value().values[2], 1);
  EXPECT_EQ(far(1).sent, 2U);
  const auto rate = ask<double>(pages_, rate_atom::value, got.value().source);
  pass(milliseconds(1));
  EXPECT_TRUE(is_slow(rate.value())) << "a session leaves them there, too";
}

TEST_F(CaseSpreading, PartsThatDoNotFitTogetherAreToldAndNothingElse) {
  const auto got = solve(7);
  finish(result_of({{"a", {1, 2}}}));
  finish(result_of({{"b", {3, 1, 2}}}));  // Of another mesh.
  pass(milliseconds(1));
  EXPECT_EQ(got.refusal().code, ec::protocol_error);
  EXPECT_EQ(got.count(), 1);
  EXPECT_TRUE(machines().tasks.empty());
}

TEST_F(CaseSpreading, ACancelReachesAllParts) {
  const auto got = solve(7);
  const auto first = machines().tasks[0].job.value;
  const auto second = machines().tasks[1].job.value;
  caf::anon_send(spreading_, cancel_atom::value, job_id{7});
  pass(milliseconds(1));
  EXPECT_EQ(got.refusal().code, ec::cancelled);
  EXPECT_THAT(machines().cancelled, ElementsAre(first, second));
}

TEST_F(CaseSpreading, ConvergenceIsThatOfTheWorstPart) {
  const auto got = solve(7);
  const auto ear = machines().tasks[0].listener;
  const auto say = [&](std::size_t part, int iterations, double residual) {
    tell(ear, job_frame{machines().tasks[part].job, iterations, residual});
    pass(milliseconds(1));
  };
  say(0, 5, 1e-3);
  const auto& heard = state_of<notes_actor>(notes_).frames;
  EXPECT_THAT(heard, IsEmpty()) << "nothing is known of the other part";
  say(1, 2, 1e-1);
  say(0, 9, 1e-5);
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard.back().job.value, 7U);
  EXPECT_EQ(heard.back().iterations, 9);
  EXPECT_EQ(heard.back().residual, 1e-1);
}

TEST_F(CaseSpreading, APictureOfTheRunningSolveIsShownOnceAllPartsHaveOne) {
  const auto got = solve(7);
  const auto ear = machines().tasks[0].listener;
  const auto first = result_of({{"a", {1, 2}}});
  for (const auto& p : first.pages)
    cache_->put(p);
  tell(ear, job_preview{machines().tasks[0].job, first.result});
  pass(milliseconds(1));
  const auto& heard = state_of<notes_actor>(notes_).previews;
  EXPECT_THAT(heard, IsEmpty());
  const auto second = result_of({{"b", {4, 0}}});
  for (const auto& p : second.pages)
    cache_->put(p);
  tell(ear, job_preview{machines().tasks[1].job, second.result});
  pass(milliseconds(1));
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard.front().job.value, 7U);
  EXPECT_EQ((**heard.front().result.outcome.get()).cases.size(), 2U);
}

}  // namespace
}  // namespace tedit::actors
