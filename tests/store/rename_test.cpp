// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents that get another name: the file goes there whole, and nothing is ever replaced.
#include <fstream>
#include <set>

#include "tests/store/fixture.hpp"

namespace tedit::store {
namespace {

class Rename : public Document {
protected:
  /// All that lies in the folder, but for the locks.
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder))
      if (const auto name = entry.path().filename().string(); name != ".tedit-lock")
        result.insert(name);
    return result;
  }

  void write(const std::string& name) const { std::ofstream(folder / name) << "somebody else's"; }
  [[nodiscard]] std::string text_of(const std::string& name) const {
    std::ifstream in(folder / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(Rename, TakesTheWholeDocumentAlongInOneFile) {
  const auto doc = open();
  ASSERT_TRUE(doc->commit(make_change(0)));
  ASSERT_TRUE(fs::exists(file.string() + "-wal"));

  const auto done = doc->rename("wing.tedit");

  ASSERT_TRUE(done.has_value()) << render(done.error());
  EXPECT_EQ(names(), (std::set<std::string>{"wing.tedit"}));
  ASSERT_TRUE(doc->commit(make_change(1)));
  EXPECT_EQ(doc->read().value().versions.size(), 2U);
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(Rename, MovesTheLockToo) {
  const auto doc = open();
  ASSERT_TRUE(doc->rename("wing.tedit"));

  EXPECT_NE(open(), nullptr) << "the name before is free";
  file = folder / "wing.tedit";
  EXPECT_EQ(refusal().code, ec::conflict);
}

TEST_F(Rename, ADocumentThatHasNoFileYetGetsItUnderThatName) {
  auto opened = document::open(file);
  ASSERT_TRUE(opened.has_value());
  ASSERT_TRUE((*opened)->rename("wing.tedit"));
  EXPECT_TRUE(names().empty());

  ASSERT_TRUE((*opened)->commit(make_change(0)));

  EXPECT_TRUE(names().contains("wing.tedit"));
  EXPECT_FALSE(names().contains("part.tedit"));
}

TEST_F(Rename, NeverTakesTheNameOfAnythingThatIsThere) {
  write("letter.tedit");
  write("gone.tedit-wal");
  write("torn.tedit-journal");
  fs::create_directory(folder / "folder.tedit");
  fs::create_symlink("nowhere", folder / "link.tedit");
  const auto doc = open();
  ASSERT_TRUE(doc->commit(make_change(0)));

  for (const auto* taken :
       {"letter.tedit", "gone.tedit", "torn.tedit", "folder.tedit", "link.tedit"}) {
    const auto refused = doc->rename(taken);
    ASSERT_FALSE(refused.has_value()) << taken;
    EXPECT_EQ(refused.error().code, ec::conflict) << render(refused.error());
    EXPECT_FALSE(refused.error().remedy.empty());
  }

  EXPECT_EQ(text_of("letter.tedit"), "somebody else's");
  ASSERT_TRUE(doc->commit(make_change(1)));
  EXPECT_TRUE(fs::exists(file));
}

TEST_F(Rename, NorThatOfADocumentThatIsOpenAndHasNoFileYet) {
  const auto doc = open();
  const auto other = document::open(folder / "wing.tedit");
  EXPECT_EQ(doc->rename("wing.tedit").error().code, ec::conflict);
  EXPECT_EQ((*other)->rename("part.tedit").error().code, ec::conflict);
}

/// Its log would stay behind, and what is written there would be lost.
TEST_F(Rename, IsRefusedWhileAnotherProgramHasTheDocumentOpen) {
  const auto doc = open();
  ASSERT_TRUE(doc->commit(make_change(0)));
  sqlite3* theirs = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &theirs), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(theirs, "SELECT count(*) FROM page", nullptr, nullptr, nullptr),
            SQLITE_OK);

  const auto refused = doc->rename("wing.tedit");

  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().message, HasSubstr("open in another program"));
  ASSERT_TRUE(doc->commit(make_change(1)));
  sqlite3_close(theirs);
  EXPECT_TRUE(doc->rename("wing.tedit"));
}

TEST_F(Rename, LeavesAFileAloneThatAnotherProgramChanged) {
  const auto doc = open();
  doc->rest();
  tamper("UPDATE seal SET rows = 9");

  const auto refused = doc->rename("wing.tedit");

  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().message, HasSubstr("changed by another program"));
  EXPECT_TRUE(fs::exists(file));
  EXPECT_FALSE(fs::exists(folder / "wing.tedit"));
}

TEST_F(Rename, ALinkToADocumentIsNotRenamed) {
  open();
  fs::create_symlink(file, folder / "link.tedit");
  auto opened = document::open(folder / "link.tedit");
  ASSERT_TRUE(opened.has_value());

  const auto refused = (*opened)->rename("wing.tedit");

  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().message, HasSubstr("is a link to"));
  EXPECT_TRUE(fs::exists(file));
}

}  // namespace
}  // namespace tedit::store
