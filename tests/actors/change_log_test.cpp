// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/session/change_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedit::actors {
namespace {

using ::testing::ElementsAre;

past_change change(const std::string& id, std::optional<std::uint32_t> version = {}) {
  past_change made;
  made.what = "edit";
  made.operation = "erode";
  made.client = "bench \"2\"";
  made.time = "2026-11-23T08:45:00Z";
  made.edit_id = id;
  made.request = asked_change{"edit", R"({"operation":"erode"})"}.id();
  made.version = version;
  made.warnings = {"one"};
  return made;
}

store::log_row row_of(const past_change& made) {
  return {1, made.what, made.to_details(R"({"operation":"erode"})")};
}

TEST(ChangeLog, ARowSaysWhatWasMade) {
  const auto made = change("a", 7);
  const auto read = past_change::from_log(row_of(made));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->what, "edit");
  EXPECT_EQ(read->operation, "erode");
  EXPECT_EQ(read->client, made.client);
  EXPECT_EQ(read->time, made.time);
  EXPECT_EQ(read->edit_id, "a");
  EXPECT_EQ(read->request, made.request);
  EXPECT_EQ(read->version, 7u);
  EXPECT_THAT(read->warnings, ElementsAre("one"));
}

TEST(ChangeLog, RowsOfOlderServersAndDamagedOnesSayNothing) {
  for (const char* details : {"", "3", "bend", R"({"operation":"erode"})", R"({"time":)"})
    EXPECT_FALSE(past_change::from_log({1, "edit", details}).has_value()) << details;
}

TEST(ChangeLog, RemembersTheNewestEditIds) {
  change_log log;
  for (std::size_t i = 0; i <= change_log::most_remembered; ++i)
    log.add(change("id" + std::to_string(i)));
  EXPECT_EQ(log.find("id0"), nullptr);
  ASSERT_NE(log.find("id1"), nullptr);
  EXPECT_EQ(log.find("id1000")->edit_id, "id1000");
  EXPECT_EQ(log.find(""), nullptr);
}

TEST(ChangeLog, IsReadFromTheDocumentAgain) {
  const change_log log({row_of(change("a", 1)), row_of(change("", 2)), row_of(change("b"))});
  EXPECT_NE(log.find("a"), nullptr);
  EXPECT_NE(log.find("b"), nullptr);
  ASSERT_TRUE(log.last_move().has_value());
  EXPECT_EQ(log.last_move()->version, 2u);
}

TEST(ChangeLog, OtherRequestsHaveOtherIds) {
  const asked_change one{"undo", "{}"};
  EXPECT_EQ(one.id(), (asked_change{"undo", "{}"}).id());
  EXPECT_NE(one.id(), (asked_change{"redo", "{}"}).id());
  EXPECT_NE(one.id(), (asked_change{"undo", R"({"number":1})"}).id());
}

TEST(ChangeLog, AnEditIdIsShortAndPlain) {
  for (const char* good : {"", "x", "0b7c1d52-77a4-4f1f-8a54-5d0c1e1f9a11"})
    EXPECT_TRUE(check_edit_id(good).has_value()) << good;
  EXPECT_TRUE(check_edit_id(std::string(64, 'x')).has_value());
  for (const auto& bad : {std::string(65, 'x'), std::string("a b"), std::string("\xC3\xBC"),
                          std::string("a\n"), std::string(1, '\0')})
    EXPECT_FALSE(check_edit_id(bad).has_value());
}

}  // namespace
}  // namespace tedit::actors
