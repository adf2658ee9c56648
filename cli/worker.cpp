// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <memory>

#include <CLI/CLI.hpp>

#include "actors/node/worker.hpp"
#include "base/child_process.hpp"
#include "base/process.hpp"
#include "base/process_usage.hpp"
#include "cli/command.hpp"
#include "cli/joining.hpp"
#include "cli/logging.hpp"

namespace tedit::cli {

namespace {

struct worker_command {
  std::string role_name;
  bool safe_mode = false;
  unsigned memory_mb = 0;
  std::string join;          ///< HOST:PORT; empty: the server that started it.
  std::string certificates;  ///< Of this node.
  bool once = false;         ///< Not again when the connection ends.
};

/// The process that is kept: this command for one connection.
std::vector<std::string> command_of(const worker_command& given) {
  std::vector<std::string> command{(executable_folder() / "tedit").string(),
                                   "worker",
                                   "--role",
                                   given.role_name,
                                   "--join",
                                   given.join,
                                   "--certificates",
                                   given.certificates,
                                   "--once"};
  if (given.safe_mode)
    command.emplace_back("--safe-mode");
  if (given.memory_mb > 0)
    command.insert(command.end(), {"--memory-mb", std::to_string(given.memory_mb)});
  return command;
}

/// What takes too long once may do so later: the keeper tries again.
int end_of(const expected<void>& done, session& s) {
  if (done)
    return 0;
  auto why = done.error();
  if (why.code == ec::timeout)
    why.code = ec::service_unavailable;
  return print_error(s, why);
}

void limit_worker(const worker_command& given) {
  const auto pages = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES));
  const auto most = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / 4 * 3;
  limit_memory(given.memory_mb > 0 ? std::uint64_t{given.memory_mb} << 20 : most);
}

int run_worker_command(const worker_command& given, session& s) {
  start_logging("info", given.role_name + ": ");
  actors::worker_options options;
  options.role = *actors::role_named(given.role_name);  // The command line takes no other.
  options.safe_mode = given.safe_mode;
  if (!given.join.empty()) {
    const auto place = parse_place(given.join);
    if (!place)
      return print_error(s, place.error());
    if (!given.once)
      return keep_joined(command_of(given), s);
    if (actors::facts_of(options.role).runs_plugins)
      limit_worker(given);
    options.joins = actors::join_place{place->host, place->port, given.certificates, TEDIT_VERSION};
    return end_of(actors::run_worker(options, s.cancel), s);
  }
  // Ctrl-C in a terminal reaches the whole group; the server ends its workers itself.
  std::signal(SIGINT, SIG_IGN);
  if (actors::facts_of(options.role).runs_plugins) {
    continue_in_child();
    limit_worker(given);
  }
  struct stat kind {};
  if (fstat(inherited_fd, &kind) != 0 || !S_ISSOCK(kind.st_mode) ||
      fcntl(inherited_fd, F_SETFD, FD_CLOEXEC) != 0)
    return print_error(s, {ec::usage,
                           "there is no link to a server to work for",
                           "\"tedit serve\" starts its workers itself; those of other machines "
                           "join one with --join HOST:PORT --certificates FOLDER",
                           {}});
  options.link = inherited_fd;
  return end_of(actors::run_worker(options, s.cancel), s);
}

}  // namespace

void add_worker(CLI::App& app, action& chosen) {
  auto options = std::make_shared<worker_command>();
  std::vector<std::string> roles;
  for (const auto& row : actors::worker_roles)
    roles.emplace_back(row.name);
  auto* command = app.add_subcommand("worker", "Work for a server on another machine (--join)");
  command->add_option("--role", options->role_name, "What it does")
    ->required()
    ->check(CLI::IsMember(roles));
  command->add_flag("--safe-mode", options->safe_mode,
                    "Only the operations that came with the program");
  command->add_option("--memory-mb", options->memory_mb,
                      "Modeling: the most memory that it may take (default: three quarters)");
  auto* join = command->add_option("--join", options->join,
                                   "Server to work for (HOST:PORT), until Ctrl-C or SIGTERM; "
                                   "without it: the one that started this");
  auto* certificates = command->add_option("--certificates", options->certificates,
                                           "Folder that \"tedit certs issue --role ROLE\" made");
  join->needs(certificates);
  certificates->needs(join);
  command->add_flag("--once", options->once, "Do not join again when the connection ends")
    ->needs(join);
  command->callback([options, &chosen] {
    chosen = [options](session& s) { return run_worker_command(*options, s); };
  });
}

}  // namespace tedit::cli
