// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/gateway/users.hpp"

#include <sys/stat.h>

#include <fstream>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/gateway/permissions.hpp"
#include "actors/gateway/token_guard.hpp"
#include "tests/support/scratch.hpp"

namespace tedit::gateway {
namespace {

namespace fs = std::filesystem;
using tedit::test::value;
using ::testing::HasSubstr;

class Users : public ::testing::Test {
protected:
  [[nodiscard]] fs::path file() const { return folder_.path() / "users.sqlite"; }
  user_file keep() const { return value(user_file::open(file())); }

private:
  tedit::test::scratch_folder folder_;
};

constexpr std::int64_t far = 4'000'000'000;  // The year 2096.

TEST_F(Users, AreListedWithTheirRolesAndTokens) {
  auto users = keep();
  EXPECT_TRUE(value(users.list()).empty());
  const auto first = value(users.add("bea@example.org", access_role::view, far));
  value(users.add("anna", access_role::admin, std::nullopt));
  const auto more = value(users.add_token("bea@example.org", std::nullopt));
  EXPECT_NE(first.text, more.text);
  EXPECT_EQ(first.text.size(), 64u);

  const auto all = value(keep().list());
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "anna");
  EXPECT_EQ(all[0].role, access_role::admin);
  EXPECT_EQ(all[1].name, "bea@example.org");
  ASSERT_EQ(all[1].tokens.size(), 2u);
  EXPECT_EQ(all[1].tokens[0].until, far);
  EXPECT_EQ(all[1].tokens[1].until, std::nullopt);
  EXPECT_EQ(all[1].tokens[1].number, more.number);
}

TEST_F(Users, TheFileIsForItsOwnerAndHoldsNoToken) {
  const auto token = value(keep().add("anna", access_role::edit, far)).text;
  struct stat about {};
  ASSERT_EQ(::stat(file().c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777, 0600u);
  std::ostringstream bytes;
  bytes << std::ifstream(file(), std::ios::binary).rdbuf();
  EXPECT_THAT(bytes.str(), HasSubstr("anna"));
  EXPECT_EQ(bytes.str().find(token), std::string::npos);
}

TEST_F(Users, ANumberIsNeverUsedAgain) {
  auto users = keep();
  const auto first = value(users.add("anna", access_role::edit, far)).number;
  value(users.withdraw(first));
  EXPECT_GT(value(users.add_token("anna", far)).number, first);
}

TEST_F(Users, WhatCannotBeIsRefused) {
  auto users = keep();
  value(users.add("anna", access_role::edit, far));
  EXPECT_EQ(users.add("anna", access_role::view, far).error().code, ec::conflict);
  EXPECT_EQ(value(users.list())[0].role, access_role::edit);
  for (const auto& name : {std::string(), std::string("a b"), std::string("a\nb"),
                           std::string("\xc3\xa4"), std::string(64, 'a')})
    EXPECT_EQ(users.add(name, access_role::view, far).error().code, ec::invalid_argument) << name;
  EXPECT_EQ(users.add_token("bea", far).error().code, ec::not_found);
  EXPECT_EQ(users.set_role("bea", access_role::view).error().code, ec::not_found);
  EXPECT_EQ(users.withdraw(17).error().code, ec::not_found);
  EXPECT_EQ(users.remove("bea").error().code, ec::not_found);
}

TEST_F(Users, AFileOfAnotherKindOrOpenToOthersIsRefused) {
  keep();
  fs::permissions(file(), fs::perms::group_read, fs::perm_options::add);
  EXPECT_EQ(user_file::open(file()).error().code, ec::invalid_argument);
  EXPECT_EQ(user_book::open(file()).error().code, ec::invalid_argument);
  fs::remove(file());
  std::ofstream(file()) << "no database at all, but long enough to be looked at as one";
  fs::permissions(file(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(user_file::open(file()).error().code, ec::bad_input);
  EXPECT_EQ(user_book::open(file()).error().code, ec::bad_input);
}

TEST_F(Users, AServerSeesWhatChangesAtOnce) {
  const auto book = value(user_book::open(file()));  // Not there yet.
  EXPECT_FALSE(book->find("anything"));
  auto users = keep();
  const auto token = value(users.add("anna", access_role::view, far));
  EXPECT_EQ(book->find(token.text), (grant{"anna", access_role::view, token.number, far}));
  EXPECT_EQ(book->find(token.number), book->find(token.text));
  EXPECT_FALSE(book->find(token.text.substr(1)));

  value(users.set_role("anna", access_role::edit));
  EXPECT_EQ(book->find(token.number)->role, access_role::edit);
  const auto more = value(users.add_token("anna", far));
  value(users.withdraw(token.number));
  EXPECT_FALSE(book->find(token.text));
  EXPECT_TRUE(book->find(more.text));
  value(users.remove("anna"));
  EXPECT_FALSE(book->find(more.number));
}

TEST_F(Users, AFileThatIsExchangedIsReadAndOneThatIsGoneHasNobody) {
  const auto token = value(keep().add("anna", access_role::view, far));
  const auto book = value(user_book::open(file()));
  EXPECT_TRUE(book->find(token.text));
  const auto other = file().parent_path() / "other.sqlite";
  const auto bea = value(value(user_file::open(other)).add("bea", access_role::edit, far));
  fs::rename(other, file());
  EXPECT_FALSE(book->find(token.text));
  EXPECT_EQ(book->find(bea.text)->user, "bea");
  fs::remove(file());
  EXPECT_FALSE(book->find(bea.text));
}

TEST_F(Users, WhatCannotBeReadLeavesWhatWasReadBefore) {
  const auto token = value(keep().add("anna", access_role::view, far));
  const auto book = value(user_book::open(file()));
  const auto other = file().parent_path() / "other";
  std::ofstream(other) << "rubbish";
  fs::permissions(other, fs::perms::owner_read | fs::perms::owner_write);
  fs::rename(other, file());
  EXPECT_TRUE(book->find(token.text));
}

// A writer holds the file: nobody who logs in waits for it.
TEST_F(Users, WhoChangesTheFileHoldsUpNobody) {
  const auto token = value(keep().add("anna", access_role::view, far));
  const auto book = value(user_book::open(file()));
  sqlite3* raw = nullptr;
  ASSERT_EQ(sqlite3_open(file().c_str(), &raw), SQLITE_OK);
  const store::connection writer(raw);
  value(store::execute(writer.get(), "BEGIN EXCLUSIVE; DELETE FROM tokens"));
  EXPECT_TRUE(book->find(token.text));
  value(store::execute(writer.get(), "COMMIT"));
  EXPECT_FALSE(book->find(token.text));
}

TEST_F(Users, TheGuardKnowsTheServersTokenAndThoseOfUsers) {
  const auto token = value(keep().add("anna", access_role::view, 1000));
  const token_guard guard("secret", value(user_book::open(file())));
  EXPECT_EQ(guard.admits("secret"), (grant{"", access_role::admin, 0, std::nullopt}));
  const auto anna = guard.admits(token.text);
  ASSERT_TRUE(anna);
  EXPECT_FALSE(anna->has_ended(999));
  EXPECT_TRUE(anna->has_ended(1000));
  EXPECT_FALSE(guard.admits("secre"));
  EXPECT_FALSE(guard.admits(""));
}

// -- who may do what -----------------------------------------------------------------------------

/// Written out once more: a change of the table is a change of this.
const std::map<std::string, access_role>& expected_roles() {
  using enum access_role;
  static const std::map<std::string, access_role> all{{"hello", view},
                                                      {"list_operations", view},
                                                      {"cancel", view},
                                                      {"get_status", view},
                                                      {"list_documents", view},
                                                      {"open_document", view},
                                                      {"close_document", view},
                                                      {"upload_chunk", edit},
                                                      {"import_mesh", edit},
                                                      {"set_load_case", edit},
                                                      {"apply_edit", edit},
                                                      {"undo", edit},
                                                      {"redo", edit},
                                                      {"solve", edit},
                                                      {"export_file", view},
                                                      {"get_history", view},
                                                      {"select_surfaces", view},
                                                      {"go_to_version", edit},
                                                      {"cut_section", view},
                                                      {"preview_edit", edit},
                                                      {"watch_fields", view},
                                                      {"annotate_version", edit},
                                                      {"remove_load_case", edit},
                                                      {"cancel_solve", edit},
                                                      {"add_document", edit},
                                                      {"import_part", edit},
                                                      {"get_surface", view},
                                                      {"rename_document", edit},
                                                      {"copy_document", edit},
                                                      {"delete_document", admin},
                                                      {"compare_versions", view},
                                                      {"check_print", view}};
  return all;
}

TEST(Permissions, EveryKindOfRequestHasItsLeastRole) {
  const auto* bodies = v1::ClientMessage::descriptor()->FindOneofByName("body");
  ASSERT_NE(bodies, nullptr);
  for (int i = 0; i < bodies->field_count(); ++i) {
    const auto* kind = bodies->field(i);
    v1::ClientMessage message;
    message.GetReflection()->MutableMessage(&message, kind);
    if (message.has_open_document())
      message.mutable_open_document()->set_name("part");
    ASSERT_TRUE(expected_roles().contains(kind->name())) << kind->name();
    const auto least = expected_roles().at(kind->name());
    EXPECT_EQ(least_role(message), least) << kind->name();
    for (const auto& row : access_roles)
      EXPECT_EQ(check_role(row.value, message).has_value(), row.value >= least) << kind->name();
  }
}

TEST(Permissions, WithoutANameADocumentIsMade) {
  v1::ClientMessage message;
  message.mutable_open_document();
  EXPECT_EQ(least_role(message), access_role::edit);
}

TEST(Permissions, ARefusalNamesBothRoles) {
  v1::ClientMessage message;
  message.mutable_delete_document();
  const auto refused = check_role(access_role::edit, message).error();
  EXPECT_EQ(refused.code, ec::permission_denied);
  EXPECT_EQ(refused.message, "this needs the role admin, and your token has edit");
  EXPECT_FALSE(refused.remedy.empty());
}

}  // namespace
}  // namespace tedit::gateway
