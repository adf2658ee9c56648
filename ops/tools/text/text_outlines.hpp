// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>

#include "ops/tools/tools.hpp"

namespace tedit::ops {

/// A font of the system by its kind: "sans", "bold", "serif", "mono". Errors: `not_found` with what
/// to install.
[[nodiscard]] expected<std::filesystem::path> font_file(const std::string& kind);

/// The outlines of a line of text (UTF-8), centred on the origin, with capitals `height` m high and
/// curves of edges no longer than `edge` m. All walls are one side, "side". Errors:
/// `invalid_parameter` for text without outlines, for letters that the font has not, and for what
/// is no UTF-8; `io_error` where the font cannot be read.
[[nodiscard]] expected<profile> text_outlines(const std::string& text,
                                              const std::filesystem::path& font, double height,
                                              double edge);

}  // namespace tedit::ops
