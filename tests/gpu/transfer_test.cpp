// SPDX-License-Identifier: AGPL-3.0-or-later
// The kernels between levels: nodes and aggregates (cycle), all nodes and corners
// (quadratic_cycle).
#include "tests/gpu/kernel_test.hpp"

namespace tedit::fem::vulkan {
namespace {

using pair = std::array<std::uint32_t, 2>;
using word4 = std::array<std::uint32_t, 4>;

constexpr std::uint32_t no_aggregate = 0xFFFFFFFF;

std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

class CycleKernels : public kernel_test {};

TEST_F(CycleKernels, RestrictSumsForceAndMoment) {
  const auto table = put(std::vector<pair>{{0, 2}, {2, 3}});
  const auto members = put(std::vector<std::uint32_t>{0, 2, 1});
  const auto arms = put(std::vector<word4>{{bits(0), bits(0), bits(1), 0},
                                           {bits(0), bits(0), bits(0), 1},
                                           {bits(2), bits(0), bits(0), 0}});
  const auto residual = put(vectors{{1, 0, 0, 0}, {7, 8, 9, 0}, {0, 3, 0, 0}});
  const auto right = put(vectors(4));

  run(kernels().cycle_restrict,
      {{cycle_at::table, &table},
       {cycle_at::members, &members},
       {cycle_at::arms, &arms},
       {cycle_at::residual, &residual},
       {cycle_at::right, &right}},
      cycle_push{.rows = 2});

  // (0 0 1) x (1 0 0) = (0 1 0); (2 0 0) x (0 3 0) = (0 0 6).
  EXPECT_EQ(get(right, 4), (vectors{{1, 3, 0, 0}, {0, 1, 6, 0}, {7, 8, 9, 0}, {}}));
}

TEST_F(CycleKernels, ProlongateMovesNodesWithTheirAggregate) {
  const auto arms = put(
    std::vector<word4>{{bits(0), bits(0), bits(1), 0}, {bits(0), bits(0), bits(1), no_aggregate}});
  const auto coarse = put(vectors{{1, 2, 3, 0}, {1, 0, 0, 0}});
  const auto s = blocks(2, {1, 0, 0, 1, 0, 0});
  const auto step = put(vectors{{9, 9, 9, 0}, {9, 9, 9, 0}});

  run(kernels().cycle_prolongate,
      {{cycle_at::arms, &arms},
       {cycle_at::coarse, &coarse},
       {cycle_at::filter, &s},
       {cycle_at::step, &step}},
      cycle_push{.rows = 2, .aggregates = 1, .over_correction = 2});

  // (1 0 0) x (0 0 1) = (0 -1 0); the filter holds z; who has no aggregate stays.
  EXPECT_EQ(get(step, 2), (vectors{{2, 2 * (2 - 1), 0, 0}, {}}));
}

class QuadraticCycleKernels : public kernel_test {};

TEST_F(QuadraticCycleKernels, RestrictAddsHalfTheMiddles) {
  // Corners 0 and 1, the middle 2 between them.
  const auto table = put(std::vector<pair>{{0, 1}, {1, 2}});
  const auto middles = put(std::vector<std::uint32_t>{2, 2});
  const auto residual = put(vectors{{1, 0, 0, 0}, {0, 1, 0, 0}, {2, 4, 6, 0}});
  const auto right = put(vectors(2));

  run(kernels().quadratic_cycle_restrict,
      {{quadratic_cycle_at::table, &table},
       {quadratic_cycle_at::middles, &middles},
       {quadratic_cycle_at::residual, &residual},
       {quadratic_cycle_at::right, &right}},
      quadratic_cycle_push{.rows = 2});

  EXPECT_EQ(get(right, 2), (vectors{{2, 2, 3, 0}, {1, 3, 3, 0}}));
}

TEST_F(QuadraticCycleKernels, ProlongateTakesTheMeanOfTheEnds) {
  const auto ends = put(std::vector<pair>{{0, 1}});
  const auto coarse = put(vectors{{2, 2, 2, 0}, {4, 6, 8, 0}});
  const auto s = blocks(3, {1, 0, 0, 1, 0, 0});
  const auto step = put(vectors(3));

  run(kernels().quadratic_cycle_prolongate,
      {{quadratic_cycle_at::ends, &ends},
       {quadratic_cycle_at::coarse, &coarse},
       {quadratic_cycle_at::filter, &s},
       {quadratic_cycle_at::step, &step}},
      quadratic_cycle_push{.rows = 3, .corners = 2});

  EXPECT_EQ(get(step, 3), (vectors{{2, 2, 2, 0}, {4, 6, 8, 0}, {3, 4, 0, 0}}));
}

}  // namespace
}  // namespace tedit::fem::vulkan
