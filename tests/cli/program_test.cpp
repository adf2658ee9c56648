// SPDX-License-Identifier: AGPL-3.0-or-later
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <sstream>
#include <thread>

#include "tests/cli/program.hpp"

namespace tedit::test {
namespace {

TEST(Program, HelpNamesTheCommandsAndExitStatuses) {
  const auto help = run("--help");

  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, ::testing::AllOf(HasSubstr("render"), HasSubstr("130")));
  for (const std::string command : {"info", "edit", "convert", "solve", "export", "run", "serve",
                                    "worker", "ops", "verify", "doctor"}) {
    EXPECT_THAT(help.out, HasSubstr(command));
    EXPECT_EQ(run(command + " --help").status, 0) << command;
  }
}

TEST(Program, UsageErrorsEndWith2) {
  EXPECT_EQ(run("").status, 2);
  EXPECT_EQ(run("frobnicate").status, 2);
  EXPECT_EQ(run("solve " + plate).status, 2);
  EXPECT_EQ(run("edit " + plate + " --op fill_hole --surfaces 1 --param exact").status, 2);
}

TEST(Program, BadInputEndsWith65AndJsonNamesTheCause) {
  const auto result = run("info --json " TEDIT_TEST_DATA "/bad/coord_nan.msh");

  EXPECT_EQ(result.status, 65);
  const auto error = result.parsed()["error"];
  EXPECT_EQ(error["code"], "bad_input");
  EXPECT_THAT(error["message"], HasSubstr("node 41"));
  EXPECT_THAT(error["where"], HasSubstr("line"));
  EXPECT_EQ(run("info /nowhere.msh").status, 65);
}

TEST(Program, NamesOfFilesThatAreNoUtf8AreReplacedInItsJson) {
  const auto odd = scratch(
    "b\xFC"
    "d.so");
  std::ofstream(odd) << "no plugin";
  ::setenv("TEDIT_PLUGIN_PATH", odd.parent_path().c_str(), 1);
  const auto result = run("ops --json");
  ::unsetenv("TEDIT_PLUGIN_PATH");

  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(result.parsed().is_object());
  EXPECT_THAT(result.out, HasSubstr("b\uFFFDd.so"));
}

TEST(Program, AServerThatIsNotThereEndsWith69AndARemedy) {
  const auto token = scratch("token");
  std::ofstream(token) << "0123456789abcdef0123456789abcdef";
  const auto result = run("run --json " TEDIT_EXAMPLES
                          "/ctc01_plate/recipe.json --server "
                          "ws://127.0.0.1:1/v1 --token-file " +
                          token.string());

  EXPECT_EQ(result.status, 69);
  EXPECT_THAT(result.parsed()["error"]["remedy"], HasSubstr("tedit serve"));
}

TEST(Program, ATokenThatOthersCanReadIsRefused) {
  const auto token = scratch("token");
  std::ofstream(token) << "0123456789abcdef0123456789abcdef";
  std::filesystem::permissions(token, std::filesystem::perms(0644));
  const auto result = run("serve --json --port 0 --token-file " + token.string());

  EXPECT_NE(result.status, 0);
  EXPECT_THAT(result.parsed()["error"]["message"], HasSubstr("others may read"));
}

TEST(Info, HasTheDocumentedKeys) {
  const auto result = run("info --json " + plate);

  ASSERT_EQ(result.status, 0);
  const auto info = result.parsed();
  EXPECT_EQ(info["tets"], 21750);
  EXPECT_EQ(info["vertices"], 5683);
  EXPECT_EQ(info["boundary_facets"], 8398);
  EXPECT_EQ(info["surfaces"].size(), 117u);
  EXPECT_EQ(info["regions"].size(), 1u);
  EXPECT_NEAR(info["volume_m3"], 0.0146833715, 1e-10);
  EXPECT_NEAR(info["radius_ratio"]["min"], 0.17361, 1e-4);
  EXPECT_EQ(info["version_id"].get<std::string>().size(), 32u);
}

TEST(Info, ListsTheSurfacesForPeople) {
  const auto block = parts + "holes_block/holes_block.coarse.msh";

  const auto all = run("info --all " + block);
  const auto some = run("info " + block);

  EXPECT_THAT(all.out,
              ::testing::ContainsRegex("\n  11 +16 +11\\.4287  bore, diameter 4\\.583 mm"));
  EXPECT_THAT(all.out, ::testing::ContainsRegex("\n  2 +52 +73\\.46  plane"));
  EXPECT_THAT(some.out, HasSubstr("... and 109 more: --all lists them"));
  EXPECT_EQ(std::ranges::count(all.out, '\n') - std::ranges::count(some.out, '\n'), 108);
  for (const auto told = run("info --json " + block).parsed(); const auto& row : told["surfaces"])
    if (row["id"] == 11) {
      EXPECT_EQ(row["shape"], "cylinder");
      EXPECT_EQ(row["hollow"], true);
      EXPECT_NEAR(row["diameter_m"], 4.583e-3, 1e-6);
    }
}

TEST(Edit, WritesAMeshThatReadsBackAndSolves) {
  const auto file = scratch("filled.msh");

  const auto edit = run("edit --json " + plate + " --op fill_hole --surfaces 1,2 --load-case " +
                        plate_loads + " -o " + file.string());

  ASSERT_EQ(edit.status, 0) << edit.out;
  const auto report = edit.parsed();
  EXPECT_EQ(report["surfaces_removed"], json({1, 2}));
  EXPECT_EQ(report["surfaces_changed"], json({3, 98}));
  EXPECT_GT(report["volume_change_m3"], 2e-5);
  EXPECT_GE(report["radius_ratio_touched"]["after_min"], 0.15);
  EXPECT_EQ(report["receipt"].size(), 2u);
  EXPECT_NE(report["from_version"], report["to_version"]);
  const auto info = run("info --json " + file.string()).parsed();
  EXPECT_EQ(info["surfaces"].size(), 115u);
  const auto solve =
    run("solve --json --device cpu " + file.string() + " --load-case " + plate_loads);
  ASSERT_EQ(solve.status, 0);
  EXPECT_LE(solve.parsed()["true_relative_residual"], 1e-6);
}

TEST(Edit, LoadsOfARemovedSurfaceFollowThePolicy) {
  const auto loads = scratch("bore.json");
  std::ifstream in(plate_loads);
  auto on_bore = json::parse(in);
  on_bore["loads"][0]["surfaces"] = {1, 2};
  std::ofstream(loads) << on_bore;
  const auto edit = "edit --json " + plate + " --op fill_hole --surfaces 1,2 --load-case " +
                    loads.string() + " --loads ";

  const auto moved = run(edit + "move");
  const auto refused = run(edit + "refuse");

  ASSERT_EQ(moved.status, 0) << moved.out;
  const auto report = moved.parsed();
  EXPECT_EQ(report["loads"], "move");
  EXPECT_EQ(report["receipt"][1]["fate"], "moved");
  EXPECT_EQ(report["receipt"][1]["moved_to"], json({3, 98}));
  EXPECT_NEAR(report["receipt"][1]["total_after_n"], 20000, 1e-6);
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.parsed()["error"]["code"], "postcondition_failed");
  EXPECT_EQ(run(edit + "keep").status, 2);
}

