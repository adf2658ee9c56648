// SPDX-License-Identifier: AGPL-3.0-or-later
// The other end of `run_program`: what the reader and the mesher begin with, and how they tell.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace tedit::cad {

/// What a program was called with: `PROGRAM FOLDER SECONDS FILE_BYTES MORE...`.
struct program_call {
  std::filesystem::path folder;
  unsigned cpu_seconds = 0;
  std::uint64_t file_bytes = 0;
};

/// The line to who started this program. Libraries print what they like: it goes into a file of the
/// folder.
class teller {
public:
  /// Takes over stdout. Call it first.
  explicit teller(const program_call& call);

  /// What is being done from now on.
  void stage(double fraction, std::string_view what) const;

  /// Ends this program with a refusal that a person reads.
  [[noreturn]] void refuse(const error& why) const;

  /// Closes all files but the standard streams and the line: whoever started this program may have
  /// left some open.
  void close_others() const;

private:
  void send(const std::string& line) const;
  int line_ = -1;
};

/// Limits and confinement: this program may read the system's files and `file` (if not empty), and
/// write into its folder. Refuses where it is wanted and cannot be.
void confine(const program_call& call, const std::filesystem::path& file, const teller& tells);

/// Errors: `usage`.
[[nodiscard]] expected<program_call> parse_call(int argc, char** argv, int least);

}  // namespace tedit::cad
