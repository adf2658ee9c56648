// SPDX-License-Identifier: AGPL-3.0-or-later
// What no version needs goes, whole or not at all; the rest is what it was.
#include <random>

#include "actors/store/document_view.hpp"
#include "mesh/version.hpp"
#include "tests/store/fixture.hpp"

namespace tedit::store {
namespace {

/// A cube thickened twice (versions 0, 1, 2), then a version 3 made from 0 with a page more: the
/// head, so that no undo or redo reaches 1 and 2.
class Removal : public Document {
protected:
  void SetUp() override {
    Document::SetUp();
    fs::copy_file(TEDIT_TEST_DATA "/documents/cube_format_1.tedit", file);
    const auto doc = open();
    auto all = doc->read().value();
    change branch;
    branch.new_version = all.versions[2];
    branch.new_version->number = 3;
    branch.new_version->parent = 0;
    branch.new_version->redo.reset();
    branch.redo = {{0, 3}};
    branch.head = 3;
    branch.annotations = {{3, "mine", ""}};
    branch.what = "edit";
    branch.details = R"({"head":3})";
    ASSERT_TRUE(doc->commit(branch));
  }

  /// Versions 1 and 2 go.
  static removal without_branch() {
    return {{0, std::nullopt, std::nullopt, 1}, {{6, "edit", R"({"head":1})"}}};
  }

  expected<std::int64_t> remove(const removal& what) const { return open()->remove(what); }

  [[nodiscard]] std::vector<hash128> pages() const {
    return document_view::open(file).value()->page_ids().value();
  }
};

TEST_F(Removal, TheRestIsNumberedAnewAndKeepsItsMeshesNamesAndLog) {
  const auto before = open()->read().value();
  ASSERT_EQ(before.log.size(), 6U);

  ASSERT_TRUE(remove(without_branch()).has_value());

  const auto doc = open();
  const auto all = doc->read();
  ASSERT_TRUE(all.has_value()) << render(all.error());
  ASSERT_EQ(all->versions.size(), 2U);
  EXPECT_EQ(all->head, 1U);
  EXPECT_EQ(all->versions[0].id, before.versions[0].id);
  EXPECT_EQ(all->versions[0].redo, 1U);
  EXPECT_EQ(all->versions[1].id, before.versions[3].id);
  EXPECT_EQ(all->versions[1].parent, 0U);
  EXPECT_EQ(all->versions[1].name, "mine");
  EXPECT_EQ(all->log.size(), 6U);
  EXPECT_EQ(all->log[5].details, R"({"head":1})");
  EXPECT_EQ(all->log[4].details, before.log[4].details);
  for (const auto& row : all->versions)
    for (const auto& id : manifest::from_bytes(row.manifest).value().page_ids())
      EXPECT_TRUE(doc->read_page(id).has_value());
}

TEST_F(Removal, PagesThatNoVersionNamesGoAndTheFileShrinks) {
  {
    const auto doc = open();
    change unneeded;
    std::mt19937 noise(1);  // Nothing that a compression would take out.
    for (int i = 0; i < 50; ++i) {
      std::vector<std::byte> bytes(20000);
      for (auto& one : bytes)
        one = static_cast<std::byte>(noise());
      unneeded.new_pages.push_back(page::from_bytes(bytes));
    }
    ASSERT_TRUE(doc->commit(unneeded));
  }
  const auto before = state_of(file).value().bytes;
  const auto needed = pages().size() - 50;

  const auto done = remove({{0, 1, 2, 3}, {}});

  ASSERT_TRUE(done.has_value()) << render(done.error());
  EXPECT_EQ(*done, 50);
  EXPECT_EQ(pages().size(), needed);
  EXPECT_LT(state_of(file).value().bytes, before - 50 * 10000);
  EXPECT_FALSE(fs::exists(file.string() + "-wal"));
  EXPECT_EQ(open()->read().value().versions.size(), 4U);
}

TEST_F(Removal, ADocumentGoesOnAfterIt) {
  const auto doc = open();
  ASSERT_TRUE(doc->remove(without_branch()).has_value());

  change words;
  words.annotations = {{0, "first", ""}};
  words.what = "annotate";
  const auto done = doc->commit(words);

  ASSERT_TRUE(done.has_value()) << render(done.error());
  EXPECT_EQ(doc->read().value().log.back().sequence, 7U);
}

TEST_F(Removal, WhatWouldLeaveNoTreeIsRefusedAndChangesNothing) {
  const auto before = pages();
  const std::pair<removal, const char*> bad[] = {
    {{{0, 1, 2, std::nullopt}, {}}, "the current one would go"},
    {{{0, std::nullopt, 1, 2}, {}}, "version 2 would lose its parent"},
    {{{std::nullopt, 0, 1, 2}, {}}, "version 1 would lose its parent"},
    {{{0, 1, 2, 4}, {}}, "version 3 would be version 4"},
    {{{0, 1, 2}, {}}, "4 versions, not 3"}};
  for (const auto& [what, why] : bad) {
    const auto refused = remove(what);
    ASSERT_FALSE(refused.has_value()) << why;
    EXPECT_EQ(refused.error().code, ec::invalid_argument);
    EXPECT_THAT(refused.error().message, HasSubstr(why));
  }
  EXPECT_EQ(open()->read().value().versions.size(), 4U);
  EXPECT_EQ(pages(), before);
}

TEST_F(Removal, ADamagedPageThatIsNeededEndsIt) {
  const auto row = open()->read().value().versions[3];
  const auto lost = manifest::from_bytes(row.manifest).value().page_ids().back();
  tamper("DELETE FROM page WHERE id = '" + to_hex(lost) + "'");

  const auto refused = remove(without_branch());

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::storage_error);
  EXPECT_THAT(refused.error().message, HasSubstr(to_hex(lost)));
  EXPECT_EQ(open()->read().value().versions.size(), 4U);
}

}  // namespace
}  // namespace tedit::store