TEST(Edit, ARefusalNamesTheRimAndWritesNothing) {
  const auto file = scratch("never.msh");

  const auto edit =
    run("edit --json " + parts +
        "foot_cup/foot_cup.coarse.msh --op fill_hole --surfaces 15,91 -o " + file.string());

  EXPECT_EQ(edit.status, 1);
  EXPECT_EQ(edit.parsed()["error"]["code"], "mixed_rim");
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Solve, HasTheDocumentedKeysAndWritesAField) {
  const auto file = scratch("field.vtu");

  const auto solve = run("solve --json --device cpu " + plate + " --load-case " + plate_loads +
                         " -o " + file.string());

  ASSERT_EQ(solve.status, 0);
  const auto result = solve.parsed();
  for (const auto* key :
       {"version_id", "device", "element_order", "dofs", "iterations", "true_relative_residual",
        "max_displacement_m", "compliance_j", "max_von_mises_pa", "reaction_n", "applied_n",
        "strain_energy_j", "mass_kg", "relative_error_estimate", "min_safety_factor",
        "min_safety_factor_at_m", "surface_reactions", "singular_places", "singular_places_count"})
    EXPECT_TRUE(result.contains(key)) << key;
  for (const auto* key : {"import", "device", "assembly", "setup", "solve", "recovery", "total"})
    EXPECT_TRUE(result["timings_ms"].contains(key)) << key;
  // CalculiX 2.20, C3D10 on the same mesh.
  EXPECT_NEAR(result["max_displacement_m"], 4.690652e-05, 1e-10);
  EXPECT_FALSE(result["preview"]);
  EXPECT_NEAR(result["mass_kg"], 2700 * 0.0146833715, 1e-6);
  ASSERT_EQ(result["surface_reactions"].size(), 8u);
  EXPECT_EQ(result["surface_reactions"][0]["surface"], 72);
  EXPECT_EQ(result["surface_reactions"][0]["force_n"].size(), 3u);
  EXPECT_GT(std::filesystem::file_size(file), 1000000u);
}

