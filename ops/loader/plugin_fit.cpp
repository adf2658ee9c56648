// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/loader/plugin_fit.hpp"

#include <algorithm>
#include <span>

namespace tedit::ops {

namespace {

std::string difference(const layout_fact& theirs, const layout_fact& ours) {
  if (theirs.size != ours.size)
    return std::to_string(theirs.size) + " bytes, " + std::to_string(ours.size) + " here";
  return theirs.size > 0 ? "as large, but its members differ" : "its functions or members differ";
}

}  // namespace

std::string magic_fault(const plugin_descriptor* plugin) {
  return plugin && plugin->magic == plugin_magic ? ""
                                                 : "it is no TEdit plugin (wrong magic number)";
}

std::string sdk_fault(const plugin_descriptor& plugin, const sdk_offer& host) {
  if (plugin.sdk_major == host.major && plugin.sdk_minor <= host.minor)
    return {};
  const auto text = [](std::uint32_t major, std::uint32_t minor) {
    return std::to_string(major) + "." + std::to_string(minor);
  };
  return "it was built for SDK " + text(plugin.sdk_major, plugin.sdk_minor) +
         ", this host offers " + text(host.major, host.minor);
}

std::string compiler_fault(const plugin_descriptor& plugin) {
  if (plugin.compiler && std::string_view(plugin.compiler) == compiler_tag)
    return {};
  return std::string("it was built with ") +
         (plugin.compiler ? plugin.compiler : "an unnamed compiler") + ", this host with " +
         compiler_tag;
}

std::string completeness_fault(const plugin_descriptor& plugin) {
  if (plugin.descriptor_size != sizeof(plugin_descriptor))
    return "its descriptor has " + std::to_string(plugin.descriptor_size) +
           " bytes, this host's has " + std::to_string(sizeof(plugin_descriptor));
  if (!plugin.create || !plugin.destroy || !plugin.plugin_name || !*plugin.plugin_name ||
      !plugin.plugin_version || plugin.operation_count == 0 || !plugin.layout ||
      plugin.layout_count == 0)
    return "its descriptor is incomplete";
  return {};
}

std::string layout_fault(const plugin_descriptor& plugin) {
  const auto& ours = layout_facts();
  for (const auto& fact : std::span(plugin.layout, plugin.layout_count)) {
    const std::string_view type = fact.type;
    const auto same = std::ranges::find(ours, type, &layout_fact::type);
    if (same == ours.end())
      return "it was built with a type that this host does not have (" + std::string(type) + ")";
    if (same->size != fact.size || same->places != fact.places)
      return "it was built against another layout of " + std::string(type) + " (" +
             difference(fact, *same) + ")";
  }
  return {};
}

std::string descriptor_fault(const plugin_descriptor* plugin, const sdk_offer& host) {
  auto fault = magic_fault(plugin);
  if (fault.empty())
    fault = sdk_fault(*plugin, host);
  if (fault.empty())
    fault = compiler_fault(*plugin);
  if (fault.empty())
    fault = completeness_fault(*plugin);
  if (fault.empty())
    fault = layout_fault(*plugin);
  return fault;
}

}  // namespace tedit::ops
