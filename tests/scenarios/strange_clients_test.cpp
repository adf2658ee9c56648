// SPDX-License-Identifier: AGPL-3.0-or-later
// What a client must not do, and bytes from strange files: others and the server go on.
#include <fstream>

#include "protocol/json.hpp"
#include "tests/scenarios/fixture.hpp"
#include "tests/support/raw_client.hpp"

namespace tedit::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// A server with a client that has introduced itself and opened the document "part".
class StrangeClients : public ::testing::Test {
protected:
  void start() {
    server = test::start(options);
    user = introduced();
    v1::ClientMessage open;
    open.mutable_open_document()->set_name("part");
    ASSERT_TRUE(user->ask(open).has_document_state());
  }

  std::unique_ptr<raw_client> introduced() {
    auto made = std::make_unique<raw_client>(server->url());
    EXPECT_TRUE(made->hello(test::server_token).has_welcome());
    return made;
  }

  static v1::ClientMessage piece(std::uint64_t upload, std::uint64_t offset, std::string data) {
    v1::ClientMessage message;
    message.mutable_upload_chunk()->set_upload(upload);
    message.mutable_upload_chunk()->set_offset(offset);
    message.mutable_upload_chunk()->set_data(std::move(data));
    return message;
  }

  v1::ServerMessage import(const std::string& bytes, const std::string& name) {
    user->start(piece(1, 0, bytes));
    v1::ClientMessage message;
    auto* wanted = message.mutable_import_mesh();
    wanted->set_document("part");
    wanted->set_upload(1);
    wanted->set_size(bytes.size());
    wanted->set_file_name(name);
    return user->ask(message);
  }

  v1::ServerMessage set_load_case(const v1::LoadCase& loads) {
    v1::ClientMessage message;
    message.mutable_set_load_case()->set_document("part");
    *message.mutable_set_load_case()->mutable_load_case() = loads;
    return user->ask(message);
  }

  static v1::ClientMessage status(std::uint64_t id) {
    v1::ClientMessage message;
    message.set_request_id(id);
    message.mutable_get_status();
    return message;
  }

  static v1::ClientMessage cancel(std::uint64_t id, std::uint64_t which) {
    v1::ClientMessage message;
    message.set_request_id(id);
    message.mutable_cancel()->set_request_id(which);
    return message;
  }

  scratch_folder folder;
  server_options options = options_for(folder, false);
  std::unique_ptr<tedit::server> server;
  std::unique_ptr<raw_client> user;
};

v1::LoadCase plate_load_case() {
  const auto loads = value(protocol::load_case_from_file(plate_loads));
  return value(protocol::message_from_json<v1::LoadCase>(protocol::load_case_to_json(loads)));
}

TEST_F(StrangeClients, ARepeatedRequestIdEndsNothingAndMakesNoRoom) {
  start();
  ASSERT_TRUE(import(content_of(plate_mesh), "plate.msh").has_committed());
  ASSERT_TRUE(set_load_case(plate_load_case()).has_done());
  v1::ClientMessage solve;
  solve.mutable_solve()->set_document("part");
  for (std::uint64_t id = 101; id <= 164; ++id) {
    solve.set_request_id(id);
    user->send(solve);  // The first runs, the others wait for it.
  }
  for (std::uint64_t id = 101; id <= 164; ++id)
    user->send(status(id));
  user->send(status(200));
  for (std::uint64_t id = 101; id <= 164; ++id)
    user->send(cancel(300 + id, id));

  for (std::uint64_t id = 101; id <= 164; ++id) {
    const auto said = user->answer(id);  // About the repetition.
    EXPECT_EQ(said.error().code(), "protocol_error");
    EXPECT_THAT(said.error().message(), HasSubstr(std::to_string(id) + " is in use"));
  }
  EXPECT_THAT(user->answer(200).error().message(), HasSubstr("too many requests"));
  for (std::uint64_t id = 101; id <= 164; ++id) {
    EXPECT_TRUE(user->answer(300 + id).has_done());
    EXPECT_EQ(user->answer(id).error().code(), "cancelled");
  }
  EXPECT_TRUE(user->ask(status(0)).has_server_status());
}

