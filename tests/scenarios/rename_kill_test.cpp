// SPDX-License-Identifier: AGPL-3.0-or-later
// A server that is killed, or whose disk fails, while a document gets another name.
#include <set>
#include <thread>

#include "tests/scenarios/disk_fault.hpp"

#include "tests/support/parts.hpp"

namespace tedit::test {
namespace {

/// Documents that have a file.
std::set<std::string> names_in(const scratch_folder& folder) {
  std::set<std::string> result;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "documents"))
    if (entry.path().extension() == ".tedit")
      result.insert(entry.path().stem().string());
  return result;
}

class RenameFault : public ::testing::TestWithParam<const char*> {
protected:
  scratch_folder folder;
  disk_fault fault{folder};
  std::optional<served> host;
  std::unique_ptr<client::client> user;

  void SetUp() override {
    if (!disk_fault::possible)
      GTEST_SKIP() << "sanitizers want to be loaded first";
    host.emplace(folder);
    user = host->connect();
    value(user->open("cube", false, false));
    value(user->import_file(test::cube_mesh, "mm", {}));
    value(user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {}));
  }

  /// The one document that a new server finds has all that was acknowledged.
  void expect_whole(const std::string& name) {
    EXPECT_EQ(names_in(folder), std::set<std::string>{name});
    fault.end();
    user.reset();
    host.reset();
    host.emplace(folder);
    user = host->connect();
    const auto state = value(user->open(name, false, false));
    ASSERT_TRUE(state.head.has_value());
    EXPECT_EQ(state.head->number, 1U);
  }
};

using RenameKill = RenameFault;
INSTANTIATE_TEST_SUITE_P(Moments, RenameKill, ::testing::Values("end-before", "end-after"),
                         [](const auto& test) {
                           return std::string(test.param) == "end-before" ? "Before" : "After";
                         });

TEST_P(RenameKill, LeavesOneOfTheTwoNamesWithEverything) {
  fault.begin(GetParam());

  const auto lost = user->rename_document("wing");

  ASSERT_FALSE(lost.has_value());
  EXPECT_EQ(lost.error().code, ec::service_unavailable) << render(lost.error());
  expect_whole(GetParam() == std::string("end-before") ? "cube" : "wing");
}

INSTANTIATE_TEST_SUITE_P(Disks, RenameFault,
                         ::testing::Values("rename", "folder", "sync", "write", "full"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(RenameFault, LeavesTheDocumentUnderTheNameThatIsSaid) {
  const std::string what = GetParam();
  fault.begin(what);

  const auto done = user->rename_document("wing");

  // The others strike what is in the log, which may be nothing by now.
  EXPECT_FALSE(done && (what == "rename" || what == "folder"));
  EXPECT_TRUE(done || !done.error().remedy.empty()) << render(done.error());
  EXPECT_EQ(names_in(folder), std::set<std::string>{done ? "wing" : "cube"});
  fault.end();
  value(user->undo());
  value(user->redo());
  value(user->rename_document("tail"));
  value(user->rename_document("cube"));
  expect_whole("cube");
}

/// kill -9 in a stream of renames and changes; TEDIT_RENAME_KILLS=1000 is the long run.
TEST(RenameKills, AcknowledgedChangesAreThereUnderOneNameAfterAKillAtAnyMoment) {
  const char* wanted = std::getenv("TEDIT_RENAME_KILLS");
  const int kills = wanted ? std::atoi(wanted) : 5;
  const scratch_folder folder;
  int noted = 0;  // The last one that was acknowledged; the next one may be there, too.
  int names = 0;
  for (int round = 0; round < kills; ++round) {
    served host(folder);
    auto user = host.connect();
    auto other = host.connect();
    if (round == 0) {
      value(user->open("name-0", false, false));
      value(user->import_file(test::cube_mesh, "mm", {}));
    }
    const auto there = names_in(folder);
    ASSERT_EQ(there.size(), 1U) << "round " << round;
    const auto state = value(user->open(*there.begin(), false, false));
    ASSERT_TRUE(state.head.has_value());
    if (round > 0) {
      const int found = std::stoi(state.head->name);
      EXPECT_TRUE(found == noted || found == noted + 1) << found << " instead of " << noted;
      noted = found;
    }
    value(other->open(*there.begin(), false, false));
    value(other->annotate(0, std::to_string(++noted), {}));
    std::thread killer([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(20 + 37 * round % 211));
      host.kill();
    });
    std::thread renamer([&] {
      while (user->rename_document("name-" + std::to_string(++names)))
        ;
    });
    while (other->annotate(0, std::to_string(noted + 1), {}))
      ++noted;
    killer.join();
    renamer.join();
  }
}

}  // namespace
}  // namespace tedit::test
