// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "base/execution.hpp"

namespace tedit {

/// A token for work that may take only so long: cancelled within 20 ms of the end of that time, or
/// of a cancel of `asked`. Two tokens, as the work's end is not that of whoever asked for it.
/// Cost: a thread that sleeps while this lives; where the system gives none, the time is over at
/// once.
class time_limit {
public:
  /// `seconds`: from now, wall clock. 0 or less: over at once.
  time_limit(const cancel_token& asked, double seconds);
  time_limit(const time_limit&) = delete;
  time_limit& operator=(const time_limit&) = delete;
  ~time_limit();

  /// For the work.
  [[nodiscard]] const cancel_token& token() const;

  /// True once the time is over, whatever was cancelled.
  [[nodiscard]] bool is_over() const;

private:
  struct impl;
  std::unique_ptr<impl> impl_;
};

}  // namespace tedit
