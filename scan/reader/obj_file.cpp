// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <map>

#include "scan/reader/file_surface.hpp"

namespace tedit::scan {

namespace {

constexpr const char* obj_remedy = "Correct the line, or save the file again";

/// Names that hold faces together: of groups, materials or objects.
class name_table {
public:
  void set(std::string name) { current_ = std::move(name); }

  void note_face(std::size_t triangles) {
    const auto place = static_cast<std::uint32_t>(places_.size());
    const auto [found, is_new] = places_.emplace(current_, place);
    if (is_new)
      names.push_back(current_);
    of_triangle.insert(of_triangle.end(), triangles, found->second);
  }

  std::vector<std::string> names;  ///< In the order in which faces have them.
  std::vector<std::uint32_t> of_triangle;

private:
  std::map<std::string, std::uint32_t> places_;
  std::string current_;
};

class obj_reader {
public:
  explicit obj_reader(std::string_view text) : lines_(text) {}

  file_surface read() {
    while (lines_.next()) {
      const auto words = words_of(lines_.line());
      if (words.empty())
        continue;
      if (words.back() == "\\")
        lines_.fail_here(ec::unsupported_format, "a line of the OBJ file goes on in the next one",
                         "Write each face on one line");
      if (words[0] == "v")
        vertex(words);
      else if (words[0] == "f")
        face(words);
      else if (words[0] == "g")
        groups_.set(rest_of_line(words));
      else if (words[0] == "o")
        objects_.set(rest_of_line(words));
      else if (words[0] == "usemtl")
        materials_.set(rest_of_line(words));
      else if (words[0].starts_with('#') && read_.unit.empty())
        read_.unit = unit_in(lines_.line());
    }
    take_groups();
    return std::move(read_);
  }

private:
  std::string rest_of_line(const std::vector<std::string_view>& words) const {
    const auto line = trimmed(lines_.line());
    return std::string(trimmed(line.substr(words[0].size())));
  }

  void vertex(const std::vector<std::string_view>& words) {
    if (words.size() < 4)
      lines_.fail_here(ec::bad_input,
                       "a vertex has " + std::to_string(words.size() - 1) + " coordinates, not 3",
                       obj_remedy);
    read_.surface.points.push_back(
      {lines_.real(words[1], "x"), lines_.real(words[2], "y"), lines_.real(words[3], "z")});
  }

  /// Indices count from 1, or back from the last vertex.
  std::uint32_t corner(std::string_view word) const {
    const auto number = lines_.integer(word.substr(0, word.find('/')), "vertex number");
    const auto count = static_cast<std::int64_t>(read_.surface.points.size());
    const auto place = number < 0 ? count + number : number - 1;
    if (place < 0 || place >= count)
      lines_.fail_here(ec::bad_input,
                       "a face names vertex " + std::to_string(number) + " of " +
                         std::to_string(count) + " so far; they count from 1, or back from -1",
                       obj_remedy);
    return static_cast<std::uint32_t>(place);
  }

  void face(const std::vector<std::string_view>& words) {
    if (words.size() < 4)
      lines_.fail_here(ec::bad_input,
                       "a face has " + std::to_string(words.size() - 1) + " corners, not 3",
                       obj_remedy);
    corners_.clear();
    for (std::size_t i = 1; i < words.size(); ++i)
      corners_.push_back(corner(words[i]));
    add_polygon(read_, corners_, 0);
    for (auto* table : {&groups_, &materials_, &objects_})
      table->note_face(corners_.size() - 2);
  }

  /// What tells faces apart at all counts: groups, or else materials. Objects are bodies.
  void take_groups() {
    auto& table = groups_.names.size() > 1 || materials_.names.size() < 2 ? groups_ : materials_;
    if (objects_.names.size() > 1) {
      read_.bodies = objects_.names;
      read_.body_of = objects_.of_triangle;
    } else {
      read_.bodies = {objects_.names.empty() ? std::string() : objects_.names.front()};
    }
    if (table.names.size() < 2) {
      read_.group_of.clear();
      return;
    }
    read_.group_of = table.of_triangle;
    for (const auto& name : table.names)
      read_.groups.push_back({name, {}, 0});
    if (!read_.unit.empty())
      take_ids();
  }

  /// Groups of TEdit's own: NAME_12, surface_12.
  void take_ids() {
    for (auto& group : read_.groups) {
      const auto bar = group.name.rfind('_');
      const auto id = number_at_end(group.name);
      if (!id || *id < 1 || bar == std::string::npos)
        continue;
      group.id = *id;
      group.name = group.name.substr(0, bar);
      if (group.name == "surface")
        group.name.clear();
    }
  }

  line_cursor lines_;
  file_surface read_;
  name_table groups_;
  name_table materials_;
  name_table objects_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

expected<file_surface> read_obj(std::span<const char> bytes) {
  auto read = guarded([&] { return obj_reader({bytes.data(), bytes.size()}).read(); });
  return read ? checked(std::move(*read), "OBJ") : read;
}

}  // namespace tedit::scan
