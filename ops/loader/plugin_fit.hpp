// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "ops/sdk/operation.hpp"

namespace tedit::ops {

/// What a host offers to plugins: this program's SDK; another one only in tests.
struct sdk_offer {
  std::uint32_t major = sdk_major;
  std::uint32_t minor = sdk_minor;
};

// What keeps a plugin out, as words that go on from "the plugin is not used: "; empty when it fits.
// In this order: what comes later may be read only where what comes before fits.

/// The magic number.
[[nodiscard]] std::string magic_fault(const plugin_descriptor* plugin);

/// The same SDK major number, and at most the host's minor one.
[[nodiscard]] std::string sdk_fault(const plugin_descriptor& plugin, const sdk_offer& host = {});

/// The same `compiler_tag`.
[[nodiscard]] std::string compiler_fault(const plugin_descriptor& plugin);

/// The size, and whether all is filled in.
[[nodiscard]] std::string completeness_fault(const plugin_descriptor& plugin);

/// Each of the plugin's facts is one of the host's. A host of a later minor number has more.
[[nodiscard]] std::string layout_fault(const plugin_descriptor& plugin);

/// All of these: the first fault.
[[nodiscard]] std::string descriptor_fault(const plugin_descriptor* plugin,
                                           const sdk_offer& host = {});

}  // namespace tedit::ops
