// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include <caf/typed_actor.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/local_messages.hpp"

namespace tedit::actors {

/// Work for a thread. Runs there and must not throw.
struct job_task {
  std::function<void()> run;
};

/// A thread that does one piece of work after the other, so that the actor that owns it always
/// answers at once.
using job_thread_actor = caf::typed_actor<caf::replies_to<job_task>::with<acknowledged>>;

/// A class, since CAF 0.17 dereferences a null pointer when it starts a function without arguments.
class job_thread final : public job_thread_actor::base {
public:
  using job_thread_actor::base::base;
  behavior_type make_behavior() override;
};

}  // namespace tedit::actors

CAF_ALLOW_UNSAFE_MESSAGE_TYPE(tedit::actors::job_task)
