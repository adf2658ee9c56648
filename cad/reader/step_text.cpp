// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/reader/step_text.hpp"

#include <charconv>

namespace tedit::cad {

namespace {

constexpr std::size_t most_entities = 4'000'000;
constexpr const char* again = "Export the part again from the CAD program";
constexpr const char* copy_again =
  "Copy or download the file again, or export the part again from the CAD program";

bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_of_word(char c) {
  return is_digit(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '!' ||
         c == '-';
}

/// Letters of no text: what another file or an empty block of a disk has left.
bool is_no_text(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 127 || (byte < ' ' && !is_blank(c));
}

std::string hex_of(char c) {
  constexpr char digits[] = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return {'0', 'x', digits[byte >> 4], digits[byte & 15]};
}

/// What a person sees of a place.
std::string shown(std::string_view text) {
  constexpr std::size_t enough = 30;
  std::string result;
  for (const char c : text.substr(0, enough)) {
    if (c == '\n' || c == '\r')
      break;
    result += is_no_text(c) ? '?' : c;
  }
  return result;
}

/// Walks the text statement by statement: `WORD(...);`, `#1 = WORD(...);`, `WORD;`.
class step_walk {
public:
  step_walk(std::string_view text, step_text& into) : text_(text), into_(into) {}

  std::optional<text_fault> walk() {
    std::optional<text_fault> fault;
    while (!fault && !is_ended_) {
      fault = skip_blanks();
      if (!fault)
        fault = at_ < text_.size() ? statement() : cut_off();
    }
    return fault;
  }

private:
  text_fault fault(std::size_t at, std::string cause, const char* remedy) const {
    return {at, entity_, std::move(cause), remedy};
  }

  text_fault cut_off() const {
    const auto last = text_.find_last_not_of(" \t\r\n");
    const char* missing = in_data_ || had_data_ ? "it ends without END-ISO-10303-21"
                          : in_header_          ? "it ends within its header"
                                                : "it ends before its entities (DATA)";
    return fault(last == text_.npos ? 0 : last, std::string("it is cut off: ") + missing,
                 copy_again);
  }

  std::optional<text_fault> skip_blanks() {
    while (at_ < text_.size()) {
      if (is_blank(text_[at_])) {
        ++at_;
      } else if (text_.substr(at_, 2) == "/*") {
        const auto end = text_.find("*/", at_ + 2);
        if (end == text_.npos)
          return fault(at_, "a comment is not closed by */", again);
        at_ = end + 2;
      } else {
        break;
      }
    }
    return std::nullopt;
  }

  /// To the first letter behind a string. One that runs over the begin of another entity lacks its
  /// end.
  std::optional<text_fault> skip_string() {
    const auto begin = at_;
    const auto end = text_.find('\'', at_ + 1);
    const auto inside = text_.substr(begin, end == text_.npos ? end : end - begin);
    if (const auto zero = inside.find('\0'); zero != inside.npos)
      return fault(begin + zero, "there is a byte that is no text, 0x00", copy_again);
    for (auto at = inside.find(';'); at != inside.npos; at = inside.find(';', at + 1)) {
      auto next = at + 1;
      while (next < inside.size() && is_blank(inside[next]))
        ++next;
      if (next > at + 1 && next + 1 < inside.size() && inside[next] == '#' &&
          is_digit(inside[next + 1]))
        return fault(begin, "a text is not closed by ': " + shown(inside), again);
    }
    if (end == text_.npos)
      return cut_off();
    at_ = end + 1;
    return std::nullopt;
  }

  /// From "(" to the ")" that closes it. Texts, comments and further parentheses are passed over.
  std::optional<text_fault> skip_parentheses() {
    std::size_t depth = 0;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\'' || text_.substr(at_, 2) == "/*") {
        if (auto found = c == '\'' ? skip_string() : skip_blanks())
          return found;
        continue;
      }
      if (c == ';')
        return fault(at_, "a parenthesis is not closed by )", again);
      if (is_no_text(c))
        return fault(at_, "there is a byte that is no text, " + hex_of(c), copy_again);
      depth += c == '(';
      ++at_;
      if (c == ')' && --depth == 0)
        return std::nullopt;
    }
    return cut_off();
  }

  std::string_view word() {
    const auto begin = at_;
    while (at_ < text_.size() && is_of_word(text_[at_]))
      ++at_;
    return text_.substr(begin, at_ - begin);
  }

