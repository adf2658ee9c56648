// SPDX-License-Identifier: AGPL-3.0-or-later
// The command line with a plugin of others whose code leaves traces wherever it runs unconfined,
// beside one that behaves.
#include "sandbox/sandbox.hpp"
#include "tests/cli/misdeed.hpp"

namespace tedit::test {
namespace {

namespace fs = std::filesystem;

/// The names that the plugin left in its user's home, sorted.
std::string traces_in(const fs::path& home) {
  std::vector<std::string> names;
  for (const auto& item : fs::directory_iterator(home))
    if (item.path().filename().string().starts_with("early-"))
      names.push_back(item.path().filename());
  std::ranges::sort(names);
  std::string text;
  for (const auto& name : names)
    text += name + " ";
  return text;
}

class PluginStart : public ::testing::Test {
protected:
  void SetUp() override {
    if (const auto can = sandbox::check(); !can)
      GTEST_SKIP() << render(can.error());
    for (const auto& folder : {home_, cache_}) {
      fs::remove_all(folder);
      fs::create_directories(folder);
    }
    setenv("HOME", home_.c_str(), 1);
    setenv("XDG_CACHE_HOME", cache_.c_str(), 1);
    setenv("TEDIT_PLUGIN_PATH", TEDIT_EARLY_PLUGIN ":" TEDIT_RULE_BREAKER, 1);
  }
  void TearDown() override {
    setenv("HOME", old_home_.c_str(), 1);
    for (const char* name : {"XDG_CACHE_HOME", "TEDIT_PLUGIN_PATH", "TEDIT_EARLY", "TEDIT_SANDBOX"})
      unsetenv(name);
  }

  static std::string edit(const std::string& operation) {
    return "edit --json " + block + " --op " + operation + " --surfaces 4";
  }

  const std::string old_home_ = std::getenv("HOME") ? std::getenv("HOME") : "/";
  const fs::path home_ = scratch("home");
  const fs::path cache_ = scratch("cache");
};

TEST_F(PluginStart, NoCommandRunsItsCodeUnconfined) {
  for (int i = 0; i < 2; ++i) {  // Not yet tried out, and known to be fine.
    const auto listed = run("ops");
    EXPECT_EQ(listed.status, 0);
    EXPECT_THAT(listed.out, HasSubstr("early 1.0.0  Leaves traces.\n    select: Any surface.\n"));
    EXPECT_THAT(listed.out, HasSubstr("\nrule_breaker 1.0.0  Moves surfaces"));
    EXPECT_THAT(run("doctor").out, HasSubstr("ok    operation early: early 1.0.0"));
    EXPECT_EQ(run(edit("rule_breaker --param distance=0.0001")).status, 0);
    EXPECT_EQ(run(edit("early")).parsed()["error"].value("message", ""), "it was called");

    EXPECT_EQ(traces_in(home_), "");
  }
}

TEST_F(PluginStart, WithoutTheSandboxItLeavesThem) {
  setenv("TEDIT_SANDBOX", "off", 1);

  EXPECT_EQ(run("ops").status, 0);
  EXPECT_EQ(traces_in(home_),
            "early-describe early-describe.socket early-start early-start.socket ");
  EXPECT_EQ(run(edit("early")).parsed()["error"].value("message", ""), "it was called");
  EXPECT_THAT(traces_in(home_), HasSubstr("early-apply early-apply.socket "));
}

TEST_F(PluginStart, AConnectionFromItIsNamedAndKeepsItOut) {
  for (const char* stage : {"start", "describe"}) {
    setenv("TEDIT_EARLY", stage, 1);
    fs::remove_all(cache_);
    for (int i = 0; i < 2; ++i) {
      const auto listed = run("ops");
      EXPECT_THAT(listed.out, HasSubstr("quarantined: " TEDIT_EARLY_PLUGIN
                                        "/early.so, 1 crash: it breaks the process that loads it: "
                                        "tedit-probe tried to open a network connection; remove "));
      EXPECT_THAT(listed.out, HasSubstr("\nrule_breaker 1.0.0  "));
      EXPECT_THAT(run("doctor").out, HasSubstr("FAIL  plugin early.so: it breaks the process"));
      EXPECT_EQ(run(edit("early")).parsed()["error"]["code"], "operation_not_found");
      EXPECT_EQ(run(edit("rule_breaker --param distance=0.0001")).status, 0);
    }
  }
  EXPECT_EQ(traces_in(home_), "");
}

TEST_F(PluginStart, OneThatBehavesIsDescribedInFull) {
  EXPECT_EQ(run("ops rule_breaker").out,
            "rule_breaker 1.0.0  Moves surfaces along their mean normals.\n"
            "    select: Surfaces to move.\n"
            "    distance (real, m; or distance_mm, -0.004 to 0.004, default 0.001): How far.\n"
            "    layers (integer, default 1): Nothing depends on it.\n");
  const auto row = run("ops rule_breaker --json").parsed()["operations"][0];
  EXPECT_EQ(row["plugin"], "rule_breaker 1.0.0");
  EXPECT_EQ(row["parameters"][1], (json{{"id", "layers"},
                                        {"name", "Layers"},
                                        {"type", "integer"},
                                        {"unit", ""},
                                        {"help", "Nothing depends on it."},
                                        {"default", 1},
                                        {"min", 1.0}}));
}

TEST_F(PluginStart, OneThatBehavesEditsAloneAndInARecipe) {
  const auto recipe = scratch("recipe.json");
  const json edit_step{
    {"operation", "rule_breaker"}, {"surfaces", {4}}, {"parameters", {{"distance", 0.0001}}}};
  std::ofstream(recipe) << json{
    {"steps", {{{"import", {{"mesh", block}}}}, {{"edit", edit_step}}}}};

  const auto alone = run(edit("rule_breaker --param distance=0.0001")).parsed();
  const auto recipes =
    run("run --json " + recipe.string() + " --out " + scratch("out").string()).parsed();

  EXPECT_GT(alone.value("tets_added", 0), 0);
  EXPECT_EQ(recipes["steps"][1].value("to_version", ""), alone.value("to_version", "-"));
  EXPECT_EQ(traces_in(home_), "");
}

}  // namespace
}  // namespace tedit::test
