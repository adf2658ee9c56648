// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/multilevel/block_rows.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "fem/multilevel/hierarchy.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::fem {
namespace {

std::uint32_t bits_of(float v) {
  return std::bit_cast<std::uint32_t>(v);
}

/// To eight bits of mantissa, halves away from zero.
float rounded(float v) {
  return std::bit_cast<float>((bits_of(v) + 0x8000U) & 0xFFFF0000U);
}

/// A block and one behind it, for it is read with what comes next.
struct split_blocks {
  std::array<half_block, 2> high{}, low{};

  explicit split_blocks(const std::array<float, 9>& v) {
    split_block({float4{v[0], v[1], v[2]}, float4{v[3], v[4], v[5]}, float4{v[6], v[7], v[8]}},
                high[0], low[0]);
  }
  [[nodiscard]] std::array<float4, 3> whole() const {
    const loaded_halves h(high[0]), l(low[0]);
    return {whole_column<0>(h, l), whole_column<1>(h, l), whole_column<2>(h, l)};
  }
  [[nodiscard]] std::array<float4, 3> upper() const {
    const loaded_halves h(high[0]);
    return {reinterpret_cast<float4>(upper_halves<0>(h)),
            reinterpret_cast<float4>(upper_halves<1>(h)),
            reinterpret_cast<float4>(upper_halves<2>(h))};
  }
};

TEST(SplitBlock, BothHalvesAreTheNumbersToTheBit) {
  for (const auto& v :
       {std::array<float, 9>{1, -1, 1.0F / 3, 0, -0.0F, 2.5e30F, -7e-30F, 1e-41F, 3},
        {1.00390625F, 1.003906F, -1.0039063F, 0.99999994F, 1.9999999F, 65504, -3.4028e37F,
         1.1754944e-38F, -0.1F}}) {
    const auto whole = split_blocks(v).whole();
    for (std::size_t i = 0; i < 9; ++i)
      EXPECT_EQ(bits_of(whole[i / 3][i % 3]), bits_of(v[i])) << v[i];
  }
}

TEST(SplitBlock, UpperHalvesAreRounded) {
  // Numbers at 1 are 2^-7 apart: 1 + 2^-9 goes down, 1 + 2^-8, in the middle, away from zero.
  const auto upper = split_blocks({1 + 1.0F / 512, 1 + 1.0F / 256, -1 - 1.0F / 256, 1 + 3.0F / 512,
                                   0, 256, 257, 259, -3})
                       .upper();
  const std::array<float, 9> expected{
    1, 1 + 1.0F / 128, -1 - 1.0F / 128, 1 + 1.0F / 128, 0, 256, 258, 260, -3};
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_EQ(upper[i / 3][i % 3], expected[i]) << i;
}

/// A bar, its matrix and a wavy displacement of each of several cases.
template <class L>
struct product_case {
  problem p = *make_problem(*test::box_mesh({7, 3, 3}, {2, 1, 1}),
                            {.materials = {{"steel", 210e9, 0.3, 7850, 0, {}}},
                             .constraints = {{{1}, fixed{}}},
                             .loads = {{{2}, force{{0, 0, -1000}}}}});
  block_matrix k = assemble_blocks(p, incidence(p));
  std::vector<float> x = std::vector<float>(L::size(p.node_count()), 0);

  product_case() {
    for (std::size_t i = 0; i < 3 * L::width * p.node_count(); ++i)
      x[i] = static_cast<float>(std::sin(0.7 * static_cast<double>(i)));
  }

  /// Row by row from blocks that `block_of(row, entry)` gives, in double precision; the largest
  /// difference to `y`, relative to the largest product.
  template <class BlockOf>
  [[nodiscard]] double difference(const std::vector<float>& y, const BlockOf& block_of) const {
    double worst = 0;
    double largest = 0;
    for (std::size_t i = 0; i < k.rows(); ++i)
      for (std::size_t lane = 0; lane < L::width; ++lane) {
        const auto at = [&](std::size_t n, std::size_t c) { return L::width * (3 * n + c) + lane; };
        std::array<double, 3> sum{};
        for (auto s = k.begin(i); s < k.end(i); ++s) {
          const std::array<float, 9> block = block_of(i, s);
          for (std::size_t e = 0; e < 9; ++e)
            sum[e % 3] += static_cast<double>(block[e]) *
                          static_cast<double>(x[at(k.column[s], e / 3)] - x[at(i, e / 3)]);
        }
        for (std::size_t c = 0; c < 3; ++c) {
          worst = std::max(worst, std::abs(sum[c] - static_cast<double>(y[at(i, c)])));
          largest = std::max(largest, std::abs(sum[c]));
        }
      }
    return worst / largest;
  }

