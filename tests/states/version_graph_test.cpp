// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/session/version_graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedit::actors {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

/// 0 -- 1 -- 2, and after an undo to 1 a branch 1 -- 3 -- 4, which is the head.
version_graph two_branches() {
  version_graph graph;
  const auto add = [&] {
    auto node = graph.draft();
    node.info.id.low = 100 + node.info.number;
    graph.add(std::move(node));
  };
  add();
  add();
  add();
  graph.move_to(1, nullptr);
  add();
  add();
  return graph;
}

/// Carries a move out as a session does.
void move(version_graph& graph, const move_request& request) {
  const auto target = graph.target_of(request);
  ASSERT_TRUE(target.has_value()) << render(target.error());
  for (const auto& [number, child] : target->redo)
    graph.set_redo(number, child);
  graph.move_to(target->number, nullptr);
}

TEST(VersionGraph, AnEmptyOneHasNothingToGoTo) {
  const version_graph graph;
  EXPECT_EQ(graph.head(), nullptr);
  EXPECT_FALSE(graph.can_undo());
  EXPECT_FALSE(graph.can_redo());
  const auto undo = graph.target_of({move_kind::undo});
  ASSERT_FALSE(undo);
  EXPECT_EQ(undo.error().code, ec::conflict);
  const auto there = graph.target_of({move_kind::go_to, 0});
  ASSERT_FALSE(there);
  EXPECT_EQ(there.error().code, ec::not_found);
  EXPECT_THAT(there.error().remedy, HasSubstr("Import"));
}

TEST(VersionGraph, ADraftIsAChildOfTheHead) {
  const auto graph = two_branches();
  const auto draft = graph.draft();
  EXPECT_EQ(draft.info.number, 5U);
  EXPECT_EQ(draft.info.parent, 4U);
  EXPECT_EQ(graph.nodes()[3].info.parent, 1U);
  EXPECT_EQ(graph.nodes()[1].redo, 3U) << "a redo leads to what was made last";
}

TEST(VersionGraph, UndoRemembersWhereItCameFrom) {
  auto graph = two_branches();
  const auto target = graph.target_of({move_kind::undo});
  ASSERT_TRUE(target);
  EXPECT_EQ(target->number, 3U);
  EXPECT_THAT(target->redo, ElementsAre(Pair(3, 4)));
  move(graph, {move_kind::undo});
  move(graph, {move_kind::undo});
  EXPECT_EQ(graph.head()->info.number, 1U);
  move(graph, {move_kind::redo});
  move(graph, {move_kind::redo});
  EXPECT_EQ(graph.head()->info.number, 4U);
  EXPECT_FALSE(graph.can_redo());
}

TEST(VersionGraph, GoingToAnotherBranchMakesRedoFollowIt) {
  auto graph = two_branches();
  move(graph, {move_kind::go_to, 2});
  EXPECT_EQ(graph.head()->info.number, 2U);
  move(graph, {move_kind::undo});
  move(graph, {move_kind::undo});
  EXPECT_EQ(graph.head()->info.number, 0U);
  EXPECT_FALSE(graph.can_undo());
  move(graph, {move_kind::redo});
  move(graph, {move_kind::redo});
  EXPECT_EQ(graph.head()->info.number, 2U) << "not the branch of before";
}

TEST(VersionGraph, GoingToAnAncestorKeepsTheWayBack) {
  auto graph = two_branches();
  move(graph, {move_kind::go_to, 0});
  for (const std::uint32_t expected : {1U, 3U, 4U}) {
    move(graph, {move_kind::redo});
    EXPECT_EQ(graph.head()->info.number, expected);
  }
}

TEST(VersionGraph, GoingToTheHeadChangesNothing) {
  auto graph = two_branches();
  move(graph, {move_kind::go_to, 4});
  EXPECT_EQ(graph.head()->info.number, 4U);
  EXPECT_FALSE(graph.can_redo());
}

TEST(VersionGraph, SaysWhichIsTheLastWhereThereIsNone) {
  const auto graph = two_branches();
  const auto target = graph.target_of({move_kind::go_to, 5});
  ASSERT_FALSE(target);
  EXPECT_EQ(target.error().code, ec::not_found);
  EXPECT_EQ(target.error().remedy, "The last one is 4");
}

TEST(VersionGraph, FindsWhatWasMadeLastOfAnId) {
  version_graph graph;
  for (int i = 0; i < 3; ++i) {
    auto node = graph.draft();
    node.info.id.low = i == 1 ? 8 : 7;
    graph.add(std::move(node));
  }
  hash128 wanted;
  wanted.low = 7;
  ASSERT_NE(graph.find(to_hex(wanted)), nullptr);
  EXPECT_EQ(graph.find(to_hex(wanted))->info.number, 2U);
  wanted.low = 9;
  EXPECT_EQ(graph.find(to_hex(wanted)), nullptr);
  EXPECT_EQ(graph.find("no id"), nullptr);
}

TEST(VersionGraph, LoadCasesAreListedByName) {
  auto graph = two_branches();
  fem::load_case one;
  one.name = "hanging";
  graph.set_load_cases(3, std::make_shared<const load_case_list>(load_case_list{one}));
  EXPECT_THAT(graph.nodes()[3].info.load_cases, ElementsAre("hanging"));
  EXPECT_THAT(graph.nodes()[4].info.load_cases, IsEmpty());
  graph.annotate(3, "light", "note");
  EXPECT_EQ(graph.nodes()[3].info.name, "light");
  EXPECT_EQ(graph.nodes()[3].info.note, "note");
}

}  // namespace
}  // namespace tedit::actors
