// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace google::protobuf {
class Message;
}  // namespace google::protobuf

namespace tedit::protocol {

/// Whether all texts of a message are UTF-8, as the protocol asks; fields of type bytes may hold
/// anything. Cost: O(texts and their bytes).
[[nodiscard]] bool has_valid_text(const google::protobuf::Message& message);

/// Makes all texts of a message UTF-8, see `to_utf8`.
void make_text_valid(google::protobuf::Message& message);

/// Where a message has a text of more than `bytes`, as "apply_edit.operation"; empty when nowhere.
[[nodiscard]] std::string find_long_text(const google::protobuf::Message& message,
                                         std::size_t bytes);

}  // namespace tedit::protocol
