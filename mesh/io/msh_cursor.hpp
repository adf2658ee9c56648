// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace tedit {

/// Thrown inside the MSH reader only; `formats::msh::read` turns it into an `expected`.
struct msh_failure {
  error reason;
};

/// A reading position in a MSH file: text tokens or raw numbers. Every read checks what is left;
/// failures name the section and the line (text) or byte offset (binary).
class msh_cursor {
public:
  explicit msh_cursor(std::span<const char> bytes) : bytes_(bytes) {}

  /// How numbers stand in the file, once the header is known.
  bool binary = false;
  bool swapped = false;
  std::string section = "header";

  // -- text ----------------------------------------------------------------------

  /// The next token, or an empty one at the end of the file.
  std::string_view token();

  /// As `token`, but empty when the line ends first.
  std::string_view token_on_line();

  /// The rest of the line without its end.
  std::string_view rest_of_line();

  /// Skips to just behind the next line end.
  void skip_line_end();

  // -- numbers, text or binary -----------------------------------------------------

  std::int64_t integer(const char* what);  ///< A 32-bit integer in binary files.
  std::uint64_t size(const char* what);    ///< A 64-bit count or number in MSH 4.1.
  double real(const std::string& what);    ///< Finite.
  std::int64_t integer_on_line(const char* what);

  /// Fails when `count` items of at least `bytes_each` bytes cannot fit into what is left.
  void check_count(std::uint64_t count, std::size_t bytes_each, const char* what);

  /// A raw 32-bit integer, whatever `binary` says.
  std::int32_t raw_int();

  /// Skips `count` raw bytes.
  void skip(std::size_t count);

  // -- place -------------------------------------------------------------------------

  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - offset_; }
  void seek(std::size_t offset) { offset_ = offset; }
  [[nodiscard]] std::string_view text() const { return {bytes_.data(), bytes_.size()}; }

  [[noreturn]] void fail_here(ec code, std::string message, std::string remedy = {}) const;
  [[noreturn]] void fail_truncated() const;

private:
  [[noreturn]] void fail_number(std::string_view word, const std::string& what,
                                const char* kind) const;

  template <class T>
  T raw() {
    if (left() < sizeof(T))
      fail_truncated();
    T value;
    std::memcpy(&value, bytes_.data() + offset_, sizeof(T));
    offset_ += sizeof(T);
    if (swapped) {
      auto* first = reinterpret_cast<unsigned char*>(&value);
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i)
        std::swap(first[i], first[sizeof(T) - 1 - i]);
    }
    return value;
  }

  template <class T>
  T parse(std::string_view word, const char* what) const;

  [[nodiscard]] std::string_view word_here();

  std::span<const char> bytes_;
  std::size_t offset_ = 0;
};

/// A token as it may stand in a message: printable and short.
[[nodiscard]] std::string plain(std::string_view word);

}  // namespace tedit
