// SPDX-License-Identifier: AGPL-3.0-or-later
// Users with their roles, and tokens that end.
#include <map>

#include "actors/gateway/permissions.hpp"
#include "actors/gateway/users.hpp"
#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

using gateway::access_role;
using ::testing::HasSubstr;

/// A server with a file of users.
class Access : public ::testing::Test {
protected:
  Access() {
    options = options_for(folder, false);
    options.documents = folder.path() / "documents";
    options.users = folder.path() / "users.sqlite";
    options.access_every = std::chrono::milliseconds(20);
  }

  gateway::new_token add(const std::string& name, access_role role,
                         std::optional<std::int64_t> until = {}) {
    return value(users.add(name, role, until));
  }

  [[nodiscard]] client::connect_options as(const std::string& token) const {
    client::connect_options how;
    how.url = host->url();
    how.token = token;
    how.client_name = "test";
    how.timeout = patience;
    return how;
  }

  std::unique_ptr<client::client> connect_as(const std::string& token) const {
    return value(client::client::connect(as(token), {}));
  }

  void run() { host = start(options); }

  scratch_folder folder;
  server_options options;
  gateway::user_file users = value(gateway::user_file::open(folder.path() / "users.sqlite"));
  std::unique_ptr<server> host;
};

TEST_F(Access, ATokenNamesItsUserAndRole) {
  const auto anna = add("anna", access_role::view);
  run();
  const auto looker = connect_as(anna.text);
  EXPECT_EQ(looker->access().user, "anna");
  EXPECT_EQ(looker->access().role, "view");
  const auto owner = connect_as(server_token);
  EXPECT_EQ(owner->access().user, "");
  EXPECT_EQ(owner->access().role, "admin");
}

TEST_F(Access, WhoMayLookBeginsNoDocument) {
  const auto anna = add("anna", access_role::view);
  run();
  const auto looker = connect_as(anna.text);
  const auto refused = looker->open("plate", true, true);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::not_found);
  EXPECT_THAT(refused.error().message, HasSubstr("there is no document plate"));
  EXPECT_THAT(value(looker->list_documents()), ::testing::IsEmpty());
  const auto owner = connect_as(server_token);
  value(owner->open("plate", false, false));
  EXPECT_TRUE(looker->open("plate", true, true).has_value());
}

/// Whether a request of this kind is refused for its role. Its fields are those of nobody's
/// request: what is allowed is refused for something else.
bool is_denied(raw_client& client, const google::protobuf::FieldDescriptor* kind) {
  v1::ClientMessage message;
  message.GetReflection()->MutableMessage(&message, kind);
  if (message.has_open_document())
    message.mutable_open_document()->set_name("part");
  const bool silent = message.has_upload_chunk();
  const auto id = client.start(std::move(message));
  if (silent) {  // What follows is answered after it.
    v1::ClientMessage next;
    next.mutable_list_documents();
    client.ask(std::move(next));
    return client.has([&](const auto& m) {
      return m.request_id() == id && m.error().code() == "permission_denied";
    });
  }
  return client.answer(id).error().code() == "permission_denied";
}

TEST_F(Access, EachRoleMayAskForWhatItMayAndForNothingElse) {
  std::map<access_role, std::string> tokens;
  for (const auto& row : gateway::access_roles)
    tokens[row.value] = add("the-" + std::string(row.name), row.value).text;
  run();
  const auto* bodies = v1::ClientMessage::descriptor()->FindOneofByName("body");
  for (const auto& [role, token] : tokens) {
    raw_client client(host->url());
    ASSERT_TRUE(client.hello(token).has_welcome());
    for (int i = 0; i < bodies->field_count(); ++i) {
      v1::ClientMessage message;
      message.GetReflection()->MutableMessage(&message, bodies->field(i));
      if (message.has_open_document())
        message.mutable_open_document()->set_name("part");
      EXPECT_EQ(is_denied(client, bodies->field(i)), role < gateway::least_role(message))
        << gateway::name_of(role) << " " << bodies->field(i)->name();
    }
  }
}

TEST_F(Access, WhoMayOnlyLookSeesWhatOthersDo) {
  const auto anna = add("anna", access_role::edit);
  const auto bert = add("bert", access_role::view);
  run();
  const auto editor = connect_as(anna.text);
  value(editor->open("plate", false, false));
  const auto made = value(editor->import_file(plate_mesh, "mm", {}));

  const auto looker = connect_as(bert.text);
  const auto state = value(looker->open("plate", true, false));
  EXPECT_EQ(state.head->version_id, made.head.version_id);
  value(looker->wait_surface(made.head.version_id, patience));
  EXPECT_FALSE(value(looker->export_file("msh", {}, "mm", {})).empty());
  const auto refused = looker->undo();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ec::permission_denied);
  EXPECT_THAT(refused.error().message, HasSubstr("role edit"));
  EXPECT_EQ(looker->import_file(plate_mesh, "mm", {}).error().code, ec::permission_denied);
  EXPECT_EQ(editor->delete_document("plate").error().code, ec::permission_denied);
}