TEST_F(StrangeClients, NamesInOtherEncodingsArriveAsUtf8) {
  start();
  auto mesh = content_of(TEDIT_TEST_DATA "/bad/good_base_22ascii.msh");
  const std::string names =
    "$PhysicalNames\n1\n2 1 \"Bohrung S\xFC"
    "d\"\n$EndPhysicalNames\n";
  mesh.insert(mesh.find("$Nodes"), names);
  const std::string facet = " 2 2 0 1 ";  // A triangle of entity 1, in no physical group.
  for (auto at = mesh.find(facet); at != std::string::npos; at = mesh.find(facet, at))
    mesh.replace(at, facet.size(), " 2 2 1 1 ");
  const auto made = import(mesh, "S\u00FCd.msh");
  ASSERT_TRUE(made.has_committed()) << made.error().message();

  const auto other = introduced();
  v1::ClientMessage open;
  open.mutable_open_document()->set_name("part");
  open.mutable_open_document()->set_watch_surface(true);
  ASSERT_TRUE(other->ask(open).has_document_state());
  const auto seen = other->wait([](const auto& m) { return m.has_surface_update(); });
  std::string all;
  for (const auto& surface : seen.surface_update().surfaces())
    all += surface.name() + "\n";
  EXPECT_THAT(all, HasSubstr("Bohrung S\uFFFDd"));
}

TEST_F(StrangeClients, TheReasonWhyADamagedDocumentDoesNotOpenArrives) {
  start();
  ASSERT_TRUE(
    import(content_of(TEDIT_TEST_DATA "/bad/good_base_22ascii.msh"), "a").has_committed());
  user.reset();
  server.reset();
  const auto file = folder.path() / "part.tedit";
  auto bytes = content_of(file);
  const auto at = bytes.find("CREATE TABLE head");
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at + 13, 4,
                "h\xFF\xFE"
                "d");
  write(file, bytes);

  server = test::start(options);
  user = introduced();
  v1::ClientMessage open;
  open.mutable_open_document()->set_name("part");
  const auto answer = user->ask(open);
  EXPECT_EQ(answer.error().code(), "storage_error");
  EXPECT_FALSE(answer.error().message().empty());
}

TEST_F(StrangeClients, ALongFileNameIsCutBetweenCharacters) {
  start();
  const std::string name = std::string(199, 'a') + "\u00FC.msh";
  ASSERT_TRUE(
    import(content_of(TEDIT_TEST_DATA "/bad/good_base_22ascii.msh"), name).has_committed());
  v1::ClientMessage history;
  history.mutable_get_history()->set_document("part");
  EXPECT_EQ(user->ask(history).history().versions_size(), 1);
}

TEST_F(StrangeClients, NamesAndTextsHaveABound) {
  start();
  ASSERT_TRUE(import(content_of(plate_mesh), "plate.msh").has_committed());
  auto loads = plate_load_case();
  loads.set_name(std::string(1 << 20, 'n'));
  const auto huge = set_load_case(loads).error();
  EXPECT_EQ(huge.code(), "invalid_argument");
  EXPECT_THAT(huge.message(), AllOf(HasSubstr("set_load_case.load_case.name"), HasSubstr("16384")));
  loads.set_name(std::string(201, 'n'));
  const auto longer = set_load_case(loads).error();
  EXPECT_THAT(longer.message(), HasSubstr("name of a load case has 201 bytes"));
  EXPECT_THAT(longer.remedy(), HasSubstr("200"));
  loads.set_name("two\nlines");
  EXPECT_THAT(set_load_case(loads).error().message(), HasSubstr("control characters"));
  loads.set_name(std::string(200, 'n'));
  EXPECT_TRUE(set_load_case(loads).has_done());
  loads.mutable_materials(0)->set_name(std::string(300, 'm'));
  EXPECT_THAT(set_load_case(loads).error().message(), HasSubstr("name of a material"));
}

