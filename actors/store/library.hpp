// SPDX-License-Identifier: AGPL-3.0-or-later
// The documents of a folder, as far as nobody has them open.
#pragma once

#include <filesystem>
#include <functional>

#include "actors/local_messages.hpp"

namespace tedit::actors {

/// Errors: `invalid_argument` unless the name is 1 to 64 letters, digits, '.', '_' or '-' and does
/// not begin with a dot.
[[nodiscard]] expected<void> check_document_name(const std::string& name);

/// How the names begin that the server makes for documents to which nobody gave one; two numbers
/// with a dash between them follow.
inline constexpr const char* temporary_prefix = "temporary-";

/// Whether the name is one of those: its document goes some time after its last client.
[[nodiscard]] bool is_temporary(const std::string& name);

/// Bytes of a document's name.
inline constexpr std::size_t longest_document_name = 64;

/// The documents that have a file in a folder, by name. Files are not looked into: one may turn out
/// to be no document. Those whose names no document can have are left out, and so is what cannot be
/// read. Cost: some questions to the system for each.
[[nodiscard]] document_list list_folder(const std::filesystem::path& folder);

/// Does `copy`, which may be cancelled. Errors: those of `copy`; `cancelled`: then nothing was
/// made.
[[nodiscard]] expected<void> cancellable_copy(const cancel_token& stop,
                                              const std::function<expected<void>()>& copy);

/// Copies a document to a file that is not there; returns how many versions it has. Errors:
/// `storage_error` when it is damaged, naming the first damage; `cancelled`; those of
/// `document_view`. Cost: that of opening it, and its size. @pre this process does not have it
/// open.
[[nodiscard]] expected<std::size_t> copy_sound_file(const file_copy& wanted);

}  // namespace tedit::actors
