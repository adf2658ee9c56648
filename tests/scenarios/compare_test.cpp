// SPDX-License-Identifier: AGPL-3.0-or-later
// What two versions differ in, asked of a server: figures that can be checked by hand, and the same
// as the room compare/ says of the versions as files.
#include "compare/compare_versions.hpp"
#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/scenarios/fixture.hpp"
#include "tests/support/blocks.hpp"

namespace tedit::test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A bar along x, held by rollers on three sides that meet, pulled at its end: everywhere the
/// stress is `pa`, and the displacement along it x pa / E.
fem::load_case pulled(double pa) {
  fem::load_case loads;
  loads.name = "pull";
  loads.materials = {{"alloy", 70e9, 0.3, 2700, 276e6, {}}};
  for (const surface_id side : {1, 3, 5})
    loads.constraints.push_back({{side}, fem::roller{}});
  loads.loads.push_back({{2}, fem::traction{{pa, 0, 0}}});
  return loads;
}

class CompareVersionsOfServer : public ::testing::Test {
protected:
  scratch_folder folder;
  std::unique_ptr<server> host = start(options_for(folder, false));
  std::unique_ptr<client::client> user = connect(host->url());

  void SetUp() override { value(user->open("bar", false, false)); }

  /// A bar of `length` m in `cells` along it as the new head, with its load case.
  void import_bar(int cells, double length, double pa) {
    const auto bar = blocks(
      {cells, 1, 1}, [](int, int, int) { return true; },
      [=](vec3 p) {
        return vec3{p.x * length / cells, p.y, p.z};
      });
    const auto file = folder.path() / "bar.msh";
    value(formats::msh::write(file, *bar, {"m"}));
    value(user->import_file(file, "m", {}));
    value(user->set_load_case(pulled(pa)));
  }

  void solve(int order = 2) {
    client::solve_settings settings;
    settings.device = "cpu";
    settings.tolerance = 1e-11;
    settings.element_order = order;
    value(user->solve(settings, {}));
  }

  error refusal(std::uint32_t before, std::uint32_t after, const std::string& load_case = {}) {
    const auto got = user->compare(before, after, load_case);
    return got ? error{ec::internal, "answered", {}, {}} : got.error();
  }
};

TEST_F(CompareVersionsOfServer, MoreLoadOnTheSameMeshIsMoreStressEverywhere) {
  import_bar(4, 4, 2e6);
  solve();
  import_bar(4, 4, 5e6);
  solve();
  const auto got = value(user->compare(0, 1, "pull"));

  EXPECT_EQ(got.what.tets_in_common, 24U);
  EXPECT_EQ(got.what.vertices_in_common, 20U);
  ASSERT_EQ(got.what.load_cases.size(), 1U);
  EXPECT_NEAR(*got.what.load_cases[0].mass_after_kg, 4 * 2700, 1e-8);
  EXPECT_THAT(got.what.load_cases[0].differences,
              ElementsAre(HasSubstr("traction.pa.x: 2e+06 -> 5e+06")));
  ASSERT_EQ(got.what.fields.size(), 1U);
  EXPECT_THAT(got.what.not_compared, IsEmpty());
  const auto& figures = got.what.fields[0];
  EXPECT_EQ(figures.same, 20U);
  EXPECT_NEAR(figures.rise.change(), 3e6, 1);
  EXPECT_NEAR(figures.fall.change(), 3e6, 1) << "it falls nowhere";
  EXPECT_NEAR(*figures.min_safety_before, 276.0 / 2, 1e-3);
  EXPECT_NEAR(*figures.min_safety_after, 276.0 / 5, 1e-3);
  EXPECT_FALSE(figures.preview);

  EXPECT_THAT(got.marks, Each(difference_mark::same));
  const auto surface = value(user->surface_of(1));
  const auto& stress = got.differences.of("von_mises_pa");
  const auto& moved = got.differences.of("displacement_m");
  ASSERT_EQ(got.vertices.size(), 20U);
  ASSERT_EQ(stress.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_NEAR(stress[i], 3e6, 1);
    EXPECT_NEAR(moved[3 * i], surface.positions().find(got.vertices[i])->x * 3e6 / 70e9, 1e-10);
  }
  EXPECT_THAT(got.differences.of("stress_pa"), IsEmpty());
  value(user->watch_fields({"stress_pa"}));
  EXPECT_EQ(value(user->compare(0, 1, "pull")).differences.of("stress_pa").size(), 120U);
}

