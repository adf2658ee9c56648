// SPDX-License-Identifier: AGPL-3.0-or-later
// Loads one plugin, so that a crash or a hang ends this program and no other one. Prints "ok", or
// why the plugin is refused.
#include <fcntl.h>
#include <unistd.h>

#include <string>

#include "ops/loader/catalogue.hpp"
#include "ops/loader/confinement.hpp"

int main(int argc, char** argv) {
  if (argc != 2)
    return 2;
  // The plugin may write to stdout; the verdict goes where it cannot reach.
  const int verdict = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  std::string text = "ok";
  if (const auto confined = tedit::ops::confine_to(tedit::ops::reach_of_plugins({argv[1]}));
      !confined) {
    text = "it was not tried out: " + confined.error().message;
  } else {
    tedit::ops::catalogue plugins;
    if (!plugins.load_file(argv[1]))
      text = plugins.refused().front().reason;
  }
  // Without destructors of the plugin: those are not asked for before the host itself ends.
  const bool said = write(verdict, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  _exit(said ? 0 : 1);
}
