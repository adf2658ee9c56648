// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cmath>
#include <fstream>
#include <iterator>

#include "tests/cli/run_program.hpp"

/// Where the libraries were not there when this was built, there is nothing to try.
#define TEDIT_NEEDS_CAD() \
  if (!TEDIT_HAS_CAD)     \
  GTEST_SKIP() << "built without OpenCASCADE and Gmsh"

namespace tedit::test {

inline const std::string cad_parts = TEDIT_TEST_DATA "/cad/";

inline std::string text_of_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline std::filesystem::path write_scratch(const std::string& name, const std::string& text) {
  const auto file = scratch(name);
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

/// What `tedit import --json` says of a file, and that it ended well.
inline json import_part(const std::string& arguments) {
  const auto result = run("import --json " + arguments);
  EXPECT_EQ(result.status, 0) << result.out;
  return result.parsed();
}

/// The error of one that must be refused.
inline json refusal_of(const std::string& arguments, int status) {
  const auto result = run("import --json " + arguments);
  EXPECT_EQ(result.status, status) << result.out;
  return result.parsed()["error"];
}

}  // namespace tedit::test
