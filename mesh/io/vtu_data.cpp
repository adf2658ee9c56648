// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/vtu_data.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "mesh/io/line_cursor.hpp"

namespace tedit {

namespace {

int digit64(char c) {
  if (c >= 'A' && c <= 'Z')
    return c - 'A';
  if (c >= 'a' && c <= 'z')
    return c - 'a' + 26;
  if (c >= '0' && c <= '9')
    return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Until there are `most` bytes. Several pieces may follow each other, each with its padding:
/// header and data are coded apart. `text` holds nothing else, but appended data end with a tag.
std::string from_base64(std::string_view text, std::uint64_t most, const std::string& name) {
  std::string result;
  std::uint32_t bits = 0;
  int digits = 0;
  int padding = 0;
  for (const char c : text) {
    if (result.size() >= most)
      break;
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t')
      continue;
    const int value = c == '=' ? 0 : digit64(c);
    if (c == '<')
      break;
    if (value < 0)
      fail_array(name, "holds \"" + shown({&c, 1}) + "\", which is no letter of base64");
    padding += c == '=';
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    if (++digits < 4)
      continue;
    for (int i = 0; i < 3 - std::min(padding, 2); ++i)
      result += static_cast<char>(bits >> (16 - 8 * i) & 255);
    bits = 0;
    digits = padding = 0;
  }
  return result;
}

struct number_type {
  const char* name;
  std::size_t size;
  char kind;  ///< 'f', 'i' or 'u'.
};

constexpr number_type number_types[] = {
  {"Float64", 8, 'f'}, {"Float32", 4, 'f'}, {"Int64", 8, 'i'},  {"Int32", 4, 'i'},
  {"Int16", 2, 'i'},   {"Int8", 1, 'i'},    {"UInt64", 8, 'u'}, {"UInt32", 4, 'u'},
  {"UInt16", 2, 'u'},  {"UInt8", 1, 'u'}};

const number_type& type_of(const pugi::xml_node& array, const std::string& name) {
  const std::string word = array.attribute("type").as_string();
  const auto* found =
    std::ranges::find_if(number_types, [&](const number_type& t) { return word == t.name; });
  if (found == std::end(number_types))
    fail_array(name, "is of type \"" + shown(word) + "\", which is not known");
  return *found;
}

template <class Stored>
Stored stored_at(const char* bytes, bool swapped) {
  std::array<char, sizeof(Stored)> room;
  std::memcpy(room.data(), bytes, sizeof(Stored));
  if (swapped)
    std::ranges::reverse(room);
  return std::bit_cast<Stored>(room);
}

/// A stored number as `Number`; whole numbers beyond 63 bits become -1, which no index is.
template <class Number>
Number number_at(const char* at, const number_type& type, bool swapped) {
  const auto as = [&]<class Stored>(Stored*) {
    const auto value = stored_at<Stored>(at, swapped);
    if constexpr (std::is_same_v<Number, std::int64_t> && std::is_floating_point_v<Stored>)
      return std::abs(value) < Stored(9e15) ? static_cast<std::int64_t>(value) : std::int64_t{-1};
    else
      return static_cast<Number>(value);
  };
  switch (type.kind == 'f' ? type.size * 10 : type.kind == 'i' ? type.size * 100 : type.size) {
    case 80:
      return as(static_cast<double*>(nullptr));
    case 40:
      return as(static_cast<float*>(nullptr));
    case 800:
      return as(static_cast<std::int64_t*>(nullptr));
    case 400:
      return as(static_cast<std::int32_t*>(nullptr));
    case 200:
      return as(static_cast<std::int16_t*>(nullptr));
    case 100:
      return as(static_cast<std::int8_t*>(nullptr));
    case 8:
      return as(static_cast<std::uint64_t*>(nullptr));
    case 4:
      return as(static_cast<std::uint32_t*>(nullptr));
    case 2:
      return as(static_cast<std::uint16_t*>(nullptr));
    default:
      return as(static_cast<std::uint8_t*>(nullptr));
  }
}

/// Numbers between blanks; one more than `most` at most.
template <class Number>
std::vector<Number> from_text(std::string_view text, std::uint64_t most, const std::string& name) {
  std::vector<Number> result;
  while (result.size() <= most) {
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == text.npos)
      return result;
    text.remove_prefix(first);
    const auto word = text.substr(0, text.find_first_of(" \t\r\n"));
    std::optional<Number> value;
    if constexpr (std::is_same_v<Number, double>)
      value = real_of(word);
    else
      value = integer_of(word);
    if (!value)
      fail_array(name, "holds \"" + shown(word) + "\" where a number should be");
    result.push_back(*value);
    text.remove_prefix(word.size());
  }
  return result;
}

std::string name_of(const pugi::xml_node& array) {
  return shown(array.attribute("Name").as_string("(without a name)"));
}

bool is_text(const pugi::xml_node& array) {
  return std::string_view(array.attribute("format").as_string("ascii")) == "ascii";
}

}  // namespace

void fail_array(const std::string& name, const std::string& what) {
  throw file_failure{{ec::bad_input, "the array \"" + name + "\" " + what,
                      "The file is cut off or damaged: write it again", "array \"" + name + "\""}};
}

std::uint64_t vtu_data::header(std::string_view bytes, std::size_t i,
                               const std::string& name) const {
  const std::size_t size = encoding_.wide_headers ? 8 : 4;
  if (bytes.size() < (i + 1) * size)
    fail_array(name, "ends inside the header of its data");
  return encoding_.wide_headers ? stored_at<std::uint64_t>(bytes.data() + 8 * i, encoding_.swapped)
                                : stored_at<std::uint32_t>(bytes.data() + 4 * i, encoding_.swapped);
}

std::string vtu_data::inflated(std::string_view stored, std::uint64_t most,
                               const std::string& name) const {
  const std::size_t word = encoding_.wide_headers ? 8 : 4;
  const auto blocks = header(stored, 0, name);
  const auto block = header(stored, 1, name);
  const auto last = header(stored, 2, name);
  if (blocks > stored.size() / word)
    fail_array(name, "says " + std::to_string(blocks) + " blocks, more than its bytes can hold");
  std::string result;
  std::size_t at = (3 + blocks) * word;
  for (std::size_t b = 0; b < blocks; ++b) {
    const auto packed = header(stored, 3 + b, name);
    const auto size = b + 1 == blocks && last != 0 ? last : block;
    if (at > stored.size() || packed > stored.size() - at)
      fail_array(name, "has a block of " + std::to_string(packed) + " packed bytes, but " +
                         std::to_string(stored.size() - std::min(at, stored.size())) + " are left");
    // Nothing that zlib packs becomes a thousandth of itself.
    if (size / 1040 > packed)
      fail_array(name, "has a block of " + std::to_string(packed) +
                         " packed bytes that should be " + std::to_string(size) +
                         ", more than zlib can pack so small");
    if (size > most - result.size())
      fail_array(name, "has " + std::to_string(result.size()) + " bytes and a block of " +
                         std::to_string(size) + " more, where " + std::to_string(most) +
                         " should be");
    const auto begin = result.size();
    result.resize(begin + size);
    uLongf made = size;
    if (uncompress(reinterpret_cast<Bytef*>(result.data() + begin), &made,
                   reinterpret_cast<const Bytef*>(stored.data() + at), packed) != Z_OK ||
        made != size)
      fail_array(name, "has a block that zlib cannot read");
    at += packed;
  }
  return result;
}

std::string vtu_data::stored_bytes(std::string_view from, std::uint64_t most,
                                   const std::string& name) const {
  if (encoding_.compressed)
    return inflated(from, most, name);
  const std::size_t word = encoding_.wide_headers ? 8 : 4;
  const auto size = header(from, 0, name);
  if (size > from.size() - word)
    fail_array(name, "says " + std::to_string(size) + " bytes, but " +
                       std::to_string(from.size() - word) + " are left");
  if (size > most)
    fail_array(
      name, "has " + std::to_string(size) + " bytes where " + std::to_string(most) + " should be");
  return std::string(from.substr(word, size));
}

std::string vtu_data::bytes_of(const pugi::xml_node& array, std::uint64_t most) const {
  const auto name = name_of(array);
  const std::string format = array.attribute("format").as_string();
  // What is packed may be a little larger than what it holds.
  const auto most_stored = most + most / 8 + (1 << 16);
  if (format == "binary")
    return stored_bytes(from_base64(array.text().as_string(), most_stored, name), most, name);
  if (format != "appended")
    fail_array(name, "has the format \"" + shown(format) + "\", which is not known");
  const std::string offset = array.attribute("offset").as_string();
  const auto at = integer_of(offset);
  if (!at || *at < 0)
    fail_array(name, "has the offset \"" + shown(offset) + "\", which is no place in the file");
  if (static_cast<std::uint64_t>(*at) >= encoding_.appended.size())
    fail_array(name, "begins at the byte " + offset + " of the appended data, which have " +
                       std::to_string(encoding_.appended.size()));
  const auto rest = encoding_.appended.substr(static_cast<std::size_t>(*at));
  return encoding_.appended_is_base64
           ? stored_bytes(from_base64(rest, most_stored, name), most, name)
           : stored_bytes(rest, most, name);
}

template <class Number>
std::vector<Number> vtu_data::numbers(const pugi::xml_node& array, std::uint64_t count) const {
  const auto name = name_of(array);
  std::vector<Number> result;
  if (is_text(array)) {
    result = from_text<Number>(array.text().as_string(), count, name);
    if (result.size() > count)
      fail_array(name, "has more than the " + std::to_string(count) + " numbers that should be");
  } else {
    const auto& type = type_of(array, name);
    const auto bytes =
      bytes_of(array, count < UINT64_MAX / 16 ? count * type.size : UINT64_MAX / 2);
    const auto there = std::min<std::uint64_t>(count, bytes.size() / type.size);
    result.reserve(there);
    for (std::size_t i = 0; i < there; ++i)
      result.push_back(number_at<Number>(bytes.data() + i * type.size, type, encoding_.swapped));
  }
  if (result.size() != count)
    fail_array(name, "has " + std::to_string(result.size()) + " numbers where " +
                       std::to_string(count) + " should be");
  return result;
}

std::vector<double> vtu_data::reals(const pugi::xml_node& array, std::uint64_t count) const {
  return numbers<double>(array, count);
}

std::vector<std::int64_t> vtu_data::integers(const pugi::xml_node& array,
                                             std::uint64_t count) const {
  return numbers<std::int64_t>(array, count);
}

std::vector<std::string> vtu_data::texts(const pugi::xml_node& array) const {
  constexpr std::uint64_t most_text = 1 << 24;
  std::string bytes;
  if (is_text(array))
    for (const auto code :
         from_text<std::int64_t>(array.text().as_string(), most_text, name_of(array)))
      bytes += static_cast<char>(code & 255);
  else
    bytes = bytes_of(array, most_text);
  std::vector<std::string> result;
  std::string one;
  for (const char c : bytes)
    if (c == '\0')
      result.push_back(std::exchange(one, {}));
    else
      one += c;
  if (!one.empty())
    result.push_back(one);
  return result;
}

}  // namespace tedit
