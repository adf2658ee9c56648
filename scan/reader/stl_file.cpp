// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstring>

#include "mesh/io/line_cursor.hpp"
#include "scan/reader/file_surface.hpp"

namespace tedit::scan {

namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t triangle_size = 50;
constexpr const char* save_again = "Save the file again in the program that it comes from";

/// Binary files may begin with "solid", too; they hold no text "facet" where one would be.
bool is_text(std::string_view bytes) {
  const auto head = bytes.substr(0, 4096);
  const auto begin = head.find_first_not_of(" \t\r\n");
  if (begin == head.npos || !head.substr(begin).starts_with("solid"))
    return false;
  std::uint32_t count = 0;
  if (bytes.size() >= header_size + 4) {
    std::memcpy(&count, bytes.data() + header_size, sizeof(count));
    if (bytes.size() == header_size + 4 + triangle_size * std::size_t{count})
      return false;
  }
  return head.find('\0') == head.npos;
}

void add_triangle(file_surface& into, const std::array<vec3, 3>& corners) {
  const auto first = static_cast<std::uint32_t>(into.surface.points.size());
  into.surface.points.insert(into.surface.points.end(), corners.begin(), corners.end());
  into.surface.triangles.push_back({first, first + 1, first + 2});
}

expected<file_surface> read_binary(std::string_view bytes) {
  if (bytes.size() < header_size + 4)
    return fail(ec::bad_input,
                "the STL file is cut off: it has " + std::to_string(bytes.size()) +
                  " bytes, its header alone has 84",
                save_again, "byte " + std::to_string(bytes.size()));
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_size, sizeof(count));
  const auto room = (bytes.size() - header_size - 4) / triangle_size;
  if (count > room)
    return fail(ec::bad_input,
                "the STL file says that it has " + std::to_string(count) +
                  " triangles, but its bytes end after " + std::to_string(room),
                std::string(save_again) + ": it is cut off", "byte 80");
  file_surface read;
  read.unit = unit_in(bytes.substr(0, header_size));
  if (const auto rest = bytes.size() - header_size - 4 - triangle_size * std::size_t{count};
      rest > 0)
    read.notices.push_back("behind the triangles of the STL file are " + std::to_string(rest) +
                           " bytes more, which are left out");
  read.surface.points.reserve(3 * std::size_t{count});
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = header_size + 4 + i * triangle_size;
    std::array<float, 9> numbers{};
    std::memcpy(numbers.data(), bytes.data() + at + 12, sizeof(numbers));
    std::array<vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
      if (!is_finite(corners[k]))
        return fail(ec::bad_input,
                    "triangle " + std::to_string(i + 1) +
                      " of the STL file has a corner that is no finite number",
                    save_again, "byte " + std::to_string(at + 12 + 12 * k));
    }
    add_triangle(read, corners);
  }
  return read;
}

/// The lines of a text file; each solid in it is a group.
class stl_text {
public:
  explicit stl_text(std::string_view text) : lines_(text) {}

  file_surface read() {
    while (lines_.next())
      take(words_of(lines_.line()));
    if (in_facet_)
      lines_.fail_here(ec::bad_input, "the STL file ends within a facet",
                       std::string(save_again) + ": it is cut off");
    if (solids_ > ends_)
      read_.notices.push_back("the STL file does not end with endsolid: it may be cut off");
    if (read_.groups.size() < 2) {
      read_.bodies.push_back(read_.groups.empty() ? std::string() : read_.groups.front().name);
      read_.groups.clear();
      read_.group_of.clear();
    }
    return std::move(read_);
  }

private:
  void take(const std::vector<std::string_view>& words) {
    if (words.empty())
      return;
    if (words[0] == "vertex") {
      vertex(words);
    } else if (words[0] == "solid") {
      begin_solid();
    } else if (words[0] == "facet" || words[0] == "endfacet") {
      end_facet();
      in_facet_ = words[0] == "facet";
    } else if (words[0] == "endsolid") {
      ++ends_;
    } else if (words[0] != "outer" && words[0] != "endloop") {
      lines_.fail_here(ec::bad_input, "\"" + shown(words[0]) + "\" is no word of an STL file",
                       save_again);
    }
  }

  /// The one before, if any.
  void end_facet() {
    if (in_facet_ && corners_ != 3)
      lines_.fail_here(
        ec::bad_input,
        "a facet of the STL file has " + std::to_string(corners_) + " corners, not 3", save_again);
    corners_ = 0;
  }

  void begin_solid() {
    const auto name = trimmed(trimmed(lines_.line()).substr(5));
    if (read_.unit.empty())
      read_.unit = unit_in(name);
    read_.groups.push_back({std::string(name), {}, 0});
    ++solids_;
  }

  void vertex(const std::vector<std::string_view>& words) {
    if (words.size() != 4)
      lines_.fail_here(ec::bad_input,
                       "a corner has " + std::to_string(words.size() - 1) + " coordinates, not 3",
                       save_again);
    if (!in_facet_)
      lines_.fail_here(ec::bad_input, "a corner stands outside of all facets", save_again);
    const vec3 corner{lines_.real(words[1], "x"), lines_.real(words[2], "y"),
                      lines_.real(words[3], "z")};
    if (corners_ < 3)
      pending_[corners_] = corner;
    if (++corners_ != 3)
      return;
    if (read_.groups.empty())
      read_.groups.push_back({});
    add_triangle(read_, pending_);
    read_.group_of.push_back(static_cast<std::uint32_t>(read_.groups.size() - 1));
  }

  line_cursor lines_;
  file_surface read_;
  std::array<vec3, 3> pending_;
  bool in_facet_ = false;
  std::size_t corners_ = 0;  ///< Of the facet.
  std::size_t solids_ = 0;
  std::size_t ends_ = 0;
};

}  // namespace

expected<file_surface> read_stl(std::span<const char> bytes) {
  const std::string_view text(bytes.data(), bytes.size());
  auto read = is_text(text) ? guarded([&] { return stl_text(text).read(); }) : read_binary(text);
  return read ? checked(std::move(*read), "STL") : read;
}

}  // namespace tedit::scan
