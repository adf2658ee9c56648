// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>
#include <mutex>

#include "actors/gateway/surface_stream.hpp"

namespace tedit::gateway {

/// The field updates of the last solves: what several clients watch is made once. Thread-safe.
class field_updates {
public:
  /// As `surface_stream::fields_of`, with the document's name of this event. Cost: that for the
  /// first who asks; for those who want the same a copy of the message, not of its arrays.
  [[nodiscard]] std::optional<bulk> get(const actors::solved& event, unsigned index,
                                        const watched_quantities& watched);

private:
  struct update {
    std::weak_ptr<const std::vector<field>> fields;  ///< Of which it is made.
    unsigned index = 0;
    watched_quantities watched;
    std::once_flag once;
    std::optional<bulk> made;
  };

  [[nodiscard]] std::shared_ptr<update> find(const actors::solved& event, unsigned index,
                                             const watched_quantities& watched);

  std::mutex mutex_;
  std::deque<std::shared_ptr<update>> latest_;  ///< Those of results that are gone leave it.
};

}  // namespace tedit::gateway
