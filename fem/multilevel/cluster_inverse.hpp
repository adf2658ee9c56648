// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "fem/multilevel/hierarchy.hpp"

namespace tedit::fem {

/// The inverse of a cluster's matrix `m` (3 unknowns a node) within the free directions of its
/// nodes.
[[nodiscard]] std::vector<float> invert_cluster(Eigen::MatrixXd m, filter_span filter,
                                                std::span<const std::uint32_t> nodes);

}  // namespace tedit::fem
