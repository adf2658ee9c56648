// SPDX-License-Identifier: AGPL-3.0-or-later
// The main job over a real WebSocket: a server with its workers on threads, a client, a real part.
#include <future>
#include <mutex>
#include <thread>

#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class MainJob : public ::testing::Test {
protected:
  scratch_folder folder;
  std::unique_ptr<server> host = start(options_for(folder, false));
  std::unique_ptr<client::client> user = connect(host->url());

  client::committed import_plate() {
    value(user->open("plate", true, true));
    auto done = value(user->import_file(plate_mesh, "mm", {}));
    value(user->set_load_case(value(protocol::load_case_from_file(plate_loads))));
    return done;
  }
};

TEST_F(MainJob, FillsSolvesAndUndoesOverWebSocket) {
  const auto imported = import_plate();
  const auto first = value(user->wait_surface(imported.head.version_id, patience));
  EXPECT_TRUE(first.full);
  const auto before = value(user->solve({.device = "cpu"}, {}));
  value(user->wait_field(imported.head.version_id, patience));

  const auto filled = value(user->edit("fill_hole", {1, 2}, {}, {}));
  EXPECT_EQ(filled.head.parent, imported.head.number);
  ASSERT_TRUE(filled.report.has_value());
  EXPECT_GT(filled.report->volume_change, 0);
  const auto update = value(user->wait_surface(filled.head.version_id, patience));
  EXPECT_FALSE(update.full);
  // What is sent follows the edit: two rims of some dozen facets against the whole boundary.
  EXPECT_LT(update.moved.bytes * 10, first.moved.bytes);
  EXPECT_EQ(user->surface().total_facets(), filled.head.boundary_facets);

  // The new field arrives without being asked for.
  const auto field = value(user->wait_field(filled.head.version_id, patience));
  EXPECT_EQ(field.report.version_id, filled.head.version_id);
  EXPECT_LT(field.report.true_relative_residual, 1e-6);
  EXPECT_NE(field.report.compliance_j, before.compliance_j);

  const auto undone = value(user->undo());
  EXPECT_EQ(undone.head.version_id, imported.head.version_id);
  EXPECT_TRUE(undone.can_redo);
  const auto again = value(user->wait_field(imported.head.version_id, patience));
  EXPECT_EQ(again.report.compliance_j, before.compliance_j);
}

TEST_F(MainJob, ASolveSaysHowFarItCanBeTrusted) {
  import_plate();
  const auto report = value(user->solve({.device = "cpu"}, {}));

  EXPECT_EQ(report.element_order, 2);
  EXPECT_FALSE(report.preview);
  // Volume 0.0146833715 m3 of aluminium; u.Ku / 2 is half the loads' work without prescribed
  // motion.
  ASSERT_TRUE(report.mass_kg.has_value());
  EXPECT_NEAR(*report.mass_kg, 2700 * 0.0146833715, 1e-6);
  EXPECT_NEAR(report.strain_energy_j, report.compliance_j / 2, 1e-6 * report.compliance_j);
  EXPECT_GT(report.relative_error_estimate, 0);
  EXPECT_LT(report.relative_error_estimate, 1);
  // One material, so that the least safety is where the stress is largest.
  ASSERT_TRUE(report.min_safety_factor.has_value());
  EXPECT_NEAR(*report.min_safety_factor, 276e6 / report.max_von_mises_pa, 1e-9);
  EXPECT_EQ(report.min_safety_factor_at, report.max_von_mises_at);
  ASSERT_EQ(report.surface_reactions.size(), 8U);
  EXPECT_EQ(report.surface_reactions.front().surface, 72);
  vec3 sum;
  for (const auto& r : report.surface_reactions)
    sum += r.force_n;
  EXPECT_NEAR(sum.z, 20000, 0.1);
  EXPECT_LE(report.singular_places.size(), 20U);
  EXPECT_GE(report.singular_places_count, report.singular_places.size());
}

TEST_F(MainJob, TheSurfaceAfterUpdatesIsTheSurfaceSentWhole) {
  import_plate();
  value(user->edit("fill_hole", {1, 2}, {}, {}));
  const auto head = value(user->edit("fill_hole", {92, 93}, {}, {}));
  value(user->wait_surface(head.head.version_id, patience));

  auto other = connect(host->url());
  value(other->open("plate", true, false));
  const auto whole = value(other->wait_surface(head.head.version_id, patience));
  EXPECT_TRUE(whole.full);
  expect_same(user->surface(), other->surface());
}

