// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/marked_cards.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <ostream>
#include <span>

#include "base/hash.hpp"

namespace tedit {

namespace {

constexpr std::string_view head_words = "TEdit load case of the cards behind these lines: ";
constexpr std::string_view piece_word = "TEdit| ";
constexpr std::size_t piece_size = 60;  ///< Nastran's lines have 80 characters.

/// Line ends inside of texts are escaped in JSON: those that are there mean nothing, nor do the
/// blanks that begin lines.
std::string on_one_line(std::string_view json) {
  std::string result;
  bool begins = true;
  for (const char c : json) {
    begins = begins ? c == ' ' || c == '\n' || c == '\r' : c == '\n' || c == '\r';
    if (!begins)
      result += c;
  }
  return result;
}

hash128 hash_of(std::string_view cards) {
  return hash_bytes(std::as_bytes(std::span(cards)));
}

}  // namespace

void write_marked_cards(std::ostream& out, std::string_view comment, const std::string& cards,
                        std::string_view load_case) {
  const auto flat = on_one_line(load_case);
  out << comment << head_words << cards.size() << " bytes, hash " << to_hex(hash_of(cards)) << '\n';
  for (std::size_t i = 0; i < flat.size(); i += piece_size)
    out << comment << piece_word << std::string_view(flat).substr(i, piece_size) << "|\n";
  out << cards;
}

namespace {

/// How many bytes of cards there are, and their hash in digits.
struct cards_mark {
  std::uint64_t size = 0;
  std::string_view hash;
};

std::optional<cards_mark> mark_of(std::string_view line) {
  cards_mark mark;
  const auto [end, code] = std::from_chars(line.data(), line.data() + line.size(), mark.size);
  constexpr std::string_view between = " bytes, hash ";
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  if (code != std::errc{} || !line.starts_with(between))
    return std::nullopt;
  mark.hash = line.substr(between.size(), 32);
  return mark;
}

/// The first line of `text`, taken off it with its end.
std::string_view take_line(std::string_view& text) {
  const auto line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.size(), line.size() + 1));
  return line;
}

}  // namespace

marked_case find_marked_case(std::string_view text, std::string_view comment) {
  const auto head = std::string(comment) + std::string(head_words);
  const auto piece = std::string(comment) + std::string(piece_word);
  const auto from = text.find(head);
  if (from == text.npos)
    return {};
  auto rest = text.substr(from + head.size());
  const auto mark = mark_of(take_line(rest));
  marked_case result;
  while (rest.starts_with(piece)) {
    const auto line = take_line(rest);
    const auto last = line.rfind('|');
    if (last >= piece.size())
      result.load_case += line.substr(piece.size(), last - piece.size());
  }
  if (!mark || mark->size > rest.size() ||
      hash_from_hex(mark->hash) != hash_of(rest.substr(0, mark->size)))
    return {{}, true};
  return result;
}

}  // namespace tedit
