// SPDX-License-Identifier: AGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bench/spmv.hpp"
#include "fem/vulkan/quadratic.hpp"
#include "kernels/copy.h"

namespace tedit::bench {

namespace {

using fem::vulkan::device_float4;

constexpr std::uint64_t node_bytes = sizeof(device_float4);

class vulkan_probe final : public product_probe {
public:
  explicit vulkan_probe(std::shared_ptr<fem::vulkan::kernel_store> kernels)
      : store_(std::move(kernels)), memory_(kernels_.layout, {}) {}

  expected<void> make(const fem::problem& p, std::uint64_t copy_bytes) {
    const fem::vulkan::device_scale scale(p);
    auto made = p.element_order == 1 ? make_linear(p, scale) : make_quadratic(p, scale);
    if (!made)
      return made;
    if (auto ok = record_product(p.node_count()); !ok)
      return ok;
    return record_copy(copy_bytes ? copy_bytes : bytes_);
  }

  double product_bytes() const override { return static_cast<double>(bytes_); }
  double copy_bytes() const override { return 2.0 * static_cast<double>(from_.bytes()); }
  expected<void> multiply(int times) override { return product_->run(times); }
  expected<void> copy(int times) override { return copy_->run(times); }

private:
  /// Blocks with their padding, two numbers a slice, x and y.
  expected<void> make_linear(const fem::problem& p, const fem::vulkan::device_scale& scale) {
    auto made = std::make_unique<fem::vulkan::sliced_matrix>(
      kernels_, memory_, fem::assemble_blocks(p, fem::incidence(p)), scale);
    if (auto ok = memory_.status(); !ok)
      return ok;
    bytes_ = made->read_bytes() + 2 * node_bytes * p.node_count();
    k_ = std::move(made);
    return {};
  }

  /// Elements and lists once, forces written and read; x, x again beside the rows, and y. Sums of
  /// earlier ranges are left out: they are written and read once for each range but the first.
  expected<void> make_quadratic(const fem::problem& p, const fem::vulkan::device_scale& scale) {
    k_ = std::make_unique<fem::vulkan::quadratic_operator>(kernels_, memory_, p, scale);
    if (auto ok = memory_.status(); !ok)
      return ok;
    const std::uint64_t elements = p.element_count();
    const std::uint64_t nodes = p.node_count();
    constexpr std::uint64_t force_bytes = 10 * node_bytes;
    const std::uint64_t in_range = std::min(elements, memory_.most_per_piece() / force_bytes);
    const std::uint64_t ranges = (elements + in_range - 1) / in_range;
    const std::uint64_t sums = ranges > 1 ? node_bytes * nodes : node_bytes;
    bytes_ = memory_.bytes() - force_bytes * in_range - sums + 2 * force_bytes * elements +
             (ranges + 2 + 2 * (ranges - 1)) * node_bytes * nodes;
    return {};
  }

  expected<void> record_product(std::size_t nodes) {
    std::vector<device_float4> x(nodes);
    for (std::size_t n = 0; n < nodes; ++n)
      for (std::size_t i = 0; i < 3; ++i)
        x[n][i] = static_cast<float>(std::sin(0.1 * static_cast<double>(3 * n + i)));
    x_ = memory_.put(x);
    y_ = memory_.room(node_bytes * nodes);
    partials_ = memory_.room(4 * std::uint64_t{k_->most_partials(kernels_)});
    if (auto ok = memory_.status(); !ok)
      return ok;
    product_.emplace(kernels_);
    k_->add(*product_, TEDIT_MULTIPLY, {.x = &x_, .r = &y_, .partials = &partials_}, {});
    return product_->record();
  }

  expected<void> record_copy(std::uint64_t bytes) {
    auto made =
      gpu::kernel::make(kernels_.layout, copy_spirv, {kernels_.group_size, kernels_.slice_rows, 0});
    if (!made)
      return fail(made.error());
    copy_kernel_ = std::move(*made);
    const auto half = std::min(bytes / 2, memory_.most_per_piece()) / node_bytes * node_bytes;
    from_ = memory_.put(std::vector<device_float4>(half / node_bytes, device_float4{1, 2, 3, 4}));
    to_ = memory_.room(half);
    if (auto ok = memory_.status(); !ok)
      return ok;
    const auto rows = static_cast<std::uint32_t>(half / node_bytes);
    copy_.emplace(kernels_);
    copy_->add(copy_kernel_, {{0, &from_}, {1, &to_}}, fem::vulkan::row_push{.rows = rows});
    return copy_->record();
  }

  // What is recorded last goes first.
  std::shared_ptr<fem::vulkan::kernel_store> store_;
  const fem::vulkan::kernel_set& kernels_ = store_->for_one();
  fem::vulkan::device_memory memory_;
  std::unique_ptr<fem::vulkan::row_operator> k_;
  gpu::kernel copy_kernel_;
  gpu::buffer x_, y_, partials_, from_, to_;
  std::optional<fem::vulkan::device_program> product_, copy_;
  std::uint64_t bytes_ = 0;
};

}  // namespace

expected<std::unique_ptr<product_probe>> probe_vulkan(const std::string& device,
                                                      const fem::problem& p,
                                                      std::uint64_t copy_bytes) {
  auto on = gpu::device::open(device == "lavapipe" ? "llvmpipe" : device);
  if (!on)
    return fail(on.error());
  auto kernels = fem::vulkan::kernel_store::make(*on, {});
  if (!kernels)
    return fail(kernels.error());
  auto probe = std::make_unique<vulkan_probe>(std::move(*kernels));
  if (auto ok = probe->make(p, copy_bytes); !ok)
    return fail(ok.error());
  return probe;
}

}  // namespace tedit::bench
