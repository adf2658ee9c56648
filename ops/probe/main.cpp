// SPDX-License-Identifier: AGPL-3.0-or-later
// Loads one plugin, confined, so that a crash or a hang ends this program and no other one, and its
// code runs in no other one. Writes a report (ops/loader/plugin_report.hpp): what its operations
// are, or why it is refused.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <span>

#include "ops/loader/catalogue.hpp"
#include "ops/loader/confinement.hpp"

namespace {

tedit::ops::plugin_report report_on(const char* file) {
  using namespace tedit::ops;
  if (const auto confined = confine_to(reach_of_plugins({file})); !confined)
    return {"it was not tried out: " + confined.error().message, {}};
  catalogue plugins;
  if (!plugins.load_file(file))
    return {plugins.refused().front().reason, {}};
  plugin_report report;
  for (const auto& entry : plugins.entries())
    report.operations.push_back({entry.description, entry.plugin});
  return report;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2)
    return 2;
  // What the plugin prints is no part of the report.
  const int answer = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  const auto bytes = tedit::ops::to_bytes(report_on(argv[1]));
  std::span<const std::byte> left = bytes;
  while (!left.empty()) {
    const auto sent = write(answer, left.data(), left.size());
    if (sent < 0 && errno != EINTR)
      break;
    left = left.subspan(static_cast<std::size_t>(std::max<ssize_t>(sent, 0)));
  }
  // Without destructors of the plugin: those are not asked for before the host itself ends.
  _exit(left.empty() ? 0 : 1);
}
