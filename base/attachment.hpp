// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.hpp"

/// A file that travels as a text: "data:NAME;base64,CONTENT" (like RFC 2397, with the file's name
/// where a media type would be). So a request that needs a file holds all of it, and can be sent to
/// another machine, kept and repeated after the file is gone.
namespace tedit {

struct attachment {
  std::string name;  ///< Without folders: "logo.svg".
  std::string bytes;

  friend bool operator==(const attachment&, const attachment&) = default;
};

/// Bytes that such a file may have.
inline constexpr std::size_t most_attached_bytes = std::size_t{4} << 20;

/// RFC 4648, section 4, with padding and without line ends.
[[nodiscard]] std::string to_base64(std::string_view bytes);

/// What begins like one, whatever follows.
[[nodiscard]] bool is_attachment_text(std::string_view text);

/// ';' and ',' of the name become '_'.
[[nodiscard]] std::string attachment_text(const attachment& file);

/// Errors: `bad_input` for what is no such text, whose content is not base64 or too long.
[[nodiscard]] expected<attachment> read_attachment(std::string_view text);

/// The text of a file. Errors: `io_error` where it cannot be read, `bad_input` where it is empty or
/// too long.
[[nodiscard]] expected<std::string> attach_file(const std::string& path);

}  // namespace tedit
