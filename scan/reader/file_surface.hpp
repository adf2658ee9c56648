// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "cad/exchange.hpp"
#include "mesh/io/line_cursor.hpp"
#include "mesh/segment/facet_net.hpp"

namespace tedit::scan {

/// Triangles that a file holds together: a group, a material, a colour.
struct face_group {
  std::string name;
  std::optional<cad::colour> looks;
  surface_id id = 0;  ///< Where the file says one: at least 1.
};

/// The triangles of a file as they are: corners of equal place may be there several times.
struct file_surface {
  triangle_surface surface;
  std::vector<std::uint32_t> group_of;  ///< Of each triangle; empty: the file has no groups.
  std::vector<face_group> groups;
  std::vector<std::uint32_t> body_of;  ///< Of each triangle; empty: the file has one body.
  std::vector<std::string> bodies;     ///< Their names; may be empty.
  std::string unit;                    ///< Where the file says it: "mm"; else empty.
  std::vector<std::string> notices;
};

/// More triangles than a mesh of tets can be made of in reasonable time.
inline constexpr std::size_t most_triangles = 2'000'000;

/// Each reads the bytes of one format. No count takes memory before it was held against the bytes
/// that are left, and no number is taken that is not finite. Errors: `bad_input` with the line or
/// byte offset in `where`; `unsupported_format`; `out_of_memory`. Cost: O(bytes).
[[nodiscard]] expected<file_surface> read_stl(std::span<const char> bytes);
[[nodiscard]] expected<file_surface> read_obj(std::span<const char> bytes);
[[nodiscard]] expected<file_surface> read_ply(std::span<const char> bytes);
[[nodiscard]] expected<file_surface> read_3mf(std::span<const char> bytes);

/// A file of a kind that `kind_of` says (scan/file_kind.hpp). Errors: also `unsupported_format` for
/// what is plainly something else under that kind's suffix.
[[nodiscard]] expected<file_surface> read_surface(std::string_view kind,
                                                  std::span<const char> bytes);

/// The words of a line, parted by blanks.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view line);

/// A file that TEdit wrote says its unit in a text like this: "TEdit boundary, unit mm". Empty
/// where it does not.
[[nodiscard]] std::string unit_in(std::string_view text);

/// What `read` gives, or why it threw. Errors: as thrown.
template <class Read>
[[nodiscard]] expected<file_surface> guarded(const Read& read) {
  try {
    return read();
  } catch (const file_failure& failure) {
    return fail(failure.reason);
  }
}

/// Puts a polygon in as triangles around its first corner; what has fewer than three is nothing.
void add_polygon(file_surface& into, std::span<const std::uint32_t> corners, std::uint32_t group);

/// Refuses files that hold no triangle, or more than can be taken.
[[nodiscard]] expected<file_surface> checked(file_surface read, const char* kind);

}  // namespace tedit::scan
