// SPDX-License-Identifier: AGPL-3.0-or-later
// Neighbours on one server: who asks for much, who guesses, who asks for what cannot be.
#include <cmath>

#include "protocol/version.hpp"
#include "tests/scenarios/fixture.hpp"
#include "tests/support/raw_client.hpp"

namespace tedit::test {
namespace {

v1::ClientMessage open_of(const std::string& document) {
  v1::ClientMessage message;
  message.mutable_open_document()->set_name(document);
  return message;
}

v1::ClientMessage export_of(const std::string& document) {
  v1::ClientMessage message;
  message.mutable_export_file()->set_document(document);
  message.mutable_export_file()->set_format("vtu");
  return message;
}

v1::ClientMessage status() {
  v1::ClientMessage message;
  message.mutable_get_status();
  return message;
}

class Turns : public ::testing::Test {
protected:
  void SetUp() override {
    value(user->open("mine", false, false));
    value(user->import_file(plate_mesh, "mm", {}));
    const auto owner = connect(host->url());
    value(owner->open("theirs", false, false));
    value(owner->import_file(plate_mesh, "mm", {}));
    ASSERT_TRUE(neighbour.hello(test::server_token).has_welcome());
    ASSERT_TRUE(neighbour.ask(open_of("theirs")).has_document_state());
  }

  scratch_folder folder;
  std::unique_ptr<tedit::server> host = start(options_for(folder, true));
  std::unique_ptr<client::client> user = connect(host->url());
  raw_client neighbour{host->url()};
};

TEST_F(Turns, TheExportsOfOneClientWaitInNobodysWay) {
  constexpr std::size_t exports = 63;  // And a request to spare.
  for (std::size_t i = 0; i < exports; ++i)
    neighbour.start(export_of("theirs"));
  const auto busy = neighbour.ask(status());
  ASSERT_EQ(busy.server_status().workers_size(), 3);
  // Two are written at once; the others wait at their client's.
  EXPECT_LE(busy.server_status().workers(0).jobs(), 2u);

  value(user->edit("fill_hole", {1, 2}, {}, {}));
}

TEST_F(Turns, AnExportCanBeCancelledBeforeItIsWritten) {
  std::vector<std::uint64_t> ids;
  for (int i = 0; i < 20; ++i)
    ids.push_back(neighbour.start(export_of("theirs")));
  v1::ClientMessage cancel;
  cancel.mutable_cancel()->set_request_id(ids.back());
  EXPECT_TRUE(neighbour.ask(cancel).has_done());
  EXPECT_EQ(neighbour.answer(ids.back()).error().code(), "cancelled");
  EXPECT_TRUE(neighbour.answer(ids[18]).has_file_ready());
}

TEST_F(Turns, WhoKnowsTheTokenIsLetInWhileOthersGuess) {
  std::vector<std::unique_ptr<raw_client>> guessers;
  for (int i = 0; i < 6; ++i) {
    v1::ClientMessage guess;
    guess.mutable_hello()->set_protocol_major(protocol::major_version);
    guess.mutable_hello()->set_protocol_minor(protocol::minor_version);
    guess.mutable_hello()->set_token("guess " + std::to_string(i));
    guessers.push_back(std::make_unique<raw_client>(host->url()));
    guessers.back()->start(guess);
    guess.mutable_hello()->set_token(test::server_token);
    guessers.back()->start(guess);  // One attempt a connection.
  }
  raw_client honest(host->url());
  EXPECT_TRUE(honest.hello(test::server_token).has_welcome());
  const auto refused = guessers.front()->answer(1).error();
  EXPECT_EQ(refused.code(), "invalid_argument");
  EXPECT_EQ(refused.message(), "the token is wrong");
  for (const auto& guesser : guessers)
    EXPECT_NE(guesser->end(), "");
  EXPECT_EQ(honest.ask(status()).server_status().wrong_tokens(), 6u);
}

TEST_F(Turns, NumbersThatCannotBeAreRefusedAndTheServerGoesOn) {
  const double odd[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308, 5e-324, 0};
  for (const double x : odd) {
    v1::ClientMessage cut;
    cut.mutable_cut_section()->set_document("theirs");
    cut.mutable_cut_section()->mutable_point_m()->set_x(x);
    cut.mutable_cut_section()->mutable_normal()->set_y(x);
    const auto section = neighbour.ask(cut);
    EXPECT_TRUE(section.has_error() || std::isfinite(x)) << x;
    for (const auto kind : {v1::SelectSurfaces::HOLES, v1::SelectSurfaces::SMOOTH}) {
      v1::ClientMessage select;
      select.mutable_select_surfaces()->set_document("theirs");
      select.mutable_select_surfaces()->set_kind(kind);
      if (kind == v1::SelectSurfaces::SMOOTH)
        select.mutable_select_surfaces()->add_surfaces(1);
      select.mutable_select_surfaces()->set_angle_rad(x);
      select.mutable_select_surfaces()->set_min_diameter_m(x);
      select.mutable_select_surfaces()->set_max_diameter_m(x);
      (void)neighbour.ask(select);
    }
    v1::ClientMessage solve;
    solve.mutable_solve()->set_document("theirs");
    solve.mutable_solve()->set_tolerance(x);
    solve.mutable_solve()->set_energy_tolerance(x);
    EXPECT_TRUE(neighbour.ask(solve).has_error()) << x;  // There is no load case, either.
  }
  v1::ClientMessage go;
  go.mutable_go_to_version()->set_document("theirs");
  go.mutable_go_to_version()->set_number(0xFFFFFFFF);
  EXPECT_EQ(neighbour.ask(go).error().code(), "not_found");
  const auto after = neighbour.ask(status()).server_status();
  for (const auto& worker : after.workers())
    EXPECT_EQ(worker.restarts(), 0u) << worker.role() << " " << worker.detail();
}

// -- bulk data -----------------------------------------------------------------------------------

TEST_F(Turns, EveryArrayBeginsAtAMultipleOfEightBytes) {
  raw_client reader(host->url());
  ASSERT_TRUE(reader.hello(test::server_token).has_welcome());
  auto open = open_of("theirs");
  open.mutable_open_document()->set_watch_surface(true);
  ASSERT_TRUE(reader.ask(open).has_document_state());
  const auto update = reader.wait([](const auto& m) { return m.has_surface_update(); });
  const auto& stream = update.surface_update().stream();
  std::size_t end = 0;
  for (const auto& array : stream.arrays()) {
    EXPECT_EQ(array.offset() % 8, 0u) << array.name();
    EXPECT_GE(array.offset(), end) << array.name();
    EXPECT_LT(array.offset(), end + 8) << array.name();
    const bool wide =
      array.type() == v1::ArrayInfo::FLOAT64 || array.type() == v1::ArrayInfo::INT64;
    end = array.offset() + array.items() * array.components() * (wide ? 8 : 4);
  }
  EXPECT_EQ(end, reader.stream(stream).size());
}

TEST_F(Turns, AClientOfAnotherReleaseIsTurnedAwayWithBothVersions) {
  raw_client old(host->url());
  const auto said = old.hello(test::server_token, protocol::minor_version - 1);
  EXPECT_EQ(said.error().code(), "protocol_error");
  EXPECT_EQ(said.error().message(),
            "the client speaks version 1.9 of the protocol, this server version 1.10");
}

}  // namespace
}  // namespace tedit::test
