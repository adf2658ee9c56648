// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tedit {

/// What a confined process (sandbox/sandbox.hpp) is ended for when it tries it.
enum class misdeed : std::uint8_t {
  network,
  program,
  process,
  other_process,
  rights,
  kernel,
  disk,
};

/// The exit status of a process that was ended for it.
[[nodiscard]] constexpr int status_of(misdeed what) {
  return 200 + static_cast<int>(what);
}

/// What a process did that ended with this status of `waitpid`, for people: "tried to open a
/// network connection". Nothing for any other status.
[[nodiscard]] std::optional<std::string> misdeed_of(int status);

/// Whether `how` is what `misdeed_of` says.
[[nodiscard]] bool is_misdeed(const std::string& how);

/// For a person whose work ended so.
inline constexpr const char* misdeed_remedy =
  "Operations and files run without network, other programs and other people's files "
  "(docs/operating.md, What workers may do). The part is unchanged; report this to the plugin's "
  "author";

}  // namespace tedit
