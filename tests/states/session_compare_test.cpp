// SPDX-License-Identifier: AGPL-3.0-or-later
// Comparisons of a session: one at a time, and how they end early.
#include "tests/states/session_fixture.hpp"

namespace tedit::actors {
namespace {

/// Two versions; the thread that compares works when a test says so.
class SessionComparisons : public Session {
protected:
  void SetUp() override {
    import_all();
    set_load("hanging", 5);
    edit(.1);
    finish({"edit", "check", "commit"});
  }

  answer<compared> compare(std::uint32_t before, std::uint32_t after,
                           const std::string& load_case = {}) {
    return request<compared>(comparison_request{++tickets_, before, after, load_case});
  }
  answer<shared_remains> ask_to_end() {
    auto got = ask<shared_remains>(session_, end_atom::value);
    pass(milliseconds(1));
    return got;
  }
};

TEST_F(SessionComparisons, AVersionWithItselfDiffersInNothing) {
  const auto got = compare(1, 1);
  EXPECT_FALSE(got.is_there()) << "the session does not compare itself";
  finish({"compare"});

  ASSERT_TRUE(got.is_success());
  EXPECT_EQ(got.value().document, "part");
  const auto& what = *got.value().what;
  EXPECT_EQ(what.before_id, what.after_id);
  EXPECT_EQ(what.tets_in_common, what.after.tets);
  EXPECT_EQ(what.deviation.distance_m, 0);
}

TEST_F(SessionComparisons, AnEditMovesOneVertexAndTheTetsAroundIt) {
  const auto got = compare(0, 1);
  finish({"compare"});

  ASSERT_TRUE(got.is_success());
  const auto& what = *got.value().what;
  EXPECT_EQ(what.vertices_in_common, what.after.vertices - 1);
  EXPECT_LT(what.tets_in_common, what.after.tets);
  EXPECT_GT(what.deviation.distance_m, 0);
  EXPECT_LT(what.deviation.distance_m, .1) << "along an edge: the corner is cut off aslant";
}

TEST_F(SessionComparisons, WhatIsNotThereIsRefusedBeforeAnyWork) {
  EXPECT_EQ(compare(0, 2).refusal().code, ec::not_found);
  EXPECT_THAT(compare(7, 0).refusal().message, HasSubstr("there is no version 7"));
  const auto refused = compare(0, 1, "standing").refusal();
  EXPECT_EQ(refused.code, ec::not_found);
  EXPECT_THAT(refused.message, HasSubstr("\"standing\""));
  EXPECT_THAT(refused.remedy, HasSubstr("They have \"hanging\""));
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(SessionComparisons, AVersionWithoutAFieldIsNamed) {
  const auto got = compare(0, 1, "hanging");
  finish({"compare"});

  ASSERT_TRUE(got.is_success());
  EXPECT_THAT(got.value().what->fields, IsEmpty());
  ASSERT_EQ(got.value().what->not_compared.size(), 1U);
  const auto& absent = got.value().what->not_compared.front();
  EXPECT_EQ(absent.load_case, "hanging");
  EXPECT_THAT(absent.reason, HasSubstr("no field of version 0"));
  EXPECT_THAT(absent.remedy, HasSubstr("solve"));
  EXPECT_THAT(*got.value().difference, IsEmpty());
}

TEST_F(SessionComparisons, AFieldOfOtherLoadsIsNotTakenForThatOfTheVersion) {
  const auto reason = [&] {
    const auto got = compare(1, 1);
    finish({"compare"});
    return got.value().what->not_compared.at(0).reason;
  };
  solve(mine_);
  finish({"solve"});
  EXPECT_THAT(reason(), HasSubstr("no von Mises stress")) << "the made-up result is found";
  set_load("hanging", 6);
  EXPECT_THAT(reason(), HasSubstr("no field of version 1 is at hand"));
  set_load("hanging", 5);
  EXPECT_THAT(reason(), HasSubstr("no von Mises stress"));
}

TEST_F(SessionComparisons, ALoadCaseThatOnlyOneHasIsNamedToo) {
  set_load("braking", 5);
  const auto got = compare(0, 1);
  finish({"compare"});

  ASSERT_TRUE(got.is_success());
  const auto& absent = got.value().what->not_compared;
  ASSERT_EQ(absent.size(), 2U);
  EXPECT_EQ(absent[1].load_case, "braking");
  EXPECT_THAT(absent[1].reason, HasSubstr("version 0 has no such load case"));
}

TEST_F(SessionComparisons, OneRunsAtATimeAndTheNextFollows) {
  const auto first = compare(0, 1);
  const auto second = compare(1, 0);
  EXPECT_THAT(tasks(), ElementsAre("compare"));
  finish({"compare"});
  EXPECT_TRUE(first.is_success());
  EXPECT_FALSE(second.is_there());
  finish({"compare"});
  ASSERT_TRUE(second.is_success());
  EXPECT_EQ(second.value().what->before_id, first.value().what->after_id);
}

TEST_F(SessionComparisons, OneThatWaitsIsCancelledAtOnceAndOneThatRunsByItsThread) {
  const auto first = compare(0, 1);
  const auto running = tickets_;
  const auto second = compare(1, 0);
  cancel(tickets_);
  EXPECT_EQ(second.refusal().code, ec::cancelled);
  cancel(running);
  EXPECT_FALSE(first.is_there());
  finish({"compare"});
  EXPECT_EQ(first.refusal().code, ec::cancelled);
  EXPECT_EQ(first.count() + second.count(), 2);
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(SessionComparisons, NeitherAnEditNorItsEndWaitsForOne) {
  const auto got = compare(0, 1);
  const auto task = take("compare");
  edit(.2);
  finish({"edit", "check", "commit"});
  EXPECT_EQ(state().graph.nodes().size(), 3U);
  within(helper_, task.succeed);
  ASSERT_TRUE(got.is_success());
  EXPECT_EQ(got.value().after, 1U);
}

TEST_F(SessionComparisons, AThreadThatFailsIsSaidAndHoldsNothingUp) {
  const auto first = compare(0, 1);
  const auto second = compare(0, 1);
  refuse("compare", {ec::out_of_memory, "no room", {}, {}});
  EXPECT_EQ(first.refusal().code, ec::out_of_memory);
  finish({"compare"});
  EXPECT_TRUE(second.is_success());
}

TEST_F(SessionComparisons, ADocumentThatIsComparedIsInUse) {
  for (const auto& one : {mine_, other_})
    caf::anon_send(session_, detach_atom::value, one);
  const auto got = compare(0, 1);
  EXPECT_EQ(ask_to_end().refusal().code, ec::conflict);
  finish({"compare"});
  EXPECT_TRUE(got.is_success());
  EXPECT_TRUE(ask_to_end().is_success());
}

}  // namespace
}  // namespace tedit::actors
