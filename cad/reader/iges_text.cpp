// SPDX-License-Identifier: AGPL-3.0-or-later
// IGES: lines of 80 letters; the 73rd names the section (S, G, D, P, T), a number within it
// follows.
#include <algorithm>
#include <charconv>
#include <vector>

#include "cad/reader/text_faults.hpp"

namespace tedit::cad {

namespace {

constexpr const char* send_again =
  "Copy or download the file again, or export the part again, as STEP where you can";
constexpr const char* as_step = "Export the part again from the CAD program, as STEP where you can";
constexpr std::size_t line_letters = 80;
constexpr std::size_t no_entry = std::size_t(-1);
constexpr std::string_view iges_sections = "SGDPT";

/// A number that is all of a field but blanks.
std::optional<std::size_t> number_in(std::string_view field) {
  const auto first = field.find_first_not_of(' ');
  if (first == field.npos)
    return std::nullopt;
  field = field.substr(first, field.find_last_not_of(' ') + 1 - first);
  std::size_t value = 0;
  const auto read = std::from_chars(field.data(), field.data() + field.size(), value);
  if (read.ec != std::errc() || read.ptr != field.data() + field.size())
    return std::nullopt;
  return value;
}

struct iges_line {
  std::string_view text;
  std::size_t at = 0;
};

/// An entity by the number of its first line in the directory: "D3, type 144".
std::string title_of(std::size_t entry, std::size_t type) {
  return "D" + std::to_string(entry) + ", type " + std::to_string(type);
}

class iges_check {
public:
  explicit iges_check(std::string_view text) : text_(text) {}

  std::optional<text_fault> first_fault() {
    if (auto fault = take_lines())
      return fault;
    if (auto fault = of_counts())
      return fault;
    take_delimiters();
    bool has_surface = false;
    for (std::size_t i = 0; i + 1 < lines('D').size(); i += 2) {
      if (auto fault = of_entry(i))
        return fault;
      has_surface |= is_surface(number_in(lines('D')[i].text.substr(0, 8)).value_or(0));
    }
    if (!has_surface)
      return text_fault{lines('D').empty() ? 0 : lines('D').front().at, "",
                        "there is no surface and no solid among its entities (" +
                          std::to_string(lines('D').size() / 2) + ")",
                        "Export the part with its surfaces, as STEP where you can"};
    return std::nullopt;
  }

private:
  const std::vector<iges_line>& lines(char section) const {
    return lines_[iges_sections.find(section)];
  }

  /// Trimmed and bounded surfaces, faces and solids; curves and points close no volume.
  static bool is_surface(std::size_t type) {
    for (const std::size_t one :
         {108, 114, 118, 120, 122, 128, 140, 143, 144, 186, 190, 192, 194, 196, 198, 510, 514})
      if (type == one)
        return true;
    return type >= 150 && type <= 184;
  }

  std::optional<text_fault> take_lines() {
    std::size_t section = 0;
    for (std::size_t at = 0; at < text_.size();) {
      auto line = text_.substr(at, text_.find('\n', at) - at);
      const auto next = at + line.size() + 1;
      if (line.ends_with('\r'))
        line.remove_suffix(1);
      if (line.find_first_not_of(" \r\t\x1a") != line.npos)
        if (auto fault = take_line({line, at}, section))
          return fault;
      at = next;
    }
    return std::nullopt;
  }

  std::optional<text_fault> take_line(const iges_line& line, std::size_t& section) {
    const auto& text = line.text;
    if (const auto zero = text.find('\0'); zero != text.npos)
      return text_fault{line.at + zero, "", "there is a byte that is no text, 0x00", send_again};
    // Blanks and carriage returns behind the 80th do no harm.
    if (text.size() < line_letters ||
        text.find_first_not_of(" \r", line_letters) != std::string_view::npos)
      return text_fault{line.at, "",
                        "the line has " + std::to_string(text.size()) + " letters in place of 80",
                        send_again};
    const auto letter = iges_sections.find(text[72]);
    if (letter == iges_sections.npos || letter < section)
      return text_fault{line.at, "",
                        std::string("the 73rd letter of the line is ") + shown(text[72]) +
                          ", and none of the sections that may follow (" +
                          std::string(iges_sections.substr(section)) + ") begins so",
                        send_again};
    section = letter;
    lines_[section].push_back(line);
    const auto number = number_in(text.substr(73, 7));
    if (number != lines_[section].size())
      return text_fault{line.at, "",
                        "the line is numbered " + std::string(text.substr(72, 8)) +
                          " where number " + std::to_string(lines_[section].size()) +
                          " must be: lines are missing, or there twice",
                        send_again};
    return std::nullopt;
  }

  static std::string shown(char c) {
    return c == ' ' ? "a blank" : c > ' ' && c < 127 ? std::string(1, c) : "no letter";
  }

