// SPDX-License-Identifier: AGPL-3.0-or-later
// Damaged copies of a box: each gets an answer within its time, and none ends the program.
#include <chrono>
#include <random>

#include "tests/cad/import_program.hpp"

namespace tedit::test {
namespace {

/// That there is an answer: a part, or an error with cause and remedy and no file.
void expect_an_answer(const std::string& name, const std::string& bytes) {
  const auto file = write_scratch(name, bytes);
  const auto out = scratch(name + ".msh");
  std::filesystem::remove(out);
  const auto begun = std::chrono::steady_clock::now();

  const auto result =
    run("import --json --size coarse --time-limit 2 " + file.string() + " -o " + out.string());

  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  EXPECT_LT(took.count(), 50) << name;  // Two readers and a mesher, 2 s each, and a busy machine.
  EXPECT_THAT(result.status, ::testing::AnyOf(0, 1, 65)) << name << ": " << result.out;
  const auto said = result.parsed();
  ASSERT_FALSE(said.is_discarded()) << name << ": " << result.out;
  EXPECT_EQ(std::filesystem::exists(out), result.status == 0) << name;
  if (result.status != 0) {
    EXPECT_NE(said["error"]["message"].get<std::string>(), "") << name;
    EXPECT_NE(said["error"]["remedy"].get<std::string>(), "") << name << said;
    EXPECT_NE(said["error"]["code"], "internal") << name << said;
  }
}

TEST(DamagedStep, CutOffAnywhereGetsAnAnswer) {
  TEDIT_NEEDS_CAD();
  const auto whole = text_of_file(cad_parts + "box.step");
  for (std::size_t i = 1; i <= 10; ++i)
    expect_an_answer("cut" + std::to_string(i) + ".step", whole.substr(0, i * whole.size() / 11));
}

TEST(DamagedStep, WithBytesThatFlippedGetsAnAnswer) {
  TEDIT_NEEDS_CAD();
  const auto whole = text_of_file(cad_parts + "box.step");
  std::mt19937 random(7);
  for (int i = 0; i < 12; ++i) {
    auto bytes = whole;
    for (int k = 0; k < 1 << (i / 2); ++k)
      bytes[random() % bytes.size()] ^= static_cast<char>(1U << (random() % 8));
    expect_an_answer("flipped" + std::to_string(i) + ".step", bytes);
  }
}

TEST(DamagedBrep, CutOffOrFlippedGetsAnAnswer) {
  TEDIT_NEEDS_CAD();
  const auto whole = text_of_file(cad_parts + "box.brep");
  std::mt19937 random(8);
  for (int i = 0; i < 8; ++i) {
    auto bytes = whole;
    if (i < 3)
      bytes.resize((i + 1) * whole.size() / 4);
    else
      bytes[random() % bytes.size()] ^= static_cast<char>(1U << (random() % 7));
    expect_an_answer("broken" + std::to_string(i) + ".brep", bytes);
  }
}

}  // namespace
}  // namespace tedit::test
