// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <pugixml.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tedit {

/// How the numbers of a VTU file stand in it.
struct vtu_encoding {
  bool wide_headers = false;       ///< UInt64 instead of UInt32.
  bool swapped = false;            ///< Big-endian.
  bool compressed = false;         ///< By zlib.
  std::string_view appended = {};  ///< Behind the "_"; empty where there is none.
  bool appended_is_base64 = false;
};

/// The numbers of data arrays. Every count is held against the bytes that are there before memory
/// is taken. Failures throw `file_failure` naming the array.
class vtu_data {
public:
  explicit vtu_data(vtu_encoding encoding) : encoding_(encoding) {}

  /// `count` numbers of an array of any numeric type: neither fewer nor more.
  [[nodiscard]] std::vector<double> reals(const pugi::xml_node& array, std::uint64_t count) const;
  /// The same, whole numbers.
  [[nodiscard]] std::vector<std::int64_t> integers(const pugi::xml_node& array,
                                                   std::uint64_t count) const;
  /// The texts of a String array.
  [[nodiscard]] std::vector<std::string> texts(const pugi::xml_node& array) const;

private:
  [[nodiscard]] std::string bytes_of(const pugi::xml_node& array, std::uint64_t most) const;
  [[nodiscard]] std::string stored_bytes(std::string_view from, std::uint64_t most,
                                         const std::string& name) const;
  [[nodiscard]] std::string inflated(std::string_view stored, std::uint64_t most,
                                     const std::string& name) const;
  [[nodiscard]] std::uint64_t header(std::string_view bytes, std::size_t i,
                                     const std::string& name) const;

  template <class Number>
  std::vector<Number> numbers(const pugi::xml_node& array, std::uint64_t count) const;

  vtu_encoding encoding_;
};

/// Fails naming an array. Never returns.
[[noreturn]] void fail_array(const std::string& name, const std::string& what);

}  // namespace tedit
