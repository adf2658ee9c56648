// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace tedit {

/// A file of a zip archive, packed.
struct zipped_file {
  std::string name;  ///< With its folders, parted by '/'.
  std::string bytes;
  std::uint32_t crc = 0;
  std::uint64_t size = 0;  ///< Before it was packed.
};

/// Packs a file as its text comes, so that the text itself is never held whole. The same text, in
/// whatever pieces, gives the same bytes.
class zip_packer {
public:
  /// Errors: throws `std::bad_alloc`.
  explicit zip_packer(std::string name);
  ~zip_packer();
  zip_packer(const zip_packer&) = delete;
  zip_packer& operator=(const zip_packer&) = delete;

  void add(std::string_view text);
  /// Nothing may be added afterwards.
  [[nodiscard]] zipped_file finish();

private:
  struct stream;

  void pack(std::string_view text, int flush);

  std::unique_ptr<stream> stream_;
  std::string waiting_;  ///< Short texts are packed together.
  zipped_file file_;
};

/// What an archive can hold: each file, and all together, stay below 4 GiB.
[[nodiscard]] bool fits_zip(std::span<const zipped_file> files);

/// Writes an archive, without times, so that the same files give the same bytes. They must fit.
void write_zip(std::ostream& out, std::span<const zipped_file> files);

}  // namespace tedit
