// SPDX-License-Identifier: AGPL-3.0-or-later
// Products of quadratic tets on a Vulkan device against the native ones.
#include "fem/vulkan/quadratic.hpp"
#include "fem/native/quadratic.hpp"
#include "tests/gpu/bent_bar.hpp"
#include "tests/gpu/kernel_test.hpp"

namespace tedit::fem::vulkan {
namespace {

using test::bent_bar;
using test::expect_near_all;
using test::wave;

class QuadraticKernels : public kernel_test {
protected:
  /// With elements in one range or in several.
  std::vector<double> product(const std::vector<double>& u, std::uint64_t most_bytes) {
    device_memory memory(kernels().layout, {.most_bytes_per_binding = most_bytes});
    const quadratic_operator k(kernels(), memory, p_, scale_);
    const auto x = memory.put(packed3(u, 1));
    const auto y = memory.room(16 * p_.node_count());
    const auto partials = memory.room(4 * std::uint64_t{k.most_partials(kernels())});
    EXPECT_TRUE(memory.status().has_value());
    device_program program(kernels());
    k.add(program, TEDIT_MULTIPLY, {.x = &x, .r = &y, .partials = &partials}, {});
    EXPECT_TRUE(program.record().has_value());
    EXPECT_TRUE(program.run().has_value());
    std::vector<device_float4> packed(p_.node_count());
    EXPECT_TRUE(memory.download(y, packed).has_value());
    std::vector<double> result(p_.dofs());
    unpack3(packed, scale_.matrix(), result);
    return result;
  }

  std::vector<double> native_product(const std::vector<double>& u) const {
    const native::quadratic_operator k(p_);
    std::vector<float> x(padded3(p_.node_count()));
    std::ranges::copy(u, x.begin());
    std::vector<double> result(p_.dofs());
    for_rows(k, x.data(), [&](std::size_t i, float4 row) {
      for (std::size_t c = 0; c < 3; ++c)
        result[3 * i + c] = static_cast<double>(row[c]);
    });
    return result;
  }

  problem p_ = bent_bar(2, {2, 3, 4});
  device_scale scale_{p_};
};

TEST_F(QuadraticKernels, ProductIsAsTheNativeOne) {
  const auto u = wave(p_.dofs(), 0.7);

  const auto y = native_product(u);

  expect_near_all(product(u, 0), y, 2e-6);
  expect_near_all(product(u, 4'000), y, 2e-6);
}

TEST_F(QuadraticKernels, TranslationsTakeNoForce) {
  std::vector<double> u(p_.dofs());
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] = std::array{0.3, -7.0, 1e3}[i % 3];

  for (const double force : product(u, 0))
    ASSERT_EQ(force, 0);
}

}  // namespace
}  // namespace tedit::fem::vulkan
