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
  expected<ops::edit_result> apply(const mesh_version&, const ops::selection&,
                                   const ops::parameters&, ops::context&) const override {
    return fail(ec::internal, "never called");
  }
};

[[maybe_unused]] const ops::plugin_descriptor descriptor{
#ifdef TEDIT_BAD_WRONG_MAGIC
  1,
#else
  ops::plugin_magic,
#endif
  sizeof(ops::plugin_descriptor),
  ops::sdk_major,
#ifdef TEDIT_BAD_NEWER_SDK
  ops::sdk_minor + 1,
#else
  ops::sdk_minor,
#endif
#ifdef TEDIT_BAD_OTHER_COMPILER
  "gcc-1.0",
#else
  ops::compiler_tag,
#endif
  "faulty",
  "1.0",
  1,
  [](std::uint32_t) -> ops::operation* { return new faulty; },
  [](ops::operation* made) { delete made; }};

}  // namespace

#ifndef TEDIT_BAD_NO_ENTRY
extern "C" __attribute__((visibility("default"))) const tedit::ops::plugin_descriptor*
tedit_plugin_query() {
  return &descriptor;
}
#endif
