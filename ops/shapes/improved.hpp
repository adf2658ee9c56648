// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/optimize/improve.hpp"
#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// What an operation of several steps goes on with: one step's candidate, improved as the host
/// would do it. Errors: `cancelled`.
[[nodiscard]] inline expected<version_ptr> improved(const edit_result& step, const execution& run) {
  if (step.improve == improvement::none)
    return step.candidate;
  mesh_builder builder(step.candidate);
  if (const auto done = improve(builder, step.touched, {}, run); !done)
    return fail(done.error());
  return builder.freeze();
}

}  // namespace tedit::ops
