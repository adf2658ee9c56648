// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gpu/kernels.hpp"

#include <cstdlib>
#include <cstring>
#include <numeric>

#include <gtest/gtest.h>

namespace tedit::gpu {
namespace {

TEST(Device, AnUnknownNameIsAnError) {
  const auto opened = device::open("no such device");

  ASSERT_FALSE(opened.has_value());
  EXPECT_EQ(opened.error().code, ec::device_unavailable);
}

/// All other tests of devices skip themselves without one, so this one must not.
TEST(Device, ThereIsOneToTestWith) {
  if (std::getenv("TEDIT_WITHOUT_VULKAN"))
    GTEST_SKIP() << "TEDIT_WITHOUT_VULKAN is set: no device is tested";
  EXPECT_FALSE(device::list().empty())
    << "no Vulkan device: install mesa-vulkan-drivers (scripts/install_deps.sh does), or set "
       "TEDIT_WITHOUT_VULKAN to go without these tests";
}

TEST(Device, BytesSurviveTheWayThereAndBack) {
  if (device::list().empty())
    GTEST_SKIP() << "no Vulkan device on this machine";
  const auto on = *device::open("");
  const auto layout = *kernel_layout::make(on, 1, 16);
  // More than one staging piece, and no multiple of it.
  std::vector<std::uint32_t> there(9'000'001);
  std::iota(there.begin(), there.end(), 1u);
  auto kept = buffer::make(on, 4 * there.size(), buffer::place::device);
  ASSERT_TRUE(kept.has_value());
  std::vector<std::uint32_t> back(there.size());

  ASSERT_TRUE(upload(layout, *kept, std::as_bytes(std::span(there))).has_value());
  ASSERT_TRUE(download(layout, *kept, std::as_writable_bytes(std::span(back))).has_value());

  EXPECT_EQ(back, there);
}

TEST(Device, AnImpossibleAllocationIsRefusedWithItsSize) {
  if (device::list().empty())
    GTEST_SKIP() << "no Vulkan device on this machine";
  const auto on = *device::open("");

  const auto huge = buffer::make(on, std::uint64_t{1} << 46, buffer::place::device);

  ASSERT_FALSE(huge.has_value());
}

}  // namespace
}  // namespace tedit::gpu
