// SPDX-License-Identifier: AGPL-3.0-or-later
// How far more solver machines help: the server's own pool and sharing out of load cases, in
// virtual time, with machines that take as long as was measured of one. usage: scaling
// [--first-s 2.6] [--further .355]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <caf/event_based_actor.hpp>
#include <caf/send.hpp>
#include <caf/stateful_actor.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/errors.hpp"
#include "actors/pages/page_store.hpp"
#include "actors/supervisor/case_spreading.hpp"
#include "actors/supervisor/lifeline.hpp"
#include "actors/supervisor/pool.hpp"
#include "actors/versions.hpp"
#include "base/logging/logging.hpp"
#include "fem/fields.hpp"
#include "tests/simulation/timeline.hpp"

namespace tedit::actors {
namespace {

using simulation::milliseconds;

/// Tets of the NIST plate's medium mesh, whose quadratic solves were measured.
constexpr std::uint32_t tets = 142'978;

/// Seconds that a machine takes for a cold solve of so many load cases with the same supports.
struct service_time {
  double first_s = 2.6;   ///< One.
  double further = .355;  ///< Each further one, as a part of that.

  [[nodiscard]] milliseconds of(std::size_t cases) const {
    const double s = first_s * (1 + further * static_cast<double>(cases - 1));
    return milliseconds(std::lround(1e3 * s));
  }
};

struct unbroken_line final : lifeline {
  std::optional<std::string> ended() override { return std::nullopt; }
  void cut() override {}
  [[nodiscard]] std::string name() const override { return "node"; }
};

/// A solver machine: one job after another, each as long as it takes.
struct machine_state {
  std::map<std::uint64_t, std::pair<caf::typed_response_promise<solve_result>, load_case_list>>
    jobs;
  static inline const char* name = "machine";
};

solve_result result_of(const load_case_list& cases, page_cache& cache) {
  static std::vector<page_ptr> held;
  solve_outcome outcome;
  solve_result result;
  for (const auto& one : cases) {
    solve_report report;
    report.load_case = one.name;
    outcome.cases.push_back(report);
    const field f{fem::case_field("von_mises_pa", one.name), field_location::vertex, 1,
                  paged_array<double>::from(std::vector<double>{1, 2, 3})};
    result.fields.push_back(make_ref(f));
    for (const auto& p : f.values.pages()) {
      cache.put(p);
      if (held.empty())
        held.push_back(p);
    }
  }
  result.outcome = wire_value(std::move(outcome));
  return result;
}

caf::behavior make_machine(caf::stateful_actor<machine_state>* self, service_time times,
                           std::shared_ptr<page_cache> cache) {
  return {[=](job_id job, const solve_order& order) {
            auto promise = self->make_response_promise<solve_result>();
            const auto cases = *order.load_cases.get();
            self->state.jobs[job.value] = {promise, *cases};
            caf::delayed_anon_send(caf::actor_cast<caf::actor>(self), times.of(cases->size()),
                                   job.value);
            return promise;
          },
          [=](std::uint64_t done) {
            auto job = std::move(self->state.jobs.extract(done).mapped());
            job.first.deliver(result_of(job.second, *cache));
          },
          [](cancel_atom, job_id) {}};
}

struct cluster {
  cluster(std::size_t machines, service_time times) {
    pool_options options;
    options.role = worker_role::solver;
    options.workers = 0;
    const auto pool = make_solver_pool(stage.system(), options);
    for (std::size_t i = 0; i < machines; ++i) {
      remote_worker guest;
      guest.worker = stage.system().spawn(make_machine, times, cache);
      guest.node.name = "rack-" + std::to_string(i);
      guest.line = std::make_shared<unbroken_line>();
      caf::anon_send(caf::actor_cast<caf::actor>(pool), guest);
    }
    pages = stage.system().spawn(make_page_store, cache);
    solvers = make_case_spreading(stage.system(), pool, pages, cache);
    stage.drain();
    auto listed = std::make_shared<manifest>();
    listed->arrays.resize(3);
    listed->arrays[2].size = tets;
    order.version.pages = listed;
    order.device = "auto";
  }

  ~cluster() {
    caf::anon_send_exit(solvers, caf::exit_reason::user_shutdown);
    caf::anon_send_exit(pages, caf::exit_reason::user_shutdown);
    stage.drain();
  }

