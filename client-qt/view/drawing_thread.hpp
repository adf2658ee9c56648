// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThread>

#include <functional>
#include <memory>

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
  [[nodiscard]] QThread* place() const { return here_.thread(); }

private:
  QThread thread_;
  QObject here_;  ///< Lives on the thread; jobs are sent to it.
};

}  // namespace tedit::desktop
