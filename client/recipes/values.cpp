// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/recipes/values.hpp"

#include <array>
#include <fstream>
#include <utility>

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

json parse_json(std::string_view text) {
  try {
    return json::parse(text, [](int depth, json::parse_event_t, json&) {
      if (depth > most_depth)
        refuse("brackets are nested more than " + std::to_string(most_depth) + " deep");
      return true;
    });
  } catch (const json::exception& e) {
    refuse(std::string("this is no JSON: ") + e.what());
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
