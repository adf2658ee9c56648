// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/attachment.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>

namespace tedit {

namespace {

constexpr std::string_view begins = "data:";
constexpr std::string_view middle = ";base64,";
constexpr std::string_view digits =
  "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

tl::unexpected<error> too_long() {
  return fail(ec::bad_input, "the file has more than 4 MiB", "Simplify what it holds");
}

/// Nothing for anything but whole groups of four with their padding at the end.
std::optional<std::string> from_base64(std::string_view text) {
  if (text.size() % 4 != 0)
    return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::size_t n = 4;
    if (i + 4 == text.size())
      while (n > 2 && text[i + n - 1] == '=')
        --n;
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto value = k < n ? digits.find(text[i + k]) : 0;
      if (value == std::string_view::npos)
        return std::nullopt;
      bits = bits << 6 | static_cast<std::uint32_t>(value);
    }
    for (std::size_t k = 0; k + 1 < n; ++k)
      bytes += static_cast<char>(bits >> (16 - 8 * k) & 255);
  }
  return bytes;
}

}  // namespace

std::string to_base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= n ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

bool is_attachment_text(std::string_view text) {
  return text.starts_with(begins);
}

std::string attachment_text(const attachment& file) {
  std::string name = file.name;
  std::ranges::replace(name, ';', '_');
  std::ranges::replace(name, ',', '_');
  return std::string(begins) + name + std::string(middle) + to_base64(file.bytes);
}

expected<attachment> read_attachment(std::string_view text) {
  const auto split = text.find(middle);
  if (!is_attachment_text(text) || split == std::string_view::npos)
    return fail(ec::bad_input, "it is not the content of a file",
                "Give it as data:NAME;base64,CONTENT; programs of this kind make that of a path");
  const auto content = text.substr(split + middle.size());
  if (content.size() > (most_attached_bytes + 2) / 3 * 4)
    return too_long();
  auto bytes = from_base64(content);
  if (!bytes)
    return fail(ec::bad_input, "the content of the file is not base64");
  return attachment{std::string(text.substr(begins.size(), split - begins.size())),
                    std::move(*bytes)};
}

expected<std::string> attach_file(const std::string& path) {
  std::error_code failure;
  // A pipe or a device may never end.
  if (!std::filesystem::is_regular_file(path, failure))
    return fail(ec::io_error,
                path + (std::filesystem::exists(path, failure) ? " is no file" : " is not there"),
                "Check the path");
  std::ifstream in(path, std::ios::binary);
  std::string bytes(most_attached_bytes + 1, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (in.bad() || !in.is_open())
    return fail(ec::io_error, path + " cannot be read", "Check who may read it");
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (bytes.empty())
    return fail(ec::bad_input, path + " is empty");
  if (bytes.size() > most_attached_bytes)
    return too_long();
  return attachment_text({std::filesystem::path(path).filename().string(), std::move(bytes)});
}

}  // namespace tedit
