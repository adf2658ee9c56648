// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <memory>

#include <CLI/CLI.hpp>

#include "actors/node/worker.hpp"
#include "base/process.hpp"
#include "base/process_usage.hpp"
#include "cli/command.hpp"
#include "cli/logging.hpp"

namespace tedit::cli {

namespace {

struct worker_command {
  std::string role_name;
  bool safe_mode = false;
  unsigned memory_mb = 0;
};

int run_worker_command(const worker_command& given, session& s) {
  start_logging("info", given.role_name + ": ");
  actors::worker_options options;
  options.role = *actors::role_named(given.role_name);  // The command line takes no other.
  // Ctrl-C in a terminal reaches the whole group; the server ends its workers itself.
  std::signal(SIGINT, SIG_IGN);
  if (actors::facts_of(options.role).runs_plugins) {
    continue_in_child();
    const auto pages = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES));
    const auto most = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / 4 * 3;
    limit_memory(given.memory_mb > 0 ? std::uint64_t{given.memory_mb} << 20 : most);
  }
  struct stat kind {};
  if (fstat(inherited_fd, &kind) != 0 || !S_ISSOCK(kind.st_mode) ||
      fcntl(inherited_fd, F_SETFD, FD_CLOEXEC) != 0)
    return print_error(s, {ec::usage,
                           "there is no link to a server to work for",
                           "\"tedit serve\" starts its workers itself",
                           {}});
  options.safe_mode = given.safe_mode;
  options.link = inherited_fd;
  const auto done = actors::run_worker(options, s.cancel);
  return done ? 0 : print_error(s, done.error());
}

}  // namespace

void add_worker(CLI::App& app, action& chosen) {
  auto options = std::make_shared<worker_command>();
  std::vector<std::string> roles;
  for (const auto& row : actors::worker_roles)
    roles.emplace_back(row.name);
  auto* command =
    app.add_subcommand("worker", "Work for the server that starts this; not for the command line");
  command->add_option("--role", options->role_name, "What it does")
    ->required()
    ->check(CLI::IsMember(roles));
  command->add_flag("--safe-mode", options->safe_mode,
                    "Only the operations that came with the program");
  command->add_option("--memory-mb", options->memory_mb,
                      "Modeling: the most memory that it may take (default: three quarters)");
  command->callback([options, &chosen] {
    chosen = [options](session& s) { return run_worker_command(*options, s); };
  });
}

}  // namespace tedit::cli
