// SPDX-License-Identifier: AGPL-3.0-or-later
// A part that CalculiX solves, too.
#include "tests/cli/program.hpp"

#include <cstdlib>

namespace tedit::test {
namespace {

const std::string block =
  parts + "inch_block/inch_block.coarse.msh --load-case " + parts + "inch_block/load_case.json";

bool has_calculix() {
  return std::system("command -v ccx >/dev/null") == 0;
}

#define TEDIT_NEEDS_CCX() \
  if (!has_calculix())    \
  GTEST_SKIP() << "ccx is not installed (Debian package calculix-ccx)"

TEST(Certify, CalculixAgreesOnARealPartAndAllIsKept) {
  TEDIT_NEEDS_CCX();
  const auto folder = scratch("certificate");
  std::filesystem::remove_all(folder);

  const auto result = run("certify --json " + block + " --device cpu -o " + folder.string());

  ASSERT_EQ(result.status, 0) << result.out;
  const auto report = result.parsed();
  EXPECT_TRUE(report["agrees"].get<bool>());
  EXPECT_THAT(report["program"].get<std::string>(), HasSubstr("CalculiX"));
  ASSERT_EQ(report["load_cases"].size(), 1U);
  const auto& row = report["load_cases"][0];
  EXPECT_LE(row["displacement"].get<double>(), 1e-5);
  EXPECT_LE(row["reaction"].get<double>(), 1e-6);
  EXPECT_LE(row["stress"].get<double>(), 1e-4);
  EXPECT_GT(row["stress_as_shown"].get<double>(), row["stress"].get<double>());
  for (const auto& name : {row["deck"].get<std::string>(), row["results"][0].get<std::string>(),
                           row["results"][1].get<std::string>(), std::string("tedit.vtu"),
                           std::string("certificate.json")})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  std::ifstream kept(folder / "certificate.json");
  EXPECT_EQ(nlohmann::json::parse(kept), report);

  const auto again = run("certify --json " + block + " -o " + folder.string());
  EXPECT_EQ(again.parsed()["error"]["code"], "conflict") << "nothing is written over";
}

TEST(Certify, SeveralLoadCasesHaveFilesOfTheirNames) {
  TEDIT_NEEDS_CCX();
  const auto folder = scratch("certificates");
  std::filesystem::remove_all(folder);
  const auto loads = parts + "inch_block/load_case.json";

  const auto result =
    run("certify --json --order 1 " + block + " --load-case " + loads + " -o " + folder.string());

  ASSERT_EQ(result.status, 0) << result.out;
  const auto rows = result.parsed()["load_cases"];
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NE(rows[0]["deck"], rows[1]["deck"]);
  EXPECT_TRUE(std::filesystem::exists(folder / rows[1]["deck"].get<std::string>()));
}

TEST(Certify, WithoutLoadsOrCalculixItSaysWhatIsMissing) {
  const auto folder = scratch("nothing");
  const auto mesh = parts + "inch_block/inch_block.coarse.msh";
  EXPECT_EQ(run("certify " + mesh).status, 2) << "no folder";
  if (has_calculix()) {
    const auto loads = run("certify --json " + mesh + " -o " + folder.string());
    EXPECT_THAT(loads.parsed()["error"]["remedy"].get<std::string>(), HasSubstr("--load-case"));
  }
  const std::string path = getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  const auto bare = run("certify --json " + block + " -o " + folder.string());
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(bare.status, 69);
  EXPECT_THAT(bare.parsed()["error"]["remedy"].get<std::string>(), HasSubstr("calculix-ccx"));
  EXPECT_FALSE(std::filesystem::exists(folder));
}

}  // namespace
}  // namespace tedit::test
