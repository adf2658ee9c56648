// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents as files: copied while they are edited, given to another server, refused when they are
// none.
#include <atomic>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>

#include "actors/store/documents_folder.hpp"
#include "base/child_process.hpp"
#include "protocol/convert.hpp"
#include "tests/scenarios/fixture.hpp"
#include "tests/support/parts.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

class DocumentFiles : public ::testing::Test {
protected:
  const scratch_folder documents;
  const scratch_folder elsewhere;
  std::unique_ptr<server> host = start(options_for(documents, false));
  std::unique_ptr<client::client> user = connect(host->url());

  /// An imported cube that was thickened twice, the second edit undone.
  client::committed make_document(const std::string& name) {
    value(user->open(name, false, false));
    value(user->import_file(test::cube_mesh, "mm", {}));
    value(user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {}));
    value(user->edit("thicken", {6}, {{"depth", 0.5e-3}}, {}));
    return value(user->undo());
  }

  [[nodiscard]] std::filesystem::path write(const std::string& bytes) const {
    const auto path = elsewhere.path() / "mailed.tedit";
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

  [[nodiscard]] std::string copy() {
    const auto bytes = value(user->export_file("tedit", {}, {}, {}));
    return {bytes.begin(), bytes.end()};
  }

  /// Names in the folder of documents, without what SQLite and locks keep there.
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(documents.path()))
      if (const auto name = entry.path().filename().string();
          !name.ends_with("-wal") && !name.ends_with("-shm") && name != ".tedit-lock")
        result.insert(name);
    return result;
  }
};

TEST_F(DocumentFiles, ACopyThatIsAddedIsTheSameDocumentUnderItsOwnName) {
  const auto head = make_document("cube");
  const auto file = write(copy());

  EXPECT_EQ(value(user->add_document(file, "mailed", false, {})), "mailed");
  EXPECT_EQ(names(), (std::set<std::string>{"cube.tedit", "mailed.tedit"}));

  const auto state = value(user->open("mailed", false, false));
  EXPECT_EQ(state.head->version_id, head.head.version_id);
  EXPECT_EQ(state.head->number, 1u);
  const auto all = value(user->get_history());
  ASSERT_EQ(all.versions.size(), 3u);
  // Each goes its own way.
  const auto redone = value(user->redo());
  EXPECT_EQ(redone.head.number, 2u);
  EXPECT_EQ(value(user->open("cube", false, false)).head->number, 1u);
}

TEST_F(DocumentFiles, ACopyIsWholeWhileTheDocumentIsEdited) {
  make_document("cube");
  std::atomic<bool> end = false;
  std::thread editor([&] {
    const auto other = connect(host->url());
    value(other->open("cube", false, false));
    while (!end) {
      value(other->redo());
      value(other->undo());
    }
  });
  for (int i = 0; i < 20; ++i) {
    const auto name = value(user->add_document(write(copy()), "copy", true, {}));
    EXPECT_EQ(name, i == 0 ? "copy" : "copy-" + std::to_string(i + 1));
  }
  end = true;
  editor.join();
  for (const auto* name : {"copy", "copy-2", "copy-20"})
    EXPECT_EQ(value(connect(host->url())->open(name, false, false)).head->tets > 0, true) << name;
}

TEST_F(DocumentFiles, WhatIsNoDocumentLeavesNothingBehind) {
  make_document("cube");
  const auto good = copy();
  auto changed = good;
  changed.at(changed.find("thicken")) = 'T';
  const std::pair<std::string, std::string> bad[] = {
    {"solid part\nendsolid part\n", "is not a database"},
    {good.substr(0, good.size() / 2), ""},
    {good.substr(0, 100), ""},
    {changed, ""}};
  for (const auto& [bytes, why] : bad) {
    const auto refused = user->add_document(write(bytes), "other", false, {});
    ASSERT_FALSE(refused.has_value()) << bytes.size();
    EXPECT_EQ(refused.error().code, ec::storage_error) << render(refused.error());
    EXPECT_THAT(refused.error().message, HasSubstr(why));
    EXPECT_EQ(refused.error().message.find("adding.tedit"), std::string::npos);
    EXPECT_EQ(refused.error().message.find(".tedit-adding"), std::string::npos)
      << render(refused.error());
    EXPECT_EQ(names(), (std::set<std::string>{"cube.tedit"}));
  }
  EXPECT_EQ(value(user->add_document(write(good), "other", false, {})), "other");
}

