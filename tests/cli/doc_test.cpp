// SPDX-License-Identifier: AGPL-3.0-or-later
// "tedit doc": documents as files, as a person or a script looks after them.
#include <set>

#include <sqlite3.h>

#include "actors/store/document.hpp"
#include "mesh/version.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/scenarios/served.hpp"
#include "tests/support/parts.hpp"

namespace tedit::test {
namespace {

namespace fs = std::filesystem;

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A document of three versions, 0, 1 (the current one, after an undo) and 2.
class Doc : public ::testing::Test {
protected:
  void SetUp() override {
    fs::copy_file(TEDIT_TEST_DATA "/documents/cube_format_1.tedit", file());
    (void)value(store::document::open(file()));
  }

  [[nodiscard]] fs::path file() const { return folder.path() / "cube.tedit"; }
  [[nodiscard]] std::string word() const { return "'" + file().string() + "'"; }
  [[nodiscard]] fs::path at(const std::string& name) const { return folder.path() / name; }

  [[nodiscard]] store::contents rows() const {
    return value(value(store::document::open(file()))->read());
  }

  /// A version 3 made from 0 is the current one: no undo or redo reaches 1 and 2.
  void branch() const {
    auto row = rows().versions[0];
    row.number = 3;
    row.parent = 0;
    row.redo.reset();
    store::change change;
    change.new_version = row;
    change.redo = {{0, 3}};
    change.head = 3;
    change.what = "edit";
    change.details = R"({"client":"t","edit_id":"e3","head":3,"request":"r","time":"t"})";
    value(value(store::document::open(file()))->commit(change));
  }

  void annotate(std::uint32_t number) const {
    store::change change;
    change.annotations = {{number, "mine", ""}};
    change.what = "annotate";
    change.details = R"({"number":)" + std::to_string(number) + "}";
    value(value(store::document::open(file()))->commit(change));
  }

  void tamper(const std::string& sql) const {
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(file().c_str(), &db), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(db);
  }

  /// A page that version 2 has and version 0 has not.
  [[nodiscard]] hash128 page_of_the_last() const {
    const auto all = rows();
    const auto ids = [&](std::size_t number) {
      return value(manifest::from_bytes(all.versions[number].manifest)).page_ids();
    };
    const auto first = ids(0);
    for (const auto& id : ids(2))
      if (std::ranges::find(first, id) == first.end())
        return id;
    return {};
  }

