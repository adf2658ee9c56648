// SPDX-License-Identifier: AGPL-3.0-or-later
// Broken CAD files, through the program: their reader may die of them.
#include "tests/broken/table.hpp"
#include "tests/cad/import_program.hpp"

namespace tedit::test {
namespace {

/// Its name tells the kind where its bytes do not.
expected<std::string> told_of_part(const std::string& name, std::span<const char> bytes) {
  const auto file = write_scratch(name, {bytes.data(), bytes.size()});
  const auto said = run("import --json --size coarse --time-limit 20 " + file.string()).parsed();
  if (said.is_discarded())
    return fail(ec::internal, "the program said nothing");
  if (!said.contains("error"))
    return said["warnings"].dump();
  const auto& why = said["error"];
  auto place = why.value("where", "");
  if (const auto at = place.find(file.string()); at != std::string::npos)
    place.erase(at, file.string().size());
  return fail(code_from_name(why["code"].get<std::string>()), why["message"].get<std::string>(),
              why.value("remedy", ""), place);
}

class BrokenCad : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Formats, BrokenCad, ::testing::Values("step", "iges", "brep"),
                         [](const auto& format) { return std::string(format.param); });

TEST_P(BrokenCad, IsRefusedWithCauseAndRemedy) {
  TEDIT_NEEDS_CAD();
  expect_told(GetParam(), [](std::span<const char> bytes) {
    return told_of_part(std::string("part.") + GetParam(), bytes);
  });
}

}  // namespace
}  // namespace tedit::test