TEST(Solve, SeveralLoadCasesHaveRowsAndAnEnvelope) {
  const auto file = scratch("cases.vtu");
  const auto doubled = scratch("doubled.json");
  std::ifstream in(plate_loads);
  auto loads = json::parse(in);
  const std::string name = loads["name"];
  for (auto& load : loads["loads"])
    load["force"]["total_n"]["z"] = 2 * load["force"]["total_n"]["z"].get<double>();
  std::ofstream(doubled) << loads;

  // The mesh may stand behind the load cases, as it always could.
  const auto solve = run("solve --json --device cpu --order 1 --load-case " + plate_loads +
                         " --load-case " + doubled.string() + " " + plate + " -o " + file.string());

  ASSERT_EQ(solve.status, 0);
  const auto result = solve.parsed();
  ASSERT_EQ(result["cases"].size(), 2u);
  EXPECT_EQ(result["cases"][0]["load_case"], name);
  EXPECT_EQ(result["cases"][1]["load_case"], name + " 2");
  EXPECT_EQ(result["envelope"]["max_displacement_case"], name + " 2");
  EXPECT_NEAR(result["envelope"]["max_displacement_m"], 2 * 3.484500e-05, 2e-10);
  EXPECT_EQ(result["envelope"]["max_von_mises_pa"], result["cases"][1]["max_von_mises_pa"]);
  EXPECT_EQ(result["envelope"]["min_safety_factor"], result["cases"][1]["min_safety_factor"]);
  EXPECT_TRUE(result["timings_ms"].contains("total"));
  std::ifstream vtu(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(vtu), {}};
  for (const std::string& field :
       {std::string("envelope_von_mises"), std::string("envelope_case"),
        std::string("envelope_safety_factor"), std::string("envelope_safety_factor_case"),
        "von_mises_pa (" + name + ")", "largest_strain (" + name + " 2)"})
    EXPECT_THAT(text, HasSubstr("Name=\"" + field + "\""));
}

TEST(Solve, OneBadLoadCaseOfSeveralIsNamedAndNothingIsSolved) {
  const auto loose = scratch("loose.json");
  std::ifstream in(plate_loads);
  auto loads = json::parse(in);
  loads["name"] = "loose";
  loads["constraints"].clear();
  std::ofstream(loose) << loads;

  const auto solve = run("solve --json --device cpu " + plate + " --load-case " + plate_loads +
                         " --load-case " + loose.string());

  EXPECT_EQ(solve.status, 1);
  EXPECT_EQ(solve.parsed()["error"]["code"], "under_constrained");
  EXPECT_THAT(solve.parsed()["error"]["message"].get<std::string>(),
              HasSubstr("load case 'loose': the part is not held"));
}

