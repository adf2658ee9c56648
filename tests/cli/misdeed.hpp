// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <utility>

#include "tests/cli/program.hpp"

/// Edits by a plugin that does one thing wrong, or says something.
namespace tedit::test {

inline const std::string block = parts + "holes_block/holes_block.coarse.msh";

/// One edit by the plugin that does what `deed` says.
class Misdeed {
public:
  explicit Misdeed(const std::string& deed) {
    setenv("TEDIT_BREAK", deed.c_str(), 1);
    setenv("TEDIT_PLUGIN_PATH", TEDIT_RULE_BREAKER, 1);
    setenv("XDG_CACHE_HOME", scratch("cache").c_str(), 1);
    std::filesystem::remove(output);
  }
  ~Misdeed() {
    unsetenv("TEDIT_BREAK");
    unsetenv("TEDIT_PLUGIN_PATH");
    unsetenv("XDG_CACHE_HOME");
  }

  const std::filesystem::path output = scratch("edited.msh");
  const std::string arguments = "edit --json " + block +
                                " --op rule_breaker --surfaces 4 --param distance=0.0001 -o " +
                                output.string();
};

/// What a command writes to stderr, and whether it ended well.
inline std::pair<std::string, bool> errors_of(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1 >/dev/null").c_str(), "r");
  std::string errors(4096, ' ');
  errors.resize(fread(errors.data(), 1, errors.size(), pipe));
  return {errors, pclose(pipe) == 0};
}

}  // namespace tedit::test
