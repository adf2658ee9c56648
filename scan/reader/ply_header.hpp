// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/io/line_cursor.hpp"

namespace tedit::scan {

enum class ply_type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a number.
[[nodiscard]] std::size_t size_of(ply_type type);

struct ply_property {
  std::string name;
  ply_type type = ply_type::float32;
  bool is_list = false;
  ply_type count_type = ply_type::uint8;  ///< Of a list.
};

struct ply_element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<ply_property> properties;
};

enum class ply_encoding { text, little, big };

struct ply_header {
  ply_encoding encoding = ply_encoding::text;
  std::vector<ply_element> elements;
  std::string unit;      ///< As TEdit writes it; else empty.
  std::size_t body = 0;  ///< Where the data begins.
  std::size_t line = 0;  ///< Lines before that.
};

/// Throws `file_failure`.
[[nodiscard]] ply_header read_ply_header(std::string_view file);

}  // namespace tedit::scan