TEST(Solve, KeysOfUnknownValuesAreLeftOut) {
  const auto file = scratch("bare.json");
  std::ifstream in(plate_loads);
  auto loads = json::parse(in);
  loads["materials"][0].erase("density_kg_m3");
  loads["materials"][0].erase("yield_strength_pa");
  std::ofstream(file) << loads;

  const auto solve = run("solve --json --device cpu " + plate + " --load-case " + file.string());

  ASSERT_EQ(solve.status, 0);
  for (const auto* key : {"mass_kg", "min_safety_factor", "min_safety_factor_at_m"})
    EXPECT_FALSE(solve.parsed().contains(key)) << key;
}

TEST(Solve, TheTextHasNoNoiseInForces) {
  const auto solve = run("solve --device cpu " + plate + " --load-case " + plate_loads);

  ASSERT_EQ(solve.status, 0);
  EXPECT_THAT(solve.out, HasSubstr("  reaction          0, 0, 20000 N\n"));
  EXPECT_THAT(solve.out, HasSubstr("(quadratic tets)"));
  EXPECT_THAT(solve.out, ::testing::Not(HasSubstr("PREVIEW")));
}

TEST(Solve, LinearTetsArePreviews) {
  const auto solve =
    run("solve --json --device cpu --order 1 " + plate + " --load-case " + plate_loads);

  ASSERT_EQ(solve.status, 0);
  const auto result = solve.parsed();
  EXPECT_EQ(result["element_order"], 1);
  EXPECT_NEAR(result["max_displacement_m"], 3.484500e-05, 1e-10);
  EXPECT_TRUE(result["preview"]);
}

TEST(Solve, AnEnergyToleranceEndsEarlyAndTheResultIsAPreview) {
  const auto solve =
    run("solve --device cpu --energy-tolerance 1e-2 " + plate + " --load-case " + plate_loads);

  ASSERT_EQ(solve.status, 0);
  EXPECT_THAT(solve.out, HasSubstr("PREVIEW: stopped at the energy tolerance"));
}

TEST(Solve, NumbersThatAreNoneAreUsageErrors) {
  const std::string command = "solve --json --device cpu " + plate + " --load-case " + plate_loads;
  for (const auto* option : {"--tolerance nan", "--tolerance inf", "--tolerance 1", "--tolerance x",
                             "--energy-tolerance nan", "--energy-tolerance -1"}) {
    const auto refused = run(command + " " + option);
    EXPECT_EQ(refused.status, 2) << option;
    EXPECT_THAT(refused.parsed()["error"]["message"], HasSubstr("tolerance")) << option;
  }
  EXPECT_EQ(run("select " + plate + " --smooth 1 --angle nan").status, 2);
  EXPECT_EQ(run("select " + plate + " --holes nan,8").status, 2);
  EXPECT_EQ(run("select " + plate + " --holes 3,inf").status, 2);
}

TEST(Solve, ALoadThatIsNoNumberEndsWith65AndNamesTheField) {
  const auto file = scratch("loads.json");
  for (const auto& [kind, field] : {std::pair<std::string, std::string>{"force", "total_n"},
                                    {"traction", "pa"},
                                    {"gravity", "m_s2"}}) {
    std::ifstream in(plate_loads);
    auto loads = nlohmann::json::parse(in);
    loads["loads"] = {{{kind, {{field, {{"x", 0}, {"y", 0}, {"z", "NaN"}}}}}}};
    if (kind != "gravity")
      loads["loads"][0]["surfaces"] = {3};
    std::ofstream(file) << loads;

    const auto solve = run("solve --json --device cpu " + plate + " --load-case " + file.string());

    EXPECT_EQ(solve.status, 65);
    EXPECT_EQ(solve.parsed()["error"]["message"], "loads[0]." + kind + "." + field + ".z is nan");
    EXPECT_EQ(solve.parsed()["error"]["where"], file.string());
  }
}

