// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/stall_watch.hpp"

#include <QMetaObject>

#include <algorithm>
#include <thread>

namespace tedit::desktop {

namespace {

using clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds pause{5};
constexpr std::size_t most_samples = 1 << 20;

}  // namespace

stall_watch::stall_watch(QObject* parent) : QObject(parent) {
  thread_ = QThread::create([this] { watch(); });
  thread_->start(QThread::HighPriority);
}

stall_watch::~stall_watch() {
  ends_ = true;
  thread_->wait();
  delete thread_;
}

void stall_watch::watch() {
  while (!ends_) {
    if (answered_.exchange(false)) {
      const auto sent = clock::now();
      QMetaObject::invokeMethod(
        this,
        [this, sent] {
          const std::chrono::duration<float, std::milli> waited = clock::now() - sent;
          const std::lock_guard lock(mutex_);
          if (sent >= since_ && waits_ms_.size() < most_samples)
            waits_ms_.push_back(waited.count());
          answered_ = true;
        },
        Qt::QueuedConnection);
    }
    std::this_thread::sleep_for(pause);
  }
}

stall_watch::figures stall_watch::take() const {
  std::vector<float> all;
  {
    const std::lock_guard lock(mutex_);
    all = waits_ms_;
  }
  if (all.empty())
    return {};
  std::ranges::sort(all);
  const auto at = [&](double share) {
    return all[std::min(all.size() - 1, static_cast<std::size_t>(share * all.size()))];
  };
  return {all.size(), at(0.5), at(0.99), all.back()};
}

void stall_watch::restart() {
  const std::lock_guard lock(mutex_);
  waits_ms_.clear();
  since_ = clock::now();
}

}  // namespace tedit::desktop
