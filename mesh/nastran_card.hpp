// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

namespace tedit {

/// A number as Nastran wants it: with a point, in at most `width` characters, 8 or 16; as many
/// digits as fit.
[[nodiscard]] std::string nastran_real(double value, std::size_t width);

/// Writes one card of Nastran's bulk data, with as many continuations as its fields need. Fields
/// are 8 characters wide, 16 where `is_wide`, which is for numbers that should keep their digits.
class nastran_card {
public:
  nastran_card(std::ostream& out, const std::string& name, bool is_wide = false);
  nastran_card(const nastran_card&) = delete;
  nastran_card& operator=(const nastran_card&) = delete;
  ~nastran_card();

  nastran_card& add(std::uint64_t number);
  nastran_card& add(double value);
  nastran_card& add(const std::string& text);
  nastran_card& blank(int fields = 1);

private:
  void put(const std::string& text);

  std::ostream& out_;
  bool is_wide_;
  int on_line_ = 0;
};

/// The largest number that a node or an element may have.
inline constexpr std::uint64_t largest_nastran_number = 99'999'999;

}  // namespace tedit
