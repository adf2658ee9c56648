// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/cancel_sweep.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <map>
#include <thread>

#include "base/guard.hpp"
#include "base/stopwatch.hpp"

namespace tedit::bench {

namespace {

using clock = std::chrono::steady_clock;

double cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

double ms_between(clock::time_point from, clock::time_point to) {
  return std::chrono::duration<double, std::milli>(to - from).count();
}

expected<fem::solution> solve_whole(const whole_solve& work, const execution& run) {
  run.report(0, "setting up the problem");
  auto p =
    guarded(run, [&] { return fem::make_problem(work.mesh, work.loads, work.element_order); });
  if (!p)
    return fail(p.error());
  return fem::solve(*p, work.device, work.settings, run);
}

struct cancelled_solve {
  double at_ms = 0;      ///< Of the cancel.
  double return_ms = 0;  ///< From the cancel.
  double cpu_ms = 0;     ///< Of all threads meanwhile.
  bool over = false;     ///< The solve was done before.
  const char* stage = "";
};

/// `run.progress` gives texts that live as long as the program.
cancelled_solve cancel_at(const whole_solve& work, double at_ms) {
  std::atomic<const char*> stage{"setting up the problem"};
  execution run;
  run.progress = [&](double, std::string_view text) { stage = text.data(); };
  clock::time_point returned;
  double cpu_at_end = 0;
  bool cancelled = false;
  const auto start = clock::now();
  std::thread worker([&] {
    const auto result = solve_whole(work, run);
    cancelled = !result && result.error().code == ec::cancelled;
    returned = clock::now();
    cpu_at_end = cpu_ms();
  });
  std::this_thread::sleep_until(start + std::chrono::duration_cast<clock::duration>(
                                          std::chrono::duration<double, std::milli>(at_ms)));
  const char* const here = stage;
  const double cpu_at_cancel = cpu_ms();
  const auto now = clock::now();
  run.cancel.cancel();
  worker.join();
  return {ms_between(start, now), ms_between(now, returned), cpu_at_end - cpu_at_cancel, !cancelled,
          here};
}

/// Of one of the two times.
nlohmann::json spread(std::vector<cancelled_solve> all, double cancelled_solve::*time) {
  std::ranges::sort(all, {}, time);
  const auto percentile = [&](double share) {
    const auto at = static_cast<std::size_t>(share * static_cast<double>(all.size()));
    return all[std::min(at, all.size() - 1)].*time;
  };
  std::map<std::string, double> worst;
  for (const auto& one : all)
    worst[one.stage] = one.*time;
  return {{"p50", percentile(0.5)},
          {"p99", percentile(0.99)},
          {"worst", all.back().*time},
          {"worst_at_ms", all.back().at_ms},
          {"worst_by_stage", worst},
          {"over_50", std::ranges::count_if(all, [&](const auto& one) { return one.*time > 50; })}};
}

nlohmann::json figures(std::vector<cancelled_solve> all) {
  const auto over = std::erase_if(all, [](const auto& one) { return one.over; });
  nlohmann::json result{{"cancelled", all.size()}, {"over_before", over}};
  if (all.empty())
    return result;
  result["return_ms"] = spread(all, &cancelled_solve::return_ms);
  result["cpu_ms"] = spread(std::move(all), &cancelled_solve::cpu_ms);
  return result;
}

}  // namespace

expected<nlohmann::json> cancel_sweep(const whole_solve& work, int moments) {
  stopwatch whole;
  const auto before = solve_whole(work, {});
  if (!before)
    return fail(before.error());
  double whole_ms = whole.restart();
  // The first one also reads the program and compiles kernels.
  if (auto again = solve_whole(work, {}); !again)
    return fail(again.error());
  whole_ms = std::min(whole_ms, whole.milliseconds());
  std::vector<cancelled_solve> all;
  for (int i = 0; i < moments; ++i)
    all.push_back(cancel_at(work, whole_ms * (i + 0.5) / moments));
  auto result = figures(std::move(all));
  const auto after = solve_whole(work, {});
  if (!after)
    return fail(after.error());
  result["device"] = before->device;
  result["element_order"] = before->element_order;
  result["whole_ms"] = whole_ms;
  result["same_bits"] =
    before->displacement == after->displacement && before->von_mises == after->von_mises;
  return result;
}

}  // namespace tedit::bench