TEST_F(Access, AConflictNamesTheUser) {
  const auto anna = add("anna", access_role::edit);
  run();
  const auto editor = connect_as(anna.text);
  value(editor->open("plate", false, false));
  value(editor->import_file(plate_mesh, "mm", {}));
  const auto other = connect_as(server_token);
  value(other->open("plate", false, false));
  client::change_terms terms;
  terms.expected_version = std::string(32, '0');
  const auto refused = other->import_file(plate_mesh, "mm", {}, terms);
  ASSERT_FALSE(refused);
  ASSERT_TRUE(refused.error().rival);
  EXPECT_EQ(refused.error().rival->client, "anna, test");
}

TEST_F(Access, OnlyAdminsAreToldWhoIsThere) {
  const auto anna = add("anna", access_role::edit);
  run();
  const auto editor = connect_as(anna.text);
  const auto owner = connect_as(server_token);
  const auto all = value(owner->status()).clients;
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].user, "anna");
  EXPECT_EQ(all[0].role, "edit");
  EXPECT_EQ(all[0].client, "test");
  EXPECT_THAT(all[0].address, HasSubstr("127.0.0.1:"));
  EXPECT_EQ(all[1].user, "");
  const auto seen = value(editor->status());
  EXPECT_TRUE(seen.clients.empty());
  EXPECT_EQ(seen.connections, 2u);
}

TEST_F(Access, ATokenThatHasEndedLetsNobodyIn) {
  const auto anna = add("anna", access_role::edit, gateway::seconds_now() - 1);
  run();
  const auto refused = client::client::connect(as(anna.text), {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ec::permission_denied);
  EXPECT_THAT(refused.error().message, HasSubstr("the token of anna ended at 20"));
  raw_client owner(host->url());
  ASSERT_TRUE(owner.hello(server_token).has_welcome());
  v1::ClientMessage status;
  status.mutable_get_status();
  EXPECT_EQ(owner.ask(std::move(status)).server_status().wrong_tokens(), 0u);  // It is no guess.
}

TEST_F(Access, AWithdrawnTokenEndsItsConnectionsWithTheReason) {
  const auto anna = add("anna", access_role::edit);
  const auto kept = value(users.add_token("anna", {}));
  run();
  raw_client ended(host->url());
  ASSERT_TRUE(ended.hello(anna.text).has_welcome());
  raw_client stays(host->url());
  ASSERT_TRUE(stays.hello(kept.text).has_welcome());

  value(users.withdraw(anna.number));

  EXPECT_THAT(ended.end(), HasSubstr("the token of anna was withdrawn"));
  EXPECT_TRUE(ended.has([](const auto& m) { return m.error().code() == "permission_denied"; }));
  EXPECT_EQ(client::client::connect(as(anna.text), {}).error().code, ec::invalid_argument);
  v1::ClientMessage still;
  still.mutable_get_status();
  EXPECT_TRUE(stays.ask(std::move(still)).has_server_status());
}

TEST_F(Access, ATokenEndsWhileItIsUsed) {
  run();
  const auto until = gateway::seconds_now() + 4;
  const auto anna = add("anna", access_role::edit, until);
  raw_client client(host->url());
  ASSERT_TRUE(client.hello(anna.text).has_welcome());
  EXPECT_THAT(client.end(), HasSubstr("the token of anna ended at 20"));
  EXPECT_GE(gateway::seconds_now(), until);
}

TEST_F(Access, AnotherRoleHoldsForThoseWhoAreThere) {
  const auto anna = add("anna", access_role::edit);
  run();
  const auto client = connect_as(anna.text);
  EXPECT_NE(client->delete_document("nothing").error().code, ec::not_found);
  value(users.set_role("anna", access_role::admin));
  const auto deadline = std::chrono::steady_clock::now() + patience;
  auto answer = client->delete_document("nothing").error().code;
  while (answer != ec::not_found && std::chrono::steady_clock::now() < deadline)
    answer = client->delete_document("nothing").error().code;
  EXPECT_EQ(answer, ec::not_found);
}

}  // namespace
}  // namespace tedit::test
