// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/field_updates.hpp"

#include <algorithm>

namespace tedit::gateway {

namespace {

/// Clients that watch one solve are sent it at about the same time.
constexpr std::size_t most_updates = 16;

}  // namespace

std::shared_ptr<field_updates::update> field_updates::find(const actors::solved& event,
                                                           unsigned index,
                                                           const watched_quantities& watched) {
  const std::lock_guard lock(mutex_);
  std::erase_if(latest_, [](const auto& one) { return one->fields.expired(); });
  const auto found = std::ranges::find_if(latest_, [&](const auto& one) {
    return one->fields.lock() == event.fields && one->index == index && one->watched == watched;
  });
  if (found != latest_.end())
    return *found;
  auto fresh = std::make_shared<update>();
  fresh->fields = event.fields;
  fresh->index = index;
  fresh->watched = watched;
  latest_.push_front(fresh);
  if (latest_.size() > most_updates)
    latest_.pop_back();
  return fresh;
}

std::optional<bulk> field_updates::get(const actors::solved& event, unsigned index,
                                       const watched_quantities& watched) {
  const auto shared = find(event, index, watched);
  // Outside the lock: others want other ones meanwhile.
  std::call_once(shared->once,
                 [&] { shared->made = surface_stream::fields_of(event, index, watched); });
  auto result = shared->made;
  if (result) {
    auto* update = result->header.mutable_field_update();
    update->set_document(event.document);  // It may have been renamed.
    result->stream = update->mutable_stream();
  }
  return result;
}

}  // namespace tedit::gateway
