// SPDX-License-Identifier: AGPL-3.0-or-later
// CGAL guards each rational number that it works out by std::call_once, and the C library wakes
// whoever may wait by a system call each time: a tenth of a boolean. This program has one thread.
#include <pthread.h>

namespace {
/// As the C library marks it.
constexpr int is_done = 2;
}  // namespace

/// In place of the C library's, for all of this program. What throws is not done.
extern "C" int pthread_once(pthread_once_t* control, void (*routine)()) {
  if (*control != is_done) {
    routine();
    *control = is_done;
  }
  return 0;
}
