// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <new>
#include <type_traits>

#include "base/error.hpp"
#include "base/execution.hpp"

namespace tedit {

/// What `check_cancelled` throws; only `guarded` catches it.
struct work_cancelled {};

/// While it lives, `parallel_for` on this thread asks `token` before each chunk, and so does
/// `check_cancelled`: long loops need no checks of their own, and inner functions no parameter. The
/// innermost scope counts. `token` must outlive it.
class cancel_scope {
public:
  explicit cancel_scope(const cancel_token& token);
  cancel_scope(const cancel_scope&) = delete;
  cancel_scope& operator=(const cancel_scope&) = delete;
  ~cancel_scope();

  /// The token of this thread's innermost scope; null without one.
  [[nodiscard]] static const cancel_token* current();

private:
  const cancel_token* before_;
};

/// Throws `work_cancelled` when the token of the scope is cancelled: for loops that run on one
/// thread. Cost: a few nanoseconds.
void check_cancelled();

/// The error of work that met std::bad_alloc.
[[nodiscard]] error out_of_host_memory();

/// Does `work` and hands back its result; memory that runs out, on whichever thread, and a cancel
/// that was noticed inside become errors. Everything that `work` owns is destroyed on the way, what
/// it changed outside may be half done. Errors: `out_of_memory`, `cancelled`.
template <class Work>
[[nodiscard]] std::invoke_result_t<Work> guarded(Work&& work) {
  try {
    return work();
  } catch (const work_cancelled&) {
    return fail(ec::cancelled, "the solve was cancelled");
  } catch (const std::bad_alloc&) {
    return fail(out_of_host_memory());
  }
}

/// The same within a scope of `run.cancel`.
template <class Work>
[[nodiscard]] std::invoke_result_t<Work> guarded(const execution& run, Work&& work) {
  const cancel_scope scope(run.cancel);
  return guarded(std::forward<Work>(work));
}

}  // namespace tedit
