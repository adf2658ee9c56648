// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/drawing_thread.hpp"

#include <QOpenGLContext>

#include <latch>
#include <utility>

namespace tedit::desktop {

std::shared_ptr<drawing_thread> drawing_thread::shared() {
  static std::weak_ptr<drawing_thread> current;
  auto result = current.lock();
  if (!result)
    current = result = std::make_shared<drawing_thread>();
  return result;
}

drawing_thread::drawing_thread() {
  if (!QOpenGLContext::supportsThreadedOpenGL())
    return;
  thread_.reset(QThread::create([this] { work(); }));
  thread_->setObjectName("drawing");
  thread_->start();
}

drawing_thread::~drawing_thread() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_one();
  if (thread_)
    thread_->wait();
}

QThread* drawing_thread::place() const {
  return thread_ ? thread_.get() : QThread::currentThread();
}

void drawing_thread::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return ends_ || !jobs_.empty(); });
    if (jobs_.empty())
      return;
    auto job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    job = {};  // What it holds goes where it was used.
    lock.lock();
  }
}

void drawing_thread::post(std::function<void()> job) {
  if (!thread_) {
    job();
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  changed_.notify_one();
}

void drawing_thread::run(const std::function<void()>& job) {
  std::latch done(1);
  post([&] {
    job();
    done.count_down();
  });
  done.wait();
}

}  // namespace tedit::desktop
