// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include <caf/actor_system.hpp>
#include <caf/actor_system_config.hpp>

namespace tedit::simulation {

/// A sequence of numbers that one seed gives on every machine (splitmix64).
class dice {
public:
  explicit dice(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
  }

  /// 0 to n - 1. @pre n > 0.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  bool one_in(std::size_t n) { return below(n) == 0; }

private:
  std::uint64_t state_;
};

using milliseconds = std::chrono::milliseconds;

/// Virtual time: what surrounds the actors (sockets, disks, processes, people) happens at points of
/// it, and an hour passes as soon as nobody has anything to do.
class timeline {
public:
  explicit timeline(std::uint64_t seed) : random(seed) {}

  [[nodiscard]] milliseconds now() const { return now_; }

  /// Events of one moment happen in the order in which they were called for.
  void after(milliseconds wait, std::function<void()> what) {
    events_.emplace(std::pair(now_ + wait, ++count_), std::move(what));
  }

  /// When the next event is; the largest time when there is none.
  [[nodiscard]] milliseconds next() const {
    return events_.empty() ? milliseconds::max() : events_.begin()->first.first;
  }

  /// Goes on to a moment; its events are then due. @pre not before now.
  void go_to(milliseconds when) { now_ = when; }

  /// Has one event happen that is due; false when none is.
  bool run_due() {
    if (next() > now_)
      return false;
    const auto what = std::move(events_.begin()->second);
    events_.erase(events_.begin());
    what();
    return true;
  }

  dice random;

private:
  milliseconds now_{0};
  std::uint64_t count_ = 0;
  std::map<std::pair<milliseconds, std::uint64_t>, std::function<void()>> events_;
};

/// An actor system in which nothing runs by itself: one message at a time, to an actor that the
/// seed picks among those that have one, by CAF's test coordinator and clock.
class stage {
public:
  explicit stage(timeline& time);
  stage(const stage&) = delete;
  stage& operator=(const stage&) = delete;
  ~stage();

  [[nodiscard]] caf::actor_system& system() { return *system_; }

  /// Has one actor handle one message, or one event happen, or goes on in time to the next of both.
  /// False when there is nothing before `limit`.
  bool step(milliseconds limit);

  /// Has all messages handled that are there or follow from these, in no time.
  void drain();

private:
  /// Of a delayed message or a timeout; the largest time when there is none.
  [[nodiscard]] milliseconds next_timeout() const;
  void go_to(milliseconds when);
  void run_one();

  timeline& time_;
  milliseconds began_;
  std::unique_ptr<caf::actor_system_config> config_;
  std::unique_ptr<caf::actor_system> system_;
};

/// Ends an actor as the end of its process does: it handles nothing more.
void cut_off(const caf::actor& who);

}  // namespace tedit::simulation
