// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThread>

#include <atomic>
#include <chrono>
#include <mutex>
#include <vector>

namespace tedit::desktop {

/// Measures how long the event loop keeps an event waiting: a thread of its own posts one every few
/// milliseconds to an object of the watched thread. What a user feels as a frozen window is a long
/// wait here.
class stall_watch : public QObject {
  Q_OBJECT

public:
  /// Watches the thread that it is made on.
  explicit stall_watch(QObject* parent = nullptr);
  ~stall_watch() override;

  struct figures {
    std::size_t samples = 0;
    double p50_ms = 0;
    double p99_ms = 0;
    double worst_ms = 0;
  };
  /// Of all waits since the start or the last `restart`.
  [[nodiscard]] figures take() const;
  /// Forgets all waits until now, and those that have begun.
  void restart();

private:
  void watch();

  std::atomic<bool> ends_{false};
  std::atomic<bool> answered_{true};
  mutable std::mutex mutex_;
  std::vector<float> waits_ms_;                  ///< Guarded.
  std::chrono::steady_clock::time_point since_;  ///< Guarded. What began before does not count.
  QThread* thread_;
};

}  // namespace tedit::desktop
