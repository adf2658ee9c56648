// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include <caf/scheduled_actor.hpp>

#include "base/logging/logging.hpp"

namespace tedit::actors {

/// Whether an actor of this process sent what `self` now works on. Nobody who stays nameless is.
[[nodiscard]] inline bool is_asked_from_here(caf::scheduled_actor* self) {
  const auto& from = self->current_sender();
  return from && from->node() == self->node();
}

/// Lets an actor be ended from this process only. By CAF's default any node that knows its number,
/// or that dies while it is linked to it, ends it too; the actors of a server serve others and must
/// outlive such a node. `before` is called first when it ends.
inline void heed_only_own_exits(caf::scheduled_actor* self,
                                const std::function<void()>& before = {}) {
  self->set_exit_handler([=](caf::exit_msg& message) {
    if (message.source && message.source.node() != self->node()) {
      logging::warn("{}: another node asked it to end; it goes on", self->name());
      return;
    }
    if (!message.reason)
      return;  // A linked actor that ended as planned.
    if (before)
      before();
    self->quit(std::move(message.reason));
  });
}

}  // namespace tedit::actors