  /// So many documents with so many solves each; how long all took in virtual seconds.
  double run(std::size_t documents, int solves, std::size_t cases, double between_s) {
    load_case_list loads(cases);
    for (std::size_t c = 0; c < cases; ++c)
      loads[c].name = "case " + std::to_string(c);
    order.load_cases = wire_value(loads);
    finished = 0;
    for (std::size_t d = 0; d < documents; ++d)
      stage.system().spawn(
        [this, solves, between_s](caf::event_based_actor* self, int /*number*/) {
          begin(self, solves, between_s);
        },
        0);
    const auto began = time.now();
    constexpr milliseconds years{std::int64_t{1} << 40};
    do
      stage.drain();  // No time passes while somebody has something to do.
    while (finished < documents && stage.step(years));
    if (finished < documents || failed > 0) {
      std::fprintf(stderr, "%zu of %zu documents ended, %zu solves failed: %s\n", finished,
                   documents, failed, why.c_str());
      std::exit(1);
    }
    return std::chrono::duration<double>(time.now() - began).count();
  }

  void begin(caf::event_based_actor* self, int left, double between_s) {
    if (left == 0) {
      ++finished;
      return;
    }
    const double u = (static_cast<double>(time.random.below(1'000'000)) + 1) / 1'000'000;
    const milliseconds pause(std::lround(-1e3 * between_s * std::log(u)));
    self->delayed_send(self, pause, left);
    self->become([=, this](int now) { ask(self, now, between_s); });
  }

  void ask(caf::event_based_actor* self, int left, double between_s) {
    auto mine = order;
    mine.base.client = self->id();
    const auto asked = time.now();
    self->request(solvers, caf::infinite, job_id{++jobs}, mine)
      .then(
        [=, this](const solve_result&) {
          waits_s.push_back(std::chrono::duration<double>(time.now() - asked).count());
          begin(self, left - 1, between_s);
        },
        [=, this](const caf::error& e) {
          ++failed;
          why = render(from_caf(e, "a solve"));
          begin(self, left - 1, between_s);
        });
  }

  simulation::timeline time{1};
  simulation::stage stage{time};
  std::shared_ptr<page_cache> cache = std::make_shared<page_cache>(std::size_t{64} << 20);
  page_store_actor pages;
  solver_actor solvers;
  solve_order order;
  std::uint64_t jobs = 0;
  std::size_t finished = 0;
  std::size_t failed = 0;
  std::string why;  ///< One failed.
  std::vector<double> waits_s;
};

double quantile(std::vector<double> values, double part) {
  std::ranges::sort(values);
  return values.at(std::min(values.size() - 1,
                            static_cast<std::size_t>(part * static_cast<double>(values.size()))));
}

void run(const service_time& times) {
  std::printf(
    "| machines | 8 load cases of one part, s | speed-up | 16 documents, solves a minute | "
    "speed-up |\n");
  std::printf("|---|---|---|---|---|\n");
  double alone_s = 0, alone_rate = 0;
  for (const std::size_t machines : {1, 2, 4, 8, 16, 32}) {
    cluster cases(machines, times);
    const double one_s = cases.run(1, 4, 8, 0) / 4;
    cluster documents(machines, times);
    const double rate = 60 * 16 * 10 / documents.run(16, 10, 1, 0);
    if (machines == 1) {
      alone_s = one_s;
      alone_rate = rate;
    }
    std::printf("| %zu | %.2f | %.2f | %.0f | %.2f |\n", machines, one_s, alone_s / one_s, rate,
                rate / alone_rate);
  }
  std::printf(
    "\n| documents | machines | a solve asked for every | answered after, s, p50 / p99 | CPU of "
    "the coordinators for a solve |\n");
  std::printf("|---|---|---|---|---|\n");
  for (const auto& [documents, machines] :
       {std::pair<std::size_t, std::size_t>{50, 5}, {200, 20}, {1000, 100}, {1000, 40}}) {
    cluster many(machines, times);
    const auto began = std::chrono::steady_clock::now();
    many.run(documents, 5, 1, 60);
    const auto cpu = std::chrono::duration<double>(std::chrono::steady_clock::now() - began);
    std::printf("| %zu | %zu | 60 s | %.1f / %.1f | %.0f us |\n", documents, machines,
                quantile(many.waits_s, .5), quantile(many.waits_s, .99),
                1e6 * cpu.count() / static_cast<double>(many.jobs));
  }
}

}  // namespace
}  // namespace tedit::actors

int main(int argc, char** argv) {
  tedit::logging::set_level("off");
  tedit::actors::service_time times;
  if (argc > 1)
    times.first_s = std::strtod(argv[1], nullptr);
  if (argc > 2)
    times.further = std::strtod(argv[2], nullptr);
  tedit::actors::run(times);
}
