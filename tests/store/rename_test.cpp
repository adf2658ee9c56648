// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents that get another name: the file goes there whole, and nothing is ever replaced.
#include <ctime>
#include <fstream>
#include <set>

#include "actors/store/former_names.hpp"
#include "tests/store/fixture.hpp"

namespace tedit::store {
namespace {

class Rename : public Document {
protected:
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

using names_of_before = std::vector<std::pair<std::string, std::string>>;

// A client that did not hear of the new name came back after a restart and began another document.
TEST_F(Rename, TheNamesOfBeforeAreKnownAlsoToALaterServer) {
  const auto doc = open();
  ASSERT_TRUE(doc->commit(make_change(0)));
  ASSERT_TRUE(doc->rename("wing.tedit"));
  ASSERT_TRUE(doc->rename("tail.tedit"));
  EXPECT_EQ(read_former_names(folder), (names_of_before{{"part", "tail"}, {"wing", "tail"}}));

  ASSERT_TRUE(doc->rename("wing.tedit"));
  EXPECT_EQ(read_former_names(folder), (names_of_before{{"part", "wing"}, {"tail", "wing"}}));
}

TEST_F(Rename, ANameOfBeforeThatAnotherDocumentHasLeadsNowhere) {
  ASSERT_TRUE(open()->rename("wing.tedit"));
  ASSERT_NE(open(), nullptr);
  EXPECT_EQ(read_former_names(folder), names_of_before());
  fs::remove(file);
  EXPECT_EQ(read_former_names(folder), (names_of_before{{"part", "wing"}}));
  fs::remove(folder / "wing.tedit");
  EXPECT_EQ(read_former_names(folder), names_of_before());
}

TEST_F(Rename, NotesThatAreNoneAreLeftOut) {
  ASSERT_TRUE(open()->rename("wing.tedit"));
  const auto notes = folder / ".tedit-names";
  const auto good = text_of(".tedit-names");
  const auto now = std::to_string(std::time(nullptr));
  const std::vector<std::string> all_bad = {"x",
                                            now + " a",
                                            now + " a wing",
                                            "1 a wing .",
                                            "99999999999999 a wing .",
                                            now + " a " + std::string(300, 'w') + " .",
                                            std::string(1, '\0')};
  for (const auto& bad : all_bad) {
    std::ofstream(notes, std::ios::binary) << bad << good;
    EXPECT_EQ(read_former_names(folder), (names_of_before{{"part", "wing"}})) << bad;
  }
  fs::remove(notes);
  EXPECT_EQ(read_former_names(folder), names_of_before());
}

}  // namespace
}  // namespace tedit::store