  std::optional<text_fault> statement() {
    entity_.clear();
    begin_ = at_;
    if (text_[at_] == '#')
      return entity();
    const auto name = word();
    if (name.empty())
      return stray();
    if (auto found = skip_blanks())
      return found;
    const auto inside = at_;
    if (at_ < text_.size() && text_[at_] == '(')
      if (auto found = skip_parentheses())
        return found;
    take_section(name, text_.substr(inside, at_ - inside));
    return is_ended_ ? std::nullopt : end_of_statement();
  }

  text_fault stray() const {
    const char c = text_[at_];
    if (is_no_text(c))
      return fault(at_, "there is a byte that is no text, " + hex_of(c), copy_again);
    if (c == ')')
      return fault(at_, "there is a ) that no ( belongs to", again);
    return fault(at_, "nothing in STEP begins like this: " + shown(text_.substr(at_)), again);
  }

  void take_section(std::string_view name, std::string_view inside) {
    if (name == "FILE_SCHEMA")
      into_.schema = inside;
    in_header_ = name == "HEADER" || (in_header_ && name != "ENDSEC");
    if (name == "DATA") {
      in_data_ = had_data_ = true;
      into_.data_at = begin_;
    } else if (name == "ENDSEC") {
      in_data_ = false;
    }
    is_ended_ = name == "END-ISO-10303-21";
  }

  std::optional<text_fault> end_of_statement() {
    if (auto found = skip_blanks())
      return found;
    if (at_ >= text_.size())
      return cut_off();
    if (text_[at_] == ')')
      return fault(at_, "there is a ) that no ( belongs to", again);
    if (is_no_text(text_[at_]))
      return stray();
    if (text_[at_] != ';')
      return fault(at_, "a ; is missing before " + shown(text_.substr(at_)), again);
    ++at_;
    return std::nullopt;
  }

  std::optional<text_fault> entity() {
    step_entity one;
    one.at = at_++;
    const auto number = word();
    const auto* end = number.data() + number.size();
    const auto read = std::from_chars(number.data(), end, one.id);
    entity_ = "#" + std::string(number.substr(0, 20));
    if (!had_data_)
      return fault(one.at, "entities begin without DATA before them", again);
    if (number.empty() || read.ec != std::errc() || read.ptr != end || one.id == 0)
      return fault(one.at, "this is no number of an entity", again);
    if (auto found = skip_blanks())
      return found;
    if (at_ >= text_.size())
      return cut_off();
    if (text_[at_] != '=')
      return fault(at_, "there is no = behind the number", again);
    ++at_;
    return content_of(one);
  }

  std::optional<text_fault> content_of(step_entity one) {
    if (auto found = skip_blanks())
      return found;
    one.type = word();
    if (!one.type.empty())
      entity_ = title_of(one);
    if (auto found = skip_blanks())
      return found;
    if (at_ >= text_.size())
      return cut_off();
    if (text_[at_] != '(')
      return one.type.empty() ? stray() : fault(at_, "there is no ( behind the type", again);
    const auto begin = at_;
    if (auto found = skip_parentheses())
      return found;
    one.inside = text_.substr(begin + 1, at_ - begin - 2);
    if (one.type.empty())
      take_first_type(one);
    keep(one);
    return end_of_statement();
  }

  static void take_first_type(step_entity& one) {
    std::size_t from = 0;
    while (from < one.inside.size() && !is_of_word(one.inside[from]))
      ++from;
    auto to = from;
    while (to < one.inside.size() && is_of_word(one.inside[to]))
      ++to;
    one.type = one.inside.substr(from, to - from);
  }

  void keep(const step_entity& one) {
    if (into_.entities.size() < most_entities)
      into_.entities.push_back(one);
    else
      into_.is_whole = false;
  }

  std::string_view text_;
  step_text& into_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;
  std::string entity_;
  bool in_header_ = false;
  bool in_data_ = false;
  bool had_data_ = false;
  bool is_ended_ = false;
};

}  // namespace

std::string title_of(const step_entity& entity) {
  constexpr std::size_t longest_type = 60;
  return "#" + std::to_string(entity.id) + " = " + std::string(entity.type.substr(0, longest_type));
}

std::optional<text_fault> take_apart(std::string_view text, step_text& into) {
  return step_walk(text, into).walk();
}

std::optional<text_fault> fault_of_step(std::string_view text) {
  step_text step;
  if (auto fault = take_apart(text, step))
    return fault;
  return fault_of_entities(step);
}

}  // namespace tedit::cad
