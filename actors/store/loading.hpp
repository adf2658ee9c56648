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

/// The same with the mesh of the current version alone. Of the others all pages are there; what
/// they hold is read, and checked, when `load_version` is asked for them. Cost: that of the rows
/// and of one mesh, and a look-up for each page.
[[nodiscard]] expected<stored_document> load_head(const store::document& document);

/// The mesh of one version. Pages that are known are not read. Errors: those of `load_mesh`.
[[nodiscard]] expected<stored_version> load_version(const store::document& document,
                                                    const version_query& wanted);

/// Whether the versions are a tree in the order in which they were made, and the head is one of
/// them. Errors: `storage_error` naming the version.
[[nodiscard]] expected<void> check_tree(const store::contents& all);

/// The mesh of a version. Pages that are in `known` are not read, and those that are read come into
/// it. Errors: `storage_error`, `protocol_error`, `invalid_mesh` for what is damaged.
[[nodiscard]] expected<version_ptr> load_mesh(const store::version_row& row,
                                              const page_reader& read, page_map& known);

/// Puts a mesh, and what is told of it, into a node.
void describe_mesh(graph_node& node, version_ptr mesh);

/// The inverse of `stored_form`. Errors: `storage_error` naming the version.
[[nodiscard]] expected<shared_load_cases> read_load_cases(const store::version_row& row);

/// What the edit reported; null for an import. Errors: `storage_error` naming the version.
[[nodiscard]] expected<shared_report> read_report(const store::version_row& row);

}  // namespace tedit::actors
