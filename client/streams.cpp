// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/streams.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace tedit::client {

static_assert(std::endian::native == std::endian::little, "streams are little-endian");

namespace {

/// Memory that is reserved on the word of an announcement alone.
constexpr std::uint64_t max_reserved = std::uint64_t{64} << 20;

std::uint64_t value_size(array_type type) {
  switch (type) {
    case array_type::u8:
      return 1;
    case array_type::u32:
    case array_type::f32:
      return 4;
    case array_type::i64:
    case array_type::f64:
      return 8;
    case array_type::unspecified:
      break;
  }
  return 0;
}

/// 0 for an empty array; more than `max_stream_bytes` when it cannot be.
std::uint64_t array_size(const stream_array& array) {
  const std::uint64_t item = value_size(array.type) * array.components;
  if (item == 0 || array.items == 0)
    return 0;
  return array.items > max_stream_bytes / item ? max_stream_bytes + 1 : item * array.items;
}

tl::unexpected<error> stream_error(std::uint64_t stream, const std::string& what) {
  return fail(ec::protocol_error, "stream " + std::to_string(stream) + " " + what);
}

}  // namespace

expected<incoming_stream> incoming_stream::begin(stream_header header, std::size_t message_bytes) {
  std::uint64_t end = 0;
  for (auto& array : header.arrays) {
    if (value_size(array.type) == 0 || array.components == 0)
      return stream_error(header.stream, "has array \"" + array.name + "\" of an unknown type");
    if (!array.offset)
      array.offset = end;
    if (*array.offset < end)
      return stream_error(header.stream, "has array \"" + array.name + "\" inside the one before");
    end = *array.offset > max_stream_bytes ? *array.offset : *array.offset + array_size(array);
    if (end > max_stream_bytes)
      return stream_error(header.stream,
                          "is larger than " + std::to_string(max_stream_bytes) + " bytes");
  }
  if (end != header.bytes)
    return stream_error(header.stream, "announces " + std::to_string(header.bytes) +
                                         " bytes, but its arrays end at " + std::to_string(end));
  incoming_stream result;
  result.data_.reserve(std::min(end, max_reserved));
  result.header_ = std::move(header);
  result.moved_ = {1, message_bytes, 0};
  result.began_ = std::chrono::steady_clock::now();
  return result;
}

expected<void> incoming_stream::append(std::uint64_t offset, std::string_view data,
                                       std::size_t message_bytes) {
  if (offset != received_)
    return stream_error(header_.stream, "goes on at byte " + std::to_string(offset) + " after " +
                                          std::to_string(received_) + " bytes");
  if (data.size() > header_.bytes - received_)
    return stream_error(
      header_.stream, "brings more than the announced " + std::to_string(header_.bytes) + " bytes");
  if (!discarded_)
    data_.insert(data_.end(), data.begin(), data.end());
  received_ += data.size();
  ++moved_.messages;
  moved_.bytes += message_bytes;
  moved_.ms =
    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began_).count();
  return {};
}

void incoming_stream::discard() {
  discarded_ = true;
  data_ = {};
}

template <class T>
expected<std::vector<T>> incoming_stream::read(std::string_view name, array_type type,
                                               std::uint32_t components) const {
  for (const auto& array : header_.arrays) {
    if (array.name != name)
      continue;
    const std::uint64_t at = *array.offset;
    const std::uint64_t size = array_size(array);
    if (array.type != type || array.components != components)
      return stream_error(header_.stream, "has array \"" + array.name + "\" in another form");
    if (data_.size() < at + size)
      return stream_error(header_.stream, "is not complete");
    std::vector<T> result(size / sizeof(T));
    if (size != 0)
      std::memcpy(result.data(), data_.data() + at, size);
    return result;
  }
  return std::vector<T>{};
}

expected<std::vector<std::uint32_t>> incoming_stream::u32(std::string_view name,
                                                          std::uint32_t components) const {
  return read<std::uint32_t>(name, array_type::u32, components);
}

expected<std::vector<std::int64_t>> incoming_stream::i64(std::string_view name,
                                                         std::uint32_t components) const {
  return read<std::int64_t>(name, array_type::i64, components);
}

expected<std::vector<float>> incoming_stream::f32(std::string_view name,
                                                  std::uint32_t components) const {
  return read<float>(name, array_type::f32, components);
}

expected<std::vector<double>> incoming_stream::f64(std::string_view name,
                                                   std::uint32_t components) const {
  return read<double>(name, array_type::f64, components);
}

expected<std::vector<char>> incoming_stream::bytes(std::string_view name) const {
  return read<char>(name, array_type::u8, 1);
}

}  // namespace tedit::client
