// SPDX-License-Identifier: AGPL-3.0-or-later
#include <csignal>
#include <cstdlib>
#include <memory>

#include <CLI/CLI.hpp>

#include "actors/node/worker.hpp"
#include "cli/command.hpp"
#include "cli/logging.hpp"

namespace tedit::cli {

namespace {

struct worker_command {
  std::string role;
  std::string join;
  bool safe_mode = false;
};

int run_worker_command(const worker_command& given, session& s) {
  start_logging("info", given.role + ": ");
  // Ctrl-C in a terminal reaches the whole group; the server ends its workers itself.
  std::signal(SIGINT, SIG_IGN);
  const auto colon = given.join.rfind(':');
  const auto* ticket = std::getenv("TEDIT_TICKET");
  actors::worker_options options;
  options.role = given.role;
  options.safe_mode = given.safe_mode;
  options.host = given.join.substr(0, colon);
  options.ticket = ticket ? ticket : "";
  unsigned long port = 0;
  if (colon != std::string::npos)
    port = std::strtoul(given.join.c_str() + colon + 1, nullptr, 10);
  if (port == 0 || port > 65535)
    return print_error(s, {ec::usage, "--join needs HOST:PORT", {}, {}});
  options.port = static_cast<std::uint16_t>(port);
  const auto done = actors::run_worker(options, s.cancel);
  return done ? 0 : print_error(s, done.error());
}

}  // namespace

void add_worker(CLI::App& app, action& chosen) {
  auto options = std::make_shared<worker_command>();
  auto* command =
    app.add_subcommand("worker", "Work for a server; \"tedit serve\" starts its workers itself");
  command->add_option("--role", options->role, "What it does")
    ->required()
    ->check(CLI::IsMember({"modeling", "optimizer", "solver"}));
  command->add_option("--join", options->join, "HOST:PORT of the server's pool")->required();
  command->add_flag("--safe-mode", options->safe_mode,
                    "Only the operations that came with the program");
  command->callback([options, &chosen] {
    chosen = [options](session& s) { return run_worker_command(*options, s); };
  });
}

}  // namespace tedit::cli
