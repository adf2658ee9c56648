// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/edit_queue.hpp"

#include <utility>

#include "client-qt/model/document.hpp"

namespace tedit::desktop {

edit_queue::edit_queue(document& part, QObject* parent) : QObject(parent), part_(part) {
  connect(&part_.foreground(), &foreground_work::changed, this, &edit_queue::next,
          Qt::QueuedConnection);
  connect(&part_, &document::surface_changed, this, &edit_queue::next, Qt::QueuedConnection);
  connect(&part_, &document::begun, this, &edit_queue::clear);
}

bool edit_queue::add(const QString& title, std::function<void()> change) {
  if (waiting_.size() == most)
    return false;
  waiting_.push_back({title, std::move(change)});
  next();
  emit changed();
  return true;
}

QStringList edit_queue::waiting() const {
  QStringList titles;
  for (const auto& one : waiting_)
    titles << one.title;
  return titles;
}

void edit_queue::clear() {
  if (!std::exchange(waiting_, {}).empty())
    emit changed();
}

void edit_queue::abandon() {
  const auto left = waiting();
  clear();
  if (!left.isEmpty())
    emit abandoned(left);
}

/// The head's surface is waited for: selections and expected versions are of it.
void edit_queue::next() {
  const auto is_free = [this] {
    const auto* head = part_.head();
    return head && head->surface && !part_.foreground().current() && !part_.edits().awaits_answer();
  };
  bool any = false;
  while (!waiting_.empty() && is_free()) {
    const auto now = std::move(waiting_.front());
    waiting_.pop_front();
    now.make();  // May find that there is nothing to do any more.
    any = true;
  }
  if (any)
    emit changed();
}

}  // namespace tedit::desktop
