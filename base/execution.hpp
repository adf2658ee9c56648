// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string_view>

namespace tedit {

/// A flag shared between who may cancel and who works. Copies share the flag; setting it is
/// idempotent and thread-safe. Workers poll it at least every 50 ms.
class cancel_token {
  struct state {
    std::atomic<bool> set{false};
    std::atomic<std::uint64_t> polls{0};
    std::uint64_t last = std::numeric_limits<std::uint64_t>::max();
  };

public:
  /// Bytes of what the copies share: for mesh/layout.hpp.
  static constexpr std::size_t state_size = sizeof(state);

  cancel_token() : state_(std::make_shared<state>()) {}

  /// Cancels itself at the `poll`-th call of `cancelled`, from 1: for tests that stop work at each
  /// of its checks.
  [[nodiscard]] static cancel_token at_poll(std::uint64_t poll) {
    cancel_token result;
    result.state_->last = poll;
    return result;
  }

  void cancel() const noexcept { state_->set.store(true, std::memory_order_relaxed); }

  [[nodiscard]] bool cancelled() const noexcept {
    if (state_->polls.fetch_add(1, std::memory_order_relaxed) + 1 >= state_->last)
      cancel();
    return state_->set.load(std::memory_order_relaxed);
  }

  /// How often `cancelled` was asked.
  [[nodiscard]] std::uint64_t polls() const noexcept {
    return state_->polls.load(std::memory_order_relaxed);
  }

private:
  std::shared_ptr<state> state_;
};

/// What every long call receives: how to notice a cancel and how to report progress.
/// Precedence: an invalid input is reported as such even when the call is already cancelled.
struct execution {
  cancel_token cancel;

  /// Called from the working thread with a fraction in [0,1] that never falls, and a stage text
  /// ("assembling"). May be empty.
  std::function<void(double fraction, std::string_view stage)> progress;

  void report(double fraction, std::string_view stage) const {
    if (progress)
      progress(fraction, stage);
  }

  /// For a step of the work: its progress from 0 to 1 is this one's from `first` to `last`.
  [[nodiscard]] execution part(double first, double last) const {
    execution step{cancel, {}};
    if (progress)
      step.progress = [tell = progress, first, last](double fraction, std::string_view stage) {
        tell(first + (last - first) * fraction, stage);
      };
    return step;
  }
};

}  // namespace tedit