TEST_F(CompareVersionsOfServer, OtherVerticesAreInterpolatedAndThoseBeyondTheEndAreMarked) {
  import_bar(4, 4, 2e6);
  solve();
  import_bar(5, 5.5, 3e6);  // At 0, 1.1, 2.2, 3.3, 4.4 and 5.5.
  solve();
  const auto got = value(user->compare(0, 1, "pull"));

  EXPECT_NEAR(got.what.before.volume_m3, 4, 1e-12);
  EXPECT_NEAR(got.what.after.volume_m3, 5.5, 1e-12);
  EXPECT_NEAR(got.what.deviation.distance_m, 1.5, 1e-12);
  EXPECT_EQ(got.what.tets_in_common, 0U);
  ASSERT_EQ(got.what.fields.size(), 1U);
  EXPECT_EQ(got.what.fields[0].same, 4U);
  EXPECT_EQ(got.what.fields[0].interpolated, 12U);
  EXPECT_EQ(got.what.fields[0].outside, 8U);
  const auto surface = value(user->surface_of(1));
  const auto& stress = got.differences.of("von_mises_pa");
  const auto& moved = got.differences.of("displacement_m");
  ASSERT_EQ(got.marks.size(), 24U);
  for (std::size_t i = 0; i < 24; ++i) {
    const auto x = surface.positions().find(got.vertices[i])->x;
    const bool outside = x > 4;
    EXPECT_EQ(got.marks[i], outside   ? difference_mark::outside
                            : x > .01 ? difference_mark::interpolated
                                      : difference_mark::same)
      << x;
    EXPECT_NEAR(stress[i], outside ? 0 : 1e6, 1);
    EXPECT_NEAR(moved[3 * i], outside ? 0 : x * 1e6 / 70e9, 1e-10);
  }
}

TEST_F(CompareVersionsOfServer, AVersionWithItselfIsZeroThroughout) {
  import_bar(4, 4, 2e6);
  solve();
  const auto got = value(user->compare(0, 0, "pull"));

  EXPECT_EQ(got.what.before_id, got.what.after_id);
  EXPECT_EQ(got.what.tets_in_common, got.what.after.tets);
  EXPECT_EQ(got.what.deviation.distance_m, 0);
  for (const auto& one : got.what.surfaces)
    EXPECT_FALSE(one.changed) << one.id;
  EXPECT_THAT(got.what.load_cases.at(0).differences, IsEmpty());
  EXPECT_EQ(got.what.fields.at(0).rise.change(), 0);
  EXPECT_THAT(got.marks, Each(difference_mark::same));
  EXPECT_THAT(got.differences.of("von_mises_pa"), Each(0.0F));
  EXPECT_THAT(got.differences.of("displacement_m"), Each(0.0F));
}

TEST_F(CompareVersionsOfServer, AVersionThatIsNotSolvedIsNamedAndComparedOnceItIs) {
  import_bar(4, 4, 2e6);
  import_bar(4, 4, 5e6);
  solve();
  const auto before = value(user->compare(0, 1, "pull"));
  EXPECT_THAT(before.what.fields, IsEmpty());
  ASSERT_EQ(before.what.not_compared.size(), 1U);
  EXPECT_EQ(before.what.not_compared[0].load_case, "pull");
  EXPECT_THAT(before.what.not_compared[0].reason, HasSubstr("no field of version 0"));
  EXPECT_THAT(before.what.not_compared[0].remedy, HasSubstr("solve"));
  EXPECT_THAT(before.vertices, IsEmpty());
  EXPECT_THAT(before.differences.of("von_mises_pa"), IsEmpty());

  value(user->go_to(0));
  solve();
  EXPECT_EQ(value(user->compare(0, 1, "pull")).what.fields.size(), 1U);
}

TEST_F(CompareVersionsOfServer, LinearAndQuadraticTetsAreNotSubtracted) {
  import_bar(4, 4, 2e6);
  solve(1);
  import_bar(4, 4, 5e6);
  solve(2);
  const auto got = value(user->compare(0, 1, "pull"));
  ASSERT_EQ(got.what.not_compared.size(), 1U);
  EXPECT_THAT(got.what.not_compared[0].reason, HasSubstr("linear tets"));

  solve(1);
  const auto linear = value(user->compare(0, 1, "pull"));
  ASSERT_EQ(linear.what.fields.size(), 1U);
  EXPECT_TRUE(linear.what.fields[0].preview);
  EXPECT_NEAR(linear.what.fields[0].rise.change(), 3e6, 1);
}

