// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/med_content.hpp"

#include <string_view>

#include "base/byte_stream.hpp"
#include "base/text.hpp"

namespace tedit {

namespace {

using namespace std::string_view_literals;

constexpr std::uint64_t content_magic = 0x31444d5454454454;
constexpr std::uint64_t refusal_magic = 0x30444d5454454454;

std::vector<char> chars_of(const byte_writer& out) {
  const auto* first = reinterpret_cast<const char*>(out.bytes.data());
  return {first, first + out.bytes.size()};
}

void put_texts(byte_writer& out, const std::vector<std::string>& texts) {
  out.number(static_cast<std::uint64_t>(texts.size()));
  for (const auto& text : texts)
    out.text(text);
}

std::vector<std::string> take_texts(byte_reader& in) {
  std::vector<std::string> result(in.count(sizeof(std::uint32_t)));
  for (auto& text : result)
    text = in.text();
  return result;
}

void put_elements(byte_writer& out, const med_content::elements& all) {
  out.list(std::span(all.nodes));
  out.list(std::span(all.families));
}

/// `width`: nodes of an element.
med_content::elements take_elements(byte_reader& in, std::size_t width) {
  med_content::elements result{in.list<std::int32_t>(), in.list<std::int32_t>()};
  in.ok = in.ok && result.nodes.size() == width * result.families.size();
  return result;
}

std::vector<med_content::family> take_families(byte_reader& in) {
  constexpr std::size_t least =
    sizeof(std::int32_t) + sizeof(std::uint32_t) + sizeof(std::uint64_t);
  std::vector<med_content::family> result(in.count(least));
  for (auto& one : result) {
    one.number = in.number<std::int32_t>();
    one.name = in.text();
    one.groups = take_texts(in);
  }
  return result;
}

}  // namespace

bool is_hdf5(std::span<const char> bytes) {
  return std::string_view(bytes.data(), bytes.size()).starts_with("\x89HDF\r\n\x1a\n"sv);
}

std::vector<char> to_bytes(const med_content& content) {
  byte_writer out;
  out.number(content_magic);
  out.text(content.name);
  out.text(content.unit);
  out.list(std::span(content.coordinates));
  out.list(std::span(content.node_families));
  put_elements(out, content.tets);
  put_elements(out, content.tets10);
  put_elements(out, content.triangles);
  out.number(static_cast<std::uint64_t>(content.families.size()));
  for (const auto& one : content.families) {
    out.number(one.number);
    out.text(one.name);
    put_texts(out, one.groups);
  }
  put_texts(out, content.notices);
  return chars_of(out);
}

expected<med_content> content_from(std::span<const char> bytes) {
  byte_reader in(std::as_bytes(bytes));
  med_content result;
  in.ok = in.number<std::uint64_t>() == content_magic;
  if (in.ok) {
    result.name = in.text();
    result.unit = in.text();
    result.coordinates = in.list<double>();
    result.node_families = in.list<std::int32_t>();
    result.tets = take_elements(in, 4);
    result.tets10 = take_elements(in, 10);
    result.triangles = take_elements(in, 3);
    result.families = take_families(in);
    result.notices = take_texts(in);
  }
  const auto nodes = result.coordinates.size() / 3;
  if (!in.ok || !in.at_end() || result.coordinates.size() % 3 != 0 ||
      (!result.node_families.empty() && result.node_families.size() != nodes))
    return fail(ec::internal, "the answer of tedit-med is no mesh", "Try again");
  return result;
}

std::vector<char> to_answer(const error& why) {
  byte_writer out;
  out.number(refusal_magic);
  out.text(code_name(why.code));
  out.text(why.message);
  out.text(why.remedy);
  out.text(why.where);
  return chars_of(out);
}

std::optional<error> refusal_in(std::span<const char> answer) {
  byte_reader in(std::as_bytes(answer));
  if (in.number<std::uint64_t>() != refusal_magic)
    return std::nullopt;
  error why;
  why.code = code_from_name(in.text());
  why.message = to_utf8(in.text());
  why.remedy = to_utf8(in.text());
  why.where = to_utf8(in.text());
  return why;
}

}  // namespace tedit
