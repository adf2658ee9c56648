// SPDX-License-Identifier: AGPL-3.0-or-later
// Flat walls of fork_thin (tests/data/LICENSES) that are moved on its CAD model as a slab.
#include "tests/cad/replayed_part.hpp"

namespace tedit::test {
namespace {

class ReplayFork : public replayed_part {
protected:
  void SetUp() override {
    TEDIT_NEEDS_CAD();
    open("fork_thin.step");
  }

  std::string way_of(surface_id wall) {
    const edit_request wanted{"thicken", {wall}, {{"depth", 0.001}}, {}};
    const auto result = replay(wanted, edit(wanted));
    EXPECT_TRUE(result.verdict.is_same) << wall << ": " << result.verdict.reason;
    return result.verdict.how;
  }
};

/// Beside a round there is a step, which goes on to a wall that is not quite upright.
TEST_F(ReplayFork, AStepGoesOnToTheNextWall) {
  EXPECT_EQ(way_of(26), "slab by planes around");
}

/// It swallows a neighbour, and ends above that one's own edges.
TEST_F(ReplayFork, ASlabEndsAtTheEdgesBeyondANeighbour) {
  EXPECT_EQ(way_of(24), "slab by edges beyond");
}

/// A wall of a letter nearly touches the fillet beside its wall: it is a plane, and no part of
/// that.
TEST_F(ReplayFork, LettersThatNearlyTouchAFilletStayAsTheyAre) {
  const edit_request letters{
    "emboss", {55}, {{"text", std::string("A8")}, {"size", 0.001125}, {"height", 0.00016875}}, {}};
  const auto result = replay(letters, edit(letters));
  EXPECT_TRUE(result.verdict.is_same) << result.verdict.reason;
}

/// A bore of six facets meets the fillets where it goes otherwise than its arc does.
TEST_F(ReplayFork, AHoleOfFewFacetsIsMadeRounderWhereItGoes) {
  const edit_request moved{
    "move", {16, 42}, {{"by", std::string("0,-0.00107401,-0.000775967")}}, {}};
  const auto result = replay(moved, edit(moved));
  EXPECT_TRUE(result.verdict.is_same) << result.verdict.reason;
}

}  // namespace
}  // namespace tedit::test
