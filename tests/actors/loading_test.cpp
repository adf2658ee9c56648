// SPDX-License-Identifier: AGPL-3.0-or-later
// What is read of a document when it is opened, and what when it is wanted.
#include "actors/store/loading.hpp"

#include "actors/pages/page_cache.hpp"
#include "actors/store/store.hpp"
#include "mesh/builder.hpp"
#include "tests/store/fixture.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::actors {
namespace {

/// A document of three versions of a block of 6 * 16^3 tets: one vertex is moved from each to the
/// next, so that they share most pages.
class Loading : public store::Document {
protected:
  void SetUp() override {
    store::Document::SetUp();
    auto mesh = test::box_mesh({16, 16, 16}, {1, 1, 1});
    const auto document = open();
    for (std::uint32_t number = 0; number < 3; ++number) {
      graph_node node;
      node.info.number = number;
      if (number > 0)
        node.info.parent = number - 1;
      node.info.operation = "nudge";
      const auto* parent = meshes.empty() ? nullptr : meshes.back().get();
      describe_mesh(node, mesh);
      ASSERT_TRUE(document->commit(change_of(node, parent)).has_value());
      meshes.push_back(mesh);
      mesh_builder builder(mesh);
      builder.set_position(0, {.001 * (number + 1), 0, 0});
      mesh = builder.freeze();
    }
  }

  [[nodiscard]] version_query query(std::uint32_t number) const {
    return {number, meshes[number]->id(), cache};
  }

  /// Makes the page that only this version has unreadable, and its hash fit.
  void damage_own_page(std::uint32_t number, const std::string& sql) const {
    std::set<hash128> others;
    for (const auto& mesh : meshes)
      if (mesh != meshes[number])
        for (const auto& id : mesh->pages().page_ids())
          others.insert(id);
    for (const auto& id : meshes[number]->pages().page_ids())
      if (!others.contains(id))
        tamper(sql + " WHERE id = '" + to_hex(id) + "'");
  }

  std::vector<version_ptr> meshes;
  std::shared_ptr<page_cache> cache = std::make_shared<page_cache>(std::size_t{1} << 30);
};

TEST_F(Loading, OpeningReadsTheHeadAloneAndSaysTheSameOfAll) {
  const auto document = open();
  const auto whole = load(*document);
  const auto opened = load_head(*document);

  ASSERT_TRUE(whole && opened);
  for (std::uint32_t number = 0; number < 3; ++number) {
    const auto& a = whole->nodes[number].info;
    const auto& b = opened->nodes[number].info;
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.tets, 6U * 16 * 16 * 16);
    EXPECT_EQ(b.tets, a.tets);
    EXPECT_EQ(b.vertices, a.vertices);
    EXPECT_EQ(b.boundary_facets, a.boundary_facets);
    EXPECT_EQ(opened->nodes[number].mesh != nullptr, number == 2);
  }
  EXPECT_EQ(opened->nodes[2].mesh->id(), meshes[2]->id());
}

TEST_F(Loading, AVersionIsReadAsFarAsItsPagesAreNotKnown) {
  const auto document = open();

  const auto first = load_version(*document, query(0));
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->mesh->id(), meshes[0]->id());
  std::uint64_t all = 0;
  first->mesh->for_each_page([&](const page_ptr& p) { all += p->bytes().size(); });
  EXPECT_EQ(first->read_bytes, all);

  cache->put(*first->mesh);
  const auto second = load_version(*document, query(1));
  ASSERT_TRUE(second.has_value());
  EXPECT_EQ(second->mesh->id(), meshes[1]->id());
  EXPECT_EQ(second->read_bytes, 2048U * sizeof(vec3)) << "the page of the vertex that moved";
}

TEST_F(Loading, ADamagedPageOfAnOldVersionRefusesThatVersionAlone) {
  damage_own_page(0, "UPDATE page SET data = zeroblob(20)");
  const auto document = open();

  ASSERT_TRUE(load_head(*document).has_value());
  EXPECT_TRUE(load_version(*document, query(1)).has_value());
  const auto old = load_version(*document, query(0));
  ASSERT_FALSE(old.has_value());
  EXPECT_EQ(old.error().code, ec::storage_error);
  EXPECT_THAT(old.error().message, ::testing::HasSubstr("is damaged"));
  EXPECT_FALSE(load(*document).has_value()) << "who wants all of it is told";
}

TEST_F(Loading, AMissingPageOfAnyVersionIsToldWhenTheDocumentIsOpened) {
  damage_own_page(0, "DELETE FROM page");
  const auto document = open();

  const auto opened = load_head(*document);

  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().message, ::testing::HasSubstr("of version 0 is missing"));
}

TEST_F(Loading, AVersionThatIsAnotherThanItIsCalledIsRefused) {
  const auto document = open();
  auto wrong = query(0);
  wrong.id = meshes[1]->id();
  EXPECT_FALSE(load_version(*document, wrong).has_value());
  wrong.number = 7;
  const auto none = load_version(*document, wrong);
  ASSERT_FALSE(none.has_value());
  EXPECT_THAT(none.error().message, ::testing::HasSubstr("version 7 is not stored"));
}

}  // namespace
}  // namespace tedit::actors
