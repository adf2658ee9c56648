// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "compare/comparison.hpp"

namespace tedit::v1 {
class VersionsCompared;
}  // namespace tedit::v1

namespace tedit::protocol {

/// Neither document nor numbers of versions are set, nor what belongs to the stream.
void to_message(const version_comparison& all, v1::VersionsCompared* out);
/// A rise or fall that the message leaves out is all zero, as that of fields of which no vertex is
/// in both. A `where` that is not said, or that a newer server may know, counts as "both".
[[nodiscard]] version_comparison from_message(const v1::VersionsCompared& message);

}  // namespace tedit::protocol
