// SPDX-License-Identifier: AGPL-3.0-or-later
// Damage and careless edits: a document says what is wrong with it, or is what it was.
#include <signal.h>
#include <sys/wait.h>

#include <fstream>
#include <iterator>

#include "mesh/version.hpp"
#include "tests/store/fixture.hpp"

namespace tedit::store {
namespace {

/// Three versions of a cube with a load case, the head on version 1 after an undo. Written by the
/// program before documents had hashes.
class Damage : public Document {
protected:
  void SetUp() override {
    Document::SetUp();
    fs::copy_file(TEDIT_TEST_DATA "/documents/cube_format_1.tedit", file);
  }

  /// Opens it once, which gives it its hashes.
  void upgrade() const { ASSERT_NE(open(), nullptr); }

  /// A version more, with enough pages to need room that was not used; whether it was stored.
  bool commit_more() const {
    const auto doc = open();
    auto c = make_change(3);
    for (std::uint32_t i = 0; i < 20; ++i)
      c.new_pages.push_back(make_page(100 + i, 5000));
    c.new_version->manifest = doc->read()->versions[1].manifest;
    return doc->commit(c).has_value();
  }

  std::vector<char> bytes() const {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  void write(const std::vector<char>& content) const {
    std::ofstream(file, std::ios::binary)
      .write(content.data(), static_cast<std::streamsize>(content.size()));
  }

  /// What a reader of the whole document is told; empty when it may read it.
  std::string complaint() const {
    const auto opened = document::open(file);
    const auto all = opened ? (*opened)->read() : fail(opened.error());
    EXPECT_TRUE(all || !all.error().remedy.empty()) << render(all.error());
    return all ? "" : render(all.error());
  }
};

/// Everything that a document says, pages and their order included.
expected<std::string> content_of(const fs::path& file) {
  const auto opened = document::open(file);
  if (!opened)
    return fail(opened.error());
  const auto all = (*opened)->read();
  if (!all)
    return fail(all.error());
  std::string text = all->head ? std::to_string(*all->head) : "none";
  for (const auto& v : all->versions) {
    text += "\n" + std::to_string(v.number) + "|" + (v.parent ? std::to_string(*v.parent) : "") +
            "|" + to_hex(v.id) + "|" + v.operation + "|" + v.load_cases + "|" + v.report + "|" +
            (v.redo ? std::to_string(*v.redo) : "") + "|" + v.name + "|" + v.note + "|";
    text.append(reinterpret_cast<const char*>(v.manifest.data()), v.manifest.size());
    const auto list = manifest::from_bytes(v.manifest);
    if (!list)
      return fail(list.error());
    for (const auto& id : list->page_ids()) {
      const auto page = (*opened)->read_page(id);
      if (!page)
        return fail(page.error());
      text.append(reinterpret_cast<const char*>((*page)->bytes().data()), (*page)->bytes().size());
    }
  }
  for (const auto& line : all->log)
    text += "\n" + std::to_string(line.sequence) + "|" + line.what + "|" + line.details;
  return text;
}

TEST_F(Damage, ADocumentOfTheFormatBeforeOpensAndGetsItsHashes) {
  EXPECT_EQ(look_up("PRAGMA user_version"), "1");
  {
    const auto doc = open();
    const auto all = doc->read();
    ASSERT_TRUE(all.has_value()) << render(all.error());
    ASSERT_EQ(all->versions.size(), 3U);
    EXPECT_EQ(all->head, 1U);
    EXPECT_EQ(all->versions[1].operation, "thicken");
    EXPECT_EQ(all->versions[1].redo, 2U);
    EXPECT_THAT(all->versions[1].load_cases, HasSubstr("-1000"));
    EXPECT_EQ(all->log.size(), 5U);
    change words;
    words.annotations = {{2, "thick", ""}};
    words.load_cases = {{1, "[]"}};
    words.head = 2;
    words.what = "redo";
    ASSERT_TRUE(doc->commit(words));
  }

  const auto all = open()->read();

  ASSERT_TRUE(all.has_value()) << render(all.error());
  EXPECT_EQ(look_up("PRAGMA user_version"), "3");
  EXPECT_EQ(all->versions[1].load_cases, "[]");
  EXPECT_EQ(all->versions[2].name, "thick");
  EXPECT_EQ(all->head, 2U);
  EXPECT_EQ(all->log.size(), 6U);
}

TEST_F(Damage, NamesWhatWasChangedBehindItsBack) {
  change words;
  words.annotations = {{0, "first", "heavy"}};
  ASSERT_TRUE(open()->commit(words));
  ASSERT_EQ(complaint(), "");
  const auto annotated = bytes();
  const std::pair<const char*, const char*> edits[] = {
    {"UPDATE version SET load_cases = replace(load_cases, '-1000', '-9000') WHERE number = 1",
     "version 1"},
    {"UPDATE version SET parent = 0 WHERE number = 2", "version 2"},
    {"UPDATE version SET id = (SELECT id FROM version WHERE number = 0) WHERE number = 1",
     "version 1"},
    {"UPDATE version SET manifest = (SELECT manifest FROM version WHERE number = 0)", "version 1"},
    {"UPDATE version SET operation = 'erode' WHERE number = 2", "version 2"},
    {"UPDATE version SET report = '{}' WHERE number = 2", "version 2"},
    {"UPDATE version SET redo = NULL WHERE number = 0", "version 0"},
    {"UPDATE version SET number = 3 WHERE number = 2", "version 3"},
    {"UPDATE version SET hash = replace(hash, substr(hash, 1, 1), 'x') WHERE number = 0",
     "version 0"},
    {"UPDATE head SET version = 0", "the current version"},
    {"DELETE FROM head", "9 rows where 10 belong"},
    {"UPDATE log SET details = 'x' WHERE sequence = 3", "line 3 of the log"},
    {"DELETE FROM log WHERE sequence = 5", "9 rows where 10 belong"},
    {"INSERT INTO log(what, details) VALUES('edit', '')", "line 6 of the log"},
    {"INSERT INTO annotation(version, name, note) VALUES(1, 'mine', '')",
     "the name and note of version 1"},
    {"UPDATE annotation SET note = 'light' WHERE version = 0", "the name and note of version 0"},
    {"UPDATE annotation SET version = 2 WHERE version = 0", "the name and note of version 2"},
    {"DELETE FROM annotation", "9 rows where 10 belong"},
    {"CREATE INDEX quick ON log(what)", "tables"},
    {"CREATE TRIGGER t AFTER INSERT ON log BEGIN UPDATE head SET version = 0; END", "tables"},
    {"UPDATE seal SET rows = rows - 1", "10 rows where 9 belong"},
    {"UPDATE seal SET sum = '00000000000000000000000000000000'", "another state"},
    {"UPDATE seal SET schema = '00000000000000000000000000000000'", "tables"},
    {"DELETE FROM seal", "seal"},
    {"UPDATE sqlite_sequence SET seq = 99 WHERE name = 'log'", "numbers of the log"},
    {"PRAGMA user_version = 1", "format number"},
    {"PRAGMA user_version = 0", "format number"},
  };
  for (const auto& [sql, named] : edits) {
    write(annotated);
    tamper(sql);
    EXPECT_THAT(complaint(), HasSubstr(named)) << sql;
  }
}

TEST_F(Damage, NoticesRowsOfAnEarlierStateWithTheirHashes) {
  upgrade();
  tamper("CREATE TABLE kept AS SELECT * FROM version; CREATE TABLE was AS SELECT * FROM head");
  {
    change redo;
    redo.head = 2;
    redo.load_cases = {{1, "[]"}};
    ASSERT_TRUE(open()->commit(redo));
  }
  const auto later = bytes();
  for (const char* sql : {"UPDATE head SET (version, hash) = (SELECT version, hash FROM was);",
                          "UPDATE version SET (load_cases, hash) = (SELECT load_cases, hash FROM "
                          "kept WHERE number = 1) WHERE number = 1;"}) {
    write(later);
    tamper(std::string(sql) + "DROP TABLE kept; DROP TABLE was");
    EXPECT_THAT(complaint(), HasSubstr("another state")) << sql;
  }
  write(later);
  tamper("DROP TABLE kept; DROP TABLE was");
  EXPECT_EQ(complaint(), "");
}

TEST_F(Damage, AChangeOfADamagedRowOrOfAForeignStateIsRefused) {
  upgrade();
  const auto sound = bytes();
  change redo;
  redo.redo = {{0, 2}};
  for (const char* sql : {"UPDATE version SET report = 'x' WHERE number = 0",
                          "UPDATE seal SET sum = '00000000000000000000000000000000'"}) {
    write(sound);
    const auto doc = open();
    tamper(sql);

    const auto done = doc->commit(redo);

    ASSERT_FALSE(done.has_value()) << sql;
    EXPECT_EQ(done.error().code, ec::storage_error);
    EXPECT_THAT(done.error().message, HasSubstr("another program"));
    EXPECT_EQ(look_up("SELECT redo FROM version WHERE number = 0"), "1");
  }
}

TEST_F(Damage, AnEmptyFileIsRefusedAndLeftAlone) {
  std::ofstream(file, std::ios::trunc);

  const auto e = refusal();

  EXPECT_EQ(e.code, ec::storage_error);
  EXPECT_THAT(e.message, HasSubstr("is empty: it is no document"));
  EXPECT_THAT(e.remedy, HasSubstr("remove it"));
  EXPECT_EQ(fs::file_size(file), 0U);
}

TEST_F(Damage, ANewDocumentDoesNotTakeTheLogOfAnother) {
  const auto orphan = file.string() + "-wal";
  fs::rename(file, folder / "elsewhere.tedit");
  std::ofstream(orphan) << "edits";

  const auto e = refusal();

  EXPECT_EQ(e.code, ec::conflict);
  EXPECT_THAT(e.message, HasSubstr(orphan));
  EXPECT_EQ(fs::file_size(orphan), 5U);
  EXPECT_FALSE(fs::exists(file));
}

/// Makes documents until it is killed.
[[noreturn]] void create_for_ever(const fs::path& folder) {
  for (int i = 0;; ++i)
    if (const auto made = document::open(folder / (std::to_string(i) + ".tedit"));
        !made || !(*made)->commit({}))
      ::_exit(1);
}

/// A machine that stopped while the log was brought into the file leaves rubbish at its start; a
/// file that somebody put in its place is not taken for that.
TEST_F(Damage, RubbishAtTheStartIsMendedFromTheLogAndOtherFilesAreLeftAlone) {
  upgrade();
  const auto doc = open();
  change words;
  words.annotations = {{2, "thick", ""}};
  words.what = "annotate";
  for (std::uint32_t i = 0; i < 20; ++i)  // So that the file grows, which its first page says.
    words.new_pages.push_back(make_page(100 + i, 5000));
  ASSERT_TRUE(doc->commit(words));
  // As a kill leaves it: the log lies beside the file.
  const auto copy = folder / "copy.tedit";
  fs::copy_file(file, copy);
  fs::copy_file(file.string() + "-wal", copy.string() + "-wal");
  auto content = bytes();
  std::fill_n(content.begin(), 512, 'x');
  std::ofstream(copy, std::ios::binary)
    .write(content.data(), static_cast<std::streamsize>(content.size()));
  const auto mended = document::open(copy);
  ASSERT_TRUE(mended.has_value()) << render(mended.error());
  const auto all = (*mended)->read();
  ASSERT_TRUE(all.has_value()) << render(all.error());
  EXPECT_EQ(all->versions[2].name, "thick");
  EXPECT_EQ(all->log.size(), doc->read()->log.size());

  const auto other = folder / "other.tedit";
  fs::copy_file(file.string() + "-wal", other.string() + "-wal");
  std::ofstream(other) << "$MeshFormat";
  const auto refused = document::open(other);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("not a database"));
  EXPECT_EQ(fs::file_size(other), 11U);

