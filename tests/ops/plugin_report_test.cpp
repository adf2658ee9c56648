// SPDX-License-Identifier: AGPL-3.0-or-later
// Plugins that another process describes: what it may say, and when the code comes into this one.
#include "ops/loader/plugin_report.hpp"

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ops/loader/catalogue.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// Every field has a value that no other one has.
described_operation full() {
  operation_description d;
  d.id = "full";
  d.name = "Full";
  d.summary = "Größe\tand\nlines";
  d.version = "1.2.3";
  d.selection = {"Walls.", 2, 7};
  d.icon = "<svg/>";
  d.guide = "**When**";
  d.rank = -5;
  d.best_for = "hole";
  d.parameters = {
    {"depth", "Depth", "How deep.", parameter_type::real, "m", -0.5, 1.5, {}, 0.25, "layers"},
    {"layers", "Layers", "", parameter_type::integer, "", {}, 9.0, {}, std::int64_t{-3}, {}},
    {"exact", "Exact", "", parameter_type::boolean, "", {}, {}, {}, true, {}},
    {"side", "", "", parameter_type::choice, "", {}, {}, {"in", "out"}, std::string("in"), {}},
    {"sizes", "", "", parameter_type::list, "m", 0.0, {}, {}, std::string("1, 2"), {}},
  };
  return {d, "full 1.2.3"};
}

std::vector<std::byte> with_id(const std::string& id) {
  auto one = full();
  one.description.id = id;
  return to_bytes({"", {one}});
}

TEST(PluginReport, EveryFieldCrossesTheBorder) {
  const auto back = report_from_bytes(to_bytes({"", {full(), {}}}));

  ASSERT_TRUE(back.has_value());
  ASSERT_EQ(back->operations.size(), 2u);
  const auto& d = back->operations[0].description;
  EXPECT_EQ(back->operations[0].plugin, "full 1.2.3");
  EXPECT_EQ(d.id + d.name + d.version, "fullFull1.2.3");
  EXPECT_EQ(d.summary, "Größe\tand\nlines");
  EXPECT_EQ(d.selection.help, "Walls.");
  EXPECT_EQ(d.selection.minimum, 2u);
  EXPECT_EQ(d.selection.maximum, 7u);
  EXPECT_EQ(d.icon + d.guide + d.best_for, "<svg/>**When**hole");
  EXPECT_EQ(d.rank, -5);
  ASSERT_EQ(d.parameters.size(), 5u);
  const auto& depth = d.parameters[0];
  EXPECT_EQ(depth.id + depth.name + depth.help, "depthDepthHow deep.");
  EXPECT_EQ(depth.type, parameter_type::real);
  EXPECT_EQ(depth.unit + depth.instead_of, "mlayers");
  EXPECT_EQ(depth.min, -0.5);
  EXPECT_EQ(depth.max, 1.5);
  EXPECT_EQ(depth.default_value, parameter_value(0.25));
  EXPECT_FALSE(d.parameters[1].min.has_value());
  EXPECT_EQ(d.parameters[1].default_value, parameter_value(std::int64_t{-3}));
  EXPECT_EQ(d.parameters[2].default_value, parameter_value(true));
  EXPECT_THAT(d.parameters[3].choices, ::testing::ElementsAre("in", "out"));
  EXPECT_EQ(d.parameters[4].default_value, parameter_value(std::string("1, 2")));
  EXPECT_TRUE(is_same(back->operations[0], full()));
  EXPECT_FALSE(is_same(back->operations[1], full()));
}

TEST(PluginReport, AReasonIsOneLineThatCanBeShown) {
  const auto back = report_from_bytes(to_bytes({"it has\n\x1b[2J no \xff entry", {}}));
  const auto lengthy = report_from_bytes(to_bytes({std::string(9000, 'x'), {}}));

  ASSERT_TRUE(back && lengthy);
  EXPECT_EQ(back->refusal, "it has  [2J no \xEF\xBF\xBD entry");
  EXPECT_EQ(lengthy->refusal, std::string(2000, 'x'));
}

