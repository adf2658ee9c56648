// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/io/med_content.hpp"

namespace tedit::med {

/// The one mesh of tets of a file. Throws `refusal`.
[[nodiscard]] med_content read_med(std::span<const char> bytes);

/// A MED 4.1 file. Throws `refusal`.
[[nodiscard]] std::vector<char> write_med(const med_content& content);

}  // namespace tedit::med
