// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/recipes/values.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include "base/text.hpp"

namespace tedit::client {

static constexpr std::size_t most_letters = 4096;
static constexpr int most_depth = 64;  ///< Of brackets: what walks through JSON calls itself.

void refuse(std::string message, std::string remedy) {
  throw error{ec::bad_input, std::move(message), std::move(remedy), {}};
}

double number_from(const json& value, const number_range& range, const std::string& what) {
  if (!value.is_number())
    refuse(what + " must be a number");
  const auto given = value.get<double>();
  if (const auto ok = check_number(given, range, what); !ok)
    refuse(ok.error().message + ". " + ok.error().remedy);
  return given;
}

std::int64_t whole_from(const json& value, const std::string& what) {
  const bool too_large = value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX;
  if (!value.is_number_integer() || too_large)
    refuse(what + " must be a whole number");
  return value.get<std::int64_t>();
}

std::string text_from(const json& value, const std::string& what) {
  if (!value.is_string() || value.get_ref<const std::string&>().size() > most_letters)
    refuse(what + " must be a text of at most " + std::to_string(most_letters) + " letters");
  return value.get<std::string>();
}

bool flag_from(const json& value, const std::string& what) {
  if (!value.is_boolean())
    refuse(what + " must be true or false");
  return value.get<bool>();
}

namespace {

/// "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error while parsing
/// value - unexpected end of input" without the words of the library, and with its place.
error fault_of(std::string_view text, std::string words) {
  error why{ec::bad_input, {}, "Correct the text there; docs/recipes.md has examples", {}};
  const auto take_behind = [&](std::string_view part) {
    const auto at = words.find(part);
    if (at != std::string::npos)
      words.erase(0, at + part.size());
    return at != std::string::npos;
  };
  take_behind("] ");
  if (take_behind("parse error at ")) {
    const auto end = std::min(words.find(": "), words.size());
    why.where = words.substr(0, end);
    words.erase(0, std::min(end + 2, words.size()));
    take_behind(" - ");
  } else if (const auto quote = words.find('\''); quote != std::string::npos) {
    // A number that is too large stands in quotes.
    const auto at = text.find(words.substr(quote + 1, words.rfind('\'') - quote - 1));
    if (at != std::string_view::npos)
      why.where = "line " + std::to_string(1 + std::ranges::count(text.substr(0, at), '\n'));
  }
  why.message = "this is no JSON: " + to_utf8(words);
  return why;
}

}  // namespace

json parse_json(std::string_view text) {
  if (text.empty())
    refuse("the file is empty", "Write it again");
  if (!is_utf8(text))
    refuse("this is no JSON: it is no text in UTF-8", "Save it as UTF-8, or choose another file");
  try {
    return json::parse(text, [](int depth, json::parse_event_t, json&) {
      if (depth > most_depth)
        refuse("brackets are nested more than " + std::to_string(most_depth) + " deep");
      return true;
    });
  } catch (const json::exception& e) {
    throw fault_of(text, e.what());
  }
}

expected<std::string> text_of_file(const std::filesystem::path& file, std::size_t most_bytes) {
  std::ifstream in(file, std::ios::binary);
  std::string text;
  std::array<char, 1 << 16> piece;
  while (in && text.size() <= most_bytes) {
    in.read(piece.data(), piece.size());
    text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad() || !in.eof() || text.size() > most_bytes)
    return fail(ec::io_error, "cannot read " + file.string());
  return text;
}

const json& list_from(const json& value, std::size_t least, std::size_t most,
                      const std::string& what) {
  if (!value.is_array() || value.size() < least || value.size() > most)
    refuse(what + " must be a list of " + (least == most ? "" : "at most ") + std::to_string(most));
  return value;
}

}  // namespace tedit::client
