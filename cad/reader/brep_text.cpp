// SPDX-License-Identifier: AGPL-3.0-or-later
// BREP, as BRepTools writes it: sections with a count each, then the shapes.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <vector>

#include "cad/reader/text_faults.hpp"

namespace tedit::cad {

namespace {

constexpr const char* write_again =
  "Write it again with BRepTools::Write of OpenCASCADE, or take a STEP file";
constexpr std::string_view head = "CASCADE Topology V";
constexpr std::array<std::string_view, 8> brep_sections{
  "Locations", "Curve2ds",       "Curves", "Polygon3D", "PolygonOnTriangulations",
  "Surfaces",  "Triangulations", "TShapes"};
constexpr std::string_view shapes = "TShapes";

bool is_finite_number(std::string_view word) {
  double value = 0;
  if (word.starts_with('+'))
    word.remove_prefix(1);
  const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
  return read.ec == std::errc() && read.ptr == word.data() + word.size() && std::isfinite(value);
}

bool is_brep_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Walks over words between blanks.
class brep_walk {
public:
  explicit brep_walk(std::string_view text) : text_(text) {}

  std::optional<text_fault> first_fault() {
    at_ = text_.find(head);
    if (at_ == text_.npos)
      return text_fault{0, "", "no line says CASCADE Topology, which the shape begins with",
                        write_again};
    at_ += head.size();
    begin_ = at_;
    if (const auto version = next(); version.substr(0, 1) < "1" || version.substr(0, 1) > "3")
      return fault("its format is version " +
                   std::string(version.substr(0, version.find(',')).substr(0, 8)) +
                   ", and 1 to 3 are known");
    at_ = std::min(text_.find('\n', at_), text_.size());
    for (const auto name : brep_sections) {
      section_ = name;
      if (auto found = section())
        return found;
    }
    return of_shapes();
  }

private:
  std::string_view next() {
    while (at_ < text_.size() && is_brep_blank(text_[at_]))
      ++at_;
    begin_ = at_;
    while (at_ < text_.size() && !is_brep_blank(text_[at_]))
      ++at_;
    return text_.substr(begin_, at_ - begin_);
  }

  text_fault fault(std::string cause) const {
    const auto last = text_.find_last_not_of(" \t\r\n");
    return {begin_ < text_.size() ? begin_
            : last == text_.npos  ? 0
                                  : last,
            section_.empty() ? "" : "section " + std::string(section_), std::move(cause),
            write_again};
  }

  std::optional<text_fault> cut_off() {
    begin_ = text_.size();
    return fault("it is cut off: it ends within its section " + std::string(section_));
  }

  static std::string shown(std::string_view word) {
    std::string result(word.substr(0, 20));
    std::ranges::replace_if(
      result, [](char c) { return c <= ' ' || c > '~'; }, '?');
    return result;
  }

  /// Its name and count; then numbers, up to the next section. Shapes are left to `of_shapes`.
  std::optional<text_fault> section() {
    const auto name = next();
    if (name.empty())
      return cut_off();
    if (name != section_)
      return fault("the section " + std::string(section_) + " must begin here, and not " +
                   shown(name));
    const auto count = next();
    const auto* end = count.data() + count.size();
    if (const auto read = std::from_chars(count.data(), end, count_);
        count.empty() || read.ec != std::errc() || read.ptr != end)
      return count.empty() ? cut_off()
                           : fault("the count of section " + std::string(section_) +
                                   " is no number: " + shown(count));
    return section_ == shapes ? std::nullopt : numbers();
  }

  std::optional<text_fault> numbers() {
    std::size_t words = 0;
    while (true) {
      const auto before = at_;
      const auto word = next();
      if (word.empty())
        return cut_off();
      if (std::ranges::find(brep_sections, word) != brep_sections.end()) {
        const auto found =
          words < count_
            ? std::optional(fault("section " + std::string(section_) + " says that it has " +
                                  std::to_string(count_) + ", and only " + std::to_string(words) +
                                  " numbers follow"))
            : std::nullopt;
        at_ = before;
        return found;
      }
      if (!is_finite_number(word))
        return fault("a finite number must be here, and not " + shown(word));
      ++words;
    }
  }