TEST_F(DocumentFiles, ANameThatIsTakenIsNotTakenTwice) {
  make_document("cube");
  const auto file = write(copy());
  for (const auto* name : {"cube", "unsaved"}) {
    value(user->open(name, false, false));  // The second has no file yet.
    const auto refused = user->add_document(file, name, false, {});
    ASSERT_FALSE(refused.has_value()) << name;
    EXPECT_EQ(refused.error().code, ec::conflict);
    EXPECT_THAT(refused.error().message, HasSubstr("there is a document"));
  }
  EXPECT_EQ(value(user->add_document(file, "cube", true, {})), "cube-2");
  const std::string longest(64, 'a');
  EXPECT_EQ(value(user->add_document(file, longest, true, {})), longest);
  EXPECT_EQ(value(user->add_document(file, longest, true, {})), longest.substr(2) + "-2");
  EXPECT_EQ(user->add_document(file, "../cube", true, {}).error().code, ec::invalid_argument);
  EXPECT_EQ(user->add_document(file, "", true, {}).error().code, ec::invalid_argument);
}

TEST_F(DocumentFiles, WithoutAPartThereIsNothingToCopy) {
  value(user->open("empty", false, false));
  const auto refused = user->export_file("tedit", {}, {}, {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::not_found);
  make_document("cube");
  EXPECT_EQ(user->export_file("tedit", {}, "mm", {}).error().code, ec::invalid_argument);
}

TEST_F(DocumentFiles, WhatAKillLeftGoesWhenTheServerStarts) {
  make_document("cube");
  user.reset();
  host.reset();
  const auto draft = store::draft_of(documents.path() / "other.tedit");
  for (const char* with : {"", "-wal", "-shm"})
    std::ofstream(draft.string() + with) << "half";

  host = start(options_for(documents, false));
  EXPECT_EQ(names(), (std::set<std::string>{"cube.tedit"}));
  user = connect(host->url());
  EXPECT_EQ(value(user->open("cube", false, false)).head->number, 1u);
}

/// The lines of a deck, but for its title, which says what it was made of.
std::vector<std::string> lines_of(const std::string& deck) {
  std::vector<std::string> lines;
  std::istringstream in(deck);
  for (std::string line; std::getline(in, line);)
    if (line.find(" on ") == std::string::npos)
      lines.push_back(line);
  return lines;
}

/// What `tedit export` writes of the same part, line by line.
TEST_F(DocumentFiles, ADeckHoldsTheLoadCaseThatItIsAskedFor) {
  const auto loads = value(protocol::load_case_from_file(plate_loads));
  value(user->open("plate", false, false));
  value(user->import_file(plate_mesh, "mm", {}));
  value(user->set_load_case(loads));
  for (const std::string format : {"inp", "bdf"}) {
    const auto file = elsewhere.path() / ("deck." + format);
    value(run_child({TEDIT_BIN "/tedit", "export", plate_mesh.string(), "--load-case",
                     plate_loads.string(), "-o", file.string()},
                    {}, {patience, 0}, {}));
    std::ifstream in(file);
    const std::string written{std::istreambuf_iterator<char>(in), {}};
    const auto sent = value(user->export_file(format, {}, {}, {}, loads.name));
    EXPECT_TRUE(lines_of({sent.begin(), sent.end()}) == lines_of(written)) << format;
    EXPECT_GT(written.size(), 1'000'000U);
  }
  EXPECT_EQ(user->export_file("inp", {}, {}, {}, "none").error().code, ec::not_found);
  EXPECT_EQ(user->export_file("inp", {}, "mm", {}, loads.name).error().code, ec::invalid_argument)
    << "it is in metres, whatever is asked for";
  for (const auto* other : {"msh", "vtu", "tedit"})
    EXPECT_EQ(user->export_file(other, {}, {}, {}, loads.name).error().code, ec::invalid_argument)
      << other;
}

}  // namespace
}  // namespace tedit::test
