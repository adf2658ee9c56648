// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// Numbers of a process that a monitoring system reads, by the conventions of Prometheus: names end
/// in their unit, what only grows in `_total`; https://prometheus.io/docs/practices/naming.
namespace tedit::metrics {

using labels = std::vector<std::pair<std::string, std::string>>;

/// Only grows. Thread-safe.
class counter {
public:
  void add(std::uint64_t n = 1) noexcept { value_.fetch_add(n, std::memory_order_relaxed); }
  /// For what is counted elsewhere.
  void set(std::uint64_t n) noexcept { value_.store(n, std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t get() const noexcept {
    return value_.load(std::memory_order_relaxed);
  }

private:
  std::atomic<std::uint64_t> value_{0};
};

/// Goes up and down. Thread-safe.
class gauge {
public:
  void set(double value) noexcept { value_.store(value, std::memory_order_relaxed); }
  void add(double change) noexcept { value_.fetch_add(change, std::memory_order_relaxed); }
  [[nodiscard]] double get() const noexcept { return value_.load(std::memory_order_relaxed); }

private:
  std::atomic<double> value_{0};
};

/// How long things take, in buckets from a millisecond to ten minutes. Thread-safe.
class times {
public:
  static constexpr std::array<double, 12> bounds_s{.001, .003, .01, .03, .1,  .3,
                                                   1,    3,    10,  30,  120, 600};

  void note(std::chrono::duration<double> took) noexcept;

  [[nodiscard]] std::uint64_t count() const noexcept { return count_.get(); }
  [[nodiscard]] double sum_s() const noexcept { return static_cast<double>(sum_us_.get()) * 1e-6; }
  /// Of those that took at most `bounds_s[i]`.
  [[nodiscard]] std::uint64_t within(std::size_t i) const noexcept;

private:
  std::array<counter, bounds_s.size()> buckets_;  ///< Each without those before it.
  counter count_;
  counter sum_us_;
};

/// The one of this name and these labels; made, and shown from then on, when it is asked for first.
/// It lives as long as the process. `help` is one sentence. Cost: a lock and a look-up; who counts
/// often keeps the reference.
[[nodiscard]] counter& count_of(const std::string& name, const std::string& help,
                                const labels& which = {});
/// Of a name in `_total` it is shown as a counter: for sums that are no whole numbers.
[[nodiscard]] gauge& level_of(const std::string& name, const std::string& help,
                              const labels& which = {});
[[nodiscard]] times& times_of(const std::string& name, const std::string& help,
                              const labels& which = {});

/// What this process takes of its machine, under the names that Prometheus' own clients have.
void note_process();

/// All of them, in the text format 0.0.4, sorted by name.
[[nodiscard]] std::string to_text();

}  // namespace tedit::metrics
