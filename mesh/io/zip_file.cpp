// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/zip_file.hpp"

#include <zlib.h>

#include <array>
#include <new>
#include <ostream>

namespace tedit {

namespace {

// PKWARE's APPNOTE 6.3, sections 4.3 and 4.4.
constexpr std::uint32_t local_mark = 0x04034b50;
constexpr std::uint32_t central_mark = 0x02014b50;
constexpr std::uint32_t end_mark = 0x06054b50;
constexpr std::uint16_t version_needed = 20;  // Deflate and folders.
constexpr std::uint16_t utf8_names = 1U << 11;
constexpr std::uint16_t deflated = 8;
constexpr std::uint16_t no_time = 0;
constexpr std::uint16_t first_date = 1U << 5 | 1U;  // 1 January 1980, the least there is.
constexpr std::size_t local_bytes = 30;
constexpr std::size_t central_bytes = 46;
constexpr std::uint64_t most_bytes = 0xFFFFFFFE;  // All ones would mean zip64.

constexpr std::size_t packed_at_once = 1U << 16;

/// Little-endian, whatever the machine is.
template <class Number>
void put_number(std::ostream& out, Number value) {
  for (std::size_t i = 0; i < sizeof(value); ++i)
    out.put(static_cast<char>(value >> (8 * i) & 0xFF));
}

/// What both headers of a file have in common.
void put_facts(std::ostream& out, const zipped_file& file) {
  put_number(out, version_needed);
  put_number(out, utf8_names);
  put_number(out, deflated);
  put_number(out, no_time);
  put_number(out, first_date);
  put_number(out, file.crc);
  put_number(out, static_cast<std::uint32_t>(file.bytes.size()));
  put_number(out, static_cast<std::uint32_t>(file.size));
  put_number(out, static_cast<std::uint16_t>(file.name.size()));
  put_number(out, std::uint16_t{0});  // Extra field.
}

}  // namespace

struct zip_packer::stream {
  z_stream z{};
};

zip_packer::zip_packer(std::string name) : stream_(std::make_unique<stream>()) {
  file_.name = std::move(name);
  file_.crc = static_cast<std::uint32_t>(crc32(0, nullptr, 0));
  constexpr int raw_window = -15;  // Without the header of zlib.
  constexpr int memory_level = 8;
  if (deflateInit2(&stream_->z, Z_DEFAULT_COMPRESSION, Z_DEFLATED, raw_window, memory_level,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
}

zip_packer::~zip_packer() {
  deflateEnd(&stream_->z);
}

void zip_packer::add(std::string_view text) {
  waiting_ += text;
  if (waiting_.size() < packed_at_once)
    return;
  pack(waiting_, Z_NO_FLUSH);
  waiting_.clear();
}

zipped_file zip_packer::finish() {
  pack(waiting_, Z_FINISH);
  return std::move(file_);
}

void zip_packer::pack(std::string_view text, int flush) {
  const auto* bytes = reinterpret_cast<const Bytef*>(text.data());
  file_.crc = static_cast<std::uint32_t>(crc32_z(file_.crc, bytes, text.size()));
  file_.size += text.size();
  auto& z = stream_->z;
  z.next_in = const_cast<Bytef*>(bytes);  // It is only read.
  z.avail_in = static_cast<uInt>(text.size());
  std::array<char, packed_at_once> packed;
  do {
    z.next_out = reinterpret_cast<Bytef*>(packed.data());
    z.avail_out = static_cast<uInt>(packed.size());
    deflate(&z, flush);
    file_.bytes.append(packed.data(), packed.size() - z.avail_out);
  } while (z.avail_out == 0);
}

bool fits_zip(std::span<const zipped_file> files) {
  std::uint64_t together = 0;
  for (const auto& file : files) {
    together += local_bytes + central_bytes + 2 * file.name.size() + file.bytes.size();
    if (file.size > most_bytes)
      return false;
  }
  return together <= most_bytes;
}

void write_zip(std::ostream& out, std::span<const zipped_file> files) {
  std::uint32_t at = 0;
  for (const auto& file : files) {
    put_number(out, local_mark);
    put_facts(out, file);
    out << file.name << file.bytes;
    at += static_cast<std::uint32_t>(local_bytes + file.name.size() + file.bytes.size());
  }
  const auto directory = at;
  std::uint32_t begin = 0;
  for (const auto& file : files) {
    put_number(out, central_mark);
    put_number(out, version_needed);
    put_facts(out, file);
    put_number(out, std::uint16_t{0});  // Comment.
    put_number(out, std::uint16_t{0});  // Disk.
    put_number(out, std::uint16_t{0});  // Attributes.
    put_number(out, std::uint32_t{0});
    put_number(out, begin);
    out << file.name;
    begin += static_cast<std::uint32_t>(local_bytes + file.name.size() + file.bytes.size());
    at += static_cast<std::uint32_t>(central_bytes + file.name.size());
  }
  put_number(out, end_mark);
  put_number(out, std::uint32_t{0});  // Disks.
  put_number(out, static_cast<std::uint16_t>(files.size()));
  put_number(out, static_cast<std::uint16_t>(files.size()));
  put_number(out, at - directory);
  put_number(out, directory);
  put_number(out, std::uint16_t{0});  // Comment.
}

}  // namespace tedit