TEST(PluginReport, WhatIsNoReportIsNotRead) {
  const auto whole = to_bytes({"", {full()}});
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(report_from_bytes(std::span(whole).first(size)).has_value()) << size;
  auto more = whole;
  more.push_back(std::byte{0});
  auto other = whole;
  other[0] ^= std::byte{1};

  EXPECT_FALSE(report_from_bytes(more).has_value());
  EXPECT_FALSE(report_from_bytes(other).has_value());
  EXPECT_FALSE(report_from_bytes(to_bytes({"", {}})).has_value()) << "neither a reason nor words";
  EXPECT_FALSE(report_from_bytes(to_bytes({"no", {full()}})).has_value()) << "both";
  EXPECT_THAT(report_from_bytes({}).error().message, HasSubstr("no answer that can be read"));
}

TEST(PluginReport, EachByteMayBeAnyOther) {
  const auto whole = to_bytes({"", {full()}});
  std::size_t read = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const unsigned value : {0U, 1U, 5U, 127U, 128U, 255U}) {
      auto wrong = whole;
      wrong[at] = static_cast<std::byte>(value);
      const auto report = report_from_bytes(wrong);
      read += report.has_value();
      for (const auto& one : report ? report->operations : std::vector<described_operation>())
        for (const auto& p : one.description.parameters)
          EXPECT_LE(p.type, parameter_type::list) << at;
    }
  }
  EXPECT_GT(read, 0u) << "another letter is still a text";
  EXPECT_LT(read, 6 * whole.size());
}

TEST(PluginReport, TextsThatTerminalsActOnAreRefused) {
  EXPECT_TRUE(report_from_bytes(with_id("good")).has_value());
  for (const char* bad : {"\x1b[31mred", "bell\a", "del\x7f", "\xff"})
    EXPECT_FALSE(report_from_bytes(with_id(bad)).has_value());
  auto one = full();
  one.description.parameters[3].choices[1] = "\x1b";
  EXPECT_THAT(text_fault(one), HasSubstr("control characters"));
  one = full();
  one.description.parameters[4].default_value = std::string("\x1b");
  EXPECT_THAT(text_fault(one), HasSubstr("control characters"));
  EXPECT_EQ(text_fault(full()), "");
}

TEST(PluginReport, ADescriptionThatIsTooLongIsAReason) {
  auto one = full();
  one.description.guide = std::string(most_report_bytes, 'x');

  const auto back = report_from_bytes(to_bytes({"", {one}}));

  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->refusal, "its description is longer than 4 MiB");
}

// -- in a catalogue ------------------------------------------------------------------------------

/// Whether the file is loaded into this process.
bool is_loaded(const fs::path& file) {
  std::ifstream in("/proc/self/maps");
  const std::string maps{std::istreambuf_iterator<char>(in), {}};
  return maps.find(fs::canonical(file).string()) != std::string::npos;
}