TEST_F(StrangeClients, TheLoadCasesOfAVersionHaveABoundTogether) {
  start();
  ASSERT_TRUE(import(content_of(plate_mesh), "plate.msh").has_committed());
  auto loads = plate_load_case();
  for (std::int64_t id = 0; id < 200'000; ++id)
    loads.mutable_loads(0)->add_surfaces(1'000'000 + id);
  std::string said;
  for (int i = 0; i < 4 && said.empty(); ++i) {
    loads.set_name("case " + std::to_string(i));
    said = set_load_case(loads).error().message();
  }
  EXPECT_THAT(said, HasSubstr("4194304 bytes together"));
}

TEST_F(StrangeClients, ABoundaryMayNotMoveAcrossThePart) {
  start();
  ASSERT_TRUE(import(content_of(plate_mesh), "plate.msh").has_committed());
  v1::ClientMessage message;
  auto* edit = message.mutable_apply_edit();
  edit->set_document("part");
  edit->set_operation("improve_mesh");
  (*edit->mutable_parameters())["surface_tolerance"].set_real(1e308);
  const auto absurd = user->ask(message).error();
  EXPECT_EQ(absurd.code(), "invalid_parameter");
  EXPECT_THAT(absurd.remedy(), HasSubstr("It takes 0 to 1 m"));
  (*edit->mutable_parameters())["surface_tolerance"].set_real(0.9);  // Longer than the plate.
  const auto refused = user->ask(message).error();
  EXPECT_EQ(refused.code(), "invalid_parameter");
  EXPECT_THAT(refused.remedy(), HasSubstr("mm"));
}

// -- uploads -------------------------------------------------------------------------------------

TEST_F(StrangeClients, OneConnectionMayNotFillTheMemoryWithUploads) {
  options.upload_bytes = 1 << 20;
  start();
  const std::string part(600'000, 'x');
  user->start(piece(1, 0, part));
  const auto refused = user->answer(user->start(piece(2, 0, part))).error();
  EXPECT_EQ(refused.code(), "conflict");
  EXPECT_THAT(refused.message(), AllOf(HasSubstr("this connection"), HasSubstr("1048576 bytes")));
  EXPECT_THAT(refused.remedy(), HasSubstr("limits.upload_bytes"));
  // The refused one is dropped, the first one is whole.
  EXPECT_EQ(user->answer(user->start(piece(2, 600'000, "x"))).error().code(), "protocol_error");
  v1::ClientMessage message;
  message.mutable_import_mesh()->set_document("part");
  message.mutable_import_mesh()->set_upload(1);
  message.mutable_import_mesh()->set_size(part.size());
  EXPECT_NE(user->ask(message).error().code(), "protocol_error");  // No mesh, but complete.
  // What was imported, or was to be, is no upload any more.
  user->start(piece(3, 0, part));
  EXPECT_TRUE(user->ask(status(0)).has_server_status());
}

TEST_F(StrangeClients, AllConnectionsTogetherMayNotEither) {
  options.upload_bytes = 1 << 20;
  options.all_upload_bytes = 1 << 20;
  start();
  const std::string part(600'000, 'x');
  auto hoarder = introduced();
  hoarder->start(piece(1, 0, part));
  ASSERT_TRUE(hoarder->ask(status(0)).has_server_status());  // The piece has been taken.
  const auto refused = user->answer(user->start(piece(1, 0, part))).error();
  EXPECT_EQ(refused.code(), "conflict");
  EXPECT_THAT(refused.message(), HasSubstr("all connections"));
  EXPECT_THAT(refused.remedy(), HasSubstr("limits.all_upload_bytes"));
  hoarder.reset();
  // Freed as soon as the server notices that it is gone.
  const auto end = std::chrono::steady_clock::now() + patience;
  bool taken = false;
  while (!taken && std::chrono::steady_clock::now() < end) {
    const auto id = user->start(piece(2, 0, part));
    const auto after = user->start(status(0));
    taken =
      user->wait([=](const auto& m) { return m.request_id() == id || m.request_id() == after; })
        .request_id() == after;
  }
  EXPECT_TRUE(taken);
}

TEST_F(StrangeClients, UploadsAreCounted) {
  start();
  for (std::uint64_t i = 1; i <= 64; ++i)
    user->start(piece(i, 0, ""));
  const auto refused = user->answer(user->start(piece(65, 0, ""))).error();
  EXPECT_THAT(refused.message(), HasSubstr("64 uploads"));
}

}  // namespace
}  // namespace tedit::test