TEST(Solve, AnUnheldPartEndsWith1AndSaysWhatMoves) {
  const auto file = scratch("free.json");
  std::ifstream in(plate_loads);
  auto loads = json::parse(in);
  loads["constraints"] = json::array();
  std::ofstream(file) << loads;

  const auto solve = run("solve --json --device cpu " + plate + " --load-case " + file.string());

  EXPECT_EQ(solve.status, 1);
  EXPECT_EQ(solve.parsed()["error"]["code"], "under_constrained");
}

TEST(Solve, AnInterruptEndsWith130) {
  const pid_t child = fork();
  if (child == 0) {
    (void)freopen("/dev/null", "w", stdout);
    (void)freopen("/dev/null", "w", stderr);
    execl(program.c_str(), "tedit", "solve", (parts + "foot_cup/foot_cup.coarse.msh").c_str(),
          "--load-case", (parts + "foot_cup/load_case.json").c_str(), "--device", "cpu",
          "--tolerance", "1e-12", nullptr);
    _exit(127);
  }
  // The signal may come before the handlers stand; then the default action ends the program.
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);

  const bool by_handler = WIFEXITED(status) && WEXITSTATUS(status) == 130;
  const bool by_default = WIFSIGNALED(status) && WTERMSIG(status) == SIGINT;
  EXPECT_TRUE(by_handler || by_default) << status;
}

TEST(Export, WritesADeckAndSaysHowToRunIt) {
  const auto file = scratch("plate.inp");

  const auto result = run("export --json --order 1 " + plate + " --load-case " + plate_loads +
                          " -o " + file.string());

  ASSERT_EQ(result.status, 0) << result.out;
  const auto report = result.parsed();
  EXPECT_EQ(report["elements"], 21750);
  EXPECT_EQ(report["nodes"], 5683);
  EXPECT_EQ(report["held_nodes"], 224);
  EXPECT_EQ(report["boundaries"], 3 * 224);
  EXPECT_EQ(report["equations"], 0);
  EXPECT_EQ(report["command"], "ccx -i " + scratch("plate").string());
  std::stringstream deck;
  deck << std::ifstream(file).rdbuf();
  EXPECT_THAT(deck.str(), HasSubstr("TYPE=C3D4"));
  EXPECT_THAT(deck.str(), HasSubstr("*STATIC, SOLVER=SPOOLES"));
  EXPECT_TRUE(deck.str().ends_with("*END STEP\n"));
}

TEST(Export, QuadraticTetsAndTheOtherSolverCanBeAskedFor) {
  const auto file = scratch("plate.inp");

  const auto result = run("export --solver cholesky " + plate + " --load-case " + plate_loads +
                          " -o " + file.string());

  ASSERT_EQ(result.status, 0);
  EXPECT_THAT(result.out, HasSubstr("21750 C3D10, 37324 nodes"));
  std::stringstream deck;
  deck << std::ifstream(file).rdbuf();
  EXPECT_THAT(deck.str(), HasSubstr("*STATIC, SOLVER=ITERATIVE CHOLESKY"));
}

TEST(Export, ARefusedPartWritesNothing) {
  const auto file = scratch("never.inp");
  const auto part = parts + "base_so101/";

  const auto result = run("export --json " + part + "base_so101.coarse.msh --load-case " + part +
                          "load_case.json -o " + file.string());

  EXPECT_EQ(result.parsed()["error"]["code"], "degenerate_tet");
  EXPECT_NE(result.status, 0);
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(run("export " + plate + " --load-case " + plate_loads + " -o deck.txt").status, 2);
}

TEST(Render, HandsItsOptionsOver) {
  if (!std::filesystem::exists(TEDIT_BIN "/tedit-render"))
    GTEST_SKIP() << "built without pictures";

  const auto help = run("render field.vtu -o field.png --title 'one hole closed' --help");

  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, HasSubstr("--field"));
}

