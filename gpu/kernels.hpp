// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gpu/buffer.hpp"

namespace tedit::gpu {

/// A family of compute kernels that share one layout: `bindings` storage buffers in set 0, the same
/// buffers behind them as uniform texel buffers (binding i again at `bindings` + i), and a block of
/// push constants.
class kernel_layout {
public:
  [[nodiscard]] static expected<std::shared_ptr<kernel_layout>> make(std::shared_ptr<device> on,
                                                                     std::uint32_t bindings,
                                                                     std::uint32_t push_bytes);
  ~kernel_layout();
  kernel_layout(const kernel_layout&) = delete;
  kernel_layout& operator=(const kernel_layout&) = delete;

  [[nodiscard]] VkPipelineLayout handle() const { return layout_; }
  [[nodiscard]] VkDescriptorSetLayout set_handle() const { return set_layout_; }
  [[nodiscard]] std::uint32_t bindings() const { return bindings_; }
  [[nodiscard]] std::uint32_t push_bytes() const { return push_bytes_; }
  [[nodiscard]] const std::shared_ptr<device>& on() const { return device_; }

private:
  kernel_layout() = default;

  std::shared_ptr<device> device_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  std::uint32_t bindings_ = 0;
  std::uint32_t push_bytes_ = 0;
};

/// Room for a known number of sets of buffers.
class binding_pool {
public:
  [[nodiscard]] static expected<binding_pool> make(std::shared_ptr<kernel_layout> layout,
                                                   std::uint32_t most_sets);
  binding_pool(binding_pool&& other) noexcept;
  binding_pool& operator=(binding_pool&&) = delete;
  binding_pool(const binding_pool&) = delete;
  ~binding_pool();

  /// A set with the given buffers at bindings 0, 1, ... Lives as long as the pool.
  [[nodiscard]] expected<VkDescriptorSet> bind(std::span<const buffer* const> buffers);

private:
  binding_pool() = default;

  std::shared_ptr<kernel_layout> layout_;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
};

/// One compiled kernel. Specialisation constants 0, 1, ... take `constants`.
class kernel {
public:
  [[nodiscard]] static expected<kernel> make(std::shared_ptr<kernel_layout> layout,
                                             std::span<const std::uint32_t> spirv,
                                             const std::vector<std::uint32_t>& constants);
  kernel() = default;
  kernel(kernel&& other) noexcept { *this = std::move(other); }
  kernel& operator=(kernel&& other) noexcept;
  kernel(const kernel&) = delete;
  kernel& operator=(const kernel&) = delete;
  ~kernel();

  [[nodiscard]] VkPipeline handle() const { return pipeline_; }

private:
  std::shared_ptr<kernel_layout> layout_;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

/// Commands recorded once and submitted any number of times. Every dispatch sees what the ones
/// before it wrote.
class commands {
public:
  [[nodiscard]] static expected<commands> begin(std::shared_ptr<kernel_layout> layout);
  commands(commands&& other) noexcept;
  commands& operator=(commands&&) = delete;
  commands(const commands&) = delete;
  ~commands();

  void use(VkDescriptorSet set);
  void dispatch(const kernel& k, std::uint32_t groups, const void* push);
  /// Group counts come from `counts` (three uint32 at `offset`), written by an earlier dispatch:
  /// zero skips.
  void dispatch_indirect(const kernel& k, const buffer& counts, std::uint64_t offset,
                         const void* push);
  void copy(const buffer& from, const buffer& to, std::span<const VkBufferCopy> regions);
  [[nodiscard]] expected<void> end();

  /// Submits and waits. Errors: those of `run_in_order`.
  [[nodiscard]] expected<void> run();

  /// Submits all of `list` at once, to be worked off one after the other, and waits; entries may
  /// repeat, none is empty. Errors: `device_lost` (also when nothing comes back within 60 s; then
  /// the device is given up), `out_of_memory`.
  [[nodiscard]] static expected<void> run_in_order(std::span<const commands* const> list);

private:
  commands() = default;
  void barrier();
  [[nodiscard]] expected<void> wait() const;

  std::shared_ptr<kernel_layout> layout_;
  VkCommandBuffer buffer_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
};

/// Copies to and from device buffers through a staging buffer, in pieces of 4 MiB; asks
/// `check_cancelled` (base/guard.hpp) before each.
[[nodiscard]] expected<void> upload(const std::shared_ptr<kernel_layout>& layout, buffer& to,
                                    std::span<const std::byte> bytes);
/// Bytes of a list that belong at a place in a device buffer.
struct patch {
  const buffer* to = nullptr;
  std::uint64_t to_offset = 0;
  std::uint64_t from_offset = 0;  ///< In the list.
  std::uint64_t bytes = 0;
};
/// Puts all patches in place in one submission. Those of one buffer stand together in `patches` and
/// do not overlap.
[[nodiscard]] expected<void> upload(const std::shared_ptr<kernel_layout>& layout,
                                    std::span<const patch> patches,
                                    std::span<const std::byte> bytes);
[[nodiscard]] expected<void> download(const std::shared_ptr<kernel_layout>& layout,
                                      const buffer& from, std::span<std::byte> bytes);

}  // namespace tedit::gpu
