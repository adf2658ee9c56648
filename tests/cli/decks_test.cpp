// SPDX-License-Identifier: AGPL-3.0-or-later
// Decks out and in again by the program, with a real part.
#include <fstream>

#include "tests/cli/program.hpp"

namespace tedit::test {
namespace {

nlohmann::json json_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return nlohmann::json::parse(in);
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Decks, WhatIsExportedComesBackAsItWas) {
  for (const std::string deck : {"inp", "bdf"}) {
    SCOPED_TRACE(deck);
    const auto out = scratch("plate." + deck).string();
    const auto mesh = scratch("back.msh").string();
    const auto loads = scratch("back.json").string();
    ASSERT_EQ(run("export " + plate + " --load-case " + plate_loads + " -o " + out).status, 0);

    const auto back =
      run("convert --json " + out + " -o " + mesh + " --output-unit mm --load-case " + loads);

    ASSERT_EQ(back.status, 0) << back.out;
    EXPECT_TRUE(back.parsed()["left_out"].empty());
    const auto again = scratch("again." + deck).string();
    ASSERT_EQ(run("export " + mesh + " --load-case " + loads + " -o " + again).status, 0);
    EXPECT_EQ(json_of(loads)["loads"][0]["force"]["total_n"]["z"], -20000);
    const auto before = run("info --json " + plate).parsed();
    const auto after = run("info --json " + mesh).parsed();
    ASSERT_EQ(after["surfaces"].size(), before["surfaces"].size());
    for (std::size_t i = 0; i < before["surfaces"].size(); ++i)
      for (const auto* key : {"id", "name", "facets"})
        EXPECT_EQ(after["surfaces"][i][key], before["surfaces"][i][key]);
    EXPECT_THAT(text_of(again), HasSubstr("TEdit load case of the cards behind these lines"));
  }
}

TEST(Decks, ChangedCardsCountMoreThanTheComment) {
  const auto out = scratch("plate.inp");
  ASSERT_EQ(
    run("export --order 1 " + plate + " --load-case " + plate_loads + " -o " + out.string()).status,
    0);
  auto text = text_of(out);
  text.replace(text.find("\n68900000000"), 12, "\n70000000000");
  std::ofstream(out) << text;
  const auto loads = scratch("back.json");

  const auto back = run("convert --json " + out.string() + " -o " + scratch("back.msh").string() +
                        " --load-case " + loads.string());

  ASSERT_EQ(back.status, 0) << back.out;
  EXPECT_THAT(back.parsed()["notes"].dump(), HasSubstr("its cards were changed since"));
  const auto read = json_of(loads);
  EXPECT_EQ(read["materials"][0]["young_modulus_pa"], 7e10);
  EXPECT_NEAR(read["loads"][0]["force"]["total_n"]["z"].get<double>(), -20000, 1e-6);
  EXPECT_EQ(read["constraints"][0]["surfaces"],
            nlohmann::json({"72", "73", "74", "75", "76", "77", "90", "91"}));
}

TEST(Decks, AMeshHasNoLoadsToWrite) {
  const auto result = run("convert --json " + plate + " -o " + scratch("a.msh").string() +
                          " --load-case " + scratch("a.json").string());

  EXPECT_NE(result.status, 0);
  EXPECT_THAT(result.parsed()["error"].value("message", ""),
              HasSubstr("holds no materials, supports or loads"));
  EXPECT_FALSE(std::filesystem::exists(scratch("a.json")));
}

}  // namespace
}  // namespace tedit::test
