// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents that programs of before have written say the same in this one. Each format has files in
// tests/data/documents, and beside each what was read from it when it was new.
#include <fstream>
#include <set>

#include "actors/store/loading.hpp"
#include "actors/store/schema.hpp"
#include "protocol/forms.hpp"
#include "tests/store/fixture.hpp"

namespace tedit::store {
namespace {

/// Everything that a document says, a line each.
std::string words_of(const actors::stored_document& all) {
  std::string text = "head " + (all.head ? std::to_string(*all.head) : "none") + "\n";
  for (const auto& node : all.nodes) {
    const auto& info = node.info;
    text += "version " + std::to_string(info.number) + " " + to_hex(info.id) + " parent " +
            (info.parent ? std::to_string(*info.parent) : "none") + " redo " +
            (node.redo ? std::to_string(*node.redo) : "none") + "\n";
    text += "  " + info.operation + ", " + std::to_string(info.tets) + " tets, " +
            std::to_string(info.vertices) + " vertices, " + std::to_string(info.boundary_facets) +
            " facets\n  named \"" + info.name + "\", note \"" + info.note + "\"\n";
    for (const auto& surface : node.mesh->surfaces())
      text += "  surface " + std::to_string(surface.id) + " " + surface.name + "\n";
    text += "  loads " + protocol::to_json(*node.load_cases) + "\n";
    text += "  report " + (node.report ? protocol::to_json(*node.report) : "none") + "\n";
  }
  for (const auto& row : all.log)
    text += "log " + std::to_string(row.sequence) + " " + row.what + " " + row.details + "\n";
  return text;
}

class Formats : public Document {
protected:
  static std::vector<fs::path> fixtures() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(TEDIT_TEST_DATA "/documents"))
      if (entry.path().extension() == ".tedit")
        found.push_back(entry.path());
    return found;
  }

  [[nodiscard]] std::string words() const {
    const auto opened = document::open(file);
    if (!opened)
      return render(opened.error());
    const auto all = actors::load(**opened);
    return all ? words_of(*all) : render(all.error());
  }
};

TEST_F(Formats, DocumentsOfEachSayWhatTheySaidWhenTheyWereNew) {
  for (const auto& fixture : fixtures()) {
    fs::remove(file);
    fs::copy_file(fixture, file);
    fs::path kept = fixture;
    kept.replace_extension(".txt");
    std::ifstream in(kept);
    const std::string before{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(words(), before) << fixture;
    EXPECT_EQ(words(), before) << fixture << ", opened again";
  }
}

// Who raises the number adds a document that the program of before has written.
TEST_F(Formats, EachHasADocumentAmongTheTests) {
  std::set<std::int64_t> numbers;
  const auto number_in = [](const fs::path& path) {
    sqlite3* made = nullptr;
    sqlite3_open_v2(path.c_str(), &made, SQLITE_OPEN_READONLY, nullptr);
    const connection db(made);
    return number_of(made, "PRAGMA user_version").value_or(-1);
  };
  for (const auto& fixture : fixtures()) {
    fs::copy_file(fixture, file, fs::copy_options::overwrite_existing);
    numbers.insert(number_in(file));
  }
  fs::remove(file);
  const auto blank = blank_document();
  ASSERT_TRUE(blank);
  std::ofstream(file, std::ios::binary)
    .write(reinterpret_cast<const char*>(blank->data()),
           static_cast<std::streamsize>(blank->size()));
  std::set<std::int64_t> all;
  for (std::int64_t i = 1; i <= number_in(file); ++i)
    all.insert(i);
  EXPECT_EQ(numbers, all);
}

}  // namespace
}  // namespace tedit::store