  /// The last line says how many lines each section has.
  std::optional<text_fault> of_counts() const {
    const auto end = std::max<std::size_t>(text_.find_last_not_of(" \r\n") + 1, 1) - 1;
    for (const char letter : std::string_view("GDP"))
      if (lines(letter).empty() && lines('T').empty())
        return text_fault{
          end, "", std::string("it is cut off: it ends before its section ") + letter, send_again};
    if (lines('T').empty())
      return text_fault{end, "", "it is cut off: it ends without its last line (section T)",
                        send_again};
    const auto& last = lines('T').front();
    for (std::size_t i = 0; i < 4; ++i) {
      const auto said = number_in(last.text.substr(8 * i + 1, 7));
      if (last.text[8 * i] != iges_sections[i] || said != lines_[i].size())
        return text_fault{last.at, "",
                          "the last line says \"" + std::string(last.text.substr(8 * i, 8)) +
                            "\" of section " + iges_sections[i] + ", which has " +
                            std::to_string(lines_[i].size()) + " lines",
                          send_again};
    }
    if (lines('D').size() % 2 != 0)
      return text_fault{lines('D').back().at, "",
                        "the directory has " + std::to_string(lines('D').size()) +
                          " lines, and each entity has two of it",
                        send_again};
    return std::nullopt;
  }

  /// "1H,,1H;,...": what separates parameters and ends records, where they are not "," and ";".
  void take_delimiters() {
    if (lines('G').empty())
      return;
    auto text = lines('G').front().text;
    if (text.starts_with("1H")) {
      separator_ = text[2];
      text.remove_prefix(3);
    }
    if (text.starts_with(separator_) && text.substr(1).starts_with("1H"))
      end_ = text[3];
  }

  std::optional<text_fault> of_entry(std::size_t i) const {
    const auto& first = lines('D')[i];
    const auto& second = lines('D')[i + 1];
    const auto type = number_in(first.text.substr(0, 8));
    const auto begin = number_in(first.text.substr(8, 8));
    const auto count = number_in(second.text.substr(24, 8));
    const auto name = "D" + std::to_string(i + 1);
    const auto fault = [&](std::size_t at, std::string cause) {
      return text_fault{at, title_of(i + 1, type.value_or(0)), std::move(cause), as_step};
    };
    if (!type || !begin || !count)
      return fault(first.at, name + " has no number in the directory where one must be");
    const auto& all = lines('P');
    if (*begin == 0 || *count == 0 || *begin > all.size() || *count > all.size() + 1 - *begin)
      return fault(first.at, name + " has its parameters at P" + std::to_string(*begin) + ", in " +
                               std::to_string(*count) + " lines, and section P has " +
                               std::to_string(all.size()));
    std::string record;
    for (std::size_t k = *begin - 1; k < *begin - 1 + *count; ++k) {
      if (number_in(all[k].text.substr(65, 7)) != i + 1)
        return fault(all[k].at, "line P" + std::to_string(k + 1) + " is not of " + name);
      record += all[k].text.substr(0, 64);
    }
    if (record.find(end_) == record.npos)
      return fault(all[*begin - 1].at, name + " has parameters that do not end with " + end_);
    if (auto cause = of_record(record, *type))
      return fault(all[*begin - 1].at, name + " " + *cause);
    return std::nullopt;
  }

  /// What the parameters refer to, of entities that tie others together.
  std::optional<std::string> of_record(std::string_view record, std::size_t type) const {
    std::vector<std::string_view> fields;
    record = record.substr(0, record.find(end_));
    for (std::size_t at = 0; at <= record.size();) {
      fields.push_back(record.substr(at, record.find(separator_, at) - at));
      at += fields.back().size() + 1;
    }
    if (number_in(fields[0]) != type)
      return "has the parameters of another type, " + std::string(fields[0].substr(0, 8));
    std::vector<std::size_t> pointers;
    if (type == 144)
      pointers = {1, 4};
    else if (type == 142)
      pointers = {2, 3, 4};
    else if (type == 102)
      for (std::size_t k = 2; k < fields.size(); ++k)
        pointers.push_back(k);
    for (const auto k : pointers) {
      const auto entry = k < fields.size() ? number_in(fields[k]).value_or(no_entry) : no_entry;
      const bool is_none = entry == 0 && type != 102;
      if (!is_none && (entry % 2 == 0 || entry >= lines('D').size()))
        return "refers to D" + (k < fields.size() ? std::string(fields[k].substr(0, 12)) : "") +
               ", where no entity begins";
    }
    return std::nullopt;
  }

  std::string_view text_;
  std::vector<iges_line> lines_[iges_sections.size()];
  char separator_ = ',';
  char end_ = ';';
};

}  // namespace

std::optional<text_fault> fault_of_iges(std::string_view text) {
  return iges_check(text).first_fault();
}

}  // namespace tedit::cad
