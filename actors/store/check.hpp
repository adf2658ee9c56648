// SPDX-License-Identifier: AGPL-3.0-or-later
// What a document's file holds and what of it is damaged, for who looks at documents as files.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "actors/local_messages.hpp"
#include "actors/store/document_view.hpp"

namespace tedit::actors {

/// What a look at all of a document found.
struct document_check {
  std::int64_t format = 0;
  std::vector<std::uint32_t> whole;  ///< Versions of which everything can be read; ascending.
  std::size_t versions = 0;          ///< With those that are damaged, as far as they can be seen.
  std::optional<std::uint32_t> head;
  std::size_t pages = 0;
  std::size_t unneeded_pages = 0;  ///< That no version names.
  std::size_t log_lines = 0;
  std::vector<error> damage;  ///< Each damaged row and page, and what does not fit; empty: sound.

  [[nodiscard]] bool sound() const { return damage.empty(); }
};

/// Reads every row and page and puts every version together. Errors: when the database cannot be
/// read at all. Cost: that of opening the document.
[[nodiscard]] expected<document_check> check_document(const store::document_view& document);

/// The mesh of a version, also of a document that is damaged elsewhere; without a number that of
/// the current one. Errors: `not_found`; `storage_error` when this version is damaged.
[[nodiscard]] expected<version_ptr> read_version(const store::document_view& document,
                                                 std::optional<std::uint32_t> number);

}  // namespace tedit::actors
