// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "base/error.hpp"

namespace tedit {

/// Why bytes are no mesh and no surface, where they are plainly something else: nothing at all,
/// blanks alone, text in UTF-16, a picture, a web page that was saved in place of a file, a pointer
/// of Git LFS, another program's format. Its code is `bad_input` or `unsupported_format`, its
/// remedy says how to come to a file that is read. Nothing where they may be what they should be.
/// Cost: the first bytes, all where they are blanks.
[[nodiscard]] std::optional<error> foreign_file(std::span<const char> bytes);

}  // namespace tedit
