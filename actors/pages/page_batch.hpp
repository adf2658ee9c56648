// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <vector>

#include "actors/messages.hpp"
#include "actors/pages/page_cache.hpp"

namespace tedit::actors {

/// A batch holds at most this many bytes of pages, so that control messages never wait long behind
/// it.
inline constexpr std::size_t max_batch_bytes = 256 * 1024;

/// The pages of a list in one batch. `packed`: the eight bytes of each number stand apart, all
/// first ones first, and zstd makes them smaller (docs/decisions/0048); as they are where that
/// saves less than a tenth. Errors: `not_found`, `invalid_argument` when the batch would be too
/// large.
[[nodiscard]] expected<page_batch> pack(page_cache& cache, const hash_list& ids, bool packed);

/// Checks sizes and hashes and returns the pages; no batch makes it take more memory than one may
/// hold. Errors: `protocol_error`.
[[nodiscard]] expected<std::vector<page_ptr>> unpack(const page_batch& batch, const hash_list& ids);

/// Splits a list into batches that fit, at most `max_batch_bytes / max_page_bytes` pages each.
[[nodiscard]] std::deque<hash_list> split(const hash_list& ids);

}  // namespace tedit::actors
