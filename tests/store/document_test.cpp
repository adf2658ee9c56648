// SPDX-License-Identifier: AGPL-3.0-or-later
#include <signal.h>
#include <sys/wait.h>

#include <fstream>

#include "tests/store/fixture.hpp"

namespace tedit::store {
namespace {

void expect_same_page(const document& doc, const page_ptr& wanted) {
  const auto got = doc.read_page(wanted->id());
  ASSERT_TRUE(got.has_value()) << render(got.error());
  EXPECT_TRUE(std::ranges::equal((*got)->bytes(), wanted->bytes()));
}

TEST_F(Document, IsEmptyWhenNew) {
  const auto all = open()->read();

  ASSERT_TRUE(all.has_value());
  EXPECT_TRUE(all->versions.empty());
  EXPECT_FALSE(all->head.has_value());
  EXPECT_TRUE(all->log.empty());
  EXPECT_EQ(look_up("PRAGMA journal_mode"), "wal");
  EXPECT_EQ(look_up("PRAGMA application_id"), std::to_string(0x54454454));
  EXPECT_EQ(look_up("PRAGMA user_version"), "3");
}

TEST_F(Document, HasNoFileBeforeItsFirstCommit) {
  auto doc = std::move(*document::open(file));
  EXPECT_TRUE(doc->read()->versions.empty());
  EXPECT_FALSE(doc->has_page(make_page(1, 8)->id()));
  EXPECT_EQ(doc->read_page(make_page(1, 8)->id()).error().code, ec::not_found);
  doc->rest();
  EXPECT_TRUE(doc->wake());
  EXPECT_FALSE(fs::exists(file));
  EXPECT_EQ(refusal().code, ec::conflict);  // Its name is taken all the same.
  doc.reset();
  EXPECT_FALSE(fs::exists(file));

  doc = std::move(*document::open(file));
  ASSERT_TRUE(doc->commit(make_change(0)));
  EXPECT_EQ(doc->read()->versions.size(), 1U);
  doc.reset();
  EXPECT_EQ(open()->read()->versions.size(), 1U);
}

TEST_F(Document, AFileThatAppearsMeanwhileIsNotTouched) {
  const auto doc = std::move(*document::open(file));
  fs::copy_file(TEDIT_TEST_DATA "/documents/cube_format_1.tedit", file);
  const auto size = fs::file_size(file);

  EXPECT_EQ(doc->commit(make_change(0)).error().code, ec::conflict);
  EXPECT_EQ(fs::file_size(file), size);
  fs::remove(file);
  EXPECT_TRUE(doc->commit(make_change(0)));
}

TEST_F(Document, NamesAndNotesStandBesideTheVersionsAlsoInDocumentsFromBefore) {
  fs::copy_file(TEDIT_TEST_DATA "/documents/cube_format_1.tedit", file);
  tamper("DROP TABLE annotation");  // As it was before there were any.
  change words;
  words.annotations = {{0, "first", "a note"}};
  change none;
  none.annotations = {{5, "no such version", ""}};
  {
    const auto doc = open();
    ASSERT_TRUE(doc->commit(words));
    EXPECT_FALSE(doc->commit(none));
  }

  const auto all = open()->read();

  ASSERT_TRUE(all.has_value());
  ASSERT_EQ(all->versions.size(), 3U);
  EXPECT_EQ(all->versions[0].name, "first");
  EXPECT_EQ(all->versions[0].note, "a note");
  words.annotations = {{0, "", ""}};
  const auto doc = open();
  ASSERT_TRUE(doc->commit(words));
  EXPECT_EQ(doc->read()->versions[0].name, "");
}

TEST_F(Document, KeepsEverythingOverCloseAndReopen) {
  const auto first = make_change(0);
  auto second = make_change(4000000000u);
  second.new_version->parent = 0;
  second.new_version->manifest.clear();
  second.new_pages.push_back(make_page(9, max_page_bytes));
  second.new_pages.push_back(make_page(0, 0));
  second.redo = {{0, 4000000000u}};
  second.load_cases = {{0, R"([{"name":"pull"}])"}};
  {
    const auto doc = open();
    ASSERT_TRUE(doc->commit(first).has_value());
    ASSERT_TRUE(doc->commit(second).has_value());
  }

  const auto doc = open();
  const auto all = doc->read();
  ASSERT_TRUE(all.has_value());
  ASSERT_EQ(all->versions.size(), 2u);
  const auto& a = all->versions[0];
  const auto& b = all->versions[1];
  EXPECT_EQ(a.parent, std::nullopt);
  EXPECT_EQ(a.id, first.new_version->id);
  EXPECT_EQ(a.manifest, first.new_version->manifest);
  EXPECT_EQ(a.operation, first.new_version->operation);
  EXPECT_EQ(a.report, first.new_version->report);
  EXPECT_EQ(a.load_cases, R"([{"name":"pull"}])");
  EXPECT_EQ(a.redo, 4000000000u);
  EXPECT_EQ(b.number, 4000000000u);
  EXPECT_EQ(b.parent, 0u);
  EXPECT_TRUE(b.manifest.empty());
  EXPECT_EQ(all->head, 4000000000u);
  ASSERT_EQ(all->log.size(), 2u);
  EXPECT_EQ(all->log[0].what, "edit");
  EXPECT_LT(all->log[0].sequence, all->log[1].sequence);
  for (const auto& page : second.new_pages)
    expect_same_page(*doc, page);
}

TEST_F(Document, ACopyIsOneFileWithAllThatIsCommitted) {
  const auto doc = open();
  ASSERT_TRUE(doc->commit(make_change(0)).has_value());
  ASSERT_TRUE(doc->commit(make_change(1)).has_value());  // In the log beside the file.
  const auto copied = doc->copy();
  ASSERT_TRUE(copied.has_value()) << render(copied.error());
  ASSERT_TRUE(doc->commit(make_change(2)).has_value());

  const auto there = folder / "copy.tedit";
  std::ofstream(there, std::ios::binary)
    .write(reinterpret_cast<const char*>(copied->data()),
           static_cast<std::streamsize>(copied->size()));
  const auto other = document::open(there);
  ASSERT_TRUE(other.has_value()) << render(other.error());
  const auto all = (*other)->read();
  ASSERT_TRUE(all.has_value()) << render(all.error());
  EXPECT_EQ(all->versions.size(), 2u);
  EXPECT_EQ(all->head, 1u);
  EXPECT_EQ(all->log.size(), 2u);
  expect_same_page(**other, make_page(1));
  EXPECT_EQ(doc->read()->versions.size(), 3u);
}

TEST_F(Document, BeforeItsFirstCommitThereIsNothingToCopy) {
  const auto made = document::open(file);
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ((*made)->copy().error().code, ec::not_found);
}

TEST_F(Document, ClearsTheRedoAndMovesTheHead) {
  const auto doc = open();
  ASSERT_TRUE(doc->commit(make_change(0)).has_value());
  ASSERT_TRUE(doc->commit(make_change(1)).has_value());
  change undo;
  undo.head = 0;
  undo.redo = {{0, 1}};
  ASSERT_TRUE(doc->commit(undo).has_value());
  change clear;
  clear.redo = {{0, std::nullopt}};
  ASSERT_TRUE(doc->commit(clear).has_value());

  const auto all = doc->read();
  ASSERT_TRUE(all.has_value());
  EXPECT_EQ(all->head, 0u);
  EXPECT_EQ(all->versions[0].redo, std::nullopt);
  EXPECT_EQ(all->log.size(), 2u);
}

TEST_F(Document, LeavesNothingOfAChangeThatFails) {
  const auto doc = open();
  ASSERT_TRUE(doc->commit(make_change(0)).has_value());
  auto taken = make_change(0);
  taken.new_pages = {make_page(77)};
  auto no_parent = make_change(5);
  auto no_version = make_change(1);
  no_version.load_cases = {{99, "[1]"}};
  auto no_redo = make_change(1);
  no_redo.redo = {{0, 99}};
  auto no_head = make_change(1);
  no_head.head = 99;
  auto no_page = make_change(1);
  no_page.new_pages.push_back(nullptr);
  auto big_page = make_change(1);
  big_page.new_pages.push_back(make_page(1, max_page_bytes + 1));

  for (const auto* bad :
       {&taken, &no_parent, &no_version, &no_redo, &no_head, &no_page, &big_page}) {
    const auto done = doc->commit(*bad);
    ASSERT_FALSE(done.has_value());
    EXPECT_EQ(done.error().code, ec::storage_error);
    EXPECT_FALSE(doc->has_page(bad->new_pages[0]->id()));
    const auto all = doc->read();
    ASSERT_TRUE(all.has_value());
    EXPECT_EQ(all->versions.size(), 1u);
    EXPECT_EQ(all->versions[0].load_cases, "[]");
    EXPECT_EQ(all->head, 0u);
    EXPECT_EQ(all->log.size(), 1u);
  }
  EXPECT_TRUE(doc->commit(make_change(1)).has_value());
}

TEST_F(Document, SkipsPagesThatAreStored) {
  const auto doc = open();
  change c;
  c.new_pages = {make_page(1), make_page(1), make_page(2)};
  EXPECT_FALSE(doc->has_page(c.new_pages[0]->id()));
  ASSERT_TRUE(doc->commit(c).has_value());
  ASSERT_TRUE(doc->commit(c).has_value());

  EXPECT_TRUE(doc->has_page(c.new_pages[0]->id()));
  EXPECT_TRUE(doc->has_page(c.new_pages[2]->id()));
  EXPECT_EQ(look_up("SELECT count(*) FROM page"), "2");
}

TEST_F(Document, SaysWhenAPageIsNotThere) {
  const auto got = open()->read_page({1, 2});

  ASSERT_FALSE(got.has_value());
  EXPECT_EQ(got.error().code, ec::not_found);
}

TEST_F(Document, RefusesADamagedPage) {
  change c;
  c.new_pages = {make_page(1), make_page(2)};
  const auto other = c.new_pages[1];
  const std::string is_first = " WHERE id = '" + to_hex(c.new_pages[0]->id()) + "'";
  ASSERT_TRUE(open()->commit(c).has_value());
  const std::string from_other = "(SELECT data FROM page WHERE id = '" + to_hex(other->id()) + "')";
  // A flipped header, a truncated frame, a sound frame of other bytes, and sizes that lie.
  for (const std::string set :
       {"data = CAST(x'00' || substr(data, 2) AS BLOB)",
        "data = CAST(substr(data, 1, length(data) - 3) AS BLOB)", "data = x''", "size = 999",
        "size = 1001", "size = 1099511627776", "size = -1"}) {
    tamper("CREATE TABLE kept AS SELECT * FROM page; UPDATE page SET " + set + is_first);
    {
      const auto doc = open();
      const auto got = doc->read_page(c.new_pages[0]->id());
      ASSERT_FALSE(got.has_value()) << set;
      EXPECT_EQ(got.error().code, ec::storage_error) << set;
      expect_same_page(*doc, other);
    }
    tamper("DELETE FROM page; INSERT INTO page SELECT * FROM kept; DROP TABLE kept");
  }
  tamper("UPDATE page SET data = " + from_other + is_first);
  const auto doc = open();
  EXPECT_FALSE(doc->read_page(c.new_pages[0]->id()).has_value());
}

TEST_F(Document, RefusesAPageWithOneFlippedByteAnywhere) {
  change c;
  c.new_pages = {make_page(3, 64)};
  ASSERT_TRUE(open()->commit(c).has_value());
  const auto data = look_up("SELECT hex(data) FROM page");
  ASSERT_FALSE(data.empty());
  int read_wrong = 0;
  for (std::size_t i = 0; i < data.size(); i += 2) {
    auto flipped = data;
    flipped[i] = data[i] == '0' ? '1' : '0';
    tamper("UPDATE page SET data = x'" + flipped + "'");
    const auto got = open()->read_page(c.new_pages[0]->id());
    if (got && !std::ranges::equal((*got)->bytes(), c.new_pages[0]->bytes()))
      ++read_wrong;
  }
  EXPECT_EQ(read_wrong, 0);
}

TEST_F(Document, RefusesImpossibleNumbers) {
  ASSERT_TRUE(open()->commit(make_change(0)).has_value());
  tamper("UPDATE version SET id = 'abc'");
  EXPECT_EQ(open()->read().error().code, ec::storage_error);
  tamper("UPDATE version SET id = '00000000000000000000000000000000', number = -1");
  EXPECT_EQ(open()->read().error().code, ec::storage_error);
}

TEST_F(Document, RefusesATextFileAndLeavesItAlone) {
  std::ofstream(file) << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";

  const auto e = refusal();

  EXPECT_EQ(e.code, ec::storage_error);
  EXPECT_THAT(e.message, HasSubstr("not a database"));
  EXPECT_FALSE(e.remedy.empty());
  EXPECT_EQ(fs::file_size(file), 35u);
  EXPECT_FALSE(fs::exists(file.string() + "-lock"));
}

TEST_F(Document, RefusesADatabaseThatIsNoDocument) {
  tamper("CREATE TABLE cooking(recipe TEXT)");

  const auto e = refusal();

  EXPECT_EQ(e.code, ec::storage_error);
  EXPECT_THAT(e.message, HasSubstr("no TEdit document"));
  EXPECT_FALSE(e.remedy.empty());
  EXPECT_EQ(look_up("PRAGMA journal_mode"), "delete");
}

TEST_F(Document, RefusesADatabaseHeaderBeforeRubbish) {
  std::ofstream(file) << std::string("SQLite format 3", 16) << std::string(8000, 'x');

  EXPECT_EQ(refusal().code, ec::storage_error);
}

TEST_F(Document, RefusesANewerFormat) {
  open();
  tamper("PRAGMA user_version = 4");

  const auto e = refusal();

  EXPECT_EQ(e.code, ec::storage_error);
  EXPECT_THAT(e.message, HasSubstr("format 4"));
  EXPECT_THAT(e.remedy, HasSubstr("newer TEdit"));
}

TEST_F(Document, RefusesADocumentWithoutItsTables) {
  open();
  tamper("DROP TABLE log");

  EXPECT_EQ(refusal().code, ec::storage_error);
}

TEST_F(Document, RefusesWhatTheSystemRefuses) {
  EXPECT_EQ(document::open(folder).error().code, ec::io_error);
  EXPECT_EQ(document::open(folder / "absent" / "part.tedit").error().code, ec::io_error);
  EXPECT_EQ(document::open("").error().code, ec::io_error);
}

TEST_F(Document, IsOpenedOnlyOnce) {
  auto doc = open();
  EXPECT_EQ(refusal().code, ec::conflict);
  const auto link = folder / "link.tedit";
  fs::create_symlink(file, link);
  EXPECT_EQ(document::open(link).error().code, ec::conflict);

  doc.reset();
  EXPECT_TRUE(document::open(link).has_value());
}

/// Commits until it is killed and writes the number of each version to `pipe` once it is durable.
[[noreturn]] void commit_for_ever(const fs::path& file, int pipe) {
  const auto doc = document::open(file);
  if (!doc)
    ::_exit(1);
  for (std::uint32_t number = 0;; ++number)
    if (!(*doc)->commit(make_change(number)) ||
        ::write(pipe, &number, sizeof number) != sizeof number)
      ::_exit(1);
}

/// Lets a child commit, kills it after `enough` versions; how many it acknowledged.
std::uint32_t kill_a_writer(const fs::path& file, std::uint32_t enough) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const auto child = ::fork();
  if (child == 0)
    commit_for_ever(file, ends[1]);
  ::close(ends[1]);
  std::uint32_t number = 0;
  std::uint32_t acknowledged = 0;
  while (::read(ends[0], &number, sizeof number) == sizeof number) {
    EXPECT_EQ(number, acknowledged);
    if (++acknowledged == enough)
      ::kill(child, SIGKILL);
  }
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  return acknowledged;
}

TEST_F(Document, KeepsEveryAcknowledgedCommitOfAKilledProcess) {
  for (const std::uint32_t enough : {1u, 2u, 17u, 60u}) {
    file = folder / (std::to_string(enough) + ".tedit");
    const auto acknowledged = kill_a_writer(file, enough);
    ASSERT_GE(acknowledged, enough);

    const auto doc = open();
    ASSERT_NE(doc, nullptr);
    const auto all = doc->read();
    ASSERT_TRUE(all.has_value());
    ASSERT_GE(all->versions.size(), acknowledged);
    EXPECT_LE(all->versions.size(), acknowledged + 1);
    EXPECT_EQ(all->log.size(), all->versions.size());
    EXPECT_EQ(all->head, all->versions.size() - 1);
    for (std::uint32_t number = 0; number < all->versions.size(); ++number)
      expect_same_page(*doc, make_page(number));
  }
}

}  // namespace
}  // namespace tedit::store