  // Of as many bytes as pages have, but beside a log that is none.
  const auto third = folder / "third.tedit";
  std::ofstream(third) << std::string(8192, 'x');
  std::ofstream(third.string() + "-wal") << std::string(8192, 'x');
  const auto not_ours = document::open(third);
  ASSERT_FALSE(not_ours);
  EXPECT_EQ(not_ours.error().message, third.string() + " is not a database");
  EXPECT_EQ(fs::file_size(third), 8192U);
  EXPECT_EQ(fs::file_size(third.string() + "-wal"), 8192U);
}

TEST_F(Damage, ANewDocumentIsThereWholeOrNotAtAll) {
  for (int round = 0; round < 8; ++round) {
    const auto place = folder / std::to_string(round);
    fs::create_directory(place);
    std::ofstream(place / "3.tedit-new") << "left by a crash";
    const auto child = ::fork();
    if (child == 0)
      create_for_ever(place);
    while (!fs::exists(place / "5.tedit"))  // Looks at the files as they come to be.
      for (const auto& entry : fs::directory_iterator(place)) {
        if (entry.path().extension() == ".tedit") {
          ASSERT_GT(fs::file_size(entry.path()), 0U);
        }
      }
    ::usleep(static_cast<useconds_t>(700 * round));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    std::vector<fs::path> made;
    for (const auto& entry : fs::directory_iterator(place))
      if (entry.path().extension() == ".tedit")
        made.push_back(entry.path());
    for (const auto& one : made) {
      const auto opened = document::open(one);
      ASSERT_TRUE(opened && (*opened)->read()) << one;
    }
    EXPECT_FALSE(fs::exists(place / "3.tedit-new"));
  }
}

/// Set TEDIT_EVERY_BYTE to flip them all, which takes a minute or two.
TEST_F(Damage, AFlippedByteIsNoticedOrChangesNothing) {
  upgrade();
  const auto sound = bytes();
  const auto wanted = content_of(file);
  ASSERT_TRUE(wanted.has_value()) << render(wanted.error());
  const bool all = std::getenv("TEDIT_EVERY_BYTE") != nullptr;
  const std::size_t step = all ? 1 : 53;
  std::size_t refused = 0;
  for (std::size_t at = 0; at < sound.size(); at += at < 200 ? 1 : step) {
    for (const int mask : {0x01, 0xFF}) {
      if (!all && at >= 200 && (at % 2 == 0) == (mask == 0xFF))
        continue;
      auto flipped = sound;
      flipped[at] = static_cast<char>(flipped[at] ^ mask);
      write(flipped);
      const auto got = content_of(file);
      refused += got ? 0 : 1;
      ASSERT_EQ(got.value_or(*wanted), *wanted) << "byte " << at;
      if (got && commit_more()) {  // What looks sound must not break with the next change.
        const auto more = content_of(file);
        EXPECT_TRUE(more && more->starts_with("3")) << "byte " << at;
      }
      fs::remove(file.string() + "-wal");
      fs::remove(file.string() + "-shm");
    }
  }
  EXPECT_GT(refused, sound.size() / step / 8);  // The test does reach what is stored.
}

}  // namespace
}  // namespace tedit::store