TEST_F(CompareVersionsOfServer, WhatIsNotThereIsRefusedWithWhatThereIs) {
  import_bar(4, 4, 2e6);
  EXPECT_EQ(refusal(0, 1).code, ec::not_found);
  EXPECT_THAT(refusal(0, 1).message, HasSubstr("there is no version 1"));
  EXPECT_THAT(refusal(9, 0).message, HasSubstr("there is no version 9"));
  EXPECT_THAT(refusal(9, 0).remedy, HasSubstr("history"));
  EXPECT_THAT(refusal(0, 0, "push").message, HasSubstr("\"push\""));
  EXPECT_THAT(refusal(0, 0, "push").remedy, HasSubstr("\"pull\""));
}

TEST_F(CompareVersionsOfServer, AfterTheServerWasStartedAnewTheFiguresAreThereAndTheFieldsAreNot) {
  import_bar(4, 4, 2e6);
  solve();
  user.reset();
  host.reset();
  host = start(options_for(folder, false));
  user = connect(host->url());
  value(user->open("bar", false, false));

  const auto got = value(user->compare(0, 0, "pull"));
  EXPECT_EQ(got.what.tets_in_common, 24U);
  EXPECT_THAT(got.what.fields, IsEmpty());
  EXPECT_THAT(got.what.not_compared.at(0).reason, HasSubstr("is at hand"));
}

TEST_F(CompareVersionsOfServer, EachOfManyRequestsGetsOneAnswerAlsoWhenItIsCancelled) {
  import_bar(4, 4, 2e6);
  solve();
  raw_client raw(host->url());
  raw.hello(server_token);
  v1::ClientMessage open;
  open.mutable_open_document()->set_name("bar");
  ASSERT_TRUE(raw.ask(open).has_document_state());
  v1::ClientMessage wanted;
  wanted.mutable_compare_versions()->set_document("bar");
  wanted.mutable_compare_versions()->set_load_case("pull");
  std::vector<std::uint64_t> asked;
  for (int i = 0; i < 20; ++i)
    asked.push_back(raw.start(wanted));
  v1::ClientMessage cancel;
  cancel.mutable_cancel()->set_request_id(asked.back());
  EXPECT_TRUE(raw.ask(cancel).has_done());

  for (const auto id : asked) {
    const auto answer = raw.answer(id);
    const bool cancelled = answer.has_error() && answer.error().code() == "cancelled";
    EXPECT_TRUE(answer.has_versions_compared() || (cancelled && id == asked.back())) << id;
    if (answer.has_versions_compared()) {
      const auto& stream = answer.versions_compared().stream();
      EXPECT_EQ(raw.stream(stream).size(), stream.bytes());
    }
  }
  EXPECT_FALSE(raw.has([](const v1::ServerMessage& m) { return m.has_versions_compared(); }));
}

TEST_F(CompareVersionsOfServer, AClientThatLeavesHoldsNobodyUp) {
  import_bar(4, 4, 2e6);
  {
    raw_client gone(host->url());
    gone.hello(server_token);
    v1::ClientMessage open;
    open.mutable_open_document()->set_name("bar");
    ASSERT_TRUE(gone.ask(open).has_document_state());
    v1::ClientMessage wanted;
    wanted.mutable_compare_versions()->set_document("bar");
    for (int i = 0; i < 30; ++i)
      gone.start(wanted);
  }
  EXPECT_EQ(value(user->compare(0, 0)).what.tets_in_common, 24U);
}

TEST_F(CompareVersionsOfServer, TheCommandLineAsksForTheSame) {
  import_bar(4, 4, 2e6);
  solve();
  import_bar(5, 5.5, 3e6);
  solve();
  const auto token = folder.path() / "token";
  std::ofstream(token) << server_token;
  const auto file = folder.path() / "d.vtu";
  const auto compare = [&](const std::string& what) {
    return run("compare " + what + " --json --server " + host->url() + " --token-file " +
               token.string());
  };

  const auto got = compare("bar --load-case pull -o " + file.string());
  ASSERT_EQ(got.status, 0) << got.out;
  const auto all = got.parsed();
  EXPECT_NEAR(all["after"]["volume_m3"], 5.5, 1e-12);
  ASSERT_EQ(all["fields"].size(), 1U);
  EXPECT_EQ(all["fields"][0]["vertices"]["outside"], 8);
  EXPECT_NEAR(all["fields"][0]["von_mises_rise"]["change_pa"], 1e6, 1);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(bytes, HasSubstr("NumberOfPoints=\"24\" NumberOfCells=\"44\""));
  EXPECT_THAT(bytes, HasSubstr("Name=\"von_mises_pa_difference\""));

  EXPECT_EQ(compare("bar --from 1 --to 1").parsed()["deviation_m"], 0);
  EXPECT_EQ(compare("bar --from 9").status, 1);
  const auto absent = compare("nothing");
  EXPECT_EQ(absent.status, 1);
  EXPECT_THAT(absent.out, HasSubstr("no document nothing"));
  EXPECT_EQ(compare("bar.tedit").status, 2);
  EXPECT_EQ(compare("bar -o " + file.string()).status, 2);
}

