// SPDX-License-Identifier: AGPL-3.0-or-later
// The actor that makes edits on CAD models: how many at once, in which order, and how they end.
#include "actors/cad/cad_editor.hpp"
#include "actors/cad/cad_rows.hpp"
#include "tests/states/hands.hpp"

namespace tedit::actors {
namespace {

class CadEditor : public WithHands {
protected:
  /// @param threads all of them are the same hands.
  explicit CadEditor(std::size_t threads = 1) {
    editor_ = stage_.system().spawn(make_cad_editor, caf::actor_cast<modeling_actor>(hands_),
                                    threads_of(threads));
  }
  ~CadEditor() override { simulation::cut_off(caf::actor_cast<caf::actor>(editor_)); }

  answer<cad_outcome> edit(std::uint64_t job, const std::string& operation = "deform") {
    cad_order order;
    order.model = std::make_shared<const store::cad_row>(
      row_with({std::make_shared<const std::string>("none"), {}}, 0));
    order.before = simulation::imported_part(1);
    order.after = simulation::nudged(order.before, 0, .1);
    order.wanted.operation = operation;
    order.report = std::make_shared<const edit_report>();
    auto result = ask<cad_outcome>(editor_, job_id{job}, order);
    pass(milliseconds(1));
    return result;
  }
  void cancel(std::uint64_t job) {
    tell(caf::actor_cast<caf::actor>(editor_), cancel_atom::value, job_id{job});
  }
  cad_editor_actor editor_;
};

TEST_F(CadEditor, MakesOneAtATimeInTheOrderOfArrival) {
  const auto first = edit(1);
  const auto second = edit(2, "of a plugin that is gone");
  EXPECT_EQ(hands().asked, 1);
  EXPECT_EQ(hands().tasks.size(), 1U);
  work();
  ASSERT_TRUE(first.is_success());
  EXPECT_EQ(first.value().row->status, "mesh_only");
  EXPECT_THAT(first.value().row->reason, ::testing::HasSubstr("deform bends walls"));
  EXPECT_FALSE(second.is_there());
  work();
  ASSERT_TRUE(second.is_success());
  EXPECT_EQ(second.value().row->reason, "the document does not say how it was made");
  EXPECT_EQ(hands().asked, 1) << "the operations are known by now";
}

TEST_F(CadEditor, WhatIsCancelledIsAnsweredAndHoldsUpNobody) {
  const auto first = edit(1);
  const auto second = edit(2);
  const auto third = edit(3);
  cancel(2);
  EXPECT_EQ(second.refusal().code, ec::cancelled);
  cancel(1);
  EXPECT_FALSE(first.is_there()) << "its thread notices";
  work();
  EXPECT_EQ(first.refusal().code, ec::cancelled);
  work();
  EXPECT_TRUE(third.is_success());
  cancel(3);
  cancel(7);
}

TEST_F(CadEditor, WithoutTheOperationsNothingIsSaidOfTheModel) {
  hands().refusal = error{ec::service_unavailable, "the modeling workers are degraded", {}, {}};
  const auto first = edit(1);
  EXPECT_EQ(first.refusal().code, ec::service_unavailable);
  hands().refusal.reset();
  const auto next = edit(2);
  work();
  EXPECT_TRUE(next.is_success());
}

class TwoCadEditors : public CadEditor {
protected:
  TwoCadEditors() : CadEditor(2) {}
};

TEST_F(TwoCadEditors, MakeTwoAtOnce) {
  const auto first = edit(1);
  const auto second = edit(2);
  const auto third = edit(3);
  EXPECT_EQ(hands().tasks.size(), 2U);
  work();
  EXPECT_TRUE(first.is_success());
  EXPECT_EQ(hands().tasks.size(), 2U);
  work();
  work();
  EXPECT_TRUE(second.is_success() && third.is_success());
}

}  // namespace
}  // namespace tedit::actors
