// SPDX-License-Identifier: AGPL-3.0-or-later
// Plugins that crash while they work: one edit is lost, never the session.
#include "actors/supervisor/quarantine.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>

#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// An edit of the operation "bad" in a document.
actors::edit_origin bad_in(const std::string& document, const std::string& client = "") {
  return {"bad", document, client};
}

TEST(Quarantine, SwitchesOffInADocumentAfterSoManyEdits) {
  actors::quarantine off(2);

  EXPECT_FALSE(off.note(bad_in("plate", "Anna"), "hung and was killed"));
  EXPECT_FALSE(off.refusal(bad_in("plate")).has_value());
  EXPECT_TRUE(off.note(bad_in("plate", "Bert"), "was killed by signal 11"));

  ASSERT_TRUE(off.refusal(bad_in("plate")).has_value());
  EXPECT_EQ(off.refusal(bad_in("plate"))->code, ec::plugin_refused);
  EXPECT_EQ(
    off.refusal(bad_in("plate"))->message,
    "the operation bad is switched off: in the document \"plate\" its plugin failed 2 edits, "
    "the last asked for by Bert: the process that ran it was killed by signal 11");
  EXPECT_FALSE(off.refusal(bad_in("bracket")).has_value());
  EXPECT_FALSE(off.refusal({"good", "plate", ""}).has_value());
}

TEST(Quarantine, SwitchesOffEverywhereAfterSoManyDocuments) {
  actors::quarantine off(2);
  for (const auto* document : {"plate", "bracket"})
    for (int edit = 0; edit < 2; ++edit) {
      EXPECT_FALSE(off.refusal(bad_in("other")).has_value());
      off.note(bad_in(document), "crashed");
    }

  ASSERT_TRUE(off.refusal(bad_in("other")).has_value());
  EXPECT_THAT(off.refusal(bad_in("other"))->message,
              AllOf(HasSubstr("in the document \"bracket\" its plugin failed 2 edits"),
                    HasSubstr("in the document \"plate\" its plugin failed 2 edits")));
}

TEST(Quarantine, ZeroSwitchesNothingOff) {
  actors::quarantine off(0);
  for (int i = 0; i < 10; ++i)
    EXPECT_FALSE(off.note(bad_in("plate"), "crashed"));
  EXPECT_FALSE(off.refusal(bad_in("plate")).has_value());
}

TEST(Quarantine, WhatIsOffEverywhereStandsAmongTheRefusedOfTheCatalogue) {
  operation_catalogue all{{{{}, "bad 1.0"}, {{}, "g 2"}}, {}};
  all.operations[0].about.id = "bad";
  all.operations[1].about.id = "good";
  actors::quarantine two(2);
  two.note(bad_in("plate"), "crashed");
  two.note(bad_in("plate"), "crashed");
  EXPECT_EQ(two.apply_to(all).operations.size(), 2u);

  actors::quarantine off(1);
  off.note(bad_in("plate"), "crashed");
  const auto [operations, refused] = off.apply_to(all);

  ASSERT_EQ(operations.size(), 1u);
  EXPECT_EQ(operations[0].about.id, "good");
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_EQ(refused[0].file, "bad 1.0");
  EXPECT_THAT(refused[0].reason, HasSubstr("switched off"));
  EXPECT_EQ(refused[0].operation, "bad");
  EXPECT_EQ(refused[0].crashes, 1u);
  EXPECT_THAT(refused[0].remedy, HasSubstr("start the server anew"));
}

/// What "tedit ops" prints, with these arguments.
std::string listed(const std::string& arguments) {
  const auto command = std::string(TEDIT_BIN "/tedit ops ") + arguments + " 2>&1";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> buffer;
  while (pipe && std::fgets(buffer.data(), buffer.size(), pipe.get()))
    text += buffer.data();
  return text;
}

bool offers(client::client& user, const std::string& operation) {
  const auto all = value(user.operations()).operations;
  return std::ranges::any_of(all, [&](const auto& one) { return one.about.id == operation; });
}

