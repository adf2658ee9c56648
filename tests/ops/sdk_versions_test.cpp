// SPDX-License-Identifier: AGPL-3.0-or-later
// A plugin's file stays as it is while the program around it goes on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ops/loader/catalogue.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path today = TEDIT_RULE_BREAKER "/rule_breaker.so";
const std::filesystem::path old = TEDIT_OLD_PLUGIN "/old_plugin.so";

/// Volume put on one end of a bar of 40 x 30 x 30 mm that the plugin lengthens by 1 mm; m^3.
double volume_added(const catalogue& plugins) {
  const auto bar = test::box_mesh({4, 3, 3}, {0.04, 0.03, 0.03});
  context ctx;
  const auto edit = run_operation(plugins, "rule_breaker", bar, {{2}}, {{"distance", 0.001}}, ctx);
  EXPECT_TRUE(edit.has_value()) << render(edit.error());
  return edit ? total_volume(*edit->candidate) - total_volume(*bar) : 0;
}

TEST(SdkVersions, APluginOfAnotherPatchReleaseOfTheCompilerLoadsAndEdits) {
  catalogue plugins;

  const auto loaded = plugins.load_file(old);

  ASSERT_TRUE(loaded.has_value()) << render(loaded.error());
  EXPECT_NEAR(volume_added(plugins), 0.9e-6, 1e-15);
}

TEST(SdkVersions, AHostOfALaterMinorReleaseTakesWhatWasBuiltBefore) {
  for (const auto& file : {today, old}) {
    catalogue later(sdk_offer{sdk_major, sdk_minor + 3});

    const auto loaded = later.load_file(file);

    ASSERT_TRUE(loaded.has_value()) << render(loaded.error());
    EXPECT_NEAR(volume_added(later), 0.9e-6, 1e-15);
  }
}

TEST(SdkVersions, AHostOfAnotherMajorNumberRefusesItWithBothNumbers) {
  const auto here = "SDK " + std::to_string(sdk_major) + "." + std::to_string(sdk_minor);
  for (const auto major : {sdk_major - 1, sdk_major + 1}) {
    catalogue other(sdk_offer{major, 7});

    const auto loaded = other.load_file(today);

    ASSERT_FALSE(loaded.has_value());
    EXPECT_THAT(loaded.error().message,
                HasSubstr(here + ", this host offers " + std::to_string(major) + ".7"));
    EXPECT_THAT(loaded.error().remedy, HasSubstr("Rebuild it"));
  }
}

TEST(SdkVersions, TheCompilersMinorAndPatchNumbersAreNotInItsTag) {
#if defined(__GNUC__) && !defined(__clang__)
  EXPECT_THAT(std::string(compiler_tag), ::testing::StartsWith("gcc-" TEDIT_TEXT(__GNUC__) " "));
  EXPECT_EQ(std::string(compiler_tag).find('.'), std::string::npos);
#endif
}

class first_operation final : public operation {
public:
  [[nodiscard]] operation_description describe() const override {
    operation_description d;
    d.id = "first";
    return d;
  }
  [[nodiscard]] expected<edit_result> apply(const version_ptr&, const selection&, const parameters&,
                                            context&) const override {
    return fail(ec::internal, "never called");
  }
};

class second_operation final : public operation {
public:
  [[nodiscard]] operation_description describe() const override {
    operation_description d;
    d.id = "second";
    return d;
  }
  [[nodiscard]] expected<edit_result> apply(const version_ptr&, const selection&, const parameters&,
                                            context&) const override {
    return fail(ec::internal, "never called");
  }
};

TEST(Descriptor, HoldsSeveralOperationsInOrder) {
  const auto d = make_descriptor<first_operation, second_operation>("two", "1.0.0");

  EXPECT_EQ(descriptor_fault(&d), "");
  ASSERT_EQ(d.operation_count, 2u);
  const std::shared_ptr<operation> first(d.create(0), d.destroy);
  const std::shared_ptr<operation> second(d.create(1), d.destroy);
  EXPECT_EQ(first->describe().id, "first");
  EXPECT_EQ(second->describe().id, "second");
  EXPECT_EQ(d.create(2), nullptr);
}

}  // namespace
}  // namespace tedit::ops
