// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/gpu/fault_injection.hpp"

#include <array>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <utility>

namespace tedit::gpu::test {

namespace {

constexpr unsigned full = 1;
constexpr unsigned lost = 2;
constexpr unsigned late = 4;

struct call_facts {
  const char* name;
  unsigned may;  ///< How the call may fail, by the specification.
};

/// Every call of this program that returns a VkResult.
constexpr std::array<call_facts, 21> facts{{{"vkEnumeratePhysicalDevices", full},
                                            {"vkCreateDevice", full | lost},
                                            {"vkCreateCommandPool", full},
                                            {"vkCreateBuffer", full},
                                            {"vkCreateBufferView", full},
                                            {"vkAllocateMemory", full},
                                            {"vkBindBufferMemory", full},
                                            {"vkMapMemory", full},
                                            {"vkCreateDescriptorSetLayout", full},
                                            {"vkCreatePipelineLayout", full},
                                            {"vkCreateDescriptorPool", full},
                                            {"vkAllocateDescriptorSets", full},
                                            {"vkCreateShaderModule", full},
                                            {"vkCreateComputePipelines", full},
                                            {"vkAllocateCommandBuffers", full},
                                            {"vkCreateFence", full},
                                            {"vkBeginCommandBuffer", full},
                                            {"vkEndCommandBuffer", full},
                                            {"vkResetFences", full},
                                            {"vkQueueSubmit", full | lost},
                                            {"vkWaitForFences", full | lost | late}}};

consteval std::size_t place_of(std::string_view name) {
  for (std::size_t i = 0; i < facts.size(); ++i)
    if (name == facts[i].name)
      return i;
  throw "unknown call";
}

struct layer_state {
  fault what = fault::none;
  std::size_t at = 0;
  bool happened = false;
  std::vector<std::size_t> trace;  ///< Places in `facts`.
  std::set<std::uint64_t> standing;
  std::size_t destroyed_since = 0;
  std::set<std::uint32_t> capabilities;
  std::size_t features = 0;
};

layer_state& state() {
  static layer_state one;
  return one;
}

bool may_fail(std::size_t place, fault what) {
  const unsigned may = facts[place].may;
  switch (what) {
    case fault::lost:
      return (may & lost) != 0;
    case fault::device_full:
    case fault::host_full:
      return (may & full) != 0;
    case fault::late:
    case fault::hung:
      return (may & late) != 0;
    default:
      return false;
  }
}

/// What the call that is made now gives, VK_SUCCESS to let it through.
VkResult verdict(std::size_t place) {
  auto& s = state();
  s.trace.push_back(place);
  const bool now = s.at != 0 && !s.happened && s.trace.size() >= s.at;
  const bool still = s.happened && (s.what == fault::lost || s.what == fault::hung);
  if (!(now || still) || !may_fail(place, s.what))
    return VK_SUCCESS;
  s.happened = true;
  switch (s.what) {
    case fault::lost:
      return VK_ERROR_DEVICE_LOST;
    case fault::device_full:
      return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    case fault::host_full:
      return VK_ERROR_OUT_OF_HOST_MEMORY;
    default:
      return VK_TIMEOUT;
  }
}

template <class Handle>
std::uint64_t number_of(Handle handle) {
  std::uint64_t result = 0;
  static_assert(sizeof(handle) == sizeof(result));
  std::memcpy(&result, &handle, sizeof(result));
  return result;
}

void made(std::uint64_t handle) {
  state().standing.insert(handle);
}

void gone(std::uint64_t handle) {
  auto& s = state();
  if (s.standing.erase(handle) > 0 && s.happened)
    ++s.destroyed_since;
}

void note_kernel(const VkShaderModuleCreateInfo& info) {
  state().capabilities.merge(capabilities_of(info.pCode, info.codeSize / 4));
}

void note_features(const VkDeviceCreateInfo& info) {
  auto& s = state();
  // A chain of structures could switch features on, too.
  s.features += info.pNext != nullptr ? 1 : 0;
  if (!info.pEnabledFeatures)
    return;
  std::array<VkBool32, sizeof(VkPhysicalDeviceFeatures) / sizeof(VkBool32)> all;
  std::memcpy(all.data(), info.pEnabledFeatures, sizeof(VkPhysicalDeviceFeatures));
  for (const auto on : all)
    s.features += on;
}

/// Looks at the arguments by their types: the last one of a creating call points to the handle.
template <class Owner, class Info, class Handle>
void note_made(Owner, const Info* info, const VkAllocationCallbacks*, Handle* handle) {
  made(number_of(*handle));
  if constexpr (std::is_same_v<Info, VkShaderModuleCreateInfo>)
    note_kernel(*info);
  if constexpr (std::is_same_v<Info, VkDeviceCreateInfo>)
    note_features(*info);
}

void note_made(VkDevice, VkPipelineCache, std::uint32_t, const VkComputePipelineCreateInfo*,
               const VkAllocationCallbacks*, VkPipeline* handle) {
  made(number_of(*handle));
}

void note_made(VkDevice, const VkCommandBufferAllocateInfo*, VkCommandBuffer* handle) {
  made(number_of(*handle));
}

void note_made(auto...) {}

template <std::size_t place, class F>
struct wrapped;

template <std::size_t place, class... Args>
struct wrapped<place, VkResult(VKAPI_PTR*)(Args...)> {
  static inline VkResult(VKAPI_PTR* real)(Args...) = nullptr;

