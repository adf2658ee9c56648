// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gpu/kernels.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "base/guard.hpp"

namespace tedit::gpu {

// -- layout ----------------------------------------------------------------------------

expected<std::shared_ptr<kernel_layout>> kernel_layout::make(std::shared_ptr<device> on,
                                                             std::uint32_t bindings,
                                                             std::uint32_t push_bytes) {
  std::shared_ptr<kernel_layout> result(new kernel_layout);
  result->device_ = std::move(on);
  result->bindings_ = bindings;
  result->push_bytes_ = push_bytes;
  const auto& calls = result->device_->calls();
  const auto handle = result->device_->handle();
  std::vector<VkDescriptorSetLayoutBinding> rows(std::size_t{2} * bindings);
  for (std::uint32_t i = 0; i < rows.size(); ++i)
    rows[i] = {
      i, i < bindings ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER : VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER,
      1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo set{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  set.bindingCount = static_cast<std::uint32_t>(rows.size());
  set.pBindings = rows.data();
  if (const auto r = calls.vkCreateDescriptorSetLayout(handle, &set, nullptr, &result->set_layout_);
      r != VK_SUCCESS)
    return fail(to_error(r, "describing kernels"));
  const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, push_bytes};
  VkPipelineLayoutCreateInfo layout{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &result->set_layout_;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &range;
  if (const auto r = calls.vkCreatePipelineLayout(handle, &layout, nullptr, &result->layout_);
      r != VK_SUCCESS)
    return fail(to_error(r, "describing kernels"));
  return result;
}

kernel_layout::~kernel_layout() {
  if (device_->given_up())
    return;
  const auto& calls = device_->calls();
  if (layout_)
    calls.vkDestroyPipelineLayout(device_->handle(), layout_, nullptr);
  if (set_layout_)
    calls.vkDestroyDescriptorSetLayout(device_->handle(), set_layout_, nullptr);
}

// -- binding_pool ----------------------------------------------------------------------

expected<binding_pool> binding_pool::make(std::shared_ptr<kernel_layout> layout,
                                          std::uint32_t most_sets) {
  binding_pool result;
  result.layout_ = std::move(layout);
  const auto& on = *result.layout_->on();
  const auto each = result.layout_->bindings() * most_sets;
  const std::array<VkDescriptorPoolSize, 2> sizes{
    {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, each}, {VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, each}}};
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = most_sets;
  pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  if (const auto r = on.calls().vkCreateDescriptorPool(on.handle(), &pool, nullptr, &result.pool_);
      r != VK_SUCCESS)
    return fail(to_error(r, "describing kernels"));
  return result;
}

binding_pool::binding_pool(binding_pool&& other) noexcept
    : layout_(std::move(other.layout_)), pool_(std::exchange(other.pool_, VK_NULL_HANDLE)) {}

binding_pool::~binding_pool() {
  if (pool_ && !layout_->on()->given_up())
    layout_->on()->calls().vkDestroyDescriptorPool(layout_->on()->handle(), pool_, nullptr);
}

expected<VkDescriptorSet> binding_pool::bind(std::span<const buffer* const> buffers) {
  const auto& on = *layout_->on();
  const auto& calls = on.calls();
  const auto set_layout = layout_->set_handle();
  VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate.descriptorPool = pool_;
  allocate.descriptorSetCount = 1;
  allocate.pSetLayouts = &set_layout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  if (const auto r = calls.vkAllocateDescriptorSets(on.handle(), &allocate, &set); r != VK_SUCCESS)
    return fail(to_error(r, "binding buffers"));
  std::vector<VkDescriptorBufferInfo> infos(buffers.size());
  std::vector<VkBufferView> texels(buffers.size());
  std::vector<VkWriteDescriptorSet> writes;
  for (std::uint32_t i = 0; i < buffers.size(); ++i) {
    infos[i] = {buffers[i]->handle(), 0,
                std::min(buffers[i]->bytes(), on.limits().storage_buffer_range)};
    texels[i] = buffers[i]->texels();
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = i;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = &infos[i];
    writes.push_back(write);
    write.dstBinding = layout_->bindings() + i;
    write.descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    write.pTexelBufferView = &texels[i];
    writes.push_back(write);
  }
  calls.vkUpdateDescriptorSets(on.handle(), static_cast<std::uint32_t>(writes.size()),
                               writes.data(), 0, nullptr);
  return set;
}

// -- kernel ----------------------------------------------------------------------------

expected<kernel> kernel::make(std::shared_ptr<kernel_layout> layout,
                              std::span<const std::uint32_t> spirv,
                              const std::vector<std::uint32_t>& constants) {
  kernel result;
  result.layout_ = std::move(layout);
  const auto& on = *result.layout_->on();
  VkShaderModuleCreateInfo code{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  code.codeSize = spirv.size_bytes();
  code.pCode = spirv.data();
  VkShaderModule module = VK_NULL_HANDLE;
  if (const auto r = on.calls().vkCreateShaderModule(on.handle(), &code, nullptr, &module);
      r != VK_SUCCESS)
    return fail(to_error(r, "loading a kernel"));
  std::vector<VkSpecializationMapEntry> entries;
  for (std::uint32_t i = 0; i < constants.size(); ++i)
    entries.push_back({i, 4 * i, 4});
  const VkSpecializationInfo values{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                    4 * constants.size(), constants.data()};
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = module;
  info.stage.pName = "main";
  info.stage.pSpecializationInfo = &values;
  info.layout = result.layout_->handle();
  const auto r = on.calls().vkCreateComputePipelines(on.handle(), VK_NULL_HANDLE, 1, &info, nullptr,
                                                     &result.pipeline_);
  on.calls().vkDestroyShaderModule(on.handle(), module, nullptr);
  if (r != VK_SUCCESS)
    return fail(to_error(r, "loading a kernel"));
  return result;
}

kernel& kernel::operator=(kernel&& other) noexcept {
  std::swap(layout_, other.layout_);
  std::swap(pipeline_, other.pipeline_);
  return *this;
}

kernel::~kernel() {
  if (pipeline_ && !layout_->on()->given_up())
    layout_->on()->calls().vkDestroyPipeline(layout_->on()->handle(), pipeline_, nullptr);
}

// -- commands --------------------------------------------------------------------------

expected<commands> commands::begin(std::shared_ptr<kernel_layout> layout) {
  commands result;
  result.layout_ = std::move(layout);
  const auto& on = *result.layout_->on();
  VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocate.commandPool = on.pool();
  allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocate.commandBufferCount = 1;
  if (const auto r = on.calls().vkAllocateCommandBuffers(on.handle(), &allocate, &result.buffer_);
      r != VK_SUCCESS)
    return fail(to_error(r, "recording commands"));
  const VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, nullptr, 0};
  if (const auto r = on.calls().vkCreateFence(on.handle(), &fence, nullptr, &result.fence_);
      r != VK_SUCCESS)
    return fail(to_error(r, "recording commands"));
  const VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, nullptr,
                                      VK_COMMAND_BUFFER_USAGE_SIMULTANEOUS_USE_BIT, nullptr};
  if (const auto r = on.calls().vkBeginCommandBuffer(result.buffer_, &info); r != VK_SUCCESS)
    return fail(to_error(r, "recording commands"));
  return result;
}

commands::commands(commands&& other) noexcept
    : layout_(std::move(other.layout_)),
      buffer_(std::exchange(other.buffer_, VK_NULL_HANDLE)),
      fence_(std::exchange(other.fence_, VK_NULL_HANDLE)) {}

commands::~commands() {
  if (!layout_ || layout_->on()->given_up())
    return;
  const auto& on = *layout_->on();
  if (fence_)
    on.calls().vkDestroyFence(on.handle(), fence_, nullptr);
  if (buffer_)
    on.calls().vkFreeCommandBuffers(on.handle(), on.pool(), 1, &buffer_);
}

void commands::use(VkDescriptorSet set) {
  layout_->on()->calls().vkCmdBindDescriptorSets(buffer_, VK_PIPELINE_BIND_POINT_COMPUTE,
                                                 layout_->handle(), 0, 1, &set, 0, nullptr);
}

void commands::barrier() {
  VkMemoryBarrier all{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  all.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
  all.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT |
                      VK_ACCESS_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_TRANSFER_READ_BIT |
                      VK_ACCESS_TRANSFER_WRITE_BIT | VK_ACCESS_HOST_READ_BIT;
  const VkPipelineStageFlags work =
    VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;
  layout_->on()->calls().vkCmdPipelineBarrier(
    buffer_, work, work | VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
    &all, 0, nullptr, 0, nullptr);
}

void commands::dispatch(const kernel& k, std::uint32_t groups, const void* push) {
  const auto& calls = layout_->on()->calls();
  calls.vkCmdBindPipeline(buffer_, VK_PIPELINE_BIND_POINT_COMPUTE, k.handle());
  calls.vkCmdPushConstants(buffer_, layout_->handle(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                           layout_->push_bytes(), push);
  calls.vkCmdDispatch(buffer_, groups, 1, 1);
  barrier();
}

void commands::dispatch_indirect(const kernel& k, const buffer& counts, std::uint64_t offset,
                                 const void* push) {
  const auto& calls = layout_->on()->calls();
  calls.vkCmdBindPipeline(buffer_, VK_PIPELINE_BIND_POINT_COMPUTE, k.handle());
  calls.vkCmdPushConstants(buffer_, layout_->handle(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                           layout_->push_bytes(), push);
  calls.vkCmdDispatchIndirect(buffer_, counts.handle(), offset);
  barrier();
}

void commands::copy(const buffer& from, const buffer& to, std::span<const VkBufferCopy> regions) {
  layout_->on()->calls().vkCmdCopyBuffer(buffer_, from.handle(), to.handle(),
                                         static_cast<std::uint32_t>(regions.size()),
                                         regions.data());
  barrier();
}

expected<void> commands::end() {
  if (const auto r = layout_->on()->calls().vkEndCommandBuffer(buffer_); r != VK_SUCCESS)
    return fail(to_error(r, "recording commands"));
  return {};
}

expected<void> commands::run() {
  const std::array<const commands*, 1> list{this};
  return run_in_order(list);
}

expected<void> commands::run_in_order(std::span<const commands* const> list) {
  const auto& fence = list.front()->fence_;
  auto& on = *list.front()->layout_->on();
  if (on.given_up())
    return fail(ec::device_lost, "the device was given up when it did not answer",
                "Use --device cpu");
  std::vector<VkCommandBuffer> buffers;
  for (const auto* one : list)
    buffers.push_back(one->buffer_);
  VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  submit.commandBufferCount = static_cast<std::uint32_t>(buffers.size());
  submit.pCommandBuffers = buffers.data();
  if (const auto r = on.calls().vkResetFences(on.handle(), 1, &fence); r != VK_SUCCESS)
    return fail(to_error(r, "submitting work"));
  if (const auto r = on.calls().vkQueueSubmit(on.queue(), 1, &submit, fence); r != VK_SUCCESS)
    return fail(to_error(r, "submitting work"));
  return list.front()->wait();
}

expected<void> commands::wait() const {
  auto& on = *layout_->on();
  constexpr std::uint64_t two_seconds = 2'000'000'000;
  VkResult last = VK_TIMEOUT;
  for (int waits = 0; waits < 30; ++waits) {
    const auto r = on.calls().vkWaitForFences(on.handle(), 1, &fence_, VK_TRUE, two_seconds);
    if (r == VK_SUCCESS)
      return {};
    if (r == VK_ERROR_DEVICE_LOST)
      return fail(to_error(r, "working"));
    // Whatever else kept the call from waiting, the work goes on: only waiting again may end this.
    last = r;
  }
  on.give_up();
  if (last != VK_TIMEOUT)
    return fail(to_error(last, "working"));
  return fail(ec::device_lost, "the device has not answered for 60 s", "Use --device cpu");
}

// -- transfers -------------------------------------------------------------------------

namespace {

constexpr std::uint64_t staging_bytes = 4ull << 20;

}  // namespace

expected<void> upload(const std::shared_ptr<kernel_layout>& layout, buffer& to,
                      std::span<const std::byte> bytes) {
  auto staging = buffer::make(layout->on(), std::min<std::uint64_t>(bytes.size(), staging_bytes),
                              buffer::place::host);
  if (!staging)
    return fail(staging.error());
  for (std::uint64_t at = 0; at < bytes.size(); at += staging_bytes) {
    check_cancelled();
    const auto part = bytes.subspan(at, std::min<std::uint64_t>(staging_bytes, bytes.size() - at));
    std::memcpy(staging->mapped().data(), part.data(), part.size());
    auto work = commands::begin(layout);
    if (!work)
      return fail(work.error());
    const VkBufferCopy whole{0, at, part.size()};
    work->copy(*staging, to, {&whole, 1});
    if (auto ok = work->end(); !ok)
      return ok;
    if (auto ok = work->run(); !ok)
      return ok;
  }
  return {};
}

expected<void> upload(const std::shared_ptr<kernel_layout>& layout, std::span<const patch> patches,
                      std::span<const std::byte> bytes) {
  if (patches.empty())
    return {};
  auto staging = buffer::make(layout->on(), bytes.size(), buffer::place::host);
  if (!staging)
    return fail(staging.error());
  std::memcpy(staging->mapped().data(), bytes.data(), bytes.size());
  auto work = commands::begin(layout);
  if (!work)
    return fail(work.error());
  std::vector<VkBufferCopy> regions;
  for (auto at = patches.begin(); at != patches.end();) {
    const auto* to = at->to;
    regions.clear();
    for (; at != patches.end() && at->to == to; ++at)
      regions.push_back({at->from_offset, at->to_offset, at->bytes});
    work->copy(*staging, *to, regions);
  }
  if (auto ok = work->end(); !ok)
    return ok;
  return work->run();
}

expected<void> download(const std::shared_ptr<kernel_layout>& layout, const buffer& from,
                        std::span<std::byte> bytes) {
  auto staging = buffer::make(layout->on(), std::min<std::uint64_t>(bytes.size(), staging_bytes),
                              buffer::place::host);
  if (!staging)
    return fail(staging.error());
  for (std::uint64_t at = 0; at < bytes.size(); at += staging_bytes) {
    check_cancelled();
    const auto part = bytes.subspan(at, std::min<std::uint64_t>(staging_bytes, bytes.size() - at));
    auto work = commands::begin(layout);
    if (!work)
      return fail(work.error());
    const VkBufferCopy whole{at, 0, part.size()};
    work->copy(from, *staging, {&whole, 1});
    if (auto ok = work->end(); !ok)
      return ok;
    if (auto ok = work->run(); !ok)
      return ok;
    std::memcpy(part.data(), staging->mapped().data(), part.size());
  }
  return {};
}

}  // namespace tedit::gpu