class CrashingPlugin : public ::testing::Test {
protected:
  scratch_folder folder;

  void SetUp() override {
    setenv("TEDIT_PLUGIN_PATH", TEDIT_RULE_BREAKER, 1);
    setenv("XDG_CACHE_HOME", folder.path().c_str(), 1);
  }
  void TearDown() override {
    unsetenv("TEDIT_PLUGIN_PATH");
    unsetenv("TEDIT_BREAK");
  }
};

TEST_F(CrashingPlugin, CostsOneEditAndIsSwitchedOffThereWhileOthersGoOn) {
  setenv("TEDIT_BREAK", "surface_two", 1);
  const auto host = start(options_for(folder, true));
  const auto user = connect(host->url());
  value(user->open("plate", true, true));
  const auto imported = value(user->import_file(plate_mesh, "mm", {}));

  for (int edit = 0; edit < 3; ++edit) {
    const auto crashed = user->edit("rule_breaker", {2}, {}, {});
    ASSERT_FALSE(crashed.has_value());
    EXPECT_EQ(crashed.error().code, edit < 2 ? ec::internal : ec::plugin_refused);
    EXPECT_THAT(crashed.error().message, AllOf(HasSubstr("rule_breaker"), HasSubstr("signal 11")));
  }

  // Whatever the edit: it is off in this document.
  const auto again = user->edit("rule_breaker", {1}, {}, {});
  ASSERT_FALSE(again.has_value());
  EXPECT_EQ(again.error().code, ec::plugin_refused);
  EXPECT_THAT(again.error().message,
              HasSubstr("in the document \"plate\" its plugin failed 3 edits"));
  EXPECT_EQ(value(user->edit("fill_hole", {1, 2}, {}, {})).head.parent, imported.head.number);
  // Correct edits go on elsewhere.
  const auto other = connect(host->url());
  value(other->open("other", false, false));
  value(other->import_file(plate_mesh, "mm", {}));
  EXPECT_EQ(value(other->edit("rule_breaker", {1}, {}, {})).head.number, 1U);
  EXPECT_TRUE(offers(*user, "rule_breaker"));
}

TEST_F(CrashingPlugin, ThatIsOffEverywhereIsListedWithTheWayBack) {
  setenv("TEDIT_BREAK", "every_surface_alone", 1);
  auto options = options_for(folder, true);
  options.quarantine_after = 1;
  const auto host = start(options);
  const auto user = connect(host->url());
  value(user->open("plate", true, true));
  value(user->import_file(plate_mesh, "mm", {}));
  EXPECT_TRUE(offers(*user, "rule_breaker"));

  EXPECT_EQ(user->edit("rule_breaker", {1}, {}, {}).error().code, ec::plugin_refused);

  EXPECT_FALSE(offers(*user, "rule_breaker"));
  const auto refused = value(user->operations()).refused;
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_THAT(refused[0].reason, HasSubstr("switched off"));
  const auto token = folder.path() / "token";
  std::ofstream(token) << "secret-of-the-test";
  std::filesystem::permissions(token, std::filesystem::perms(0600));
  EXPECT_THAT(listed("--server " + host->url() + " --token-file " + token.string()),
              AllOf(HasSubstr("fill_hole 1"), HasSubstr("quarantined: rule_breaker (rule_breaker"),
                    HasSubstr(", 1 crash: "), HasSubstr("to lift it: start the server anew")));
}

/// Plugins that harm more than their own edit: the server goes on, and the next edit is made.
class HarmfulPlugin : public CrashingPlugin, public ::testing::WithParamInterface<const char*> {};

