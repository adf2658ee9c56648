// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/backend.hpp"

#include "base/guard.hpp"
#include "fem/vulkan/system.hpp"

namespace tedit::fem {

namespace {

device_info describe(const gpu::device_summary& summary) {
  device_info info;
  info.name = summary.name;
  info.kind = summary.kind;
  info.driver = summary.driver;
  info.memory_bytes = summary.memory_bytes;
  return info;
}

class vulkan_backend final : public backend {
public:
  vulkan_backend(std::shared_ptr<gpu::device> on, const vulkan_settings& settings)
      : device_(std::move(on)), settings_(settings), info_(describe(device_->summary())) {}

  const device_info& info() const override { return info_; }

  expected<std::unique_ptr<linear_system>> assemble(const problem& p,
                                                    const execution& run) override {
    return guarded(run, [&]() -> expected<std::unique_ptr<linear_system>> {
      if (!kernels_) {
        auto made = vulkan::kernel_store::make(device_, settings_);
        if (!made)
          return fail(made.error());
        kernels_ = std::move(*made);
      }
      return vulkan::system::make(device_, kernels_, p, settings_, run);
    });
  }

private:
  std::shared_ptr<gpu::device> device_;
  vulkan_settings settings_;
  device_info info_;
  std::shared_ptr<vulkan::kernel_store> kernels_;  ///< Made with the first system.
};

}  // namespace

expected<std::unique_ptr<backend>> open_vulkan(const std::string& part,
                                               const vulkan_settings& settings) {
  auto opened = gpu::device::open(part == "lavapipe" ? "llvmpipe" : part);
  if (!opened)
    return fail(opened.error());
  return std::make_unique<vulkan_backend>(std::move(*opened), settings);
}

std::vector<device_info> list_vulkan_devices() {
  std::vector<device_info> result;
  for (const auto& summary : gpu::device::list())
    result.push_back(describe(summary));
  return result;
}

}  // namespace tedit::fem