/// An edit of a real part, against the room compare/ on the versions as files.
TEST_F(CompareVersionsOfServer, AnEditOfAPartIsSaidAsItsFilesAreCompared) {
  const auto imported = value(user->import_file(plate_mesh, "mm", {}));
  const auto edited = value(user->edit("fill_hole", {1, 2}, {}, {}));
  const auto got = value(user->compare(0, 1));

  const auto as_file = [&](const std::string& version) {
    const auto bytes = value(user->export_file("msh", version, "mm", {}));
    return value(import_mesh_bytes(bytes, "mm")).version;
  };
  const auto before = as_file(imported.head.version_id);
  const auto after = as_file(edited.head.version_id);
  const auto local =
    value(compare_versions({*before}, {*after}, value(match_versions(*before, *after, {})), {}));
  EXPECT_EQ(got.what.before_id, imported.head.version_id);
  EXPECT_EQ(got.what.after_id, edited.head.version_id);
  EXPECT_EQ(got.what.before.tets, local.before.tets);
  EXPECT_EQ(got.what.after.vertices, local.after.vertices);
  EXPECT_EQ(got.what.tets_in_common, local.tets_in_common);
  EXPECT_EQ(got.what.vertices_in_common, local.vertices_in_common);
  EXPECT_NEAR(got.what.after.volume_m3, local.after.volume_m3, 1e-12 * local.after.volume_m3);
  EXPECT_NEAR(got.what.deviation.distance_m, local.deviation.distance_m, 1e-9);
  ASSERT_EQ(got.what.surfaces.size(), local.surfaces.size());
  std::size_t gone = 0;
  for (std::size_t i = 0; i < local.surfaces.size(); ++i) {
    const auto& mine = got.what.surfaces[i];
    const auto& theirs = local.surfaces[i];
    EXPECT_EQ(mine.id, theirs.id);
    EXPECT_EQ(mine.where, theirs.where) << mine.id;
    EXPECT_EQ(mine.changed, theirs.changed) << mine.id;
    EXPECT_EQ(mine.kin, theirs.kin) << mine.id;
    EXPECT_NEAR(mine.area_after_m2, theirs.area_after_m2, 1e-9 * theirs.area_after_m2);
    gone += mine.where == presence::only_before ? 1 : 0;
  }
  EXPECT_EQ(gone, 2U) << "the two walls of the hole";
}

/// The difference at a vertex that both versions have is that of the fields that clients are sent.
TEST_F(CompareVersionsOfServer, ADifferenceIsThatOfTheFieldsAsTheyWereSent) {
  value(user->open("plate", true, true));
  const auto imported = value(user->import_file(plate_mesh, "mm", {}));
  const auto loads = value(protocol::load_case_from_file(plate_loads));
  value(user->set_load_case(loads));
  solve(1);
  const auto was = value(user->wait_field(imported.head.version_id, patience));
  const auto edited = value(user->edit("fill_hole", {1, 2}, {}, {}));
  solve(1);
  const auto is = value(user->wait_field(edited.head.version_id, patience));
  const auto got = value(user->compare(0, 1, loads.name));

  ASSERT_EQ(got.what.fields.size(), 1U);
  EXPECT_EQ(got.vertices, is.vertices);
  const auto slot_before = [&](std::uint32_t v) {
    const auto found = std::ranges::lower_bound(was.vertices, v);
    return found != was.vertices.end() && *found == v
             ? std::optional(static_cast<std::size_t>(found - was.vertices.begin()))
             : std::nullopt;
  };
  const double largest = got.what.fields[0].max_von_mises_after_pa;
  const auto surface = value(user->surface_of(0));
  const auto surface_after = value(user->surface_of(1));
  std::size_t checked = 0;
  for (std::size_t i = 0; i < got.vertices.size(); ++i) {
    const auto v = got.vertices[i];
    const auto then = slot_before(v);
    if (got.marks[i] != difference_mark::same || !then ||
        *surface.positions().find(v) != *surface_after.positions().find(v))
      continue;
    ++checked;
    EXPECT_NEAR(got.differences.of("von_mises_pa")[i],
                is.values.of("von_mises_pa")[i] - was.values.of("von_mises_pa")[*then],
                1e-6 * largest);
  }
  EXPECT_GT(checked, got.vertices.size() / 2);
}

}  // namespace
}  // namespace tedit::test