  static VkResult VKAPI_PTR call(Args... args) {
    const auto result = verdict(place);
    if (result != VK_SUCCESS) {
      // A lost or hung device works no more, but the driver's threads do: let them end.
      const bool over = result == VK_ERROR_DEVICE_LOST || state().what == fault::hung;
      if constexpr (place == place_of("vkWaitForFences"))
        if (over)
          real(args...);
      return result;
    }
    const auto done = real(args...);
    if (done == VK_SUCCESS)
      note_made(args...);
    return done;
  }
};

/// A call that destroys one object: the handle is its last argument but one.
template <class F>
struct destroying;

template <class Owner, class Handle>
struct destroying<void(VKAPI_PTR*)(Owner, Handle, const VkAllocationCallbacks*)> {
  static inline void(VKAPI_PTR* real)(Owner, Handle, const VkAllocationCallbacks*) = nullptr;

  static void VKAPI_PTR call(Owner owner, Handle handle, const VkAllocationCallbacks* with) {
    gone(number_of(handle));
    real(owner, handle, with);
  }
};

PFN_vkGetDeviceProcAddr real_device_calls = nullptr;
PFN_vkFreeCommandBuffers real_free_commands = nullptr;
PFN_vkDestroyDevice real_destroy_device = nullptr;

void VKAPI_PTR free_commands(VkDevice on, VkCommandPool pool, std::uint32_t count,
                             const VkCommandBuffer* buffers) {
  for (std::uint32_t i = 0; i < count; ++i)
    gone(number_of(buffers[i]));
  real_free_commands(on, pool, count, buffers);
}

void VKAPI_PTR destroy_device(VkDevice on, const VkAllocationCallbacks* with) {
  gone(number_of(on));
  real_destroy_device(on, with);
}

template <class F>
PFN_vkVoidFunction swapped(F& keep, F mine, PFN_vkVoidFunction real) {
  keep = reinterpret_cast<F>(real);
  return reinterpret_cast<PFN_vkVoidFunction>(mine);
}

PFN_vkVoidFunction VKAPI_PTR device_calls(VkDevice on, const char* name) {
  const auto real = real_device_calls(on, name);
  if (!real)
    return nullptr;
  const std::string_view wanted = name;
#define TEDIT_FAULTY(call_name)                               \
  if (wanted == #call_name) {                                 \
    using w = wrapped<place_of(#call_name), PFN_##call_name>; \
    return swapped<PFN_##call_name>(w::real, &w::call, real); \
  }
#define TEDIT_DESTROYING(call_name)                           \
  if (wanted == #call_name) {                                 \
    using w = destroying<PFN_##call_name>;                    \
    return swapped<PFN_##call_name>(w::real, &w::call, real); \
  }
  TEDIT_FAULTY(vkCreateCommandPool)
  TEDIT_FAULTY(vkCreateBuffer)
  TEDIT_FAULTY(vkCreateBufferView)
  TEDIT_FAULTY(vkAllocateMemory)
  TEDIT_FAULTY(vkBindBufferMemory)
  TEDIT_FAULTY(vkMapMemory)
  TEDIT_FAULTY(vkCreateDescriptorSetLayout)
  TEDIT_FAULTY(vkCreatePipelineLayout)
  TEDIT_FAULTY(vkCreateDescriptorPool)
  TEDIT_FAULTY(vkAllocateDescriptorSets)
  TEDIT_FAULTY(vkCreateShaderModule)
  TEDIT_FAULTY(vkCreateComputePipelines)
  TEDIT_FAULTY(vkAllocateCommandBuffers)
  TEDIT_FAULTY(vkCreateFence)
  TEDIT_FAULTY(vkBeginCommandBuffer)
  TEDIT_FAULTY(vkEndCommandBuffer)
  TEDIT_FAULTY(vkResetFences)
  TEDIT_FAULTY(vkQueueSubmit)
  TEDIT_FAULTY(vkWaitForFences)
  TEDIT_DESTROYING(vkDestroyCommandPool)
  TEDIT_DESTROYING(vkDestroyBuffer)
  TEDIT_DESTROYING(vkDestroyBufferView)
  TEDIT_DESTROYING(vkFreeMemory)
  TEDIT_DESTROYING(vkDestroyDescriptorSetLayout)
  TEDIT_DESTROYING(vkDestroyPipelineLayout)
  TEDIT_DESTROYING(vkDestroyDescriptorPool)
  TEDIT_DESTROYING(vkDestroyShaderModule)
  TEDIT_DESTROYING(vkDestroyPipeline)
  TEDIT_DESTROYING(vkDestroyFence)
#undef TEDIT_FAULTY
#undef TEDIT_DESTROYING
  if (wanted == "vkFreeCommandBuffers")
    return swapped(real_free_commands, &free_commands, real);
  if (wanted == "vkDestroyDevice")
    return swapped(real_destroy_device, &destroy_device, real);
  return real;
}

using enumerate_call =
  wrapped<place_of("vkEnumeratePhysicalDevices"), PFN_vkEnumeratePhysicalDevices>;
using create_call = wrapped<place_of("vkCreateDevice"), PFN_vkCreateDevice>;

}  // namespace

fault_layer::fault_layer() {
  state() = {};
  real_device_calls = std::exchange(vkGetDeviceProcAddr, &device_calls);
  enumerate_call::real = std::exchange(vkEnumeratePhysicalDevices, &enumerate_call::call);
  create_call::real = std::exchange(vkCreateDevice, &create_call::call);
}

fault_layer::~fault_layer() {
  plan(fault::none, 0);  // Devices that are still open go on through this layer.
  vkGetDeviceProcAddr = real_device_calls;
  vkEnumeratePhysicalDevices = enumerate_call::real;
  vkCreateDevice = create_call::real;
}

void fault_layer::plan(fault what, std::size_t at) {
  auto& s = state();
  s.what = what;
  s.at = at;
  s.happened = false;
  s.destroyed_since = 0;
  s.trace.clear();
}

bool fault_layer::possible(fault what, std::size_t at) const {
  return may_fail(state().trace.at(at - 1), what);
}

std::size_t fault_layer::calls() const {
  return state().trace.size();
}

const char* fault_layer::name(std::size_t at) const {
  return facts[state().trace.at(at - 1)].name;
}

bool fault_layer::happened() const {
  return state().happened;
}

std::size_t fault_layer::standing() const {
  return state().standing.size();
}

std::size_t fault_layer::destroyed_since() const {
  return state().destroyed_since;
}

void fault_layer::forget() {
  // Kept, so that tools that look for lost memory find the handles.
  static std::vector<std::set<std::uint64_t>> given_up;
  given_up.push_back(std::move(state().standing));
  state().standing.clear();
}

const std::set<std::uint32_t>& fault_layer::capabilities() const {
  return state().capabilities;
}

std::size_t fault_layer::features() const {
  return state().features;
}

std::set<std::uint32_t> capabilities_of(const std::uint32_t* words, std::size_t count) {
  constexpr std::uint32_t op_capability = 17;
  std::set<std::uint32_t> result;
  // Five words of header; the first word of an instruction: length << 16 | opcode.
  for (std::size_t at = 5; at + 1 < count && (words[at] & 0xFFFF) == op_capability;
       at += words[at] >> 16)
    result.insert(words[at + 1]);
  return result;
}

}  // namespace tedit::gpu::test
