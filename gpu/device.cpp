// SPDX-License-Identifier: AGPL-3.0-or-later
#define VOLK_IMPLEMENTATION
#include "gpu/device.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>

namespace tedit::gpu {

namespace {

std::atomic<int> message_count{0};

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                          VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
  ++message_count;
  std::fprintf(stderr, "vulkan validation: %s\n", data->pMessage);
  return VK_FALSE;
}

bool has_validation_layer() {
  std::uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::ranges::any_of(layers, [](const VkLayerProperties& layer) {
    return std::strcmp(layer.layerName, "VK_LAYER_KHRONOS_validation") == 0;
  });
}

VkInstance make_instance() {
  if (volkInitialize() != VK_SUCCESS)
    return VK_NULL_HANDLE;
  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = "tedit";
  application.apiVersion = VK_API_VERSION_1_1;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  const char* wanted = std::getenv("TEDIT_VULKAN_VALIDATION");
  const bool validate = wanted && std::strcmp(wanted, "1") == 0 && has_validation_layer();
  const char* layer = "VK_LAYER_KHRONOS_validation";
  const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  VkDebugUtilsMessengerCreateInfoEXT messenger{
    VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  messenger.messageSeverity =
    VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  messenger.pfnUserCallback = on_message;
  if (validate) {
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &layer;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
    info.pNext = &messenger;
  }
  VkInstance instance = VK_NULL_HANDLE;
  if (vkCreateInstance(&info, nullptr, &instance) != VK_SUCCESS)
    return VK_NULL_HANDLE;
  volkLoadInstanceOnly(instance);
  if (validate) {
    VkDebugUtilsMessengerEXT kept = VK_NULL_HANDLE;  // lives as long as the instance
    vkCreateDebugUtilsMessengerEXT(instance, &messenger, nullptr, &kept);
  }
  return instance;
}

/// One instance for the whole program; never destroyed, since drivers may not load twice.
VkInstance instance() {
  static const VkInstance made = make_instance();
  return made;
}

int compute_family(VkPhysicalDevice physical) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  for (std::uint32_t i = 0; i < count; ++i)
    if (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT)
      return static_cast<int>(i);
  return -1;
}

std::vector<VkPhysicalDevice> physical_devices() {
  std::vector<VkPhysicalDevice> result;
  if (!instance())
    return result;
  std::uint32_t count = 0;
  if (vkEnumeratePhysicalDevices(instance(), &count, nullptr) != VK_SUCCESS)
    return result;
  result.resize(count);
  if (vkEnumeratePhysicalDevices(instance(), &count, result.data()) < VK_SUCCESS)
    count = 0;  // What stands in the list then is nothing.
  result.resize(count);
  std::erase_if(result, [](VkPhysicalDevice physical) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    return properties.apiVersion < VK_API_VERSION_1_1 || compute_family(physical) < 0;
  });
  return result;
}

device_summary summarise(VkPhysicalDevice physical) {
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  VkPhysicalDeviceProperties basic;
  vkGetPhysicalDeviceProperties(physical, &basic);
  if (basic.apiVersion >= VK_API_VERSION_1_2)
    properties.pNext = &driver;
  vkGetPhysicalDeviceProperties2(physical, &properties);
  device_summary result;
  result.name = basic.deviceName;
  result.driver = std::string(driver.driverName) + " " + driver.driverInfo;
  switch (basic.deviceType) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      result.kind = "discrete";
      break;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      result.kind = "integrated";
      break;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      result.kind = "software";
      break;
    default:
      result.kind = "other";
  }
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physical, &memory);
  for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i)
    if (memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
      result.memory_bytes = std::max(result.memory_bytes, memory.memoryHeaps[i].size);
  return result;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace

error to_error(VkResult result, const std::string& what) {
  switch (result) {
    case VK_ERROR_DEVICE_LOST:
      return {
        ec::device_lost, "the device failed while " + what, "Try again, or use --device cpu", {}};
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return {ec::out_of_memory,
              "the device has no memory left while " + what,
              "Take a coarser mesh, or use --device cpu",
              {}};
    default:
      return {ec::device_unavailable,
              "the device cannot do this (" + what + ", code " + std::to_string(result) + ")",
              "Use --device cpu",
              {}};
  }
}

std::vector<device_summary> device::list() {
  std::vector<device_summary> result;
  for (const auto physical : physical_devices())
    result.push_back(summarise(physical));
  return result;
}

int device::validation_messages() {
  return message_count;
}

expected<std::shared_ptr<device>> device::open(const std::string& part) {
  for (const auto physical : physical_devices()) {
    auto summary = summarise(physical);
    if (lower(summary.name).find(lower(part)) == std::string::npos)
      continue;
    std::shared_ptr<device> result(new device);
    result->summary_ = std::move(summary);
    if (auto ok = result->create(physical); !ok)
      return fail(ok.error());
    return result;
  }
  return fail(ec::device_unavailable, "no Vulkan device is called \"" + part + "\"");
}

expected<void> device::create(VkPhysicalDevice physical) {
  VkPhysicalDeviceSubgroupProperties subgroup{
    VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES};
  VkPhysicalDeviceProperties2 properties{
    VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &subgroup, {}};
  vkGetPhysicalDeviceProperties2(physical, &properties);
  const auto& limits = properties.properties.limits;
  limits_.storage_buffer_range = limits.maxStorageBufferRange;
  limits_.texel_buffer_range = 16 * std::uint64_t{limits.maxTexelBufferElements};
  limits_.subgroup_size = subgroup.subgroupSize;
  limits_.workgroup_size = limits.maxComputeWorkGroupInvocations;
  limits_.memory_bytes = summary_.memory_bytes;
  vkGetPhysicalDeviceMemoryProperties(physical, &memory_);

  const float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = static_cast<std::uint32_t>(compute_family(physical));
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  if (const auto result = vkCreateDevice(physical, &info, nullptr, &device_); result != VK_SUCCESS)
    return fail(to_error(result, "opening it"));
  volkLoadDeviceTable(&calls_, device_);
  calls_.vkGetDeviceQueue(device_, queue.queueFamilyIndex, 0, &queue_);
  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  pool.queueFamilyIndex = queue.queueFamilyIndex;
  if (const auto result = calls_.vkCreateCommandPool(device_, &pool, nullptr, &pool_);
      result != VK_SUCCESS)
    return fail(to_error(result, "opening it"));
  return {};
}

device::~device() {
  if (given_up_)
    return;
  if (pool_)
    calls_.vkDestroyCommandPool(device_, pool_, nullptr);
  if (device_)
    calls_.vkDestroyDevice(device_, nullptr);
}

int device::memory_type(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const {
  for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i)
    if ((allowed >> i & 1) && (memory_.memoryTypes[i].propertyFlags & wanted) == wanted)
      return static_cast<int>(i);
  return -1;
}

}  // namespace tedit::gpu
