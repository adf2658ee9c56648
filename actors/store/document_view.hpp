// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/store/reading.hpp"

namespace tedit::store {

/// A document's file as it was at one moment, for who only reads: also beside a server that has it
/// open and goes on changing it, and also of an older format, which the file keeps. Not for a
/// process that has the document open itself: it looks at the file beside SQLite, and closing a
/// file ends all locks that SQLite has on it in that process. Not thread-safe.
class document_view {
public:
  /// Errors: `not_found` when there is no file; `storage_error` when it is empty, no TEdit document
  /// or of a newer format; `io_error`. Damage is told by `read`.
  [[nodiscard]] static expected<std::unique_ptr<document_view>> open(
    const std::filesystem::path& file);

  ~document_view();
  document_view(const document_view&) = delete;
  document_view& operator=(const document_view&) = delete;

  /// The format that the file has.
  [[nodiscard]] std::int64_t format() const;

  /// How many pages there are, needed or not. Errors: those of `sql_failure`.
  [[nodiscard]] expected<std::vector<hash128>> page_ids() const;

  /// As `read_sound_rows`.
  [[nodiscard]] expected<sound_rows> read() const;

  /// As `document::read_page`.
  [[nodiscard]] expected<page_ptr> read_page(const hash128& id) const;

  /// As `document::read_cad`.
  [[nodiscard]] expected<std::optional<cad_row>> read_cad(std::uint32_t number) const;

  /// Writes the document as it was at the moment of the view, and of its format, to a file that is
  /// not there. It is there whole or not at all. Errors: `conflict` when something has the name;
  /// `io_error`, `storage_error`. Cost: its size; needs no memory for it.
  [[nodiscard]] expected<void> copy_to(const std::filesystem::path& file) const;

private:
  struct impl;
  document_view();

  std::unique_ptr<impl> impl_;
};

/// How a document's file stands, without a look into it.
struct file_state {
  std::int64_t bytes = 0;       ///< With its log.
  std::int64_t changed_ms = 0;  ///< Since 1970, UTC.
};

/// Errors: `not_found`, `io_error`. Cost: two questions to the system.
[[nodiscard]] expected<file_state> state_of(const std::filesystem::path& file);

}  // namespace tedit::store
