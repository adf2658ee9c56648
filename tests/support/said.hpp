// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "base/forked_call.hpp"

namespace tedit::test {

/// What `work` says in a copy of this process within these limits. Errors: those of `call_forked`.
inline expected<std::string> said_in_copy(const forked_limits& limits,
                                          const std::function<std::string()>& work) {
  std::string heard;
  const auto end = call_forked(
    [&](const caller_line& line) {
      const auto text = work();
      line.send(1, std::as_bytes(std::span(text)));
    },
    limits, {},
    [&](std::uint32_t, std::span<const std::byte> bytes) {
      heard.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    });
  if (!end)
    return fail(end.error());
  return heard;
}

}  // namespace tedit::test
