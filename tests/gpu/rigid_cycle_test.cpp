// SPDX-License-Identifier: AGPL-3.0-or-later
// The kernels on levels of rigid motions.
#include "fem/vulkan/row_operator.hpp"
#include "tests/gpu/kernel_test.hpp"

namespace tedit::fem::vulkan {
namespace {

/// 6 x 6, column by column.
using block6 = std::array<float, 36>;

/// `factor` times the permutation that takes each motion to the next one.
block6 shift(float factor) {
  block6 result{};
  for (std::size_t c = 0; c < 6; ++c)
    result[6 * c + (c + 1) % 6] = factor;
  return result;
}

class RigidCycleKernels : public kernel_test {
protected:
  using pair = std::array<std::uint32_t, 2>;

  /// One row: 1 shift at column 0 and 2 shifts at column 1; x = 1 ... 6 and 10 ... 60.
  void run_rows(std::uint32_t mode, const row_buffers& others, const row_push& push) {
    const auto table = put(std::vector<pair>{{0, 2}});
    const auto columns = put(std::vector<std::uint32_t>{0, 1});
    const auto blocks = put(std::vector<block6>{shift(1), shift(2)});
    const auto x = put(vectors{{1, 2, 3, 0}, {4, 5, 6, 0}, {10, 20, 30, 0}, {40, 50, 60, 0}});
    auto at = others;
    at.x = &x;
    run(kernels().rigid_cycle_rows[mode],
        at.with({{rigid_cycle_at::table, &table},
                 {rigid_cycle_at::columns, &columns},
                 {rigid_cycle_at::blocks, &blocks}}),
        push);
  }
};

TEST_F(RigidCycleKernels, RowsMultiply) {
  const auto y = put(vectors(2));

  run_rows(TEDIT_MULTIPLY, {.r = &y}, {.rows = 1});

  EXPECT_EQ(get(y, 2), (vectors{{6 + 120, 1 + 20, 2 + 40, 0}, {3 + 60, 4 + 80, 5 + 100, 0}}));
}

TEST_F(RigidCycleKernels, RowsLeaveTheResidual) {
  const auto r = put(vectors{{126, 21, 42, 0}, {64, 86, 108, 0}});
  const auto left = put(vectors(2));

  run_rows(TEDIT_RESIDUAL, {.r = &r, .next = &left}, {.rows = 1});

  EXPECT_EQ(get(left, 2), (vectors{{0, 0, 0, 0}, {1, 2, 3, 0}}));
}

TEST_F(RigidCycleKernels, RowsTakeAChebyshevStep) {
  const auto r = put(vectors{{126, 21, 42, 0}, {64, 86, 108, 0}});
  const auto inverse = put(std::vector<block6>{shift(1)});
  const auto step = put(vectors(2));
  const auto z = put(vectors{{100, 100, 100, 0}, {100, 100, 100, 0}});

  run_rows(TEDIT_MOVE, {.r = &r, .diagonal = &inverse, .next = &step, .z = &z},
           {.rows = 1, .before = 1, .fresh = 10, .enter = 1});

  // What is left is (0 0 0 1 2 3), shifted (3 0 0 0 1 2); the old step is (1 2 3 4 5 6).
  EXPECT_EQ(get(r, 2), (vectors{{0, 0, 0, 0}, {1, 2, 3, 0}}));
  EXPECT_EQ(get(step, 2), (vectors{{31, 2, 3, 0}, {4, 15, 26, 0}}));
  EXPECT_EQ(get(z, 2), (vectors{{132, 104, 106, 0}, {108, 120, 132, 0}}));
}

TEST_F(RigidCycleKernels, StartTakesTheFirstStepFromZero) {
  const auto right = put(vectors{{1, 2, 3, 0}, {4, 5, 6, 0}});
  const auto inverse = put(std::vector<block6>{shift(1)});
  const auto r = put(vectors(2));
  const auto step = put(vectors(2));
  const auto z = put(vectors(2));

  run(kernels().rigid_cycle_start,
      row_buffers{.x = &right, .r = &r, .diagonal = &inverse, .next = &step, .z = &z}.with(),
      row_push{.rows = 1, .fresh = 2});

  EXPECT_EQ(get(r, 2), (vectors{{1, 2, 3, 0}, {4, 5, 6, 0}}));
  EXPECT_EQ(get(step, 2), (vectors{{12, 2, 4, 0}, {6, 8, 10, 0}}));
  EXPECT_EQ(get(z, 2), get(step, 2));
}

TEST_F(RigidCycleKernels, CoarsestMultipliesWithTheDenseInverse) {
  // Entry k of row i lies at 6 k + i and has columns 3 k to 3 k + 2: the identity but for column 5
  // of row 0.
  vectors dense(12);
  for (std::size_t i = 0; i < 6; ++i)
    dense[6 * (i / 3) + i][i % 3] = 1;
  dense[6][2] = 10;
  const auto inverse = put(dense);
  const auto right = put(vectors{{1, 2, 3, 0}, {4, 5, 6, 0}});
  const auto z = put(vectors(2));

  run(kernels().rigid_cycle_coarsest,
      row_buffers{.x = &right, .z = &z}.with({{rigid_cycle_at::inverse, &inverse}}),
      row_push{.rows = 6, .halves = 2});

  EXPECT_EQ(get(z, 2), (vectors{{61, 2, 3, 0}, {4, 5, 6, 0}}));
}

}  // namespace
}  // namespace tedit::fem::vulkan