INSTANTIATE_TEST_SUITE_P(Rules, HarmfulPlugin,
                         ::testing::Values("kills_parent", "kills_group", "leaves_no_descriptor",
                                           "leaks"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(HarmfulPlugin, LeavesTheNextEditAlone) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  if (GetParam() == std::string("leaks"))
    GTEST_SKIP() << "sanitizers reserve terabytes: nothing limits memory but the machine's";
#endif
  setenv("TEDIT_BREAK", GetParam(), 1);
  auto options = options_for(folder, true);
  options.modeling_memory_mb = 1500;
  const auto host = start(options);
  const auto user = connect(host->url());
  value(user->open("plate", false, false));
  value(user->import_file(plate_mesh, "mm", {}));

  for (int round = 0; round < 2; ++round) {
    const auto harmed = user->edit("rule_breaker", {1}, {}, {});
    if (!harmed) {
      EXPECT_THAT(harmed.error().message, HasSubstr("rule_breaker"));
      EXPECT_NE(harmed.error().code, ec::plugin_refused);
    }
    EXPECT_FALSE(harmed && std::string(GetParam()).starts_with("kills"));
    const auto filled = user->edit("fill_hole", {1, 2}, {}, {});  // Needs a program of its own.
    EXPECT_TRUE(filled.has_value()) << render(filled.error());
    value(user->undo());
  }
  EXPECT_EQ(value(user->status()).workers.front().state, "ready");
}

TEST(ServedOperations, AreDescribedAsTheLocalOnes) {
  const scratch_folder folder;
  const auto host = start(options_for(folder, false));
  const auto token = folder.path() / "token";
  std::ofstream(token) << "secret-of-the-test";
  std::filesystem::permissions(token, std::filesystem::perms(0600));
  const auto server = " --server " + host->url() + " --token-file " + token.string();

  EXPECT_EQ(listed("erode" + server), listed("erode"));
  EXPECT_THAT(listed("erode" + server), HasSubstr("    depth (real, m; or depth_mm"));
  EXPECT_THAT(listed("erod" + server), HasSubstr("Did you mean erode?"));
}

TEST_F(CrashingPlugin, ThatCrashesWhenItIsTriedIsListedWithTheWayBack) {
  setenv("TEDIT_BREAK", "file_opens", 1);

  const auto text = listed("");

  EXPECT_THAT(text,
              AllOf(HasSubstr("quarantined: " TEDIT_RULE_BREAKER "/rule_breaker.so, 1 crash: "),
                    HasSubstr("to lift it: remove " + folder.path().string())));
  unsetenv("TEDIT_BREAK");
  std::filesystem::remove_all(folder.path() / "tedit/probes");
  EXPECT_THAT(listed(""), AllOf(HasSubstr("rule_breaker 1"), Not(HasSubstr("quarantined"))));
}

TEST_F(CrashingPlugin, AHangIsEndedByTheLimitOfEdits) {
  setenv("TEDIT_BREAK", "hang", 1);
  auto options = options_for(folder, true);
  options.edit_limit = std::chrono::seconds(3);
  options.quarantine_after = 1;
  const auto host = start(options);
  const auto user = connect(host->url());
  value(user->open("plate", true, true));
  value(user->import_file(plate_mesh, "mm", {}));

  const auto hung = user->edit("rule_breaker", {1}, {}, {});

  ASSERT_FALSE(hung.has_value());
  EXPECT_EQ(hung.error().code, ec::timeout);
  EXPECT_THAT(hung.error().message, HasSubstr("the operation rule_breaker did not end within 3 s"));
  const auto again = user->edit("rule_breaker", {1}, {}, {});
  ASSERT_FALSE(again.has_value());
  EXPECT_THAT(again.error().message, HasSubstr("hung and was killed"));
  EXPECT_TRUE(user->get_history().has_value()) << "the session goes on";
}

TEST_F(CrashingPlugin, SafeModeLeavesItOut) {
  auto options = options_for(folder, true);
  options.safe_mode = true;
  const auto host = start(options);
  const auto user = connect(host->url());
  value(user->open("plate", true, true));
  value(user->import_file(plate_mesh, "mm", {}));

  const auto refused = user->edit("rule_breaker", {1}, {}, {});

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::operation_not_found);
  EXPECT_TRUE(user->edit("fill_hole", {1, 2}, {}, {}).has_value());
}

}  // namespace
}  // namespace tedit::test
