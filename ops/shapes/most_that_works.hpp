// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// One operation as a function of the parameter that may be too large.
using value_trial = std::function<expected<edit_result>(double value, context& ctx)>;

/// A parameter of an operation and what was asked for.
struct asked_value {
  std::string parameter;  ///< Its id.
  std::string name;       ///< For people: "depth".
  double value = 0;       ///< m.
};

/// Does the candidate hold what an edit promises once the host has improved it? Errors: those of
/// `finish_edit`. Cost: that of the host's improvement and checks.
[[nodiscard]] expected<void> passes(const version_ptr& mesh, const edit_result& result,
                                    const execution& run);

/// The same; what is nowhere below the promised quality is taken to pass. Cost: then O(touched).
[[nodiscard]] expected<void> passes_if_doubtful(const version_ptr& mesh, const edit_result& result,
                                                const execution& run);

/// Runs `trial` with the value that was asked for. Where that is refused with an error that has no
/// remedy of its own, the most that works is looked for, for as long as `context::search_s` lets
/// it (a trial that takes longer is ended), and told: one of the same values whatever was asked
/// for, at most 15 % below the limit, and tried to the end. Where the time is over before the limit
/// is found, a value that works is told as no more than that. Where the mesh came out too bad and a
/// larger value does better, that is the remedy. Errors: those of the trial, with a remedy. Cost: a
/// refusal costs 3 to 13 trials.
[[nodiscard]] expected<edit_result> at_most(const version_ptr& mesh, const asked_value& asked,
                                            const value_trial& trial, context& ctx);

}  // namespace tedit::ops
