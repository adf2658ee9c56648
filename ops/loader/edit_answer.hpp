// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// An operation's answer as bytes, for another process that has `base`: of the candidate only the
/// pages that `base` does not have. @pre An edit has a candidate.
[[nodiscard]] std::vector<std::byte> to_bytes(const expected<edit_result>& answer,
                                              const mesh_version& base);

/// The inverse of `to_bytes`. Bounded. Errors: the answer's own; `protocol_error`, whose
/// message has no subject ("gave no answer"), when the bytes are none.
[[nodiscard]] expected<edit_result> answer_from_bytes(std::span<const std::byte> bytes,
                                                      const mesh_version& base);

}  // namespace tedit::ops
