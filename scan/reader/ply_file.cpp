// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>

#include "base/text.hpp"
#include "scan/reader/file_surface.hpp"
#include "scan/reader/ply_header.hpp"

namespace tedit::scan {

namespace {

constexpr const char* ply_cut_off =
  "Save the file again in the program that it comes from: it is cut off";
constexpr const char* ply_save_again = "Save the file again in the program that it comes from";
/// Colours of a scan are a picture, not groups.
constexpr std::size_t most_colours = 64;
constexpr double most_corners = 1000;  ///< Of one face.

/// The numbers behind the header, one after the other.
class ply_numbers {
public:
  ply_numbers(std::string_view file, const ply_header& header)
      : file_(file), at_(header.body), encoding_(header.encoding) {}

  double next(ply_type type) {
    return encoding_ == ply_encoding::text ? next_word() : next_bytes(type);
  }

  [[nodiscard]] std::size_t left() const { return file_.size() - at_; }
  [[nodiscard]] bool is_text() const { return encoding_ == ply_encoding::text; }

  [[noreturn]] void fail_here(std::string message, const char* remedy) const {
    throw file_failure{{ec::bad_input, std::move(message), remedy, place()}};
  }

  /// Blanks at the end are no numbers.
  [[nodiscard]] std::size_t left_over() const {
    return is_text() ? trimmed_end() - std::min(at_, trimmed_end()) : left();
  }

private:
  [[nodiscard]] std::size_t trimmed_end() const {
    return file_.find_last_not_of(" \t\r\n\v\f") + 1;
  }

  /// In a text the line, for people who look there.
  [[nodiscard]] std::string place() const {
    if (!is_text())
      return "byte " + std::to_string(at_);
    return "line " + std::to_string(1 + std::ranges::count(file_.substr(0, at_), '\n'));
  }

  double next_word() {
    constexpr std::string_view blanks = " \t\r\n\v\f";
    const auto from = std::min(file_.find_first_not_of(blanks, at_), file_.size());
    const auto to = std::min(file_.find_first_of(blanks, from), file_.size());
    at_ = from;
    if (from == to)
      fail_here("the numbers of the PLY file end before its counts", ply_cut_off);
    const auto value = real_of(file_.substr(from, to - from));
    if (!value)
      fail_here("\"" + shown(file_.substr(from, to - from)) + "\" is not a finite number",
                ply_save_again);
    at_ = to;
    return *value;
  }

  template <class T>
  double as(const char* bytes) const {
    T value;
    std::memcpy(&value, bytes, sizeof(value));
    return static_cast<double>(value);
  }

  double next_bytes(ply_type type) {
    const auto size = size_of(type);
    if (size > left())
      fail_here("the numbers of the PLY file end before its counts", ply_cut_off);
    char bytes[8];
    std::memcpy(bytes, file_.data() + at_, size);
    if ((encoding_ == ply_encoding::big) != (std::endian::native == std::endian::big))
      std::reverse(bytes, bytes + size);
    const double value = value_of(type, bytes);
    if (!std::isfinite(value))
      fail_here("a number of the PLY file is not finite", ply_save_again);
    at_ += size;
    return value;
  }

  double value_of(ply_type type, const char* bytes) const {
    switch (type) {
      case ply_type::int8:
        return as<std::int8_t>(bytes);
      case ply_type::uint8:
        return as<std::uint8_t>(bytes);
      case ply_type::int16:
        return as<std::int16_t>(bytes);
      case ply_type::uint16:
        return as<std::uint16_t>(bytes);
      case ply_type::int32:
        return as<std::int32_t>(bytes);
      case ply_type::uint32:
        return as<std::uint32_t>(bytes);
      case ply_type::float32:
        return as<float>(bytes);
      case ply_type::float64:
        break;
    }
    return as<double>(bytes);
  }

  std::string_view file_;
  std::size_t at_;
  ply_encoding encoding_;
};

class ply_reader {
public:
  explicit ply_reader(std::string_view file)
      : header_(read_ply_header(file)), numbers_(file, header_) {}

  file_surface read() {
    read_.unit = header_.unit;
    for (const auto& element : header_.elements)
      read_element(element);
    const auto rest = numbers_.left_over();
    if (rest > 0 && numbers_.is_text())
      numbers_.fail_here("the PLY file goes on behind the numbers that its header counts",
                         ply_save_again);
    if (rest > 0)
      read_.notices.push_back("behind the numbers of the PLY file are " + std::to_string(rest) +
                              " bytes more, which are left out");
    if (read_.groups.size() < 2 || read_.groups.size() > most_colours) {
      read_.groups.clear();
      read_.group_of.clear();
    }
    return std::move(read_);
  }

private:
  /// The least that an element takes, so that no count is believed beyond the file's end.
  void check_count(const ply_element& element) const {
    std::size_t least = 0;
    for (const auto& one : element.properties)
      least += numbers_.is_text() ? 2 : size_of(one.is_list ? one.count_type : one.type);
    if (least == 0 ? element.count > 0 : element.count > (numbers_.left() + 1) / least)
      numbers_.fail_here("the PLY file says that it has " + std::to_string(element.count) +
                           " of \"" + shown(element.name) + "\", more than its bytes can hold",
                         ply_cut_off);
  }

