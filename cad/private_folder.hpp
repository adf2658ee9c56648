// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "base/error.hpp"

namespace tedit::cad {

/// A temporary folder in which a process and the programs that it starts exchange files: the only
/// place where those may write. It goes with this; what a killed process left goes when the next
/// one of this prefix is made.
class private_folder {
public:
  /// @param prefix of its name, the same for all that do the same.
  explicit private_folder(std::string_view prefix);
  ~private_folder();
  private_folder(const private_folder&) = delete;
  private_folder& operator=(const private_folder&) = delete;

  /// Empty where none could be made; errno says why.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

/// What is said of an empty path.
[[nodiscard]] error no_private_folder();

}  // namespace tedit::cad
