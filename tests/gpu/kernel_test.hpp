// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "fem/vulkan/memory.hpp"
#include "fem/vulkan/program.hpp"
#include "gpu/device.hpp"

namespace tedit::fem::vulkan {

/// One kernel on numbers that can be checked by hand.
class kernel_test : public ::testing::Test {
protected:
  using vectors = std::vector<device_float4>;

  void SetUp() override {
    if (list_vulkan_devices().empty())
      GTEST_SKIP() << "no Vulkan device on this machine";
    before_ = gpu::device::validation_messages();
    store_ = *kernel_store::make(*gpu::device::open(""), {.group_size = 4, .slice_rows = 1});
    memory_.emplace(kernels().layout, vulkan_settings{});
  }

  void TearDown() override { EXPECT_EQ(gpu::device::validation_messages(), before_); }

  [[nodiscard]] const kernel_set& kernels() const { return store_->for_one(); }

  template <class T>
  [[nodiscard]] gpu::buffer put(const std::vector<T>& values) {
    return memory_->put(values);
  }
  /// S or B, the same at each of so many nodes: xx, xy, xz, yy, yz, zz.
  [[nodiscard]] gpu::buffer blocks(std::size_t nodes, const std::array<double, 6>& block) {
    return put(std::vector<std::array<float, 8>>(nodes, packed_six(block.data(), 1)));
  }

  template <class T = device_float4>
  [[nodiscard]] std::vector<T> get(const gpu::buffer& from, std::size_t count) const {
    std::vector<T> values(count);
    EXPECT_TRUE(memory_->download(from, values).has_value());
    return values;
  }

  void run(const gpu::kernel& kernel, const device_program::places& at,
           const push_constants& push) {
    ASSERT_TRUE(memory_->status().has_value());
    device_program program(kernels());
    program.add(kernel, at, push);
    ASSERT_TRUE(program.record().has_value());
    ASSERT_TRUE(program.run().has_value());
  }

private:
  int before_ = 0;
  std::shared_ptr<kernel_store> store_;
  std::optional<device_memory> memory_;
};

}  // namespace tedit::fem::vulkan
