// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "actors/errors.hpp"
#include "actors/session/session.hpp"
#include "actors/worker/worker_jobs.hpp"

namespace tedit::actors {

/// Has the work of the first of `asides` done on its thread, answers with what comes of it, whose
/// `document` is set here, and begins the next one. `what`: for people, "the comparison".
template <class Result>
void session_state::do_aside(caf::typed_response_promise<Result> promise,
                             const std::function<expected<Result>()>& work, const char* what) {
  const auto made = std::make_shared<std::optional<expected<Result>>>();
  run_aside({[=] { *made = guarded<Result>(work); }}, what,
            [=, this](const error* failure) mutable {
              if (failure || !**made) {
                promise.deliver(to_caf(failure ? *failure : (*made)->error()));
              } else {
                (**made)->document = parts.document;
                promise.deliver(std::move(***made));
              }
              end_aside();
            });
}

}  // namespace tedit::actors
