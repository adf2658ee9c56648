// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/number_range.hpp"

namespace google::protobuf {
class Message;
}

namespace tedit::protocol {

/// Goes through all fields of a message that came from outside, those of messages in it, too: every
/// number with a fraction must lie in `range`. What a field means, and a range of its own, is
/// judged where it is used. Errors: `code` naming the field, "loads[0].force.total_n.z". Cost:
/// O(fields that are set); repeated whole numbers and bytes cost nothing.
[[nodiscard]] expected<void> check_numbers(const google::protobuf::Message& message,
                                           const number_range& range, ec code);

}  // namespace tedit::protocol
