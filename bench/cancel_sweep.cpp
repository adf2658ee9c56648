// SPDX-License-Identifier: AGPL-3.0-or-later
#include "bench/cancel_sweep.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <thread>

#include "base/guard.hpp"
#include "base/stopwatch.hpp"

namespace tedit::bench {

namespace {

using clock = std::chrono::steady_clock;

double ms_between(clock::time_point from, clock::time_point to) {
  return std::chrono::duration<double, std::milli>(to - from).count();
}

expected<fem::solution> solve_whole(const whole_solve& work, const execution& run) {
  run.report(0, "setting up the problem");
  auto p = guarded(
    run, [&] { return fem::make_problem(work.mesh, work.loads, work.element_order); });
  if (!p)
    return fail(p.error());
  return fem::solve(*p, work.device, work.settings, run);
}

struct cancelled_solve {
  double at_ms = 0;      ///< Of the cancel.
  double return_ms = 0;  ///< From the cancel; negative when the solve was over before.
  const char* stage = "";
};

/// `run.progress` gives texts that live as long as the program.
cancelled_solve cancel_at(const whole_solve& work, double at_ms) {
  std::atomic<const char*> stage{"setting up the problem"};
  execution run;
  run.progress = [&](double, std::string_view text) { stage = text.data(); };
  clock::time_point returned;
  bool cancelled = false;
  const auto start = clock::now();
  std::thread worker([&] {
    const auto result = solve_whole(work, run);
    cancelled = !result && result.error().code == ec::cancelled;
    returned = clock::now();
  });
  std::this_thread::sleep_until(
    start + std::chrono::duration_cast<clock::duration>(
              std::chrono::duration<double, std::milli>(at_ms)));
  const char* const here = stage;
  const auto now = clock::now();
  run.cancel.cancel();
  worker.join();
  return {ms_between(start, now), cancelled ? ms_between(now, returned) : -1, here};
}

/// The value that this share of the ascending ones does not exceed.
double percentile(const std::vector<cancelled_solve>& ascending, double share) {
  const auto at = static_cast<std::size_t>(share * static_cast<double>(ascending.size()));
  return ascending[std::min(at, ascending.size() - 1)].return_ms;
}

nlohmann::json figures(std::vector<cancelled_solve> all) {
  const auto over = std::erase_if(all, [](const auto& one) { return one.return_ms < 0; });
  nlohmann::json result{{"cancelled", all.size()}, {"over_before", over}};
  if (all.empty())
    return result;
  std::ranges::sort(all, {}, &cancelled_solve::return_ms);
  std::map<std::string, double> worst;
  for (const auto& one : all)
    worst[one.stage] = one.return_ms;
  result["p50_ms"] = percentile(all, 0.5);
  result["p99_ms"] = percentile(all, 0.99);
  result["worst_ms"] = all.back().return_ms;
  result["worst_at_ms"] = all.back().at_ms;
  result["worst_stage"] = all.back().stage;
  result["worst_by_stage_ms"] = worst;
  result["over_50_ms"] =
    std::ranges::count_if(all, [](const auto& one) { return one.return_ms > 50; });
  return result;
}

}  // namespace

expected<nlohmann::json> cancel_sweep(const whole_solve& work, int moments) {
  const stopwatch whole;
  const auto before = solve_whole(work, {});
  if (!before)
    return fail(before.error());
  const double whole_ms = whole.milliseconds();
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
