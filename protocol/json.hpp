// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <google/protobuf/util/json_util.h>

#include "base/error.hpp"

namespace tedit::protocol {

/// A message as canonical JSON with the field names of its .proto file.
template <class Message>
[[nodiscard]] std::string message_to_json(const Message& message, bool indent = false) {
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = indent;
  options.preserve_proto_field_names = true;
  std::string json;
  (void)google::protobuf::util::MessageToJsonString(message, &json, options);
  return json;
}

/// The inverse; unknown fields are refused. Errors: `protocol_error` with the parser's words.
template <class Message>
[[nodiscard]] expected<Message> message_from_json(std::string_view json) {
  Message message;
  const auto status = google::protobuf::util::JsonStringToMessage(
    google::protobuf::StringPiece(json.data(), json.size()), &message);
  if (!status.ok())
    return fail(ec::protocol_error, std::string(status.message()));
  return message;
}

}  // namespace tedit::protocol
