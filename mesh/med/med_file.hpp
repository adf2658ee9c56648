// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <med.h>

#include "base/error.hpp"

namespace tedit::med {

/// Thrown inside this program only.
struct refusal {
  error reason;
};

[[noreturn]] void refuse(ec code, std::string message, std::string remedy);

/// That libmed could not read something of the file.
[[noreturn]] void refuse_damaged(const std::string& what);

/// A MED file in memory: no file by name is opened or made.
class med_file {
public:
  /// Of these bytes, which must outlive it. Refuses what is cut off, no HDF5 or no MED.
  explicit med_file(std::span<const char> bytes);
  /// An empty one to write into.
  med_file();
  ~med_file();
  med_file(const med_file&) = delete;
  med_file& operator=(const med_file&) = delete;

  [[nodiscard]] med_idt id() const { return id_; }

  /// Ends it: the bytes of the file that was written.
  [[nodiscard]] std::vector<char> close();

private:
  med_memfile memory_ = MED_MEMFILE_INIT;
  med_idt id_ = -1;
};

/// A text of libmed's in a field of so many bytes, without what fills it up.
[[nodiscard]] std::string text_in(const char* field, std::size_t most);

}  // namespace tedit::med
