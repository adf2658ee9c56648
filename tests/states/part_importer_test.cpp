// SPDX-License-Identifier: AGPL-3.0-or-later
// The actor that meshes the CAD files of clients: how many at once, in which order, and how they
// end.
#include "actors/cad/part_importer.hpp"
#include "tests/states/hands.hpp"

namespace tedit::actors {
namespace {

struct client_notes {
  std::vector<request_progress> told;
  static inline const char* name = "client_notes";
};

class PartImporter : public WithHands {
protected:
  explicit PartImporter(std::size_t threads = 1) {
    client_ = stage_.system().spawn(
      [](caf::stateful_actor<client_notes>* self, int) -> caf::behavior {
        return {[=](const request_progress& one) { self->state.told.push_back(one); }};
      },
      0);
    importer_ =
      stage_.system().spawn(make_part_importer, threads_of(threads), std::chrono::seconds(60));
  }
  ~PartImporter() override { simulation::cut_off(caf::actor_cast<caf::actor>(importer_)); }

  /// A file that is no part: what is wrong with it is found without any program.
  answer<part_document> import(std::uint64_t ticket, const cancel_token& stop = {}) {
    constexpr std::string_view bytes = "nothing that is a part";
    part_order order;
    order.file = {page::from_bytes(std::as_bytes(std::span(bytes)))};
    order.file_name = "Bracket 7.step";
    order.ticket = ticket;
    order.client = client_;
    order.stop = stop;
    auto result = ask<part_document>(importer_, order);
    pass(milliseconds(1));
    return result;
  }
  std::vector<request_progress>& told() { return simulation::state_of<client_notes>(client_).told; }

  caf::actor client_;
  part_importer_actor importer_;
};

TEST_F(PartImporter, OneAfterTheOtherAndWhoWaitsIsTold) {
  const auto first = import(1);
  const auto second = import(2);
  EXPECT_EQ(hands().tasks.size(), 1U);
  ASSERT_EQ(told().size(), 1U);
  EXPECT_EQ(told()[0].ticket, 2U);
  EXPECT_EQ(told()[0].stage, "waiting for another import");

  work();
  EXPECT_EQ(first.refusal().code, ec::unsupported_format);
  EXPECT_FALSE(second.is_there());
  work();
  EXPECT_EQ(second.refusal().code, ec::unsupported_format);
  pass(milliseconds(1000));
  EXPECT_EQ(first.count() + second.count(), 2);
}

TEST_F(PartImporter, SpeaksOfTheFileByItsOwnName) {
  const auto refused = import(1);
  work();
  EXPECT_EQ(refused.refusal().where, "Bracket 7.step");
  EXPECT_THAT(render(refused.refusal()), ::testing::Not(HasSubstr("tedit-part-")));
}

TEST_F(PartImporter, WhatNobodyWantsAnyMoreIsAnsweredBeforeItsTurn) {
  const cancel_token stop_first;
  const cancel_token stop_second;
  const auto first = import(1, stop_first);
  const auto second = import(2, stop_second);
  const auto third = import(3);
  stop_second.cancel();
  pass(milliseconds(300));
  EXPECT_EQ(second.refusal().code, ec::cancelled);
  EXPECT_EQ(hands().tasks.size(), 1U);

  stop_first.cancel();
  EXPECT_FALSE(first.is_there()) << "its thread notices";
  work();
  EXPECT_EQ(first.refusal().code, ec::cancelled);
  work();
  EXPECT_EQ(third.refusal().code, ec::unsupported_format);
}

class TwoPartImporters : public PartImporter {
protected:
  TwoPartImporters() : PartImporter(2) {}
};

TEST_F(TwoPartImporters, MeshTwoAtOnce) {
  const auto first = import(1);
  const auto second = import(2);
  const auto third = import(3);
  EXPECT_EQ(hands().tasks.size(), 2U);
  work();
  EXPECT_EQ(hands().tasks.size(), 2U);
  work();
  work();
  EXPECT_TRUE(first.is_there() && second.is_there() && third.is_there());
}

}  // namespace
}  // namespace tedit::actors
