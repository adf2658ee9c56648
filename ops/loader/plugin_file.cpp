// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/loader/plugin_file.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "ops/loader/catalogue.hpp"

namespace tedit::ops {

namespace {

using query_function = const plugin_descriptor* (*)();

/// Throws what the plugin throws.
expected<std::vector<callable_operation>> load_unguarded(const std::filesystem::path& file,
                                                         const sdk_offer& offer) {
  const auto refuse = [](std::string reason) {
    return fail(ec::plugin_refused, std::move(reason));
  };
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library)
    return refuse(readable_dl_error(dlerror()));
  const auto query = reinterpret_cast<query_function>(dlsym(library, "tedit_plugin_query"));
  if (!query)
    return refuse("it has no entry tedit_plugin_query");
  const auto* descriptor = query();
  if (auto fault = descriptor_fault(descriptor, offer); !fault.empty())
    return refuse(std::move(fault));
  std::vector<callable_operation> made;
  for (std::uint32_t i = 0; i < descriptor->operation_count; ++i) {
    auto* raw = descriptor->create(i);
    if (!raw)
      return refuse("operation " + std::to_string(i) + " could not be made");
    std::shared_ptr<const operation> code(
      raw, [descriptor](const operation* p) { descriptor->destroy(const_cast<operation*>(p)); });
    described_operation about{
      code->describe(), std::string(descriptor->plugin_name) + " " + descriptor->plugin_version};
    if (auto fault = text_fault(about); !fault.empty())
      return refuse(std::move(fault));
    made.push_back({std::move(about), std::move(code)});
  }
  return made;
}

/// Loads its plugin when it is called.
class deferred_operation final : public operation {
public:
  deferred_operation(described_operation about, std::filesystem::path file, const sdk_offer& offer)
      : about_(std::move(about)), file_(std::move(file)), offer_(offer) {}

  [[nodiscard]] operation_description describe() const override { return about_.description; }

  [[nodiscard]] expected<edit_result> apply(const version_ptr& mesh, const selection& picked,
                                            const parameters& values, context& ctx) const override {
    std::call_once(once_, [this] { code_ = load(); });
    return code_ ? (*code_)->apply(mesh, picked, values, ctx) : fail(code_.error());
  }

private:
  [[nodiscard]] expected<std::shared_ptr<const operation>> load() const {
    auto all = load_plugin(file_, offer_);
    if (!all)
      return fail(plugin_not_used(file_, all.error().message));
    for (auto& one : *all)
      if (is_same(one.about, about_))
        return std::move(one.code);
    return fail(ec::plugin_refused,
                "the plugin " + file_.string() + " describes " + about_.description.id +
                  " otherwise than a moment ago",
                "Try again once its file is written; describe() must say the same every time");
  }

  described_operation about_;
  std::filesystem::path file_;
  sdk_offer offer_;
  mutable std::once_flag once_;
  mutable expected<std::shared_ptr<const operation>> code_;
};

}  // namespace

expected<std::vector<callable_operation>> load_plugin(const std::filesystem::path& file,
                                                      const sdk_offer& offer) {
  try {
    return load_unguarded(file, offer);
  } catch (const std::exception& e) {
    return fail(ec::plugin_refused, std::string("it failed while it was loaded: ") + e.what());
  } catch (...) {
    return fail(ec::plugin_refused,
                "it failed while it was loaded: it threw something that is no std::exception");
  }
}

callable_operation make_deferred(described_operation about, std::filesystem::path file,
                                 const sdk_offer& offer) {
  auto code = std::make_shared<const deferred_operation>(about, std::move(file), offer);
  return {std::move(about), std::move(code)};
}

error plugin_not_used(const std::filesystem::path& file, const std::string& reason) {
  return {ec::plugin_refused,
          "the plugin " + file.string() + " is not used: " + reason,
          "Rebuild it against this version, or remove it",
          {}};
}

}  // namespace tedit::ops
