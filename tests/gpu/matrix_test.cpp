// SPDX-License-Identifier: AGPL-3.0-or-later
// The matrix of linear tets on a Vulkan device as smoothers read it, against the native one.
#include "fem/vulkan/matrix.hpp"
#include "fem/multilevel/block_rows.hpp"
#include "gpu/device.hpp"
#include "tests/gpu/bent_bar.hpp"

namespace tedit::fem::vulkan {
namespace {

using test::bent_bar;
using test::largest;
using test::wave;

class VulkanMatrix : public ::testing::Test {
protected:
  void SetUp() override {
    if (list_vulkan_devices().empty())
      GTEST_SKIP() << "no Vulkan device on this machine";
    before_ = gpu::device::validation_messages();
    on_ = *gpu::device::open("");
    vulkan_settings settings;
    settings.slice_rows = 8;
    settings.most_bytes_per_binding = 40'000;  // many pieces
    kernels_ = *kernel_store::make(on_, settings);
    memory_ = std::make_unique<device_memory>(kernels_->for_one().layout, settings);
    k_ = assemble_blocks(p_, incidence(p_));
    matrix_ = std::make_unique<sliced_matrix>(kernels_->for_one(), *memory_, k_, scale_);
    ASSERT_TRUE(memory_->status().has_value());
    x_ = wave(p_.dofs(), 0.7);
  }

  void TearDown() override { EXPECT_EQ(gpu::device::validation_messages(), before_); }

  /// K x as smoothers read it: what a residual of nothing, unfiltered, is.
  std::vector<double> smoothed_product() {
    const std::array<double, 6> one{1, 0, 0, 1, 0, 1};
    const auto x = memory_->put(packed3(x_, 1));
    const auto r = memory_->put(std::vector<device_float4>(p_.node_count()));
    const auto filter =
      memory_->put(std::vector<std::array<float, 8>>(p_.node_count(), packed_six(one.data(), 1)));
    EXPECT_TRUE(memory_->status().has_value());
    device_program program(kernels_->for_one());
    matrix_->add(program, TEDIT_RESIDUAL, {.x = &x, .r = &r, .diagonal = &filter}, {});
    EXPECT_TRUE(program.record().has_value());
    EXPECT_TRUE(program.run().has_value());
    std::vector<device_float4> packed(p_.node_count());
    EXPECT_TRUE(memory_->download(r, packed).has_value());
    std::vector<double> y(p_.dofs());
    unpack3(packed, -scale_.matrix(), y);
    return y;
  }

  template <class Values>
  std::vector<double> native_product() const {
    std::vector<float> x(x_.begin(), x_.end());
    x.push_back(0);
    std::vector<double> y(p_.dofs());
    for (std::size_t i = 0; i < k_.rows(); ++i) {
      const float4 row = row_of<Values>(k_, i, x.data(), one_case{});
      for (std::size_t c = 0; c < 3; ++c)
        y[3 * i + c] = static_cast<double>(row[c]);
    }
    return y;
  }

  /// Rows whose slice is marked as these exact products are, all others as rounded ones.
  void expect_exact(std::span<const std::uint8_t> marked_rows) {
    const auto y = smoothed_product();
    const auto exact = native_product<exact_values>();
    const auto rounded = native_product<rounded_values>();
    const double same = 2e-6 * largest(exact);
    std::size_t told_apart = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const auto first = i / 3 / 8 * 8;
      const auto slice = marked_rows.subspan(first, std::min<std::size_t>(8, k_.rows() - first));
      const bool is_exact = std::ranges::find(slice, 1) != slice.end();
      ASSERT_NEAR(y[i], is_exact ? exact[i] : rounded[i], same) << i;
      told_apart += std::abs(exact[i] - rounded[i]) > 2 * same ? 1 : 0;
    }
    EXPECT_GE(told_apart, y.size() / 2);
  }

  std::vector<std::uint8_t> rows_marked(std::initializer_list<std::size_t> rows) const {
    std::vector<std::uint8_t> result(k_.rows(), 0);
    for (const auto row : rows)
      result[row] = 1;
    return result;
  }

  int before_ = 0;
  problem p_ = bent_bar(1);
  device_scale scale_{p_};
  std::shared_ptr<gpu::device> on_;
  std::shared_ptr<kernel_store> kernels_;
  std::unique_ptr<device_memory> memory_;
  block_matrix k_;
  std::unique_ptr<sliced_matrix> matrix_;
  std::vector<double> x_;
};

TEST_F(VulkanMatrix, SmoothersReadExactlyUntilTheyAreToldOtherwise) {
  expect_exact(std::vector<std::uint8_t>(k_.rows(), 1));
}

TEST_F(VulkanMatrix, SmoothersReadRoundedValues) {
  ASSERT_TRUE(matrix_->read_exactly({}).has_value());

  expect_exact(rows_marked({}));
}

TEST_F(VulkanMatrix, SmoothersReadMarkedRowsAndThoseBesideThemExactly) {
  const auto marked = rows_marked({0, 99, 100, 400, k_.rows() - 1});

  ASSERT_TRUE(matrix_->read_exactly(marked).has_value());

  expect_exact(marked);
}

TEST_F(VulkanMatrix, MarksFollowAnEdit) {
  ASSERT_TRUE(matrix_->read_exactly(rows_marked({8, 300})).has_value());
  const auto now = rows_marked({16, 300, 500});
  device_changes changes;

  matrix_->update(k_, {}, now, changes);

  ASSERT_TRUE(changes.fits());
  EXPECT_EQ(changes.bytes(), 8 * (2 + 1));  // 8 and 16 are neighbouring slices; 300 stays
  ASSERT_TRUE(memory_->send(changes).has_value());
  expect_exact(now);
}

TEST_F(VulkanMatrix, ScalesArePowersOfTwo) {
  int exponent = 0;
  EXPECT_EQ(std::frexp(scale_.size, &exponent), 0.5);
  EXPECT_EQ(std::frexp(scale_.stiffness, &exponent), 0.5);
}

}  // namespace
}  // namespace tedit::fem::vulkan
