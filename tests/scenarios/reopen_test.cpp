// SPDX-License-Identifier: AGPL-3.0-or-later
// A document that the server has closed and opened again says of each version what it said before.
#include <sqlite3.h>

#include <algorithm>
#include <string_view>
#include <thread>

#include "tests/scenarios/fixture.hpp"

#include "tests/support/parts.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

fem::load_case pull(double newton) {
  return value(protocol::load_case_from_json(
    R"({"name": "pull", "materials": [{"young_modulus_pa": 2.1e11, "poisson_ratio": 0.3}],
        "constraints": [{"surfaces": ["1"], "fixed": {}}],
        "loads": [{"surfaces": ["2"], "force": {"total_n": {"x": )" +
      std::to_string(newton) + "}}}]}",
    "test"));
}

/// A cube that was thickened twice, with the second edit undone.
struct two_edits {
  client::committed imported, first, second, undone;

  explicit two_edits(client::client& user) {
    value(user.open("cube", false, false));
    imported = value(user.import_file(test::cube_mesh, "mm", {}));
    value(user.set_load_case(pull(1000)));
    first = value(user.edit("thicken", {4}, {{"depth", 0.25e-3}}, {}));
    second = value(user.edit("thicken", {6}, {{"depth", 0.5e-3}}, {}));
    undone = value(user.undo());
  }
};

void expect_same(const std::optional<edit_report>& got, const std::optional<edit_report>& wanted) {
  ASSERT_TRUE(got && wanted);
  EXPECT_EQ(got->operation, wanted->operation);
  EXPECT_EQ(got->surfaces, wanted->surfaces);
  EXPECT_EQ(got->from_version, wanted->from_version);
  EXPECT_EQ(got->to_version, wanted->to_version);
  EXPECT_EQ(got->volume_change, wanted->volume_change);
  EXPECT_EQ(got->receipt.size(), wanted->receipt.size());
  EXPECT_EQ(got->surface_map.size(), wanted->surface_map.size());
}

/// Whoever comes back with a surface of before, also to another server, is sent what has changed.
TEST(Reopen, WhoHasASurfaceIsSentTheDifferenceToIt) {
  const scratch_folder folder;
  auto host = start(options_for(folder, false));
  client::surface_model held;
  std::string imported;
  std::uint64_t whole_bytes = 0;
  {
    auto user = connect(host->url());
    value(user->open("part", true, false));
    imported = value(user->import_file(plate_mesh, "mm", {})).head.version_id;
    whole_bytes = value(user->wait_surface(imported, patience)).moved.bytes;
    held = user->surface();
  }
  const auto other = connect(host->url());
  value(other->open("part", false, false));
  const auto edited = value(other->edit("fill_hole", {1, 2}, {}, {})).head.version_id;
  value(other->close_document());
  host.reset();
  host = start(options_for(folder, false));

  auto back = connect(host->url());
  value(back->open("part", true, false, held));
  const auto came = value(back->wait_surface(edited, patience));
  EXPECT_FALSE(came.full);
  EXPECT_LT(came.moved.bytes, whole_bytes / 20) << whole_bytes;
  const auto fresh = connect(host->url());
  value(fresh->open("part", true, false));
  value(fresh->wait_surface(edited, patience));
  test::expect_same(back->surface(), fresh->surface());

  // The head's own surface is not sent at all.
  auto again = connect(host->url());
  value(again->open("part", true, false, fresh->surface()));
  const auto nothing = value(again->wait_surface(edited, patience));
  EXPECT_FALSE(nothing.full);
  EXPECT_EQ(nothing.facets_changed + nothing.vertices_sent, 0U);
  test::expect_same(again->surface(), fresh->surface());
}

/// The same of its fields, as long as the server has that result.
TEST(Reopen, WhoHasTheFieldsOfASolveIsNotSentThemAgain) {
  const scratch_folder folder;
  auto host = start(options_for(folder, false));
  const client::watched_quantities wanted{"stress_pa"};
  const client::solve_settings settings{.device = "cpu", .element_order = 1};
  std::uint64_t solve = 0;
  std::string head;
  {
    auto user = connect(host->url());
    value(user->open("cube", false, true));
    head = value(user->import_file(test::cube_mesh, "mm", {})).head.version_id;
    value(user->set_load_case(pull(1000)));
    solve = value(user->solve_cases(settings, {})).solve;
  }
  std::atomic<int> came{0};
  client::events heard;
  heard.on_field = [&](const client::field_event&) { ++came; };
  auto back = connect(host->url(), heard);
  value(back->open("cube", false, true));
  EXPECT_EQ(value(back->watch_fields(wanted, solve)), "");
  auto again = settings;
  again.held_solve = solve;
  EXPECT_EQ(value(back->solve_cases(again, {})).solve, solve);
  EXPECT_EQ(came, 0);
  // Another one's number is that of no solve here.
  EXPECT_EQ(value(back->watch_fields(wanted, solve + 1)), "");
  const auto field = value(back->wait_field(head, patience));
  EXPECT_EQ(field.solve, solve);
  EXPECT_FALSE(field.values.of("stress_pa").empty());
  // Who waits for a field is told before who listens.
  const auto until = std::chrono::steady_clock::now() + patience;
  while (came == 0 && std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  value(back->status());  // What was sent before it has come.
  EXPECT_EQ(came, 1);

  // A server that began anew has other numbers.
  back.reset();
  host.reset();
  host = start(options_for(folder, false));
  back = connect(host->url(), heard);
  value(back->open("cube", false, true));
  EXPECT_NE(value(back->solve_cases(again, {})).solve, solve);
  EXPECT_NE(value(back->wait_field(head, patience)).solve, solve);
}

/// A document of that name may be another one by now.
TEST(Reopen, WhoHasASurfaceOfAnotherPartIsSentTheWhole) {
  const scratch_folder folder;
  const auto host = start(options_for(folder, false));
  auto user = connect(host->url());
  value(user->open("cube", true, false));
  const auto cube = value(user->import_file(test::cube_mesh, "mm", {})).head.version_id;
  value(user->wait_surface(cube, patience));
  const auto held = user->surface();
  value(user->open("plate", true, false));
  const auto plate = value(user->import_file(plate_mesh, "mm", {})).head.version_id;
  value(user->wait_surface(plate, patience));
  const auto wanted = user->surface();

  auto back = connect(host->url());
  value(back->open("plate", true, false, held));
  EXPECT_TRUE(value(back->wait_surface(plate, patience)).full);
  test::expect_same(back->surface(), wanted);
}

TEST(Reopen, TheSurfaceOfAnyVersionIsThereWithoutMovingTheHead) {
  const scratch_folder folder;
  auto host = start(options_for(folder, false));
  std::vector<client::surface_model> as_heads;
  std::string head;
  {
    auto user = connect(host->url());
    value(user->open("cube", true, false));
    const auto imported = value(user->import_file(test::cube_mesh, "mm", {}));
    value(user->wait_surface(imported.head.version_id, patience));
    as_heads.push_back(user->surface());
    const auto edited = value(user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {}));
    value(user->wait_surface(edited.head.version_id, patience));
    as_heads.push_back(user->surface());
    head = edited.head.version_id;
  }
  host.reset();
  host = start(options_for(folder, false));
  auto user = connect(host->url());
  value(user->open("cube", true, false));
  value(user->wait_surface(head, patience));

  for (std::uint32_t number = 0; number < as_heads.size(); ++number) {
    const auto got = value(user->surface_of(number));
    const auto& wanted = as_heads[number];
    EXPECT_EQ(got.version_id(), wanted.version_id());
    ASSERT_EQ(got.total_facets(), wanted.total_facets());
    wanted.facets().for_each([&](std::uint32_t slot, const client::surface_facet& facet) {
      const auto* other = got.facets().find(slot);
      ASSERT_NE(other, nullptr);
      EXPECT_EQ(*other, facet);
      for (const auto v : facet.v)
        EXPECT_EQ(*got.positions().find(v), *wanted.positions().find(v));
    });
  }
  EXPECT_EQ(user->surface().version_id(), head);
  const auto none = user->surface_of(2);
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().code, ec::not_found);
  EXPECT_THAT(none.error().message, HasSubstr("there is no version 2"));
  // What the connection holds of the head is what its next difference builds on.
  const auto next = value(user->edit("thicken", {6}, {{"depth", 0.5e-3}}, {}));
  value(user->wait_surface(next.head.version_id, patience));
}

TEST(Reopen, EveryVersionSaysWhatItsEditReported) {
  const scratch_folder folder;
  auto host = start(options_for(folder, false));
  const two_edits made(*connect(host->url()));
  host.reset();
  host = start(options_for(folder, false));
  auto user = connect(host->url());

  const auto state = value(user->open("cube", false, false));

  ASSERT_TRUE(state.head.has_value());
  EXPECT_EQ(state.head->version_id, made.first.head.version_id);
  expect_same(state.head->report, made.first.report);
  const auto all = value(user->get_history(true));
  ASSERT_EQ(all.versions.size(), 3U);
  EXPECT_EQ(all.head, 1U);
  EXPECT_FALSE(all.versions[0].report.has_value());
  expect_same(all.versions[1].report, made.first.report);
  expect_same(all.versions[2].report, made.second.report);
  for (const auto& one : value(user->get_history()).versions)
    EXPECT_FALSE(one.report.has_value());
}

TEST(Reopen, FieldsAreOfTheVersionAndItsLoads) {
  const scratch_folder folder;
  auto host = start(options_for(folder, false));
  const two_edits made(*connect(host->url()));
  host.reset();
  host = start(options_for(folder, false));
  auto user = connect(host->url());
  value(user->open("cube", true, true));
  const auto solve = [&](const std::string& version) {
    const auto report = value(user->solve({.device = "cpu"}, {}));
    EXPECT_EQ(report.version_id, version);
    EXPECT_EQ(value(user->wait_fields(version, patience)).front().version_id(), version);
    return report.max_von_mises_pa;
  };

  const double of_first = solve(made.first.head.version_id);
  EXPECT_EQ(value(user->redo()).head.number, 2U);
  const double of_second = solve(made.second.head.version_id);
  EXPECT_EQ(value(user->go_to(0)).head.number, 0U);
  const double of_import = solve(made.imported.head.version_id);
  EXPECT_EQ(value(user->go_to(1)).head.number, 1U);

  EXPECT_EQ(solve(made.first.head.version_id), of_first);
  EXPECT_NE(of_first, of_import);
  EXPECT_NE(of_second, of_first);
}

bool has_field(client::client& user) {
  const auto file = value(user.export_file("vtu", {}, "mm", {}));
  constexpr std::string_view wanted = "von_mises";
  return std::search(file.begin(), file.end(), wanted.begin(), wanted.end()) != file.end();
}

TEST(Reopen, AFileHasNoFieldOfLoadsThatWereChanged) {
  const scratch_folder folder;
  auto host = start(options_for(folder, false));
  auto user = connect(host->url());
  const two_edits made(*user);
  value(user->solve({.device = "cpu"}, {}));
  ASSERT_TRUE(has_field(*user));

  value(user->set_load_case(pull(2000)));

  EXPECT_FALSE(has_field(*user));
  value(user->solve({.device = "cpu"}, {}));
  EXPECT_TRUE(has_field(*user));
}

TEST(Reopen, ALoadThatWasChangedInTheFileIsRefusedByItsVersion) {
  const scratch_folder folder;
  auto host = start(options_for(folder, false));
  const two_edits made(*connect(host->url()));
  host.reset();
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open((folder.path() / "cube.tedit").c_str(), &db), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(db,
                         "UPDATE version SET load_cases = replace(load_cases, '1000', '9000')"
                         " WHERE number = 1",
                         nullptr, nullptr, nullptr),
            SQLITE_OK);
  EXPECT_EQ(sqlite3_changes(db), 1);
  sqlite3_close(db);
  host = start(options_for(folder, false));

  for (int time = 0; time < 2; ++time) {
    const auto refused = connect(host->url())->open("cube", false, false);

    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ec::storage_error);
    EXPECT_THAT(refused.error().message, HasSubstr("version 1"));
    EXPECT_THAT(refused.error().remedy, HasSubstr("backup"));
    value(connect(host->url())->open("another", false, false));
  }
}

TEST(Reopen, AnImportThatFailedLeavesNoDocument) {
  const scratch_folder folder;
  auto host = start(options_for(folder, false));
  const auto user = connect(host->url());
  value(user->open("wrong", true, true));
  const auto wrong = user->import_file(TEDIT_TEST_DATA "/bad/elem_missing_node.msh", "mm", {});
  EXPECT_FALSE(wrong.has_value());
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_NE(entry.path().extension(), ".tedit") << entry.path();

  value(user->import_file(test::cube_mesh, "mm", {}));  // Of a good file it becomes one.

  EXPECT_TRUE(std::filesystem::exists(folder.path() / "wrong.tedit"));
}

}  // namespace
}  // namespace tedit::test
