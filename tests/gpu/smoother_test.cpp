// SPDX-License-Identifier: AGPL-3.0-or-later
// The kernels of a smoother of nodes that no product is part of.
#include "fem/vulkan/row_operator.hpp"
#include "tests/gpu/kernel_test.hpp"

namespace tedit::fem::vulkan {
namespace {

class SmootherKernels : public kernel_test {};

TEST_F(SmootherKernels, StartTakesTheFirstStepFromZero) {
  const auto right = put(vectors{{1, 2, 3, 0}});
  const auto b = blocks(1, {1, 1, 0, 2, 0, 3});
  const auto r = put(vectors{{}});
  const auto step = put(vectors{{}});
  const auto z = put(vectors{{}});

  run(kernels().smoother_start,
      row_buffers{.x = &right, .r = &r, .diagonal = &b, .next = &step, .z = &z}.with(),
      row_push{.rows = 1, .fresh = 2});

  EXPECT_EQ(get(r, 1), (vectors{{1, 2, 3, 0}}));
  EXPECT_EQ(get(step, 1), (vectors{{2 * (1 + 2), 2 * (1 + 2 * 2), 2 * 3 * 3, 0}}));
  EXPECT_EQ(get(z, 1), get(step, 1));
}

TEST_F(SmootherKernels, ClustersAddTheirDenseInverses) {
  // Nodes 0 and 2: the block of node 2 in the row of node 0 is [0 1 0; 0 0 1; 1 0 0], all others
  // are zero. The last row is none.
  using words = std::array<std::uint32_t, 12>;
  const auto one = std::bit_cast<std::uint32_t>(1.0F);
  const auto rows = put(std::vector<std::array<std::uint32_t, 4>>{{0, 0, 2}, {2, 2, 2}, {1, 0, 0}});
  const auto inverse = put(std::vector<words>{{0}, {2, 0, one, 0, 0, 0, one, one, 0, 0}, {0}, {2}});
  const auto r = put(vectors{{9, 9, 9, 0}, {9, 9, 9, 0}, {1, 2, 3, 0}});
  const auto step = put(vectors{{1, 1, 1, 0}, {1, 1, 1, 0}, {1, 1, 1, 0}});
  const auto z = put(vectors(3));

  run(kernels().smoother_clusters,
      row_buffers{.r = &r, .next = &step, .z = &z}.with(
        {{smoother_at::cluster_rows, &rows}, {smoother_at::cluster_blocks, &inverse}}),
      row_push{.rows = 3, .fresh = 2});

  EXPECT_EQ(get(step, 3), (vectors{{5, 7, 3, 0}, {1, 1, 1, 0}, {1, 1, 1, 0}}));
  EXPECT_EQ(get(z, 3), (vectors{{4, 6, 2, 0}, {}, {}}));
}

}  // namespace
}  // namespace tedit::fem::vulkan
