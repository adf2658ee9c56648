// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

/// Runs the built program as a person or a script does.
namespace tedit::test {

using nlohmann::json;
using ::testing::HasSubstr;

inline const std::string program = TEDIT_BIN "/tedit";

struct outcome {
  int status = -1;
  std::string out;

  [[nodiscard]] json parsed() const { return json::parse(out, nullptr, false); }
};

inline outcome run(const std::string& arguments) {
  outcome result;
  FILE* pipe = popen((program + " " + arguments + " 2>/dev/null").c_str(), "r");
  std::array<char, 4096> buffer;
  while (const auto got = fread(buffer.data(), 1, buffer.size(), pipe))
    result.out.append(buffer.data(), got);
  const int status = pclose(pipe);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

/// A file of the running test.
inline std::filesystem::path scratch(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(::testing::TempDir()) / "tedit_cli" / test->name();
  std::filesystem::create_directories(folder);
  return folder / name;
}

}  // namespace tedit::test