class Described : public ::testing::Test {
protected:
  void SetUp() override {
    auto pattern = (fs::temp_directory_path() / "tedit-described-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
    setenv("HOME", folder_.c_str(), 1);
    setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
  }
  void TearDown() override {
    unsetenv("TEDIT_LIBEXEC");
    fs::remove_all(folder_);
  }

  expected<edit_result> apply(const catalogue& plugins, const std::string& id) {
    context ctx;
    return run_operation(plugins, id, mesh_, {{1}}, {}, ctx);
  }

  fs::path folder_;
  const version_ptr mesh_ = test::box_mesh({4, 3, 3}, {0.04, 0.03, 0.03});
};

TEST_F(Described, TheCodeComesIntoTheProcessThatAppliesIt) {
  const fs::path file = TEDIT_EARLY_PLUGIN "/early.so";
  catalogue plugins;

  plugins.load_directory(TEDIT_EARLY_PLUGIN, load_care::describe);

  ASSERT_TRUE(plugins.find("early").has_value());
  EXPECT_EQ((*plugins.find("early"))->plugin, "early 1.0.0");
  EXPECT_EQ((*plugins.find("early"))->code->describe().summary, "Leaves traces.");
  EXPECT_FALSE(is_loaded(file));
  const auto applied = apply(plugins, "early");
  ASSERT_FALSE(applied.has_value());
  EXPECT_EQ(applied.error().message, "it was called");
  EXPECT_TRUE(is_loaded(file));
}

TEST_F(Described, ItSaysWhatLoadingItHereSays) {
  catalogue loaded;
  ASSERT_TRUE(loaded.load_file(TEDIT_RULE_BREAKER "/rule_breaker.so").has_value());

  const auto said = describe_plugin(TEDIT_RULE_BREAKER "/rule_breaker.so");

  EXPECT_EQ(said.refusal, "");
  ASSERT_EQ(said.operations.size(), 1u);
  const auto& entry = loaded.entries()[0];
  EXPECT_TRUE(is_same(said.operations[0], {entry.description, entry.plugin}));
}

TEST_F(Described, ATakenIdIsRefused) {
  auto one = full();
  one.description.id = "fill_hole";
  auto plugins = load_default_catalogue(plugin_source::built_in);
  const auto before = plugins.entries().size();

  plugins.load({{"/x/false.so", {}, {{one}}}, {"/x/twice.so", {}, {{full(), full()}}}});

  EXPECT_EQ(plugins.entries().size(), before);
  ASSERT_EQ(plugins.refused().size(), 2u);
  EXPECT_EQ(plugins.refused()[0].reason, "the operation id fill_hole is taken already");
  EXPECT_EQ(plugins.refused()[1].reason, "the operation id full is taken already");
}

TEST_F(Described, AFileThatIsGoneOrAnotherByThenIsNamed) {
  const fs::path other = TEDIT_RULE_BREAKER "/rule_breaker.so";
  auto gone = full();
  gone.description.id = "gone";
  catalogue plugins;
  plugins.load({{folder_ / "gone.so", {}, {{gone}}}, {other, {}, {{full()}}}});
  context ctx;

  const auto nowhere = run_operation(plugins, "gone", mesh_, {{1, 2}}, {}, ctx);
  const auto changed = run_operation(plugins, "full", mesh_, {{1, 2}}, {}, ctx);

  ASSERT_FALSE(nowhere || changed);
  EXPECT_EQ(nowhere.error().code, ec::plugin_refused);
  EXPECT_THAT(nowhere.error().message, HasSubstr("gone.so is not used: there is no file"));
  EXPECT_EQ(changed.error().message,
            "the plugin " + other.string() + " describes full otherwise than a moment ago");
}

TEST_F(Described, AnEndWithoutAnAnswerIsNoPermission) {
  const auto tool = folder_ / "tedit-probe";
  setenv("TEDIT_LIBEXEC", folder_.c_str(), 1);
  const auto says = [&](const std::string& script) {
    std::ofstream(tool) << "#!/bin/sh\n" + script;
    fs::permissions(tool, fs::perms::owner_all);
    return describe_plugin(TEDIT_RULE_BREAKER "/rule_breaker.so").refusal;
  };

  EXPECT_THAT(says("exit 0\n"), HasSubstr("tedit-probe gave no answer that can be read"));
  EXPECT_THAT(says("printf ok\n"), HasSubstr("gave no answer that can be read"));
  EXPECT_THAT(probe_plugin(TEDIT_RULE_BREAKER "/rule_breaker.so"), HasSubstr("gave no answer"));
  EXPECT_THAT(says("yes\n"), HasSubstr("tedit-probe wrote more than 4194304 bytes"));
}

}  // namespace
}  // namespace tedit::ops
