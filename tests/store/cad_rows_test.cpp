// SPDX-License-Identifier: AGPL-3.0-or-later
// CAD models of versions: kept, covered by the seal, gone with their version, and absent in
// documents from before there were any.
#include "actors/store/document_view.hpp"
#include "tests/store/fixture.hpp"

namespace tedit::store {
namespace {

const std::string shape(100'000, 'b');

cad_row model_of(std::uint32_t number) {
  return {number, "same", "", 2.5e-9, R"({"faces":[]})", shape};
}

class CadRows : public Document {
protected:
  void make_three_versions() const {
    const auto doc = open();
    for (std::uint32_t number = 0; number < 3; ++number) {
      auto change = make_change(number);
      if (number == 0)
        change.cad = {model_of(0)};
      if (number == 2)
        change.cad = {{2, "mesh_only", "no way", 0, "", ""}};
      ASSERT_TRUE(doc->commit(change));
    }
  }

  [[nodiscard]] std::string complaint() const {
    const auto opened = document::open(file);
    if (!opened)
      return opened.error().message;
    const auto all = (*opened)->read();
    return all ? "" : all.error().message;
  }
};

TEST_F(CadRows, AModelIsReadAsItWasWritten) {
  make_three_versions();

  const auto doc = open();
  const auto first = doc->read_cad(0);
  const auto second = doc->read_cad(1);
  const auto third = doc->read_cad(2);

  ASSERT_TRUE(first && *first);
  EXPECT_EQ((*first)->shape, shape);
  EXPECT_EQ((*first)->facts, R"({"faces":[]})");
  EXPECT_EQ((*first)->deviation, 2.5e-9);
  EXPECT_FALSE(*second);
  ASSERT_TRUE(third && *third);
  EXPECT_EQ((*third)->status, "mesh_only");
  EXPECT_EQ((*third)->reason, "no way");
  EXPECT_EQ((*third)->shape, "");
  const auto rows = doc->read();
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->cad.size(), 2U);
  EXPECT_EQ(rows->cad[1].number, 2U);
  EXPECT_EQ(rows->cad[0].shape, "");  // Not with all rows: it is read when it is asked for.
  EXPECT_LT(fs::file_size(file), shape.size());
  const auto view = document_view::open(file);
  ASSERT_TRUE(view);
  EXPECT_EQ((*view)->read_cad(0).value()->shape, shape);
}

TEST_F(CadRows, WhatWasChangedBehindItsBackIsNamed) {
  make_three_versions();
  const fs::path kept = folder / "kept";
  fs::copy_file(file, kept);
  for (const char* sql :
       {"UPDATE cad SET status = 'same' WHERE version = 2",
        "UPDATE cad SET shape = x'00' WHERE version = 0",
        "UPDATE cad SET deviation = 1 WHERE version = 0", "DELETE FROM cad WHERE version = 0"}) {
    fs::copy_file(kept, file, fs::copy_options::overwrite_existing);
    tamper(sql);
    EXPECT_THAT(complaint(), HasSubstr("damaged")) << sql;
  }
}

TEST_F(CadRows, AShapeThatCannotBeUnpackedIsRefused) {
  make_three_versions();
  tamper("UPDATE cad SET shape = x'28b52ffd00' WHERE version = 0");

  const auto read = open()->read_cad(0);

  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("the CAD model of version 0 is damaged"));
}

TEST_F(CadRows, AModelGoesWithItsVersionAndFollowsItsNumber) {
  fs::copy_file(TEDIT_TEST_DATA "/documents/cube_format_1.tedit", file);
  {
    const auto doc = open();
    change models;
    models.cad = {model_of(0), model_of(1), {2, "mesh_only", "no way", 0, "", ""}};
    models.head = 2;
    ASSERT_TRUE(doc->commit(models));
    auto parent = doc->read().value().versions[2].parent;
    ASSERT_EQ(parent, 1U);
  }
  {
    const auto doc = open();
    change back;
    back.head = 0;
    ASSERT_TRUE(doc->commit(back));
    ASSERT_TRUE(doc->remove({{0, std::nullopt, std::nullopt}, {}}));
  }

  const auto doc = open();
  const auto rows = doc->read();
  ASSERT_TRUE(rows) << render(rows.error());
  ASSERT_EQ(rows->cad.size(), 1U);
  EXPECT_EQ(doc->read_cad(0).value()->shape, shape);
  EXPECT_FALSE(*doc->read_cad(1));
}

TEST_F(CadRows, ADocumentFromBeforeHasNoneAndIsReadWithoutBeingChanged) {
  fs::copy_file(TEDIT_TEST_DATA "/documents/block_format_2.tedit", file);
  {
    const auto view = document_view::open(file);
    ASSERT_TRUE(view) << render(view.error());
    EXPECT_EQ((*view)->format(), 2);
    const auto rows = (*view)->read();
    ASSERT_TRUE(rows);
    EXPECT_TRUE(rows->damage.empty());
    EXPECT_FALSE(*(*view)->read_cad(0));
  }
  EXPECT_EQ(look_up("PRAGMA user_version"), "2");

  EXPECT_FALSE(*open()->read_cad(0));
  EXPECT_EQ(look_up("PRAGMA user_version"), "3");
}

TEST_F(CadRows, ADamagedDocumentFromBeforeIsNotSealedAnew) {
  fs::copy_file(TEDIT_TEST_DATA "/documents/block_format_2.tedit", file);
  tamper("UPDATE version SET operation = 'erode' WHERE number = 1");

  const auto why = refusal();

  EXPECT_EQ(why.code, ec::storage_error);
  EXPECT_THAT(why.message, HasSubstr("version 1"));
  EXPECT_EQ(look_up("PRAGMA user_version"), "2");
  const auto view = document_view::open(file);
  ASSERT_TRUE(view);
  EXPECT_THAT((*view)->read()->damage.front().message, HasSubstr("version 1"));
}

}  // namespace
}  // namespace tedit::store
