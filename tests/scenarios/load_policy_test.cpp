// SPDX-License-Identifier: AGPL-3.0-or-later
// What becomes of a load whose surface an edit takes away, over a real WebSocket.
#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class LoadPolicy : public ::testing::Test {
protected:
  scratch_folder folder;
  std::unique_ptr<server> host = start(options_for(folder, false));
  std::unique_ptr<client::client> user = connect(host->url());
  client::committed imported;

  /// The plate held as ever and pushed down with 20 kN in the bore that is going to be filled.
  void SetUp() override {
    value(user->open("plate", true, true));
    imported = value(user->import_file(plate_mesh, "mm", {}));
    auto loads = value(protocol::load_case_from_file(plate_loads));
    loads.loads.front().surfaces = {1, 2};
    value(user->set_load_case(loads));
  }

  expected<client::committed> fill(const fem::carry_settings& loads) {
    return user->edit("fill_hole", {1, 2}, {}, {}, {}, loads);
  }
};

TEST_F(LoadPolicy, MoveCarriesTheTotalToThePlanesThatCloseTheBore) {
  const auto filled = value(fill({fem::load_policy::move}));

  ASSERT_TRUE(filled.report.has_value());
  EXPECT_EQ(filled.report->loads.policy, fem::load_policy::move);
  const auto& line = filled.report->receipt.back();
  EXPECT_EQ(line.fate, fem::receipt_fate::moved);
  EXPECT_THAT(line.surfaces_lost, ElementsAre(1, 2));
  EXPECT_THAT(line.moved_to, ElementsAre(3, 98));
  EXPECT_NEAR(line.total_after, 20000, 1e-6);
  EXPECT_THAT(line.text, HasSubstr("total force 20000 N kept"));
  const auto solved = value(user->solve({.device = "cpu", .element_order = 1}, {}));
  EXPECT_NEAR(solved.applied_n.z, -20000, 1e-3);
}

TEST_F(LoadPolicy, AMoveToWholeWallsWarnsAndSoDoResultsUntilTheLoadIsSetAnew) {
  const client::solve_settings settings{.device = "cpu", .element_order = 1};
  const auto filled = value(fill({fem::load_policy::move}));
  const auto warning = filled.report->receipt.back().warning;
  EXPECT_THAT(warning, HasSubstr("an edit moved load 0 (force) from "));

  EXPECT_THAT(value(user->solve(settings, {})).warnings, ElementsAre(warning));
  const auto later = value(user->edit("fill_hole", {92, 93}, {}, {}));
  EXPECT_EQ(later.report->receipt.back().warning, "");
  EXPECT_THAT(value(user->solve(settings, {})).warnings, ElementsAre(warning));

  auto looked_at = later.load_cases.front();
  for (auto& one : looked_at.loads)
    one.warning.clear();
  value(user->set_load_case(looked_at));
  EXPECT_TRUE(value(user->solve(settings, {})).warnings.empty());
}

TEST_F(LoadPolicy, DropIsTheDefault) {
  const auto filled = value(user->edit("fill_hole", {1, 2}, {}, {}));

  EXPECT_EQ(filled.report->receipt.back().fate, fem::receipt_fate::dropped);
  const auto solved = user->solve({.device = "cpu", .element_order = 1}, {});
  EXPECT_TRUE(!solved || solved->applied_n == vec3{});
}

TEST_F(LoadPolicy, RefuseNamesTheLoadAndLeavesTheHead) {
  const auto refused = fill({fem::load_policy::refuse});

  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::postcondition_failed);
  EXPECT_THAT(refused.error().message,
              HasSubstr("load case ctc01_plate static: load 0 (force) acts on surfaces 1, 2"));
  const auto history = value(user->get_history());
  EXPECT_EQ(history.versions.size(), 1u);
  EXPECT_TRUE(user->edit("fill_hole", {92, 93}, {}, {}, {}, {fem::load_policy::refuse}).has_value())
    << "nothing is lost there";
}

}  // namespace
}  // namespace tedit::test
