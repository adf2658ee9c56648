// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scan/reader/zip_reader.hpp"

#include <algorithm>
#include <cstring>

#include <zlib.h>

namespace tedit::scan {

namespace {

constexpr const char* zip_remedy = "Save the file again in the program that it comes from";
constexpr std::size_t end_record_size = 22;
constexpr std::size_t directory_size = 46;
constexpr std::size_t local_size = 30;
constexpr std::uint16_t stored = 0;
constexpr std::uint16_t deflated = 8;
constexpr std::uint16_t encrypted = 1;

template <class T>
T number_at(std::span<const char> bytes, std::size_t at) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    value = static_cast<T>(
      value | static_cast<T>(static_cast<T>(static_cast<unsigned char>(bytes[at + i])) << (8 * i)));
  return value;
}

bool has_mark(std::span<const char> bytes, std::size_t at, const char* mark) {
  return at + 4 <= bytes.size() && std::memcmp(bytes.data() + at, mark, 4) == 0;
}

/// The last one in the file: a comment may be behind it.
std::optional<std::size_t> end_record(std::span<const char> bytes) {
  constexpr std::size_t longest_comment = 65535;
  if (bytes.size() < end_record_size)
    return std::nullopt;
  const std::size_t last = bytes.size() - end_record_size;
  for (std::size_t back = 0; back <= std::min(last, longest_comment); ++back)
    if (has_mark(bytes, last - back, "PK\5\6"))
      return last - back;
  return std::nullopt;
}

tl::unexpected<error> damaged(const std::string& what, std::size_t at) {
  return fail(ec::bad_input, "the archive of the 3MF file is damaged: " + what, zip_remedy,
              "byte " + std::to_string(at));
}

expected<std::string> inflated(std::span<const char> packed, std::uint64_t size, std::size_t at) {
  std::string text(size, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
    return fail(ec::out_of_memory, "there is no memory to unpack the 3MF file");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  const int end = inflate(&stream, Z_FINISH);
  const auto made = stream.total_out;
  inflateEnd(&stream);
  if (end != Z_STREAM_END || made != size)
    return damaged("a file in it does not unpack", at);
  return text;
}

}  // namespace

expected<zip_archive> zip_archive::open(std::span<const char> bytes) {
  if (!has_mark(bytes, 0, "PK\3\4"))
    return damaged("it does not begin as a zip archive does", 0);
  const auto end = end_record(bytes);
  if (!end)
    return damaged("it has no directory, as if it were cut off", bytes.size());
  const auto count = number_at<std::uint16_t>(bytes, *end + 10);
  std::size_t at = number_at<std::uint32_t>(bytes, *end + 16);
  zip_archive archive;
  archive.bytes_ = bytes;
  archive.directory_ = at;
  for (std::uint16_t i = 0; i < count; ++i) {
    if (at > bytes.size() || bytes.size() - at < directory_size || !has_mark(bytes, at, "PK\1\2"))
      return damaged("its directory is not whole", std::min(at, bytes.size()));
    const std::size_t name = number_at<std::uint16_t>(bytes, at + 28);
    const std::size_t more = number_at<std::uint16_t>(bytes, at + 30) +
                             std::size_t{number_at<std::uint16_t>(bytes, at + 32)};
    if (bytes.size() - at - directory_size < name + more)
      return damaged("its directory is not whole", at);
    archive.entries_.push_back(
      {std::string(bytes.data() + at + directory_size, name),
       number_at<std::uint16_t>(bytes, at + 8), number_at<std::uint16_t>(bytes, at + 10),
       number_at<std::uint32_t>(bytes, at + 16), number_at<std::uint32_t>(bytes, at + 20),
       number_at<std::uint32_t>(bytes, at + 24), number_at<std::uint32_t>(bytes, at + 42)});
    at += directory_size + name + more;
  }
  return archive;
}

std::vector<std::string> zip_archive::names() const {
  std::vector<std::string> result;
  for (const auto& one : entries_)
    result.push_back(one.name);
  return result;
}

expected<std::string> zip_archive::unpack(std::string_view name, std::size_t most) const {
  const auto found = std::ranges::find(entries_, name, &entry::name);
  if (found == entries_.end())
    return fail(ec::bad_input, "the archive holds no " + std::string(name) + ": it is no 3MF file",
                zip_remedy, "byte " + std::to_string(directory_));
  if ((found->flags & encrypted) != 0)
    return fail(ec::unsupported_format, "the 3MF archive is locked by a password",
                "Save it without one", "byte " + std::to_string(found->offset));
  if (found->packed == UINT32_MAX || found->size == UINT32_MAX || found->offset == UINT32_MAX)
    return fail(ec::unsupported_format, "the 3MF archive has sizes of 64 bits (ZIP64)",
                "Save the part as STL, or simplify it", "byte " + std::to_string(directory_));
  const auto at = found->offset;
  if (at > bytes_.size() || bytes_.size() - at < local_size || !has_mark(bytes_, at, "PK\3\4"))
    return damaged("a file in it is not where its directory says", at);
  const std::size_t begin = at + local_size + number_at<std::uint16_t>(bytes_, at + 26) +
                            std::size_t{number_at<std::uint16_t>(bytes_, at + 28)};
  if (begin > bytes_.size() || bytes_.size() - begin < found->packed)
    return damaged("a file in it goes beyond its end", at);
  if (found->size > most)
    return fail(ec::bad_input,
                "a file in the 3MF archive says that it has " + std::to_string(found->size) +
                  " bytes unpacked, more than " + std::to_string(most),
                "Simplify the part first", "byte " + std::to_string(at));
  // Nothing that is deflated becomes a thousandth of itself: no bomb gets its memory.
  if (found->size / 1040 > found->packed)
    return damaged("a file in it says that " + std::to_string(found->packed) + " bytes become " +
                     std::to_string(found->size),
                   at);
  const auto packed = bytes_.subspan(begin, found->packed);
  expected<std::string> text = std::string();
  if (found->method == deflated)
    text = inflated(packed, found->size, at);
  else if (found->method == stored && found->packed == found->size)
    text = std::string(packed.data(), packed.size());
  else
    return fail(ec::unsupported_format, "the 3MF archive is packed in a way that is not read",
                zip_remedy, "byte " + std::to_string(at));
  if (text && crc32(0, reinterpret_cast<const Bytef*>(text->data()),
                    static_cast<uInt>(text->size())) != found->crc)
    return damaged("the checksum of a file in it is another", at);
  return text;
}

}  // namespace tedit::scan
