// SPDX-License-Identifier: AGPL-3.0-or-later
// Plugins that break the process that loads them.
#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ops/loader/catalogue.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

const fs::path breaker = TEDIT_RULE_BREAKER "/rule_breaker.so";

/// A cache of its own, and the plugin's misdeed.
class Loading : public ::testing::Test {
protected:
  void SetUp() override {
    auto pattern = (fs::temp_directory_path() / "tedit-loading-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
    setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
    setenv("TEDIT_PLUGIN_PATH", TEDIT_RULE_BREAKER, 1);
    setenv("XDG_DATA_HOME", folder_.c_str(), 1);
  }
  void TearDown() override {
    for (const char* name : {"TEDIT_BREAK", "TEDIT_PLUGIN_PATH", "XDG_DATA_HOME"})
      unsetenv(name);
    fs::remove_all(folder_);
  }

  static std::string kept(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_;
};

TEST_F(Loading, AGoodPluginIsProbedOnce) {
  EXPECT_EQ(probe_plugin(breaker), "");
  EXPECT_EQ(kept(probe_cache(breaker)), "ok");
  setenv("TEDIT_LIBEXEC", "/nowhere", 1);

  EXPECT_EQ(probe_plugin(breaker), "") << "the cache answers, no program runs";
}

TEST_F(Loading, WithoutTheProbeNothingUnknownIsLoaded) {
  setenv("TEDIT_LIBEXEC", "/nowhere", 1);

  EXPECT_THAT(probe_plugin(breaker), HasSubstr("/nowhere/tedit-probe is not there"));
}

TEST_F(Loading, ACrashWhileLoadingIsNamedAndKeptFromThisProcess) {
  setenv("TEDIT_BREAK", "file_opens", 1);

  const auto plugins = load_default_catalogue();

  ASSERT_EQ(plugins.refused().size(), 1u);
  EXPECT_EQ(plugins.refused()[0].file, breaker);
  EXPECT_THAT(plugins.refused()[0].reason, HasSubstr("signal 6"));
  EXPECT_TRUE(plugins.find("fill_hole").has_value()) << "the others are there";
  unsetenv("TEDIT_BREAK");
  EXPECT_THAT(probe_plugin(breaker), HasSubstr("signal 6")) << "the verdict is kept";
  fs::remove(probe_cache(breaker));
  EXPECT_EQ(probe_plugin(breaker), "") << "until its file is removed, as the reason says";
}

TEST_F(Loading, WhatThrowsInDescribeIsRefusedEachTimeAnew) {
  setenv("TEDIT_BREAK", "makes_operations", 1);
  EXPECT_THAT(probe_plugin(breaker), HasSubstr("no licence file"));
  unsetenv("TEDIT_BREAK");

  EXPECT_EQ(probe_plugin(breaker), "");
}

TEST_F(Loading, SafeModeUsesBuiltInPluginsOnly) {
  const auto all = load_default_catalogue();
  const auto safe = load_default_catalogue(plugin_source::built_in);

  EXPECT_TRUE(all.find("rule_breaker").has_value());
  EXPECT_FALSE(safe.find("rule_breaker").has_value());
  EXPECT_TRUE(safe.find("fill_hole").has_value());
  EXPECT_TRUE(safe.refused().empty());
}

TEST_F(Loading, WhoAsksForOneThatCameWithTheProgramLoadsItAlone) {
  const auto safe = load_default_catalogue(plugin_source::built_in);
  ASSERT_GT(safe.entries().size(), 20u);
  for (const auto& one : safe.entries()) {
    const auto alone = load_catalogue_for(one.description.id);
    ASSERT_EQ(alone.entries().size(), 1u) << one.description.id;
    EXPECT_EQ(alone.entries()[0].description.id, one.description.id);
  }

  EXPECT_TRUE(load_catalogue_for("rule_breaker").find("rule_breaker").has_value()) << "of others";
  EXPECT_TRUE(load_catalogue_for("fil_hole").find("fill_hole").has_value())
    << "to name the nearest";
}

TEST_F(Loading, AFileThatIsNoLibraryIsNamed) {
  const auto file = folder_ / "text.so";
  std::ofstream(file) << "no library at all, only some words";

  catalogue plugins;
  plugins.load_directory(folder_, load_care::probe);

  ASSERT_EQ(plugins.refused().size(), 1u);
  EXPECT_THAT(plugins.refused()[0].reason, HasSubstr("no shared library"));
}

TEST(DlError, IsToldInWordsOfPeople) {
  EXPECT_EQ(readable_dl_error("libfoo.so.1: cannot open shared object file: No such file or "
                              "directory"),
            "it needs libfoo.so.1, which is not installed");
  EXPECT_EQ(readable_dl_error("/x/a.so: cannot open shared object file: No such file or directory"),
            "there is no file /x/a.so");
  EXPECT_EQ(readable_dl_error("/x/a.so: undefined symbol: _ZN5tedit12total_volumeERKNS_12mesh_"
                              "versionE"),
            "it uses tedit::total_volume(tedit::mesh_version const&), which neither it nor the "
            "libraries that it names have");
  EXPECT_EQ(readable_dl_error("/lib/libc.so.6: version `GLIBC_2.99' not found (required by a.so)"),
            "it was built on a newer system: version `GLIBC_2.99' not found (required by a.so)");
  EXPECT_EQ(readable_dl_error("something else"), "something else");
}

}  // namespace
}  // namespace tedit::ops
