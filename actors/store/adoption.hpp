// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents that come as files from elsewhere.
#pragma once

#include <filesystem>
#include <vector>

#include "base/error.hpp"
#include "mesh/page.hpp"

namespace tedit::actors {

/// Makes `file` a document with these bytes, once all of it was read and checked as an opening
/// does. It is there whole or not at all, also after a kill or a power failure; what a kill leaves
/// is no document and goes when the server starts (`store::prepare_documents_folder`).
/// Errors: `conflict` when something has the name; those of `store::document::open` and `load`;
/// `io_error`. Cost: that of opening the document.
[[nodiscard]] expected<void> adopt(const std::filesystem::path& file,
                                   const std::vector<page_ptr>& bytes);

}  // namespace tedit::actors
