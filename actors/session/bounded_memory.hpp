// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "mesh/field.hpp"
#include "mesh/version.hpp"

namespace tedit::actors {

/// What a server keeps to have it at hand, of all its documents together: what was used last stays,
/// up to a budget. Thread-safe.
template <class T>
class bounded_memory : public std::enable_shared_from_this<bounded_memory<T>> {
public:
  using kept_ptr = std::shared_ptr<const T>;

  /// A place for one of them; it is given back with it.
  class slot {
  public:
    slot(std::shared_ptr<bounded_memory> owner, kept_ptr what, std::uint64_t bytes)
        : owner_(std::move(owner)), what_(std::move(what)), bytes_(bytes) {}
    slot(const slot&) = delete;
    slot& operator=(const slot&) = delete;
    ~slot() { owner_->release(*this); }

  private:
    friend class bounded_memory;

    std::shared_ptr<bounded_memory> owner_;
    kept_ptr what_;  ///< Null once it gave way.
    std::uint64_t bytes_;
    typename std::list<slot*>::iterator at_;
  };
  using handle = std::shared_ptr<slot>;

  explicit bounded_memory(std::uint64_t budget_bytes) : budget_(budget_bytes) {}

  /// `bytes` are what giving it back would free. Those used longest ago give way; this one stays
  /// until others come, however large it is.
  [[nodiscard]] handle keep(kept_ptr what, std::uint64_t bytes) {
    auto place = std::make_shared<slot>(this->shared_from_this(), std::move(what), bytes);
    std::vector<kept_ptr> gone;  // Freed outside the lock.
    const std::lock_guard lock(mutex_);
    recent_.push_front(place.get());
    place->at_ = recent_.begin();
    used_ += bytes;
    while (used_ > budget_ && recent_.size() > 1) {
      auto* last = recent_.back();
      recent_.pop_back();
      used_ -= last->bytes_;
      gone.push_back(std::exchange(last->what_, nullptr));
    }
    return place;
  }

  /// Null when it had to give way. Counts as a use.
  [[nodiscard]] kept_ptr find(const handle& place) {
    const std::lock_guard lock(mutex_);
    if (place->what_)
      recent_.splice(recent_.begin(), recent_, place->at_);
    return place->what_;
  }

  [[nodiscard]] bool has(const handle& place) const {
    const std::lock_guard lock(mutex_);
    return place->what_ != nullptr;
  }

  /// Bytes of what is kept.
  [[nodiscard]] std::uint64_t used() const {
    const std::lock_guard lock(mutex_);
    return used_;
  }
  [[nodiscard]] std::uint64_t budget() const noexcept { return budget_; }

private:
  void release(slot& place) {
    const std::lock_guard lock(mutex_);
    if (!place.what_)
      return;
    recent_.erase(place.at_);
    used_ -= place.bytes_;
  }

  const std::uint64_t budget_;
  mutable std::mutex mutex_;  ///< Guards what follows, and all slots.
  std::uint64_t used_ = 0;
  std::list<slot*> recent_;  ///< Those with something, used last at the front.
};

/// The fields of results.
using result_memory = bounded_memory<std::vector<field>>;

[[nodiscard]] inline std::uint64_t bytes_of(const std::vector<field>& fields) {
  std::uint64_t bytes = 0;
  for (const auto& f : fields)
    bytes += f.values.size() * sizeof(double);
  return bytes;
}

/// Versions other than the heads; their bytes are those of pages that the version before has not.
using version_memory = bounded_memory<mesh_version>;

}  // namespace tedit::actors
