// SPDX-License-Identifier: AGPL-3.0-or-later
// Broken documents, through the program: `tedit doc check` reads all of one.
#include "tests/broken/table.hpp"
#include "tests/cli/run_program.hpp"

namespace tedit::test {
namespace {

/// The file is called FILE in what is said.
std::string without_path(std::string text, const std::string& path) {
  if (const auto at = text.find(path); at != std::string::npos)
    text.replace(at, path.size(), "FILE");
  return text;
}

expected<std::string> told_of_document(std::span<const char> bytes) {
  const auto file = scratch("broken.tedit");
  for (const char* end : {"-wal", "-shm"})
    std::filesystem::remove(file.string() + end);
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<long>(bytes.size()));
  const auto said = run("doc check --json " + file.string()).parsed();
  if (said.is_discarded())
    return fail(ec::internal, "the program said nothing");
  if (said.value("sound", false))
    return "sound";
  // Of several damages the first is asked for.
  const auto why = said.contains("error") ? said["error"] : said["damage"].at(0);
  return fail(code_from_name(why.value("code", "storage_error")),
              without_path(why.value("message", why.value("what", "")), file.string()),
              why.value("remedy", ""), without_path(why.value("where", ""), file.string()));
}

TEST(BrokenDocuments, AreRefusedWithCauseAndRemedy) {
  expect_told("tedit", told_of_document);
}

TEST(BrokenDocuments, AFolderIsNone) {
  const auto said = run("doc check --json " + scratch("").string()).parsed();

  EXPECT_THAT(said["error"]["message"].get<std::string>(), HasSubstr("is no file"));
  EXPECT_EQ(said["error"]["remedy"], "Name a TEdit document or a new file");
}

}  // namespace
}  // namespace tedit::test
