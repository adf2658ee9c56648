// SPDX-License-Identifier: AGPL-3.0-or-later
// Checks for printing of a session: which version, in turn with comparisons, and what is told.
#include "tests/states/session_fixture.hpp"

namespace tedit::actors {
namespace {

/// Two versions; the thread that checks works when a test says so.
class SessionPrintChecks : public Session {
protected:
  void SetUp() override {
    import_all();
    edit(.1);
    finish({"edit", "check", "commit"});
  }

  answer<print_checked> check(std::optional<std::uint32_t> number = {},
                              const print_settings& settings = {}) {
    return request<print_checked>(print_request{++tickets_, number, settings, mine_});
  }
};

TEST_F(SessionPrintChecks, WithoutANumberItIsTheHead) {
  const auto got = check({}, {{1, 0, 0}, 1e-3, 0.5});
  EXPECT_FALSE(got.is_there()) << "the session does not check itself";
  finish({"compare"});

  ASSERT_TRUE(got.is_success());
  EXPECT_EQ(got.value().document, "part");
  EXPECT_EQ(got.value().number, 1U);
  EXPECT_EQ(to_hex(got.value().mesh->id()), head());
  EXPECT_EQ(got.value().settings, (print_settings{{1, 0, 0}, 1e-3, 0.5}));
  EXPECT_TRUE(got.value().what->watertight());
  EXPECT_NEAR(got.value().what->volume, total_volume(*got.value().mesh), 1e-12);
}

TEST_F(SessionPrintChecks, TheHeadOfWhenItWasAskedIsChecked) {
  const auto got = check();
  edit(.2);
  finish({"edit", "check", "commit", "compare"});
  ASSERT_TRUE(got.is_success());
  EXPECT_EQ(got.value().number, 1U);
}

TEST_F(SessionPrintChecks, AVersionThatIsNotThereIsRefused) {
  EXPECT_EQ(check(2).refusal().code, ec::not_found);
  EXPECT_THAT(check(7).refusal().message, HasSubstr("there is no version 7"));
  EXPECT_THAT(tasks(), IsEmpty());
}

TEST_F(SessionPrintChecks, ItWaitsForAComparisonAndAComparisonForIt) {
  const auto first = request<compared>(comparison_request{++tickets_, 0, 1, {}});
  const auto second = check(0);
  const auto third = request<compared>(comparison_request{++tickets_, 1, 0, {}});
  EXPECT_THAT(tasks(), ElementsAre("compare"));
  finish({"compare"});
  EXPECT_TRUE(first.is_success());
  EXPECT_FALSE(second.is_there() || third.is_there());
  // Version 0 may have to be read first.
  if (tasks() == std::vector<std::string>{"load"})
    finish({"load"});
  finish({"compare"});
  ASSERT_TRUE(second.is_success());
  EXPECT_EQ(second.value().number, 0U);
  finish({"compare"});
  EXPECT_TRUE(third.is_success());
}

TEST_F(SessionPrintChecks, OneThatRunsEndsByItsThreadAndOneThatWaitsAtOnce) {
  const auto first = check();
  const auto running = tickets_;
  const auto second = check();
  cancel(tickets_);
  EXPECT_EQ(second.refusal().code, ec::cancelled);
  cancel(running);
  EXPECT_FALSE(first.is_there());
  finish({"compare"});
  EXPECT_EQ(first.refusal().code, ec::cancelled);
  EXPECT_THAT(state().progress_of, IsEmpty());
}

TEST_F(SessionPrintChecks, ItsStagesAreToldToWhoAsked) {
  const auto got = check({}, {.thinner_than = 1e-3});
  caf::anon_send(state().ear, job_progress{state().asides.front().job, .5, "measuring walls"});
  pass(milliseconds(1));
  ASSERT_EQ(heard(mine_).progress.size(), 1U);
  EXPECT_EQ(heard(mine_).progress[0].ticket, tickets_);
  EXPECT_EQ(heard(mine_).progress[0].stage, "measuring walls");
  EXPECT_THAT(heard(other_).progress, IsEmpty());
  finish({"compare"});
  EXPECT_TRUE(got.is_success());
}

}  // namespace
}  // namespace tedit::actors
