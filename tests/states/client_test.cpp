// SPDX-License-Identifier: AGPL-3.0-or-later
// One client's actor alone: who is let in, what is answered, what runs, and what a slow line gets.
#include "tests/states/client_fixture.hpp"

namespace tedit::gateway {
namespace {

using simulation::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// -- who is let in -------------------------------------------------------------------------------

TEST_F(Client, NothingIsAnsweredBeforeHello) {
  const auto id = edit();
  EXPECT_EQ(answer_to(id).error().code(), "protocol_error");
  EXPECT_EQ(line_->closed_with, 1008);
  EXPECT_EQ(line_->welcomed, 0);
}

TEST_F(Client, BytesThatAreNoMessageCloseTheLineAndAreCountedOff) {
  hello();
  const auto before = line_->dealt_with;
  caf::anon_send(client_, std::string(100, '\xff'));
  pass(milliseconds(1));
  EXPECT_EQ(line_->closed_with, 1007);
  EXPECT_EQ(line_->dealt_with - before, 100U);
}

TEST_F(Client, AWrongTokenIsAnsweredLaterAndNothingElseIsHeard) {
  const auto wrong = hello("wrong");
  const auto right = hello();
  EXPECT_THAT(line_->messages, IsEmpty());
  pass(token_guard::first_delay);
  EXPECT_THAT(answer_to(wrong).error().message(), HasSubstr("token"));
  EXPECT_EQ(line_->closed_with, 1008);
  EXPECT_THAT(answers_to(right), IsEmpty());
  EXPECT_EQ(line_->welcomed, 0);
}

TEST_F(Client, HelloIsSaidOnce) {
  EXPECT_TRUE(answer_to(hello()).has_welcome());
  EXPECT_EQ(answer_to(hello()).error().code(), "protocol_error");
  EXPECT_EQ(line_->welcomed, 1);
  EXPECT_EQ(line_->closed_with, 0);
}

// -- requests ------------------------------------------------------------------------------------

TEST_F(Client, WhatIsAskedOfADocumentThatIsNotOpenSaysHowToOpenIt) {
  hello();
  for (const auto id : {edit(), preview(), export_file(), surface_of(0), close("part")}) {
    const auto error = answer_to(id).error();
    EXPECT_EQ(error.code(), "not_found");
    EXPECT_THAT(error.remedy(), HasSubstr("OpenDocument"));
  }
  EXPECT_THAT(state().requests, IsEmpty());
}

TEST_F(Client, ANumberThatIsInUseEndsNothing) {
  open();
  const auto first = edit();
  edit("part", first);
  EXPECT_THAT(answer_to(first).error().message(), HasSubstr("in use"));
  EXPECT_EQ(server().edits.size(), 1U);
  within_server([&] { take(server().edits).promise.deliver(moved_to(second_)); });
  ASSERT_EQ(answers_to(first).size(), 2U);
  EXPECT_TRUE(answers_to(first).back().has_committed());
}

TEST_F(Client, SixtyFourRequestsRunAndCancellingOneMakesRoom) {
  open();
  std::vector<std::uint64_t> running;
  for (int i = 0; i < 64; ++i)
    running.push_back(edit());
  EXPECT_EQ(answer_to(edit()).error().code(), "conflict");
  EXPECT_TRUE(answer_to(cancel(running[5])).has_done());
  ASSERT_EQ(server().cancelled.size(), 1U);
  EXPECT_EQ(server().cancelled.front(), server().edits[5].wanted.ticket);
  within_server([&] {
    server().edits[5].promise.deliver(actors::to_caf({ec::cancelled, "was cancelled", {}, {}}));
  });
  EXPECT_EQ(answer_to(running[5]).error().code(), "cancelled");
  EXPECT_THAT(answers_to(edit()), IsEmpty()) << "it runs";
}

TEST_F(Client, ARequestWithoutANumberIsNoneButAPieceOfAFileIs) {
  open();
  v1::ClientMessage message;
  message.mutable_apply_edit()->set_document("part");
  caf::anon_send(client_, message.SerializeAsString());
  pass(milliseconds(1));
  EXPECT_EQ(answer_to(0).error().code(), "protocol_error");
  line_->messages.clear();
  v1::ClientMessage piece;
  piece.mutable_upload_chunk()->set_upload(1);
  piece.mutable_upload_chunk()->set_data("abc");
  caf::anon_send(client_, piece.SerializeAsString());
  pass(milliseconds(1));
  EXPECT_THAT(line_->messages, IsEmpty());
  EXPECT_EQ(all_uploads_->used(), 3U);
}

TEST_F(Client, WhenTheLineIsGoneItsRequestsEndAndItsDocumentsAreLeft) {
  open();
  edit();
  preview();
  const auto edit_ticket = server().edits.front().wanted.ticket;
  const auto preview_ticket = server().previews.front().wanted.edit.ticket;
  tell(closed_atom::value);
  EXPECT_THAT(server().cancelled, ElementsAre(edit_ticket, preview_ticket));
  EXPECT_EQ(server().detached, 1);
}

TEST_F(Client, ProgressGoesToTheRequestThatRuns) {
  open();
  const auto id = edit();
  const auto ticket = server().edits.front().wanted.ticket;
  tell(actors::request_progress{ticket, .5, "cutting"});
  EXPECT_EQ(answer_to(id).progress().stage(), "cutting");
  within_server([&] { take(server().edits).promise.deliver(moved_to(second_)); });
  line_->messages.clear();
  tell(actors::request_progress{ticket, .9, "late"});
  tell(actors::request_progress{0, .9, "nobody's"});
  EXPECT_THAT(line_->messages, IsEmpty());
}

// -- documents -----------------------------------------------------------------------------------

TEST_F(Client, ASessionThatEndedOnTheWayIsAskedForAgain) {
  hello();
  const auto id = ask_to_open();
  within_server([&] {
    take(server().openings).promise.deliver(actors::opened_document{"part", server_});
  });
  within_server([&] {
    take(server().attachments)
      .promise.deliver(actors::to_caf({ec::service_unavailable, "ended", {}, {}}));
  });
  EXPECT_THAT(answers_to(id), IsEmpty());
  let_open("part", nullptr, server_);
  EXPECT_TRUE(answer_to(id).has_document_state());
}

TEST_F(Client, AClosedDocumentSendsNothingMore) {
  open("part", first_);
  EXPECT_TRUE(answer_to(close("part")).has_done());
  EXPECT_EQ(server().detached, 1);
  line_->messages.clear();
  tell(moved_to(second_));
  EXPECT_THAT(line_->messages, IsEmpty());
}

TEST_F(Client, ClosingOneDocumentLeavesThePreviewOfAnother) {
  open("one", first_);
  open("other", first_, stage_.system().spawn(make_server, 2));
  const auto id = preview("one");
  EXPECT_TRUE(answer_to(close("other")).has_done());
  EXPECT_THAT(server().cancelled, IsEmpty());
  within_server([&] {
    take(server().previews)
      .promise.deliver(actors::previewed{
        "one", first_, second_, std::make_shared<const edit_report>(), actors::no_load_cases()});
  });
  EXPECT_TRUE(answer_to(id).has_edit_preview());
}

TEST_F(Client, ClosingADocumentEndsItsPreviewAtOnce) {
  open("part", first_);
  const auto id = preview();
  close("part");
  EXPECT_EQ(answer_to(id).error().code(), "cancelled");
  EXPECT_EQ(server().cancelled.size(), 1U);
}

// -- previews ------------------------------------------------------------------------------------

TEST_F(Client, ANewerPreviewEndsTheOneBeforeWhoseAnswerIsForNobody) {
  open("part", first_);
  const auto older = preview();
  const auto newer = preview();
  EXPECT_EQ(answer_to(older).error().code(), "superseded");
  EXPECT_EQ(server().cancelled.size(), 1U);
  const actors::previewed made{"part", first_, second_, std::make_shared<const edit_report>(),
                               actors::no_load_cases()};
  within_server([&] { take(server().previews).promise.deliver(made); });
  within_server([&] { take(server().previews).promise.deliver(made); });
  EXPECT_EQ(answers_to(older).size(), 1U);
  EXPECT_TRUE(answer_to(newer).has_edit_preview());
}

// Numbers of requests that were answered may be used again.
TEST_F(Client, ANewPreviewLeavesARequestThatTookTheNumberOfAnOldOne) {
  open("part", first_);
  const auto number = preview();
  within_server([&] {
    take(server().previews)
      .promise.deliver(actors::previewed{
        "part", first_, second_, std::make_shared<const edit_report>(), actors::no_load_cases()});
  });
  ASSERT_TRUE(answer_to(number).has_edit_preview());
  line_->messages.clear();
  edit("part", number);
  preview();
  EXPECT_THAT(server().cancelled, IsEmpty());
  EXPECT_THAT(answers_to(number), IsEmpty());
  within_server([&] { take(server().edits).promise.deliver(moved_to(second_)); });
  EXPECT_TRUE(answer_to(number).has_committed());
}

TEST_F(Client, APreviewOfAHeadThatMovedMeanwhileIsNotSent) {
  open("part", first_);
  const auto id = preview();
  line_->queued = more_than_is_sent_ahead;
  within_server([&] {
    take(server().previews)
      .promise.deliver(actors::previewed{
        "part", first_, second_, std::make_shared<const edit_report>(), actors::no_load_cases()});
  });
  EXPECT_THAT(answers_to(id), IsEmpty());
  tell(moved_to(third_));
  drain();
  EXPECT_EQ(answer_to(id).error().code(), "superseded");
}

// -- a slow line ---------------------------------------------------------------------------------

TEST_F(Client, ASlowLineGetsTheNewestSurfaceAloneAsADifferenceToWhatItHolds) {
  open("part", first_);
  line_->queued = more_than_is_sent_ahead;
  tell(moved_to(second_));
  tell(moved_to(third_));
  EXPECT_EQ(surfaces_sent(), 0U);
  EXPECT_EQ(count([](const auto& one) { return one.has_committed(); }), 2U) << "events overtake";
  drain();
  ASSERT_EQ(surfaces_sent(), 1U);
  const auto sent =
    std::ranges::find_if(line_->messages, [](const auto& one) { return one.has_surface_update(); });
  EXPECT_EQ(sent->surface_update().base_version_id(), to_hex(first_->id()));
  EXPECT_EQ(sent->surface_update().version_id(), to_hex(third_->id()));
}

TEST_F(Client, AHeadThatCameBackMeanwhileNeedsNoSurface) {
  open("part", first_);
  line_->queued = more_than_is_sent_ahead;
  tell(moved_to(second_));
  tell(moved_to(first_));
  drain();
  EXPECT_EQ(surfaces_sent(), 0U);
}

TEST_F(Client, WhoAskedHearsOfANewHeadOnceAndGetsItsSurface) {
  open("part", first_);
  const auto id = edit();
  within_server([&] { take(server().edits).promise.deliver(moved_to(second_)); });
  EXPECT_TRUE(answer_to(id).has_committed());
  EXPECT_EQ(count([](const auto& one) { return one.has_committed(); }), 1U);
  EXPECT_EQ(surfaces_sent(), 1U);
}

TEST_F(Client, AnAnswerThatRepeatsAnEarlierOneMovesNothing) {
  open("part", first_);
  tell(moved_to(third_));
  line_->messages.clear();
  edit();
  auto before = moved_to(second_);
  before.repeated = true;
  within_server([&] { take(server().edits).promise.deliver(before); });
  EXPECT_EQ(surfaces_sent(), 0U);
  EXPECT_EQ(to_hex(state().documents.at("part").head->id()), to_hex(third_->id()));
}

TEST_F(Client, ASurfaceThatIsAskedForWaitsItsTurnAndIsGoneWithItsLine) {
  open("part", first_);
  line_->queued = more_than_is_sent_ahead;
  const auto id = surface_of(0);
  within_server([&] {
    take(server().versions).promise.deliver(actors::session_version{"part", 0, first_});
  });
  EXPECT_THAT(answers_to(id), IsEmpty());
  drain();
  EXPECT_EQ(answer_to(id).version_surface().surface().version_id(), to_hex(first_->id()));
  EXPECT_THAT(state().requests, IsEmpty());
}

// -- files ---------------------------------------------------------------------------------------

TEST_F(Client, TwoFilesAreWrittenAtOnceAndOneThatWaitsIsCancelledUnasked) {
  open("part", first_);
  const auto first = export_file();
  export_file();
  const auto third = export_file();
  const auto fourth = export_file();
  EXPECT_EQ(server().files.size(), 2U);
  cancel(third);
  EXPECT_EQ(answer_to(third).error().code(), "cancelled");
  EXPECT_THAT(server().cancelled, IsEmpty()) << "nobody had begun it";
  within_server([&] { take(server().files).promise.deliver(actors::exported{"part.msh", {}, 0}); });
  EXPECT_EQ(answer_to(first).file_ready().file_name(), "part.msh");
  EXPECT_EQ(server().files.size(), 2U) << "the fourth is begun";
  EXPECT_EQ(server().files.back().wanted.ticket, state().requests.at(fourth).ticket);
}

TEST_F(Client, AFileThatCannotBeWrittenMakesRoomForTheNext) {
  open("part", first_);
  const auto first = export_file();
  export_file();
  export_file();
  within_server([&] {
    take(server().files).promise.deliver(actors::to_caf({ec::internal, "disk full", {}, {}}));
  });
  EXPECT_THAT(answer_to(first).error().message(), HasSubstr("disk full"));
  EXPECT_EQ(server().files.size(), 2U);
}

TEST_F(Client, NoFileIsWrittenForWhoHasNotTakenTheLastOnes) {
  open("part", first_);
  line_->queued = std::size_t{33} << 20;
  export_file();
  EXPECT_THAT(server().files, IsEmpty());
  drain();
  EXPECT_EQ(server().files.size(), 1U);
}

// -- files that come -----------------------------------------------------------------------------

TEST_F(Client, AnImportedFileIsOffTheAccountWhenNobodyHoldsItAnyMore) {
  open();
  upload(1, 0, 600);
  EXPECT_EQ(all_uploads_->used(), 600U);
  const auto id = import(1, 600);
  ASSERT_EQ(server().imports.size(), 1U);
  within_server([&] { take(server().imports).promise.deliver(moved_to(first_)); });
  EXPECT_TRUE(answer_to(id).has_committed());
  EXPECT_EQ(all_uploads_->used(), 0U);
}

TEST_F(Client, MoreThanOneConnectionMayHoldIsRefusedAndDropped) {
  open();
  upload(1, 0, 600);
  upload(2, 0, 600);
  ASSERT_EQ(line_->messages.size(), 1U);
  EXPECT_THAT(line_->messages.front().error().message(), HasSubstr("1000 bytes"));
  EXPECT_EQ(all_uploads_->used(), 600U);
  const auto id = import(2, 600);
  EXPECT_EQ(answer_to(id).error().code(), "protocol_error");
}

TEST_F(Client, AMissingPieceDropsTheFile) {
  open();
  upload(1, 0, 100);
  upload(1, 200, 100);
  EXPECT_THAT(line_->messages.front().error().message(), HasSubstr("missing"));
  EXPECT_EQ(all_uploads_->used(), 0U);
}

// The remedy is to send it again: what is there of it must not stay on the account, nor in the way.
TEST_F(Client, AFileOfAnotherSizeThanWasSaidIsDropped) {
  open();
  upload(1, 0, 100);
  const auto id = import(1, 150);
  EXPECT_THAT(answer_to(id).error().remedy(), HasSubstr("again"));
  EXPECT_EQ(all_uploads_->used(), 0U);
  upload(1, 0, 150);
  import(1, 150);
  EXPECT_EQ(server().imports.size(), 1U);
}

TEST_F(Client, AFileWhoseDocumentIsNotOpenIsDropped) {
  open();
  upload(1, 0, 100);
  EXPECT_EQ(answer_to(import(1, 100, "another")).error().code(), "not_found");
  EXPECT_EQ(all_uploads_->used(), 0U);
}

TEST_F(Client, WithTheLineAllUploadsAreOffTheAccount) {
  open();
  upload(1, 0, 300);
  upload(2, 0, 300);
  tell(closed_atom::value);
  pass(milliseconds(1));
  EXPECT_EQ(all_uploads_->used(), 0U);
}

// -- names ---------------------------------------------------------------------------------------

TEST_F(Client, ADocumentIsFoundByTheNamesThatItHadInThisConnection) {
  open("part", first_);
  tell(actors::document_renamed{"part", "bracket"});
  EXPECT_EQ(line_->messages.back().document_renamed().document(), "bracket");
  edit("part");
  EXPECT_EQ(server().edits.size(), 1U);
  line_->messages.clear();
  tell(moved_to(second_, "bracket"));
  EXPECT_EQ(line_->messages.front().committed().document(), "bracket");
  EXPECT_EQ(surfaces_sent(), 1U);
}

TEST_F(Client, ASurfaceThatWaitedWhileItsDocumentWasRenamedHasTheNewName) {
  open("part", first_);
  line_->queued = more_than_is_sent_ahead;
  tell(moved_to(second_));
  tell(actors::document_renamed{"part", "bracket"});
  drain();
  const auto sent =
    std::ranges::find_if(line_->messages, [](const auto& one) { return one.has_surface_update(); });
  ASSERT_NE(sent, line_->messages.end());
  EXPECT_EQ(sent->surface_update().document(), "bracket");
}

}  // namespace
}  // namespace tedit::gateway