TEST_F(MainJob, TheSurfaceOfABranchIsTheSurfaceSentWhole) {
  const auto imported = import_plate();
  const auto left = value(user->edit("fill_hole", {1, 2}, {}, {}));
  value(user->wait_surface(left.head.version_id, patience));
  value(user->undo());
  value(user->wait_surface(imported.head.version_id, patience));
  // Its new vertices lie in slots that the fill had used.
  const auto branch = value(user->edit("thicken", {7}, {{"depth", "0.001"}}, {}));
  value(user->wait_surface(branch.head.version_id, patience));

  auto other = connect(host->url());
  value(other->open("plate", true, false));
  value(other->wait_surface(branch.head.version_id, patience));
  expect_same(user->surface(), other->surface());
}

TEST_F(MainJob, RefusalsNameCauseAndRemedyAndChangeNothing) {
  const auto imported = import_plate();

  const auto no_hole = user->edit("fill_hole", {5}, {}, {});
  ASSERT_FALSE(no_hole.has_value());
  EXPECT_FALSE(no_hole.error().message.empty());
  const auto no_operation = user->edit("fil_hole", {1}, {}, {});
  ASSERT_FALSE(no_operation.has_value());
  EXPECT_EQ(no_operation.error().code, ec::operation_not_found);
  EXPECT_THAT(render(no_operation.error()), HasSubstr("fill_hole"));
  const auto stale = user->edit("fill_hole", {1, 2}, {}, {}, std::string(32, '0'));
  ASSERT_FALSE(stale.has_value());
  EXPECT_EQ(stale.error().code, ec::conflict);
  EXPECT_FALSE(user->undo().has_value());
  EXPECT_FALSE(user->redo().has_value());
  EXPECT_EQ(user->solve({.load_case = "no such case", .device = "cpu"}, {}).error().code,
            ec::not_found);

  const auto versions = value(user->get_history()).versions;
  ASSERT_EQ(versions.size(), 1U);
  EXPECT_EQ(versions.front().version_id, imported.head.version_id);
}

TEST_F(MainJob, RedoAndBranchesKeepEveryVersion) {
  const auto imported = import_plate();
  const auto one = value(user->edit("fill_hole", {1, 2}, {}, {}));
  value(user->undo());
  EXPECT_EQ(value(user->redo()).head.version_id, one.head.version_id);
  value(user->undo());
  const auto two = value(user->edit("fill_hole", {92, 93}, {}, {}));

  EXPECT_EQ(two.head.parent, imported.head.number);
  EXPECT_FALSE(two.can_redo);
  EXPECT_EQ(value(user->get_history()).versions.size(), 3U);
}

/// With worker processes, as users have it.
TEST(MainJobOnADevice, LavapipeSolvesOverTheSocketWhatTheProcessorSolves) {
  if (std::getenv("TEDIT_WITHOUT_VULKAN"))
    GTEST_SKIP() << "TEDIT_WITHOUT_VULKAN is set";
  const scratch_folder folder;
  const auto host = start(options_for(folder, true));
  const auto user = connect(host->url());
  value(user->open("plate", false, true));
  value(user->import_file(plate_mesh, "mm", {}));
  value(user->set_load_case(value(protocol::load_case_from_file(plate_loads))));
  value(user->edit("fill_hole", {1, 2}, {}, {}));

  const auto device = value(user->solve({.device = "llvmpipe"}, {}));
  const auto processor = value(user->solve({.device = "cpu"}, {}));

  EXPECT_THAT(device.device, HasSubstr("llvmpipe"));
  EXPECT_EQ(device.notice, "");
  EXPECT_EQ(processor.device, "cpu");
  EXPECT_LT(device.true_relative_residual, 1e-6);
  EXPECT_NEAR(device.compliance_j, processor.compliance_j, 1e-6 * processor.compliance_j);
}

