// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/guard.hpp"

#include <utility>

namespace tedit {

namespace {

thread_local const cancel_token* current_token = nullptr;

}  // namespace

cancel_scope::cancel_scope(const cancel_token& token)
    : before_(std::exchange(current_token, &token)) {}

cancel_scope::~cancel_scope() {
  current_token = before_;
}

const cancel_token* cancel_scope::current() {
  return current_token;
}

void check_cancelled() {
  if (current_token && current_token->cancelled())
    throw work_cancelled{};
}

error out_of_host_memory() {
  return {ec::out_of_memory, "memory ran out", "Close other programs or take a coarser mesh", {}};
}

}  // namespace tedit
