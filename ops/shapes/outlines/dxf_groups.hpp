// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/attachment.hpp"

namespace tedit::ops {

/// A group of an ASCII DXF: a code and a value, a line each. Source: Autodesk, DXF Reference.
struct dxf_group {
  int code = 0;
  std::string_view value;  ///< Of the file's bytes, without blanks at its ends.
};

/// What begins with a group 0: an entity, a table's row, a section.
struct dxf_item {
  std::string_view kind;
  std::span<const dxf_group> groups;  ///< Without the first.
  std::size_t line = 0;               ///< Of its kind in the file, from 1.
};

/// Its groups as they are asked for. What is no number, or none that a drawing has (1e9 and above),
/// is kept as the first fault and answered with what it would be without that group.
class dxf_values {
public:
  explicit dxf_values(const dxf_item& item) : item_(item) {}

  [[nodiscard]] std::string_view text(int code) const;
  [[nodiscard]] double number(int code, double otherwise);
  [[nodiscard]] int whole(int code, int otherwise);
  [[nodiscard]] double number_in(const dxf_group& group);
  [[nodiscard]] const std::optional<error>& fault() const { return fault_; }

private:
  [[nodiscard]] const dxf_group* find(int code) const;

  const dxf_item& item_;
  std::optional<error> fault_;
};

/// Does a file say of itself that it is a drawing, whether it can be read or not?
[[nodiscard]] bool is_drawing_file(std::string_view bytes);

/// All groups up to the end mark; their values point into the file. Errors: `unsupported_format`
/// for a binary DXF and a DWG, `bad_input` with the line for what are no groups, and for a file
/// that ends before its mark. Cost: O(bytes), six times the file at most.
[[nodiscard]] expected<std::vector<dxf_group>> dxf_groups(const attachment& file);

/// The same, each from its group 0 on.
[[nodiscard]] std::vector<dxf_item> dxf_items(const std::vector<dxf_group>& groups);

}  // namespace tedit::ops
