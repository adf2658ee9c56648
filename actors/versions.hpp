// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/local_messages.hpp"

namespace tedit::fem {
struct result_array;
}

namespace tedit::actors {

[[nodiscard]] version_ref make_ref(const version_ptr& version);

/// How many places for tets a version has; 0 when its manifest is damaged.
[[nodiscard]] double tets_of(const version_ref& ref);

/// The pages that a version needs. Errors: `protocol_error` when the manifest is damaged or is not
/// the one that the id names.
[[nodiscard]] expected<hash_list> pages_of(const version_ref& ref);

/// Puts a version together from pages that are all there. Errors: `protocol_error`, `not_found`,
/// `invalid_mesh`. Cost: O(pages).
[[nodiscard]] expected<version_ptr> open_version(const version_ref& ref, const page_set& pages);

[[nodiscard]] field_ref make_ref(const field& f);

/// The array of a load case that only those need who watch it, or null: "stress_pa (braking)" is
/// "stress_pa".
[[nodiscard]] const fem::result_array* for_watchers(const field_ref& one);

/// The pages of all of them.
[[nodiscard]] hash_list pages_of(const std::vector<field_ref>& fields);

/// Errors: `not_found`, `invalid_mesh`.
[[nodiscard]] expected<field> open_field(const field_ref& ref, const page_set& pages);

/// Bytes cut into pages of at most `max_page_bytes`.
[[nodiscard]] std::vector<page_ptr> cut(std::span<const char> bytes);

/// The inverse of `cut`. Errors: `not_found`, `protocol_error` when the sizes do not add up.
[[nodiscard]] expected<std::vector<char>> join(const hash_list& ids, std::uint64_t size,
                                               const page_set& pages);

}  // namespace tedit::actors
