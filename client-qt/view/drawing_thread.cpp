// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/view/drawing_thread.hpp"

#include <QOpenGLContext>

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
  here_.moveToThread(&thread_);
  thread_.setObjectName("drawing");
  thread_.start();
}

drawing_thread::~drawing_thread() {
  thread_.quit();
  thread_.wait();
}

void drawing_thread::post(std::function<void()> job) {
  if (thread_.isRunning())
    QMetaObject::invokeMethod(&here_, std::move(job), Qt::QueuedConnection);
  else
    job();
}

void drawing_thread::run(const std::function<void()>& job) {
  if (thread_.isRunning())
    QMetaObject::invokeMethod(&here_, job, Qt::BlockingQueuedConnection);
  else
    job();
}

}  // namespace tedit::desktop