  /// Each shape begins with two letters and ends with its parts: "+5 0 -3 0 *".
  std::optional<text_fault> of_shapes() {
    while (kinds_.size() < count_) {
      const auto kind = next();
      if (kind.empty())
        return cut_off();
      constexpr std::array<std::string_view, 8> known{"Ve", "Ed", "Wi", "Fa",
                                                      "Sh", "So", "CS", "Co"};
      const auto found = std::ranges::find(known, kind);
      if (found == known.end())
        return fault("shape " + std::to_string(kinds_.size() + 1) + " of " +
                     std::to_string(count_) +
                     " must begin here (Ve, Ed, Wi, Fa, Sh, So, CS or Co), and not " + shown(kind));
      kinds_.push_back(static_cast<std::uint8_t>(found - known.begin()));
      if (auto wrong = of_shape(*found))
        return wrong;
    }
    return of_part_as_a_whole();
  }

  std::optional<text_fault> of_shape(std::string_view kind) {
    bool in_parts = false;
    std::size_t parts = 0;
    // A vertex begins with its tolerance and its place.
    std::size_t numbers = kind == "Ve" ? 4 : 0;
    for (auto word = next(); word != "*"; word = next()) {
      if (word.empty())
        return cut_off();
      if (numbers > 0 && !is_finite_number(word))
        return fault("a finite number must be here, and not " + shown(word));
      numbers -= numbers > 0;
      if (in_parts && (word[0] == '+' || word[0] == '-')) {
        if (auto found = of_part(word))
          return found;
        ++parts;
      }
      in_parts |= word.size() == 7 && word.find_first_not_of("01") == word.npos;  // Its flags.
    }
    if (parts == 0 && kind != "Ve" && kind != "Ed" && kind != "Fa")
      return fault("shape " + std::to_string(count_ + 1 - kinds_.size()) + " (" +
                   std::string(kind) + ") is made of nothing");
    return std::nullopt;
  }

  /// The last line: which shape is the part. A vertex, an edge or a wire is none.
  std::optional<text_fault> of_part_as_a_whole() {
    const auto word = next();
    if (word.empty())
      return fault("it is cut off: behind its shapes there must be which of them is the part");
    std::uint64_t index = 0;
    std::from_chars(word.data() + 1, word.data() + word.size(), index);
    if (index < 1 || index > count_)
      return fault("the part is shape " + shown(word.substr(1)) + ", and there are " +
                   std::to_string(count_));
    constexpr std::array<const char*, 3> no_part{"a vertex", "an edge", "a wire"};
    if (const auto kind = kinds_[count_ - index]; kind < no_part.size())
      return fault("the part is shape " + std::to_string(index) + ", which is " + no_part[kind]);
    return std::nullopt;
  }

  /// Shapes are numbered from behind; parts come before what they are parts of.
  std::optional<text_fault> of_part(std::string_view word) const {
    std::uint64_t index = 0;
    const auto read = std::from_chars(word.data() + 1, word.data() + word.size(), index);
    const bool is_number = read.ec == std::errc() && read.ptr == word.data() + word.size();
    const auto own = count_ + 1 - kinds_.size();
    if (is_number && index > own && index <= count_)
      return std::nullopt;
    return fault("shape " + std::to_string(own) + " refers to shape " + shown(word.substr(1)) +
                 ", and only " + std::to_string(own + 1) + " to " + std::to_string(count_) +
                 " stand before it");
  }

  std::string_view text_;
  std::string_view section_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;
  std::uint64_t count_ = 0;
  std::vector<std::uint8_t> kinds_;  ///< Of the shapes that were met.
};

}  // namespace

std::optional<text_fault> fault_of_brep(std::string_view text) {
  return brep_walk(text).first_fault();
}

bool names_its_part(const std::string& brep_file) {
  constexpr std::streamoff enough = 4096;
  std::ifstream in(brep_file, std::ios::binary | std::ios::ate);
  in.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(in.tellg()) - enough));
  const std::string end{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  // The last shape ends with a star.
  const auto star = end.rfind('*');
  return star == std::string::npos || !std::ranges::all_of(end.substr(star + 1), is_brep_blank);
}

}  // namespace tedit::cad