TEST_F(MainJob, AFirstFieldComesWhileTheSolveRuns) {
  std::mutex mutex;
  std::vector<solve_report> reports;
  client::events handlers;
  handlers.on_solved = [&](const solve_outcome& outcome) {
    const std::lock_guard lock(mutex);
    reports.push_back(outcome.cases.front());
  };
  user = connect(host->url(), handlers);
  const auto imported = import_plate();

  const auto answer = value(user->solve({.device = "cpu"}, {}));
  const auto field = value(user->wait_field(imported.head.version_id, patience));

  EXPECT_FALSE(answer.interim);
  EXPECT_FALSE(answer.preview);
  EXPECT_FALSE(field.report.interim);
  const std::lock_guard lock(mutex);
  ASSERT_GE(reports.size(), 2U);
  EXPECT_TRUE(reports.front().interim);
  EXPECT_TRUE(reports.front().preview);
  EXPECT_LT(reports.front().iterations, answer.iterations);
  // 1 % in the energy norm is 1e-4 of the compliance.
  EXPECT_NEAR(reports.front().compliance_j, answer.compliance_j, 1e-3 * answer.compliance_j);
  EXPECT_FALSE(reports.back().interim);
}

TEST_F(MainJob, ExportsWhatWasMade) {
  const auto imported = import_plate();
  value(user->solve({.device = "cpu"}, {}));
  const auto vtu = value(user->export_file("vtu", "", "", {}));
  const std::string text(vtu.data(), vtu.size());
  EXPECT_THAT(text.substr(0, text.find("<AppendedData")), HasSubstr("von_mises_pa"));
  const auto msh = value(user->export_file("msh", imported.head.version_id, "mm", {}));
  EXPECT_THAT(std::string(msh.data(), 20), HasSubstr("$MeshFormat"));
}

TEST_F(MainJob, TheServerSaysWhichFormatsThereAre) {
  import_plate();
  const auto offered = user->formats();

  const auto refused = user->export_file("step", "", "", {});

  ASSERT_EQ(offered.size(), file_formats.size());
  EXPECT_EQ(offered.front().name, "msh");
  EXPECT_EQ(offered.front().title, "Mesh");
  EXPECT_TRUE(offered.front().reads && offered.front().keeps.tets);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::invalid_argument);
  EXPECT_EQ(refused.error().message, "there is no file format \"step\" to write");
  EXPECT_THAT(refused.error().remedy,
              testing::AllOf(HasSubstr("Take msh, vtu, stl"), HasSubstr(" or tedit")));
}

TEST_F(MainJob, OnePickFindsTheWholeHole) {
  import_plate();

  const auto hole = value(user->select({feature_kind::hole, {1}}, {}));
  ASSERT_EQ(hole.size(), 1U);
  EXPECT_THAT(hole.front().surfaces, testing::ElementsAre(1, 2));
  EXPECT_NEAR(hole.front().diameter, 25e-3, 1e-6);

  selection_query holes{feature_kind::holes};
  holes.min_diameter = 24e-3;
  holes.max_diameter = 26e-3;
  EXPECT_EQ(value(user->select(holes, {})).size(), 4U);

  const auto refused = user->select({feature_kind::hole, {123456}}, {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::surface_not_found);
}

TEST_F(MainJob, AnyVersionCanBeGoneToAndRedoFollowsItsBranch) {
  import_plate();
  value(user->edit("fill_hole", {1, 2}, {}, {}));  // 1
  value(user->undo());
  value(user->edit("fill_hole", {51, 52}, {}, {}));  // 2, another branch.

  const auto there = value(user->go_to(1));
  EXPECT_EQ(there.head.number, 1U);
  EXPECT_EQ(there.cause, "goto");
  EXPECT_FALSE(there.can_redo);
  EXPECT_EQ(value(user->undo()).head.number, 0U);
  EXPECT_EQ(value(user->redo()).head.number, 1U);  // Not 2, which was made last.
  value(user->go_to(2));
  const auto root = value(user->go_to(0));
  EXPECT_TRUE(root.can_redo);
  EXPECT_EQ(value(user->redo()).head.number, 2U);  // Back where it came from.

  const auto refused = user->go_to(3);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::not_found);
}

