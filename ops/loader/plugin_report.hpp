// SPDX-License-Identifier: AGPL-3.0-or-later
// What a process that loaded a plugin tells one that must not (tedit-probe, and who starts it).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// An operation of a plugin, as that describes it.
struct described_operation {
  operation_description description;
  std::string plugin;  ///< Name and version.
};

/// What loading a plugin came to.
struct plugin_report {
  std::string refusal;  ///< Why it must not be used; empty: it may.
  std::vector<described_operation> operations;
};

/// The most that a report may hold.
inline constexpr std::size_t most_report_bytes = std::size_t{4} << 20;

/// What in a description nobody can show, as words that go on from "the plugin is not used: ":
/// control characters, which terminals act on, and what is no UTF-8. Empty: nothing.
[[nodiscard]] std::string text_fault(const described_operation& one);

/// A report as bytes for another process of this machine; one that would be too long is a refusal.
[[nodiscard]] std::vector<std::byte> to_bytes(const plugin_report& report);

/// The inverse. The bytes are the plugin's word, whose code ran where they were written: bounded,
/// with no text that has a `text_fault`, and either a reason of one line or operations. Errors:
/// `protocol_error`, whose message has no subject ("gave no answer that can be read").
[[nodiscard]] expected<plugin_report> report_from_bytes(std::span<const std::byte> bytes);

/// Whether both say the same.
[[nodiscard]] bool is_same(const described_operation& a, const described_operation& b);

}  // namespace tedit::ops