  template <class Matrix>
  [[nodiscard]] std::vector<float> times(const Matrix& m) const {
    std::vector<float> y(x.size(), 0);
    for_rows<L>(m, x.data(),
                [&](std::size_t i, const typename L::node& row) { L::store(row, y.data(), i); });
    return y;
  }

  [[nodiscard]] std::array<float, 9> rounded_block(std::size_t entry) const {
    auto block = k.block(entry);
    std::ranges::transform(block, block.begin(), rounded);
    return block;
  }
};

template <class L>
class BlockRows : public testing::Test {};
using lane_types = testing::Types<one_case, cases_of<4>, cases_of<8>>;
TYPED_TEST_SUITE(BlockRows, lane_types);

TYPED_TEST(BlockRows, ExactProductsAreThoseOfTheBlocks) {
  const product_case<TypeParam> c;
  const auto y = c.times(c.k);
  EXPECT_LT(c.difference(y, [&](std::size_t, std::size_t s) { return c.k.block(s); }), 1e-6);
}

TYPED_TEST(BlockRows, SmoothersReadRoundedBlocks) {
  const product_case<TypeParam> c;
  const auto y = c.times(smoothed_matrix{c.k, {}});
  EXPECT_LT(c.difference(y, [&](std::size_t, std::size_t s) { return c.rounded_block(s); }), 1e-6);
  EXPECT_GT(c.difference(y, [&](std::size_t, std::size_t s) { return c.k.block(s); }), 1e-4);
}

TYPED_TEST(BlockRows, MarkedRowsAreExact) {
  const product_case<TypeParam> c;
  std::vector<std::uint8_t> exact(c.k.rows(), 0);
  exact[50] = exact[c.k.rows() - 1] = 1;
  const auto y = c.times(smoothed_matrix{c.k, exact});
  EXPECT_LT(c.difference(y,
                         [&](std::size_t i, std::size_t s) {
                           return exact[i] != 0 ? c.k.block(s) : c.rounded_block(s);
                         }),
            1e-6);
}

std::ptrdiff_t exact_rows(const hierarchy& h) {
  return std::ranges::count(h.exact_rows, 1);
}

TEST(ExactRows, AreThoseAtSliversInSoftMaterialAndAllAfterDistrust) {
  const auto of = [](const version_ptr& mesh, double poisson) {
    return *make_problem(*mesh, {.materials = {{"m", 1e9, poisson, 1000, 0, {}}},
                                 .constraints = {{{1}, fixed{}}},
                                 .loads = {{{2}, force{{0, 0, -1}}}}});
  };
  const auto built = [](const problem& p) {
    return *build_hierarchy(p, assemble_blocks(p, incidence(p)), p.filter, {.rounded = true}, {});
  };
  const auto good = test::box_mesh({6, 4, 4}, {6, 4, 4});
  auto h = built(of(good, 0.3));
  EXPECT_EQ(exact_rows(h), 0);
  const auto bar = of(good, 0.3);
  const auto k = assemble_blocks(bar, incidence(bar));
  EXPECT_EQ(exact_rows(*build_hierarchy(bar, k, bar.filter, {}, {})), 175);
  raise_lambdas(h);
  EXPECT_EQ(exact_rows(h), 175);  // All of 7 x 5 x 5 vertices.
  EXPECT_EQ(exact_rows(built(of(good, 0.49))), 0);
  EXPECT_EQ(exact_rows(built(of(good, 0.499))), 175);

  // One inner node almost on top of its neighbour.
  const auto thin = test::box_mesh({6, 4, 4}, {6, 4, 4}, [](vec3 p) {
    return p.x == 3 && p.y == 2 && p.z == 2 ? p + vec3{0, 0, 0.999} : p;
  });
  const auto some = exact_rows(built(of(thin, 0.3)));
  EXPECT_GE(some, 4);
  EXPECT_LT(some, 175);
}

}  // namespace
}  // namespace tedit::fem
