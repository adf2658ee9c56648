// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "base/error.hpp"
#include "base/unique_fd.hpp"

/// Files for their owner alone (0600, in folders 0700), written so that a kill leaves the old state
/// or the new one. Errors: `io_error`, and what a function names.
namespace tedit::certs {

/// Writes and syncs a file that must not be there.
[[nodiscard]] expected<void> write_new(const std::filesystem::path& file, const std::string& text);

/// Puts `text` in a file's place in one step; the file need not be there.
[[nodiscard]] expected<void> replace_file(const std::filesystem::path& file,
                                          const std::string& text);

/// A folder that is filled under a hidden name beside its place, and gone with what is in it unless
/// it was put there.
class folder_draft {
public:
  /// Errors: `conflict` when `place` is there and not an empty folder.
  [[nodiscard]] static expected<folder_draft> make(const std::filesystem::path& place);
  /// The same for a place that holds what is to be exchanged.
  [[nodiscard]] static expected<folder_draft> make_exchange(const std::filesystem::path& place);

  folder_draft(folder_draft&& other) noexcept;
  folder_draft& operator=(folder_draft&&) = delete;
  folder_draft(const folder_draft&) = delete;
  folder_draft& operator=(const folder_draft&) = delete;
  ~folder_draft();

  [[nodiscard]] const std::filesystem::path& path() const { return draft_; }

  /// Puts it in place in one step. Errors: `conflict` when something came there meanwhile.
  [[nodiscard]] expected<void> put_in_place();

private:
  folder_draft(std::filesystem::path place, std::filesystem::path draft, bool exchanges)
      : place_(std::move(place)), draft_(std::move(draft)), exchanges_(exchanges) {}

  [[nodiscard]] static expected<folder_draft> begin(const std::filesystem::path& place,
                                                    bool exchanges);

  std::filesystem::path place_;
  std::filesystem::path draft_;  ///< Empty: nothing is left to remove.
  bool exchanges_;
};

/// Held by whoever changes a folder; others wait. It ends with its owner.
[[nodiscard]] expected<unique_fd> lock_folder(const std::filesystem::path& folder);

}  // namespace tedit::certs
