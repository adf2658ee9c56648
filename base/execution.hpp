// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string_view>

namespace tedit {

/// A flag shared between who may cancel and who works. Copies share the flag; setting it is
/// idempotent and thread-safe. Workers poll it at least every 50 ms.
class cancel_token {
public:
  cancel_token() : flag_(std::make_shared<std::atomic<bool>>(false)) {}

  void cancel() const noexcept { flag_->store(true, std::memory_order_relaxed); }

  [[nodiscard]] bool cancelled() const noexcept { return flag_->load(std::memory_order_relaxed); }

private:
  std::shared_ptr<std::atomic<bool>> flag_;
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
};

}  // namespace tedit
