// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/time_limit.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>

namespace tedit {

namespace {

using clock = std::chrono::steady_clock;
constexpr auto look_every = std::chrono::milliseconds(20);
/// More would not fit into the clock's count.
constexpr double for_ever = 1e9;

clock::time_point after(double seconds) {
  const std::chrono::duration<double> time(std::clamp(seconds, 0.0, for_ever));
  return clock::now() + std::chrono::duration_cast<clock::duration>(time);
}

}  // namespace

struct time_limit::impl {
  impl(const cancel_token& asked, double seconds) : asked(asked), end(after(seconds)) {
    if (is_over()) {
      work.cancel();
      return;
    }
    try {
      watcher = std::jthread([this](const std::stop_token& stop) { watch(stop); });
    } catch (const std::system_error&) {
      work.cancel();  // What nothing watches may not go on for ever.
    }
  }

  [[nodiscard]] bool is_over() const { return clock::now() >= end; }

  void watch(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      if (asked.cancelled() || is_over())
        return work.cancel();
      done.wait_until(lock, stop, std::min(end, clock::now() + look_every), [] { return false; });
    }
  }

  cancel_token asked;
  clock::time_point end;
  cancel_token work;
  std::mutex mutex;
  std::condition_variable_any done;
  std::jthread watcher;  // Last: it ends before what it uses.
};

time_limit::time_limit(const cancel_token& asked, double seconds)
    : impl_(std::make_unique<impl>(asked, seconds)) {}

time_limit::~time_limit() = default;

const cancel_token& time_limit::token() const {
  return impl_->work;
}

bool time_limit::is_over() const {
  return impl_->is_over();
}

}  // namespace tedit
