// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QThread>

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>

namespace tedit::desktop {

/// The thread that OpenGL draws on, one for all views, so that no window waits for a frame. Where a
/// platform's OpenGL keeps to one thread, jobs run on the caller's, at once.
class drawing_thread {
public:
  /// Ends with the last who holds it. Only for the thread of the widgets.
  [[nodiscard]] static std::shared_ptr<drawing_thread> shared();

  drawing_thread();
  ~drawing_thread();
  drawing_thread(const drawing_thread&) = delete;
  drawing_thread& operator=(const drawing_thread&) = delete;

  /// Runs after all jobs before it.
  void post(std::function<void()> job);
  /// Waits until it ran, and all before it.
  void run(const std::function<void()>& job);
  /// Where jobs run.
  [[nodiscard]] QThread* place() const;

private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;
  bool ends_ = false;
  std::unique_ptr<QThread> thread_;  ///< None: the caller's.
};

}  // namespace tedit::desktop
