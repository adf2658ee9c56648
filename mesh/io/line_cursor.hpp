// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "mesh/io/read_mesh.hpp"

namespace tedit {

/// Thrown inside readers only; `guarded_read` turns it into an `expected`.
struct file_failure {
  error reason;
};

/// The lines of a text file, for readers of decks. Failures name the line and what stands there.
class line_cursor {
public:
  explicit line_cursor(std::span<const char> bytes) : text_(bytes.data(), bytes.size()) {}

  /// Goes to the next line, without its end; false where there is none.
  bool next();
  /// The next call of `next` gives this line again.
  void back() { again_ = true; }

  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Where the line begins in the file, and the whole of it.
  [[nodiscard]] std::size_t offset() const { return begin_; }
  [[nodiscard]] std::string_view text() const { return text_; }

  [[noreturn]] void fail_here(ec code, std::string message, std::string remedy = {}) const;

  /// A number as a field holds it, blanks around it allowed; reals must be finite. Fails naming
  /// `what`.
  [[nodiscard]] std::int64_t integer(std::string_view field, std::string_view what) const;
  /// At least 1.
  [[nodiscard]] std::uint64_t positive(std::string_view field, std::string_view what) const;
  /// Also with Fortran's exponents: 1.5D+3, and without a letter as Nastran writes them: 1.5+3.
  [[nodiscard]] double real(std::string_view field, std::string_view what) const;

private:
  std::string_view text_;
  std::string_view line_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;  ///< Behind the line and its end.
  std::size_t number_ = 0;
  bool again_ = false;
};

/// Without blanks at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// In capitals: ASCII letters alone.
[[nodiscard]] std::string upper(std::string_view text);

/// The whole of a field as a number; nothing where it is none.
[[nodiscard]] std::optional<std::int64_t> integer_of(std::string_view field);
[[nodiscard]] std::optional<double> real_of(std::string_view field);

/// A word as it may stand in a message: printable and short.
[[nodiscard]] std::string shown(std::string_view word);

/// The number at the end of a name, "Surface12"; nothing where there is none below 2^31.
[[nodiscard]] std::optional<std::int64_t> number_at_end(std::string_view name);

/// What `read` gives, or why it threw. Errors: as thrown; `out_of_memory`.
template <std::invocable Read>
[[nodiscard]] expected<read_mesh> guarded_read(Read&& read) {
  try {
    return read();
  } catch (const file_failure& failure) {
    return fail(failure.reason);
  } catch (const std::bad_alloc&) {
    return fail(ec::out_of_memory, "there is not enough memory to read this mesh",
                "Close other programs or take a coarser mesh");
  }
}

}  // namespace tedit
