// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/rigid_levels.hpp"

/// From nodes to the first level of rigid motions; internal to fem/multilevel/.
namespace tedit::fem {

[[nodiscard]] bool is_held(const std::array<double, 6>& filter);
[[nodiscard]] bool is_free(const std::array<double, 6>& filter);

/// |K_ij| in the Frobenius norm, of an entry of `k`.
[[nodiscard]] float block_norm(const block_matrix& k, std::uint32_t entry);
/// 1 / sqrt(|K_ii|); 0 for a row without entries.
[[nodiscard]] float coupling_scale(const block_matrix& k, std::size_t row);

[[nodiscard]] rigid_frame frame_of(const problem& p, std::span<const std::uint32_t> nodes);

/// Stores arm and filter of a node of an aggregate; the first node that is not free makes room for
/// the filters of all.
void store_transfer(const problem& p, filter_span filter, const rigid_frame& frame,
                    std::uint32_t node, hierarchy& h);

/// The rows `rows` of the first coarse matrix P^T K P, ascending, and the projectors onto the
/// motions that their aggregates have; members, arms and filters of all aggregates are there, and
/// are the ones that the cycle multiplies with. Cost: their nodes' entries, on all cores.
void make_galerkin_rows(const block_matrix& k, std::span<const std::uint32_t> rows, hierarchy& h);

}  // namespace tedit::fem