TEST_F(MainJob, LoadCasesComeWithTheHeadAndWhenTheyChange) {
  std::promise<client::load_cases_event> told;
  client::events handlers;
  handlers.on_load_cases = [&](const client::load_cases_event& event) { told.set_value(event); };
  const auto other = connect(host->url(), handlers);
  value(other->open("plate", false, false));
  const auto imported = import_plate();

  auto event = told.get_future();
  ASSERT_EQ(event.wait_for(patience), std::future_status::ready);
  const auto got = event.get();
  EXPECT_EQ(got.version_id, imported.head.version_id);
  ASSERT_EQ(got.load_cases.size(), 1U);
  EXPECT_EQ(got.load_cases[0].loads.size(), 1U);
  const auto again = connect(host->url());
  EXPECT_EQ(value(again->open("plate", false, false)).load_cases.size(), 1U);
  const auto filled = value(user->edit("fill_hole", {1, 2}, {}, {}));
  ASSERT_EQ(filled.load_cases.size(), 1U);
  EXPECT_EQ(filled.load_cases[0].name, got.load_cases[0].name);
}

TEST_F(MainJob, ASectionHasTheFieldOfItsVersion) {
  const auto imported = import_plate();
  const auto bare = value(user->cut({0, 0, 0}, {1, 0, 0}, "", {}));
  EXPECT_EQ(bare.version_id, imported.head.version_id);
  EXPECT_GT(bare.triangles.size(), 30U);
  EXPECT_TRUE(bare.values.of("von_mises_pa").empty());

  const auto report = value(user->solve({.device = "cpu"}, {}));
  const auto solved = value(user->cut({0, 0, 0}, {2, 0, 0}, "", {}));
  const auto& stress = solved.values.of("von_mises_pa");
  ASSERT_EQ(3 * stress.size(), solved.positions.size());
  EXPECT_EQ(solved.values.of("displacement_m").size(), solved.positions.size());
  for (std::size_t i = 0; i < stress.size(); ++i) {
    EXPECT_NEAR(solved.positions[3 * i], 0, 1e-7);
    EXPECT_LE(stress[i], report.max_von_mises_pa * (1 + 1e-6));
  }
  const auto refused = user->cut({0, 0, 0}, {0, 0, 0}, "", {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::invalid_argument);
}

TEST_F(MainJob, OfManySectionsAtOnceEachIsAnsweredAndTheNewestIsMade) {
  import_plate();
  std::vector<std::future<expected<client::section>>> asked;
  for (int i = 0; i < 8; ++i)
    asked.push_back(std::async(std::launch::async, [&, i] {
      return user->cut({0.001 * i, 0, 0}, {1, 0, 0}, "", {});
    }));

  int made = 0;
  for (auto& one : asked) {
    const auto got = one.get();
    if (got)
      ++made;
    else
      EXPECT_EQ(got.error().code, ec::superseded) << render(got.error());
  }
  EXPECT_GE(made, 1);
}

TEST_F(MainJob, ABadFileIsRefusedWithItsPlace) {
  value(user->open("bad", false, false));
  const auto refused = user->import_file(TEDIT_TEST_DATA "/bad/coord_nan.msh", "mm", {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::bad_input);
  EXPECT_THAT(refused.error().where, HasSubstr("coord_nan.msh"));
  EXPECT_THAT(refused.error().where, HasSubstr("line"));
}

TEST_F(MainJob, DocumentsSurviveTheServer) {
  const auto imported = import_plate();
  const auto filled = value(user->edit("fill_hole", {1, 2}, {}, {}));
  user.reset();
  host.reset();

  host = start(options_for(folder, false));
  user = connect(host->url());
  const auto state = value(user->open("plate", true, false));
  ASSERT_TRUE(state.head.has_value());
  EXPECT_EQ(state.head->version_id, filled.head.version_id);
  EXPECT_EQ(state.head->load_cases.size(), 1U);
  EXPECT_TRUE(state.can_undo);
  value(user->wait_surface(filled.head.version_id, patience));
  EXPECT_EQ(value(user->undo()).head.version_id, imported.head.version_id);
  value(user->solve({.device = "cpu"}, {}));
}

TEST_F(MainJob, AWrongTokenIsTurnedAway) {
  client::connect_options options;
  options.url = host->url();
  options.token = "another";
  const auto refused = client::client::connect(options, {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(render(refused.error()), HasSubstr("token"));
}

TEST_F(MainJob, DocumentNamesCannotLeaveTheFolder) {
  for (const auto* name : {"../x", "a/b", ".hidden", "a b", "x\n"}) {
    const auto refused = user->open(name, false, false);
    ASSERT_FALSE(refused.has_value()) << name;
    EXPECT_EQ(refused.error().code, ec::invalid_argument);
  }
}

}  // namespace
}  // namespace tedit::test
