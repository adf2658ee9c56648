// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/group_names.hpp"

#include "base/text.hpp"
#include "mesh/io/line_cursor.hpp"

namespace tedit {

namespace {

std::string head_of_group(std::string_view word, std::int64_t id) {
  return std::string(word) + " " + std::to_string(id);
}

/// As much of a name as has room. What comes before and behind the cut is no blank, for readers
/// take these off.
std::string_view piece_of_name(std::string_view name, std::size_t room) {
  if (name.size() <= room)
    return name;
  const auto whole = cut_text(name, room);
  auto piece = whole;
  while (piece.size() > 1 && (piece.back() == ' ' || name[piece.size()] == ' '))
    piece = cut_text(name, piece.size() - 1);
  return piece.size() > 1 ? piece : whole;
}

/// The number in "12 (2)" behind the blank; nothing where there is none.
std::optional<std::int64_t> part_of(std::string_view text) {
  if (!text.starts_with(" (") || !text.ends_with(')'))
    return std::nullopt;
  return integer_of(text.substr(2, text.size() - 3));
}

}  // namespace

std::string name_of_group(std::string_view word, std::int64_t id, std::string_view name) {
  const auto head = head_of_group(word, id);
  return name.empty() ? head : head + ": " + std::string(name);
}

std::vector<std::string> names_of_group(std::string_view word, std::int64_t id,
                                        std::string_view name, std::size_t most) {
  auto head = head_of_group(word, id);
  auto piece = piece_of_name(name, most - head.size() - 2);
  std::vector<std::string> result{name_of_group(word, id, piece)};
  for (name.remove_prefix(piece.size()); !name.empty(); name.remove_prefix(piece.size())) {
    head = head_of_group(word, id) + " (" + std::to_string(result.size() + 1) + ")";
    piece = piece_of_name(name, most - head.size() - 2);
    result.push_back(head + ": " + std::string(piece));
  }
  return result;
}

std::optional<group_name> own_group(std::string_view group, std::string_view word) {
  if (!group.starts_with(word) || !group.substr(word.size()).starts_with(' '))
    return std::nullopt;
  group.remove_prefix(word.size() + 1);
  const auto colon = group.find(':');
  const auto head = trimmed(group.substr(0, colon));
  const auto blank = head.find(' ');
  const auto id = integer_of(head.substr(0, blank));
  const auto part =
    blank == head.npos ? std::optional<std::int64_t>(1) : part_of(head.substr(blank));
  if (!id || !part || *part < 1)
    return std::nullopt;
  return group_name{*id, colon == group.npos ? "" : std::string(trimmed(group.substr(colon + 1))),
                    static_cast<std::size_t>(*part)};
}

}  // namespace tedit
