// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/recipe_player.hpp"

#include <utility>

namespace tedit::client {

recipe_player::recipe_player(std::vector<recipe_step> steps, performer& by,
                             std::function<void()> began)
    : steps_(std::move(steps)), by_(by), began_(std::move(began)) {
  // nop
}

double recipe_player::fraction() const noexcept {
  return done_ ? 1 : static_cast<double>(begun_) / static_cast<double>(steps_.size() + 1);
}

error recipe_player::stop(error reason) {
  if (const auto* now = current())
    reason.message =
      "step " + std::to_string(begun_) + " (" + kind_of(*now) + "): " + reason.message;
  stopped_ = reason;
  return reason;
}

expected<bool> recipe_player::advance() {
  if (stopped_)
    return fail(*stopped_);
  if (done_)
    return false;
  const auto* next = begun_ < steps_.size() ? &steps_[begun_] : nullptr;
  const auto ready = by_.is_ready_for(next);
  if (!ready)
    return fail(stop(ready.error()));
  if (!*ready)
    return true;
  if (!next) {
    done_ = true;
    return false;
  }
  ++begun_;
  if (began_)
    began_();
  if (const auto ok = by_.perform(*next); !ok)
    return fail(stop(ok.error()));
  return stopped_ ? expected<bool>(fail(*stopped_)) : true;  // Stopped while it was performed.
}

}  // namespace tedit::client