  /// Without one of them the surface would be flat.
  void check_coordinates(const ply_element& element) const {
    for (const char* name : {"x", "y", "z"})
      if (std::ranges::none_of(element.properties, [&](const ply_property& one) {
            return one.name == name && !one.is_list;
          }))
        throw file_failure{{ec::bad_input,
                            std::string("the vertices of the PLY file have no ") + name,
                            ply_save_again, "line " + std::to_string(header_.line)}};
  }

  void read_element(const ply_element& element) {
    check_count(element);
    const bool vertices = element.name == "vertex";
    if (vertices)
      check_coordinates(element);
    const bool faces = element.name == "face" || element.name == "faces";
    for (std::uint64_t i = 0; i < element.count; ++i) {
      place_ = {};
      colour_ = {};
      corners_.clear();
      for (const auto& property : element.properties)
        read_property(property, vertices, faces);
      if (vertices)
        read_.surface.points.push_back(place_);
      if (faces)
        add_face();
    }
  }

  void read_property(const ply_property& property, bool of_vertex, bool of_face) {
    if (property.is_list) {
      const double count = numbers_.next(property.count_type);
      if (!(count >= 0) || count > most_corners || count != std::floor(count))
        numbers_.fail_here("a list of the PLY file says " + format_number("%.10g", count) +
                             " numbers, not a whole number from 0 to 1000",
                           ply_save_again);
      const bool wanted = of_face && property.name.starts_with("vertex_ind");
      for (int k = 0; k < static_cast<int>(count); ++k) {
        const double value = numbers_.next(property.type);
        if (wanted)
          corners_.push_back(corner(value));
      }
      return;
    }
    const double value = numbers_.next(property.type);
    const auto& name = property.name;
    if (of_vertex) {
      (name == "x" ? place_.x : name == "y" ? place_.y : name == "z" ? place_.z : unused_) = value;
    } else if (of_face && (name == "red" || name == "green" || name == "blue")) {
      const double byte = property.type == ply_type::float32 ? 1 : 255;
      if (!colour_)
        colour_ = cad::colour{};
      (*colour_)[name == "red" ? 0 : name == "green" ? 1 : 2] = std::clamp(value / byte, 0.0, 1.0);
    }
  }

  std::uint32_t corner(double value) const {
    const auto count = read_.surface.points.size();
    if (!(value >= 0) || value >= static_cast<double>(count) || value != std::floor(value))
      numbers_.fail_here("a face of the PLY file names vertex " + format_number("%.10g", value) +
                           " of " + std::to_string(count) + "; they count from 0",
                         ply_save_again);
    return static_cast<std::uint32_t>(value);
  }

  void add_face() {
    if (corners_.size() < 3)
      numbers_.fail_here(
        "a face of the PLY file has " + std::to_string(corners_.size()) + " corners, not 3",
        ply_save_again);
    std::uint32_t group = 0;
    if (colour_) {
      const auto next = static_cast<std::uint32_t>(read_.groups.size());
      const auto [found, is_new] = places_.emplace(*colour_, next);
      if (is_new)
        read_.groups.push_back({name_of(*colour_), colour_, 0});
      group = found->second;
    }
    add_polygon(read_, corners_, group);
  }

  static std::string name_of(const cad::colour& looks) {
    char text[16];
    const auto byte = [&](std::size_t i) {
      return static_cast<unsigned>(std::lround(255 * looks[i]));
    };
    std::snprintf(text, sizeof(text), "#%02x%02x%02x", byte(0), byte(1), byte(2));
    return text;
  }

  ply_header header_;
  ply_numbers numbers_;
  file_surface read_;
  vec3 place_;
  double unused_ = 0;
  std::optional<cad::colour> colour_;
  std::vector<std::uint32_t> corners_;
  std::map<cad::colour, std::uint32_t> places_;
};

}  // namespace

expected<file_surface> read_ply(std::span<const char> bytes) {
  auto read = guarded([&] { return ply_reader({bytes.data(), bytes.size()}).read(); });
  return read ? checked(std::move(*read), "PLY") : read;
}

}  // namespace tedit::scan
