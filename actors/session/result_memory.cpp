// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/session/result_memory.hpp"

#include <utility>

namespace tedit::actors {

class result_memory::slot {
public:
  slot(std::shared_ptr<result_memory> owner, fields_ptr what)
      : owner_(std::move(owner)), fields_(std::move(what)) {
    for (const auto& f : *fields_)
      bytes_ += f.values.size() * sizeof(double);
  }
  slot(const slot&) = delete;
  slot& operator=(const slot&) = delete;
  ~slot() { owner_->release(*this); }

private:
  friend class result_memory;

  std::shared_ptr<result_memory> owner_;
  fields_ptr fields_;  ///< Null once they gave way.
  std::uint64_t bytes_ = 0;
  std::list<slot*>::iterator at_;
};

result_memory::handle result_memory::keep(fields_ptr fields) {
  auto place = std::make_shared<slot>(shared_from_this(), std::move(fields));
  std::vector<fields_ptr> gone;  // Freed outside the lock.
  const std::lock_guard lock(mutex_);
  recent_.push_front(place.get());
  place->at_ = recent_.begin();
  used_ += place->bytes_;
  while (used_ > budget_ && recent_.size() > 1) {
    auto* last = recent_.back();
    recent_.pop_back();
    used_ -= last->bytes_;
    gone.push_back(std::exchange(last->fields_, nullptr));
  }
  return place;
}

result_memory::fields_ptr result_memory::find(const handle& place) {
  const std::lock_guard lock(mutex_);
  if (place->fields_)
    recent_.splice(recent_.begin(), recent_, place->at_);
  return place->fields_;
}

bool result_memory::has(const handle& place) const {
  const std::lock_guard lock(mutex_);
  return place->fields_ != nullptr;
}

std::uint64_t result_memory::used() const {
  const std::lock_guard lock(mutex_);
  return used_;
}

void result_memory::release(slot& place) {
  const std::lock_guard lock(mutex_);
  if (!place.fields_)
    return;
  recent_.erase(place.at_);
  used_ -= place.bytes_;
}

}  // namespace tedit::actors
