// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string_view>

namespace tedit::protocol {

/// The schema of the protocol as a serialised google.protobuf.FileDescriptorSet, with its comments:
/// what a program needs that has no .proto files. Made by protoc when TEdit is built.
[[nodiscard]] std::string_view descriptor_set() noexcept;

}  // namespace tedit::protocol