  scratch_folder folder;
};

constexpr bool disk_dies =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  false;
#else
  true;
#endif

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(Doc, ListSaysWhatThereIsAndWhatCannotBeRead) {
  std::ofstream(at("letter.tedit")) << "Dear Sir";
  std::ofstream(at("part.msh")) << "no document";
  const auto open_one = value(store::document::open(file()));

  const auto result = run("doc list --json '" + folder.path().string() + "'");

  EXPECT_EQ(result.status, 0);
  const auto all = result.parsed()["documents"];
  ASSERT_EQ(all.size(), 2U) << result.out;
  EXPECT_EQ(all[0]["name"], "cube");
  EXPECT_EQ(all[0]["bytes"], fs::file_size(file()));
  EXPECT_EQ(all[0]["versions"], 3);
  EXPECT_EQ(all[0]["head"], 1);
  EXPECT_EQ(all[0]["open"], true);
  EXPECT_EQ(all[0]["readable"], true);
  EXPECT_THAT(all[0]["changed"].get<std::string>(), ::testing::MatchesRegex("20.*T.*Z"));
  EXPECT_EQ(all[1]["name"], "letter");
  EXPECT_EQ(all[1]["open"], false);
  EXPECT_EQ(all[1]["readable"], false);
  EXPECT_THAT(all[1]["fault"]["what"].get<std::string>(), HasSubstr("not a database"));
  EXPECT_THAT(run("doc list '" + folder.path().string() + "'").out, HasSubstr("sound, open"));
  EXPECT_EQ(run("doc list '" + at("nowhere").string() + "'").status, 65);
}

TEST_F(Doc, CheckReadsAllOfASoundDocument) {
  const auto result = run("doc check --json " + word());
  EXPECT_EQ(result.status, 0) << result.out;
  const auto found = result.parsed();
  EXPECT_EQ(found["sound"], true);
  EXPECT_EQ(found["versions"], 3);
  EXPECT_EQ(found["head"], 1);
  EXPECT_THAT(found["whole_versions"].get<std::vector<int>>(), ElementsAre(0, 1, 2));
  EXPECT_EQ(found["unneeded_pages"], 0);
  EXPECT_EQ(found["log_lines"], 5);
}

TEST_F(Doc, CheckNamesEachDamageAndWhatIsWhole) {
  const auto page = to_hex(page_of_the_last());
  tamper("UPDATE page SET data = zeroblob(length(data)) WHERE id = '" + page + "'");
  tamper("UPDATE log SET details = 'x' WHERE sequence = 3");

  const auto result = run("doc check --json " + word());

  EXPECT_EQ(result.status, 65);
  const auto found = result.parsed();
  EXPECT_EQ(found["sound"], false);
  ASSERT_EQ(found["damage"].size(), 2U) << result.out;
  EXPECT_THAT(found["damage"][0]["what"].get<std::string>(), HasSubstr("line 3 of the log"));
  EXPECT_THAT(found["damage"][1]["what"].get<std::string>(), HasSubstr(page));
  const auto whole = found["whole_versions"].get<std::vector<int>>();
  EXPECT_THAT(whole, ::testing::Contains(0));
  EXPECT_THAT(whole, ::testing::Not(::testing::Contains(2)));
  EXPECT_THAT(found["remedy"].get<std::string>(), HasSubstr("tedit doc export"));
  EXPECT_THAT(run("doc check " + word()).out, HasSubstr("is damaged"));
  // What it says can be done can be done.
  EXPECT_EQ(run("doc export " + word() + " " + at("saved.msh").string() + " --version 0").status,
            0);
  EXPECT_EQ(run("info " + at("saved.msh").string()).status, 0);
  EXPECT_EQ(run("doc export " + word() + " " + at("lost.msh").string() + " --version 2").status, 1);
  EXPECT_FALSE(fs::exists(at("lost.msh")));
  EXPECT_EQ(run("doc copy " + word() + " " + at("copy.tedit").string()).status, 1);
  EXPECT_FALSE(fs::exists(at("copy.tedit")));
}

TEST_F(Doc, CheckOfWhatIsNoDocument) {
  std::ofstream(at("letter.tedit")) << "Dear Sir";
  EXPECT_EQ(run("doc check " + at("letter.tedit").string()).status, 65);
  EXPECT_EQ(run("doc check --json " + at("nowhere.tedit").string()).parsed()["error"]["code"],
            "not_found");
  EXPECT_FALSE(fs::exists(at("nowhere.tedit")));
}

TEST_F(Doc, CopyIsTheSameDocumentAndReplacesNothing) {
  const auto copy = at("copy.tedit").string();
  const auto result = run("doc copy --json " + word() + " " + copy);
  EXPECT_EQ(result.status, 0) << result.out;
  EXPECT_EQ(result.parsed()["versions"], 3);
  EXPECT_EQ(run("doc check --json " + copy).parsed()["whole_versions"].size(), 3U);

  EXPECT_EQ(run("doc copy --json " + word() + " " + copy).parsed()["error"]["code"], "conflict");
  EXPECT_EQ(run("doc copy " + word() + " " + at("copy.db").string()).status, 2);
  EXPECT_EQ(run("doc copy " + word() + " " + at("no/folder.tedit").string()).status, 65);
}

TEST_F(Doc, ExportWritesTheCurrentVersionOrAnother) {
  const auto tets = [&](const std::string& arguments) {
    const auto result =
      run("doc export --json " + word() + " " + at("out.msh").string() + arguments);
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_EQ(run("info --json " + at("out.msh").string()).parsed()["tets"],
              result.parsed()["tets"]);
    return result.parsed()["version_id"].get<std::string>();
  };
  const auto all = rows().versions;
  EXPECT_EQ(tets(""), to_hex(all[1].id));
  EXPECT_EQ(tets(" --version 2"), to_hex(all[2].id));
  EXPECT_EQ(run("doc export " + word() + " " + at("out.stl").string()).status, 0);
  EXPECT_EQ(run("doc export " + word() + " " + at("out.vtu").string() + " --length-unit m").status,
            0);
  const auto refused =
    run("doc export --json " + word() + " " + at("o.msh").string() + " --version 3").parsed();
  EXPECT_EQ(refused["error"]["code"], "not_found");
  EXPECT_THAT(refused["error"]["remedy"].get<std::string>(), HasSubstr("The last one is 2"));
  EXPECT_EQ(run("doc export " + word() + " " + at("out.doc").string()).status, 2);
  EXPECT_EQ(run("doc export " + word() + " " + at("o.msh").string() + " --version -1").status, 2);
}

TEST_F(Doc, GcTakesNoVersionUnlessToldSo) {
  branch();
  const auto result = run("doc gc --json " + word()).parsed();
  EXPECT_THAT(result["dropped_versions"], IsEmpty());
  EXPECT_EQ(result["versions"].size(), 4U);
  EXPECT_EQ(result["bytes_after"], fs::file_size(file()));
  EXPECT_EQ(rows().versions.size(), 4U);
}

TEST_F(Doc, GcTakesBranchesThatNoUndoOrRedoReaches) {
  branch();
  const auto asked = " --drop-unreachable --json " + word();
  const auto foreseen = run("doc gc --dry-run" + asked).parsed();
  EXPECT_THAT(foreseen["dropped_versions"].get<std::vector<int>>(), ElementsAre(1, 2));
  EXPECT_EQ(rows().versions.size(), 4U);

  const auto done = run("doc gc" + asked);

  EXPECT_EQ(done.status, 0) << done.out;
  const auto result = done.parsed();
  EXPECT_EQ(result["dropped_versions"], foreseen["dropped_versions"]);
  EXPECT_EQ(result["versions"],
            (json{{{"before", 0}, {"after", 0}}, {{"before", 3}, {"after", 1}}}));
  EXPECT_GT(result["removed_pages"], 0);
  EXPECT_LT(result["bytes_after"], result["bytes_before"]);
  const auto all = rows();
  ASSERT_EQ(all.versions.size(), 2U);
  EXPECT_EQ(all.head, 1U);
  EXPECT_EQ(json::parse(all.log.back().details)["head"], 1);
  EXPECT_EQ(run("doc check " + word()).status, 0);
}

TEST_F(Doc, GcKeepsWhatRedoReachesWhatHasANameAndWhatIsAsked) {
  const auto dropped = [&](const std::string& more) {
    const auto result = run("doc gc --dry-run --drop-unreachable --json " + word() + more);
    EXPECT_EQ(result.status, 0) << result.out;
    return result.parsed()["dropped_versions"].get<std::vector<int>>();
  };
  EXPECT_THAT(dropped(""), IsEmpty()) << "2 is one redo away";
  branch();
  EXPECT_THAT(dropped(" --keep 1"), ElementsAre(2));
  EXPECT_THAT(dropped(" --keep 2"), IsEmpty()) << "2 was made from 1";
  EXPECT_EQ(
    run("doc gc --drop-unreachable --json " + word() + " --keep 4").parsed()["error"]["code"],
    "not_found");
  annotate(1);
  EXPECT_THAT(dropped(""), ElementsAre(2));
  EXPECT_EQ(run("doc gc --drop-unreachable " + word()).status, 0);
  const auto all = rows();
  ASSERT_EQ(all.versions.size(), 3U);
  EXPECT_EQ(all.versions[1].name, "mine");
  EXPECT_EQ(all.versions[1].redo, std::nullopt);
}

TEST_F(Doc, GcIsRefusedWhereItWouldDisturbOrIsDamaged) {
  {
    const auto held = value(store::document::open(file()));
    const auto refused = run("doc gc --json " + word());
    EXPECT_EQ(refused.status, 1);
    EXPECT_EQ(refused.parsed()["error"]["code"], "conflict");
    EXPECT_THAT(refused.parsed()["error"]["remedy"].get<std::string>(), HasSubstr("server"));
  }
  EXPECT_EQ(run("doc gc --json " + at("new.tedit").string()).parsed()["error"]["code"],
            "not_found");
  EXPECT_FALSE(fs::exists(at("new.tedit")));
  tamper("DELETE FROM page WHERE id = '" + to_hex(page_of_the_last()) + "'");
  const auto before = text_of(file());
  EXPECT_EQ(run("doc gc --json " + word()).parsed()["error"]["code"], "storage_error");
  EXPECT_EQ(text_of(file()), before);
}

/// The program ends by kill -9 before its first change of a file, its second, ... until it is
/// through: what is left is the document as it was, or without what was to go.
TEST_F(Doc, GcThatIsKilledAtAnyMomentLeavesAllThatItShall) {
  if (!disk_dies)
    GTEST_SKIP() << "sanitizers want to be loaded first";
  branch();
  const auto whole = rows();
  const auto original = text_of(file());
  int kills = 0;
  int done_before_the_kill = 0;
  for (int status = 128 + SIGKILL; status == 128 + SIGKILL; ++kills) {
    ASSERT_LT(kills, 1000);
    for (const char* with : {"-wal", "-shm"})
      fs::remove(file().string() + with);
    std::ofstream(file(), std::ios::binary) << original;
    setenv("LD_PRELOAD", TEDIT_DYING_DISK, 1);
    setenv("TEDIT_DIE_AT", std::to_string(kills + 1).c_str(), 1);
    status = run("doc gc --drop-unreachable " + word()).status;
    unsetenv("LD_PRELOAD");
    unsetenv("TEDIT_DIE_AT");
    const auto found = run("doc check --json " + word());
    ASSERT_EQ(found.status, 0) << kills << " " << found.out;
    const auto now = rows();
    const bool before = now.versions.size() == 4U;
    ASSERT_TRUE(before || now.versions.size() == 2U) << kills;
    EXPECT_EQ(now.versions.back().id, whole.versions.back().id);
    EXPECT_EQ(now.log.size(), whole.log.size());
    done_before_the_kill += before ? 0 : 1;
  }
  EXPECT_GT(kills, 10);
  EXPECT_GT(done_before_the_kill, 1) << "also between the removal and the giving back of the room";
}

TEST(DocBesideAServer, AllButGcLooksAtADocumentThatAServerHasOpen) {
  const scratch_folder folder;
  served host(folder);
  const auto user = host.connect();
  value(user->open("cube", false, false));
  value(user->import_file(cube_mesh, "mm", {}));
  const auto head = value(user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {}));
  const auto file = (folder.path() / "documents/cube.tedit").string();

