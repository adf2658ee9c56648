// SPDX-License-Identifier: AGPL-3.0-or-later
// One faulty plugin per TEDIT_BAD_... definition; see CMakeLists.txt.
#include <stdexcept>

#include "ops/sdk/operation.hpp"

namespace {

using namespace tedit;

class faulty final : public ops::operation {
public:
  faulty() {
#ifdef TEDIT_BAD_THROWS
    throw std::runtime_error("no licence file");
#endif
  }
  ops::operation_description describe() const override {
    ops::operation_description d;
    d.id = "fill_hole";  // taken by the built-in operation
    return d;
  }
  expected<ops::edit_result> apply(const version_ptr&, const ops::selection&,
                                   const ops::parameters&, ops::context&) const override {
    return fail(ec::internal, "never called");
  }
};

/// What this plugin says of its types.
[[maybe_unused]] std::vector<layout_fact> facts() {
  auto result = ops::layout_facts();
#ifdef TEDIT_BAD_OTHER_LAYOUT
  for (auto& fact : result)
    if (std::string_view(fact.type) == "edit_result")
      fact.size += 8;
#endif
#ifdef TEDIT_BAD_OTHER_MEMBERS
  for (auto& fact : result)
    if (std::string_view(fact.type) == "mesh_version")
      ++fact.places;
#endif
#ifdef TEDIT_BAD_NEW_TYPE
  result.push_back({"stress_view", 24, 0});
#endif
  return result;
}

[[maybe_unused]] ops::plugin_descriptor make() {
  auto result = ops::make_descriptor<faulty>("faulty", "1.0");
  static const auto layout = facts();
  result.layout = layout.data();
  result.layout_count = static_cast<std::uint32_t>(layout.size());
#ifdef TEDIT_BAD_WRONG_MAGIC
  result.magic = 1;
#endif
#ifdef TEDIT_BAD_NEWER_SDK
  ++result.sdk_minor;
#endif
#ifdef TEDIT_BAD_NEXT_SDK
  ++result.sdk_major;
  result.descriptor_size += 8;
#endif
#ifdef TEDIT_BAD_LAST_SDK
  // As those before SDK 6 had it: nothing after `destroy`.
  --result.sdk_major;
  result.descriptor_size = offsetof(ops::plugin_descriptor, layout);
  result.layout = reinterpret_cast<const layout_fact*>(1);
#endif
#ifdef TEDIT_BAD_OTHER_COMPILER
  result.compiler = "gcc-1 libstdc++-1 strings-0";
#endif
#ifdef TEDIT_BAD_NO_LAYOUT
  result.layout = nullptr;
#endif
  return result;
}

}  // namespace

#ifndef TEDIT_BAD_NO_ENTRY
extern "C" __attribute__((visibility("default"))) const tedit::ops::plugin_descriptor*
tedit_plugin_query() {
  static const auto descriptor = make();
  return &descriptor;
}
#endif
