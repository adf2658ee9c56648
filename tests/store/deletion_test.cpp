// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents that go with all that lies beside them, and copies that are made before.
#include "actors/store/deletion.hpp"

#include <sys/wait.h>

#include <fstream>
#include <set>

#include "actors/store/document_lock.hpp"
#include "actors/store/documents_folder.hpp"
#include "actors/store/former_names.hpp"
#include "tests/store/fixture.hpp"

namespace tedit::store {
namespace {

class Deletion : public Document {
protected:
  /// As a kill leaves a document: with its last commit in the log.
  void make_and_be_killed() const {
    if (const auto child = ::fork(); child == 0) {
      const auto doc = document::open(file);
      const bool made = doc && (*doc)->commit(make_change(0)) && (*doc)->commit(make_change(1));
      ::_exit(made ? 0 : 1);
    } else {
      int how = 0;
      ASSERT_EQ(::waitpid(child, &how, 0), child);
      ASSERT_EQ(how, 0);
    }
    ASSERT_TRUE(fs::exists(file.string() + "-wal"));
  }

  void write(const fs::path& path, const std::string& text) const { std::ofstream(path) << text; }
};

TEST_F(Deletion, AnOpenDocumentGoesWithItsLogAndItsNameIsFreeAfterwards) {
  auto doc = open();
  ASSERT_TRUE(doc->commit(make_change(0)));
  ASSERT_TRUE(fs::exists(file.string() + "-wal"));

  const auto done = doc->erase();

  ASSERT_TRUE(done.has_value()) << render(done.error());
  EXPECT_TRUE(names().empty());
  EXPECT_EQ(refusal().code, ec::conflict) << "its name is locked until the object goes";
  doc.reset();
  const auto next = open();
  EXPECT_TRUE(next->read().value().versions.empty());
}

TEST_F(Deletion, ADocumentWithoutAFileIsErasedWithoutOne) {
  auto doc = document::open(file);
  ASSERT_TRUE(doc.has_value());
  EXPECT_TRUE((*doc)->erase().has_value());
  EXPECT_TRUE(names().empty());
}

TEST_F(Deletion, OneThatAKillLeftGoesWithItsLog) {
  make_and_be_killed();
  const auto done = delete_document(file);
  ASSERT_TRUE(done.has_value()) << render(done.error());
  EXPECT_TRUE(names().empty());
}

TEST_F(Deletion, DamagedOnesGoToo) {
  ASSERT_TRUE(open()->commit(make_change(0)));
  tamper("UPDATE version SET report = 'another'");
  ASSERT_FALSE(open()->read().has_value());
  EXPECT_TRUE(delete_document(file).has_value());
  EXPECT_TRUE(names().empty());
}

TEST_F(Deletion, OneThatIsOpenIsRefusedAndStays) {
  const auto doc = open();
  const auto refused = delete_document(file);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::conflict);
  EXPECT_FALSE(refused.error().remedy.empty());
  EXPECT_TRUE(doc->commit(make_change(0)));
}

TEST_F(Deletion, WhatIsNoDocumentIsLeftAlone) {
  EXPECT_EQ(delete_document(file).error().code, ec::not_found);
  const auto refused = [&](const char* words) {
    const auto got = delete_document(file);
    ASSERT_FALSE(got.has_value());
    EXPECT_EQ(got.error().code, ec::storage_error);
    EXPECT_THAT(got.error().message, HasSubstr(words));
    EXPECT_THAT(got.error().remedy, HasSubstr("by hand"));
    EXPECT_TRUE(fs::exists(file));
  };
  write(file, "Dear all");
  refused("not a database");
  write(file, "");
  refused("is empty");
  fs::remove(file);
  tamper("CREATE TABLE letter(text TEXT)");
  refused("no TEdit document");
}

TEST_F(Deletion, ALinkIsNotFollowed) {
  const auto there = folder / "elsewhere.tedit";
  open().reset();
  fs::rename(file, there);
  fs::create_symlink(there, file);

  const auto refused = delete_document(file);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::conflict);
  EXPECT_THAT(refused.error().message, HasSubstr("link"));
  EXPECT_EQ(open()->erase().error().code, ec::conflict);
  EXPECT_TRUE(fs::exists(there));
}

TEST_F(Deletion, TheNamesThatItHadLeadToNoLaterDocumentOfItsName) {
  ASSERT_TRUE(open()->rename("wing.tedit"));
  file = folder / "wing.tedit";
  ASSERT_EQ(read_former_names(folder).size(), 1U);
  ASSERT_TRUE(delete_document(file));
  EXPECT_TRUE(read_former_names(folder).empty());
  open().reset();
  EXPECT_TRUE(read_former_names(folder).empty()) << "part was the one before";
  ASSERT_TRUE(open()->rename("tail.tedit"));
  EXPECT_EQ(read_former_names(folder),
            (std::vector<std::pair<std::string, std::string>>{{"wing", "tail"}}));
}

/// The hidden name is all that such a document has; what lay beside it would block its own.
TEST_F(Deletion, WhatAKillLeftOfItGoesWhenTheFolderIsPrepared) {
  make_and_be_killed();
  fs::rename(file, folder / ".part.tedit-erased");
  ASSERT_FALSE(document::open(file).has_value()) << "the log keeps others from the name";

  ASSERT_TRUE(prepare_documents_folder(folder).has_value());
  EXPECT_TRUE(names().empty());
  EXPECT_NE(open(), nullptr);

  // Not that of a document which has the name since.
  write(folder / ".part.tedit-erased", "rest");
  write(file.string() + "-wal", "of the new one");
  ASSERT_TRUE(prepare_documents_folder(folder).has_value());
  EXPECT_EQ(names(), (std::set<std::string>{"part.tedit", "part.tedit-wal"}));
}

TEST_F(Deletion, ACopyHasWhatWasCommittedAndGoesItsOwnWay) {
  const auto doc = open();
  ASSERT_TRUE(doc->commit(make_change(0)));
  const auto target = folder / "copy.tedit";

  const auto done = doc->copy_to(target);

  ASSERT_TRUE(done.has_value()) << render(done.error());
  ASSERT_TRUE(doc->commit(make_change(1)));
  const auto copy = document::open(target);
  ASSERT_TRUE(copy.has_value());
  EXPECT_EQ((*copy)->read().value().versions.size(), 1U);
  EXPECT_EQ(doc->read().value().versions.size(), 2U);
  EXPECT_TRUE((*copy)->read_page(make_page(0)->id()).has_value());
  const auto again = doc->copy_to(target);
  ASSERT_FALSE(again.has_value());
  EXPECT_EQ(again.error().code, ec::conflict);
}

}  // namespace
}  // namespace tedit::store
