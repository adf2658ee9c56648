// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cstring>

#include "ops/conformance/kit.hpp"

namespace tedit::ops::kit {

namespace {

std::string opens(bench& b) {
  b.open();
  return "it opens";
}

std::string entry(bench& b) {
  b.find_entry();
  return "tedit_plugin_query answers";
}

std::string magic(bench& b) {
  b.find_entry();
  const auto& d = b.descriptor();
  if (d.magic != plugin_magic)
    throw failure{
      "the magic number is " + std::to_string(d.magic) + ", not " + std::to_string(plugin_magic),
      "Fill the descriptor by the macro TEDIT_PLUGIN"};
  if (d.descriptor_size != sizeof(plugin_descriptor))
    throw failure{"descriptor_size is " + std::to_string(d.descriptor_size) + ", not " +
                    std::to_string(sizeof(plugin_descriptor)),
                  "Rebuild against this version's ops/sdk/operation.hpp"};
  if (!d.plugin_name || !*d.plugin_name || !d.plugin_version || !d.create || !d.destroy ||
      d.operation_count == 0)
    throw failure{"the descriptor is incomplete", "Fill it by the macro TEDIT_PLUGIN"};
  b.say("operations " + std::to_string(d.operation_count));
  return std::string(d.plugin_name) + " " + d.plugin_version + ", " +
         std::to_string(d.operation_count) + " operation(s)";
}

std::string sdk_version(bench& b) {
  b.find_entry();
  const auto& d = b.descriptor();
  const auto built = std::to_string(d.sdk_major) + "." + std::to_string(d.sdk_minor);
  const auto offered = std::to_string(sdk_major) + "." + std::to_string(sdk_minor);
  if (d.sdk_major != sdk_major || d.sdk_minor > sdk_minor)
    throw failure{"it was built for SDK " + built + ", this host offers " + offered,
                  "Rebuild against this version, or install the version it was built for"};
  return "built for SDK " + built + ", this host offers " + offered;
}

std::string compiler(bench& b) {
  b.find_entry();
  const auto& d = b.descriptor();
  if (!d.compiler || std::strcmp(d.compiler, compiler_tag) != 0)
    throw failure{std::string("it was built with ") + (d.compiler ? d.compiler : "nothing named") +
                    ", this host with " + compiler_tag,
                  "Build with the host's compiler: C++ types cross the border"};
  return d.compiler;
}

std::string makes_operations(bench& b) {
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
    {"descriptor", "The descriptor has the right magic number and size and is complete",
     need::nothing, magic},
    {"sdk_version", "It was built for an SDK that this host offers", need::nothing, sdk_version},
    {"compiler", "It was built with this host's compiler", need::nothing, compiler},
    {"makes_operations", "Every operation can be made, described and destroyed", need::nothing,
     makes_operations}};
  return list;
}

}  // namespace tedit::ops::kit
