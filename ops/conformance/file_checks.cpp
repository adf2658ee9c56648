// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/conformance/kit.hpp"
#include "ops/loader/plugin_fit.hpp"

namespace tedit::ops::kit {

namespace {

std::string opens(plugin_trial& b) {
  b.open();
  return "it opens";
}

std::string entry(plugin_trial& b) {
  b.find_entry();
  return "tedit_plugin_query answers";
}

/// Throws a fault as the failure that it is.
void refuse(const std::string& fault, const std::string& remedy) {
  if (!fault.empty())
    throw failure{fault, remedy};
}

std::string sdk_version(plugin_trial& b) {
  b.find_entry();
  const auto& d = b.descriptor();
  refuse(magic_fault(&d), "Write TEDIT_PLUGIN(name, version, class)");
  refuse(sdk_fault(d), "Rebuild against this version, or install the version it was built for");
  return "built for SDK " + std::to_string(d.sdk_major) + "." + std::to_string(d.sdk_minor) +
         ", this host offers " + std::to_string(sdk_major) + "." + std::to_string(sdk_minor);
}

std::string compiler(plugin_trial& b) {
  b.find_entry();
  refuse(compiler_fault(b.descriptor()),
         "Build with a compiler of the host's series: C++ types cross the border");
  return b.descriptor().compiler;
}

std::string descriptor(plugin_trial& b) {
  b.find_entry();
  const auto& d = b.descriptor();
  refuse(completeness_fault(d),
         "Fill it by the macro TEDIT_PLUGIN, or from tedit::ops::make_descriptor");
  b.say("operations " + std::to_string(d.operation_count));
  return std::string(d.plugin_name) + " " + d.plugin_version + ", " +
         std::to_string(d.operation_count) + " operation(s)";
}

std::string layout(plugin_trial& b) {
  b.find_entry();
  const auto& d = b.descriptor();
  refuse(layout_fault(d),
         "Rebuild against this version's headers and libraries, with the flags of TEdit::options");
  return std::to_string(d.layout_count) + " facts of types are the host's";
}

std::string makes_operations(plugin_trial& b) {
  b.load();
  for (std::uint32_t i = 0; i < b.descriptor().operation_count; ++i) {
    auto* made = b.descriptor().create(i);
    if (!made)
      throw failure{"create(" + std::to_string(i) + ") returned a null pointer",
                    "Return a new operation for every index below operation_count"};
    (void)made->describe();
    b.descriptor().destroy(made);
  }
  return "made, described and destroyed";
}

}  // namespace

const std::vector<check>& file_checks() {
  static const std::vector<check> list{
    {"file_opens", "The file is a shared library whose dependencies are there", need::nothing,
     opens},
    {"entry", "It exports tedit_plugin_query", need::nothing, entry},
    {"sdk_version", "It was built for an SDK that this host offers", need::nothing, sdk_version},
    {"compiler", "It was built with a compiler of this host's series", need::nothing, compiler},
    {"descriptor", "The descriptor has the right size and is complete", need::nothing, descriptor},
    {"layout", "The types that cross the border are laid out as the host's", need::nothing, layout},
    {"makes_operations", "Every operation can be made, described and destroyed", need::nothing,
     makes_operations}};
  return list;
}

}  // namespace tedit::ops::kit
