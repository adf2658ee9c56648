// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/worker/worker_jobs.hpp"

#include <unistd.h>

namespace tedit::actors {

job_thread_actor::behavior_type job_thread::make_behavior() {
  return {[](const job_task& task) {
    task.run();
    return acknowledged{};
  }};
}

worker_status worker_jobs::status() const {
  return {name_of(role),
          "ready",
          static_cast<std::int32_t>(getpid()),
          0,
          static_cast<std::uint32_t>(running.size()),
          {}};
}

execution make_execution(cancel_token token,
                         std::function<void(double fraction, std::string_view stage)> tell) {
  using clock = std::chrono::steady_clock;
  constexpr auto interval = std::chrono::milliseconds(50);
  execution run;
  run.cancel = std::move(token);
  auto last = std::make_shared<clock::time_point>(clock::now() - interval);
  run.progress = [=, tell = std::move(tell)](double fraction, std::string_view stage) {
    const auto now = clock::now();
    if (now - *last < interval)
      return;
    *last = now;
    tell(fraction, stage);
  };
  return run;
}

execution make_execution(job_id job, const order_base& order, cancel_token token) {
  if (!order.listener)
    return {std::move(token), {}};
  return make_execution(std::move(token),
                        [job, to = order.listener](double fraction, std::string_view stage) {
                          caf::anon_send(to, job_progress{job, fraction, std::string(stage)});
                        });
}

}  // namespace tedit::actors
