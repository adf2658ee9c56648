// SPDX-License-Identifier: AGPL-3.0-or-later
// What the rows and pages of a document mean.
#pragma once

#include <functional>

#include "actors/local_messages.hpp"
#include "actors/store/document.hpp"

namespace tedit::actors {

/// Yields a page of a document by its identity.
using page_reader = std::function<expected<page_ptr>(const hash128&)>;

/// Everything in a document; versions share the pages that they have in common. Errors:
/// `storage_error` naming what is damaged. Cost: reads all of it.
[[nodiscard]] expected<stored_document> load(const store::document& document);

/// Whether the versions are a tree in the order in which they were made, and the head is one of
/// them. Errors: `storage_error` naming the version.
[[nodiscard]] expected<void> check_tree(const store::contents& all);

/// The mesh of a version. Pages that are in `known` are not read, and those that are read come into
/// it. Errors: `storage_error`, `protocol_error`, `invalid_mesh` for what is damaged.
[[nodiscard]] expected<version_ptr> load_mesh(const store::version_row& row,
                                              const page_reader& read, page_map& known);

/// The inverse of `stored_form`. Errors: `storage_error` naming the version.
[[nodiscard]] expected<shared_load_cases> read_load_cases(const store::version_row& row);

/// What the edit reported; null for an import. Errors: `storage_error` naming the version.
[[nodiscard]] expected<shared_report> read_report(const store::version_row& row);

}  // namespace tedit::actors