  const auto listed =
    run("doc list --json " + (folder.path() / "documents").string()).parsed()["documents"];
  ASSERT_EQ(listed.size(), 1U);
  EXPECT_EQ(listed[0]["open"], true);
  EXPECT_EQ(listed[0]["versions"], 2);
  EXPECT_EQ(run("doc check " + file).status, 0);
  const auto copy = (folder.path() / "copy.tedit").string();
  EXPECT_EQ(run("doc copy " + file + " " + copy).status, 0);
  EXPECT_EQ(run("doc check --json " + copy).parsed()["versions"], 2);
  const auto mesh = (folder.path() / "head.msh").string();
  EXPECT_EQ(run("doc export --json " + file + " " + mesh).parsed()["version_id"],
            head.head.version_id);
  const auto refused = run("doc gc --json " + file).parsed()["error"];
  EXPECT_EQ(refused["code"], "conflict") << refused;

  // Nothing of it was disturbed.
  value(user->edit("thicken", {6}, {{"depth", 0.5e-3}}, {}));
  value(user->rename_document("wing"));
  value(user->undo());
  const auto now = (folder.path() / "documents/wing.tedit").string();
  EXPECT_EQ(run("doc check --json " + now).parsed()["head"], 1);
  host.kill();
  EXPECT_EQ(run("doc gc --json " + now).parsed()["versions"].size(), 3U);
}

/// A server opens what was cleaned, and who asks for a change again whose version is gone is told
/// so.
TEST(DocBesideAServer, AServerGoesOnWithADocumentThatWasCleaned) {
  const scratch_folder folder;
  client::committed kept;
  {
    served host(folder);
    const auto user = host.connect();
    value(user->open("cube", false, false));
    value(user->import_file(cube_mesh, "mm", {}));
    value(user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {}, {}, {}, "gone"));
    value(user->undo());
    kept = value(user->edit("thicken", {6}, {{"depth", 0.5e-3}}, {}, {}, {}, "kept"));
  }
  const auto file = (folder.path() / "documents/cube.tedit").string();
  ASSERT_THAT(run("doc gc --drop-unreachable --json " + file).parsed()["dropped_versions"],
              (json{1}));

  served host(folder);
  const auto user = host.connect();
  const auto state = value(user->open("cube", false, false));
  EXPECT_EQ(state.head->number, 1U);
  EXPECT_EQ(state.head->version_id, kept.head.version_id);
  const auto again = value(user->edit("thicken", {6}, {{"depth", 0.5e-3}}, {}, {}, {}, "kept"));
  EXPECT_TRUE(again.repeated);
  EXPECT_EQ(again.head.number, 1U);
  const auto refused = user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {}, {}, {}, "gone");
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::conflict);
  value(user->undo());
  EXPECT_EQ(value(user->redo()).head.number, 1U);
}

}  // namespace
}  // namespace tedit::test