TEST(Render, ItsFailuresAreTheJsonObjectOfTheOtherCommands) {
  if (!std::filesystem::exists(TEDIT_BIN "/tedit-render"))
    GTEST_SKIP() << "built without pictures";

  const auto missing = run("--json render /nowhere.vtu -o field.png");
  const auto wrong = run("render --json /nowhere.vtu -o field.png --zoom -1");

  EXPECT_EQ(missing.status, 65);
  EXPECT_EQ(missing.parsed()["error"]["code"], "io_error");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.parsed()["error"]["code"], "usage");
}

TEST(Program, AWordThatIsNoCommandIsNamedWithThoseThatThereAre) {
  for (const auto& [arguments, message] :
       {std::pair("--json devices", R"("tedit" has no "devices")"),
        std::pair("--json plugin tst", R"("tedit plugin" has no "tst")"),
        std::pair("--json plugin", R"("tedit plugin" needs a command)")}) {
    const auto wrong = run(arguments);
    EXPECT_EQ(wrong.status, 2) << arguments;
    EXPECT_EQ(wrong.parsed()["error"]["message"], message);
  }
  EXPECT_THAT(run("--json plugin tst").parsed()["error"]["remedy"], HasSubstr("new, test."));
}

TEST(Program, ADeviceThatIsNotThereEndsWith69) {
  const auto solve = run("solve --json --device nosuch " + plate + " --load-case " + plate_loads);

  EXPECT_EQ(solve.status, 69);
  EXPECT_EQ(solve.parsed()["error"]["code"], "device_unavailable");
}

TEST(Ops, ListsFillHoleWithItsParameters) {
  const auto ops = run("ops fill_hole --json").parsed();

  ASSERT_EQ(ops["operations"].size(), 1u);
  EXPECT_EQ(ops["operations"][0]["id"], "fill_hole");
  EXPECT_EQ(ops["operations"][0]["parameters"].size(), 2u);
}

TEST(Ops, ALengthSaysThatItTakesMillimetres) {
  EXPECT_THAT(run("ops erode").out, HasSubstr("depth (real, m; or depth_mm"));
}

TEST(Edit, ErodeSaysWhatItMeasured) {
  const auto edit = run("edit --json " + parts + "inch_block/inch_block.coarse.msh --op erode " +
                        "--surfaces 5 --param depth_mm=2");

  ASSERT_EQ(edit.status, 0) << edit.out;
  const auto json = edit.parsed();
  EXPECT_NEAR(json["thickness_change_mm"].get<double>(), 2, 0.02);
  EXPECT_EQ(json["pieces"], 1);
  EXPECT_EQ(json["hinges_repaired"], 0);
}

TEST(Verify, AllFiguresHoldAndThePageIsWritten) {
  const auto page = scratch("page.md");

  const auto result = run("verify --suite --json --device cpu -o " + page.string());

  EXPECT_EQ(result.status, 0);
  const auto report = result.parsed();
  EXPECT_TRUE(report["passed"]);
  EXPECT_GT(report["results"].size(), 40u);
  EXPECT_EQ(report["convergence"].size(), 6u);
  EXPECT_EQ(report["side_by_side"].size(), 0u);
  std::stringstream text;
  text << std::ifstream(page).rdbuf();
  EXPECT_THAT(text.str(), HasSubstr("(page.svg)"));
  EXPECT_TRUE(std::filesystem::exists(scratch("page.svg")));
}

TEST(Verify, NeedsToBeToldWhatToVerify) {
  EXPECT_EQ(run("verify").status, 2);
  EXPECT_EQ(run("verify --suite --part " + plate).status, 2);
  EXPECT_EQ(run("verify --suite --device nosuchdevice").status, 69);
  EXPECT_EQ(run("verify --suite --parts " + parts).status, 2) << "only with --calculix";
  const auto nothing = run("verify --suite --json --calculix --parts /nowhere");
  EXPECT_EQ(nothing.parsed()["error"]["code"], "not_found");
}

TEST(Doctor, FindsNothingMissing) {
  EXPECT_TRUE(run("doctor --json").parsed().contains("checks"));
}

}  // namespace
}  // namespace tedit::test
