// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "actors/links/dial.hpp"
#include "actors/node/worker.hpp"
#include "base/child_process.hpp"
#include "base/keeper.hpp"
#include "base/logging/logging.hpp"
#include "base/memory.hpp"
#include "base/process.hpp"
#include "base/process_usage.hpp"
#include "base/program_line.hpp"
#include "cli/command.hpp"
#include "cli/joining.hpp"
#include "ops/loader/confinement.hpp"
#include "ops/services/host_services.hpp"

namespace tedit::cli {

namespace {

struct worker_command {
  std::string role_name;
  bool safe_mode = false;
  unsigned memory_mb = 0;
  std::string join;          ///< HOST:PORT; empty: the server that started it.
  std::string certificates;  ///< Of this node.
  bool once = false;         ///< Not again when the connection ends.
  bool no_sandbox = false;
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
  if (given.no_sandbox)
    command.emplace_back("--no-sandbox");
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
  const auto most = whole_memory() / 4 * 3;
  limit_memory(given.memory_mb > 0 ? std::uint64_t{given.memory_mb} << 20 : most);
}

/// The link that the server left for its worker. Errors: `usage` when somebody else started it.
expected<int> inherited_link() {
  struct stat kind {};
  if (fstat(inherited_fd, &kind) != 0 || !S_ISSOCK(kind.st_mode) ||
      fcntl(inherited_fd, F_SETFD, FD_CLOEXEC) != 0)
    return fail(ec::usage, "there is no link to a server to work for",
                "\"tedit serve\" starts its workers itself; those of other machines "
                "join one with --join HOST:PORT --certificates FOLDER");
  return inherited_fd;
}

/// The keeper joins the server, and hands the link on: key and connection stay out of the process
/// that runs plugins.
class joining_keeper {
public:
  joining_keeper(const actors::join_place& where, session& s) : where_(where), session_(s) {}

  int join(int line) {
    auto made =
      actors::dial::connect({where_.certificates, where_.host, where_.port}, session_.cancel);
    if (!made)
      return end_of(fail(made.error()), session_);
    connection_ = std::move(*made);
    logging::info("joined {} at {}:{}", connection_->server().name, where_.host, where_.port);
    const auto link = connection_->take_link();
    return send_descriptors(line, {link.get()}) ? 0 : exit_status(ec::service_unavailable);
  }

private:
  const actors::join_place& where_;
  session& session_;
  std::unique_ptr<actors::dial> connection_;
};

/// What the worker has of its keeper. Errors: `service_unavailable`.
expected<keeper_gifts> start_keeper(const actors::worker_options& options, session& s) {
  const auto& facts = actors::facts_of(options.role);
  keeper_options with;
  if (options.confined && facts.runs_plugins) {
    with.programs = ops::programs_of_operations();
    with.temporary_folder = true;
  }
  std::optional<joining_keeper> joining;
  if (options.joins) {
    joining.emplace(*options.joins, s);
    with.prepare = [&](int line) { return joining->join(line); };
  }
  auto gifts = continue_in_child(with);
  if ((!with.programs.empty() && !gifts.programs) || (options.joins && !gifts.line))
    return fail(ec::service_unavailable, "no second process can be started for the worker",
                "Close other programs, or raise the limit of processes (ulimit -u)");
  return gifts;
}

/// What it loads and reaches. Errors: those of `confine_files`.
expected<void> prepare_work(actors::worker_options& options, const worker_command& given,
                            keeper_gifts gifts) {
  std::vector<std::filesystem::path> files;
  if (actors::facts_of(options.role).runs_plugins) {
    limit_worker(given);
    options.plugins =
      ops::find_plugins(given.safe_mode ? ops::plugin_source::built_in : ops::plugin_source::all);
    for (const auto& one : options.plugins)
      files.push_back(one.file);
  }
  if (!options.confined)
    return {};
  if (gifts.programs)
    start_programs_by(std::move(gifts.programs), ops::programs_of_operations());
  auto reach = ops::reach_of_plugins(files);
  reach.own_folder = gifts.temporary_folder;
  return sandbox::confine_files(reach);
}

/// In processes of their own: what runs plugins, and what joined and is confined.
expected<void> work_in_child(actors::worker_options& options, const worker_command& given,
                             session& s) {
  auto gifts = start_keeper(options, s);
  if (!gifts)
    return fail(gifts.error());
  if (gifts->line) {
    bool ended = false;
    auto links = take_descriptors(gifts->line.get(), ended, true).all;
    if (links.empty())
      return fail(ec::service_unavailable, "the server was not joined");
    options.link = links.front().release();
    gifts->line.reset();
  }
  if (auto ready = prepare_work(options, given, std::move(*gifts)); !ready)
    return ready;
  return actors::run_worker(options, s.cancel);
}

int run_worker_command(const worker_command& given, session& s) {
  if (given.no_sandbox)
    setenv("TEDIT_SANDBOX", "off", 1);  // For the programs that it starts, too.
  logging::start("info", given.role_name + ": ");
  actors::worker_options options;
  options.role = *actors::role_named(given.role_name);  // The command line takes no other.
  const auto& facts = actors::facts_of(options.role);
  options.confined = facts.confined && sandbox::is_wanted();
  if (!given.join.empty()) {
    const auto place = parse_place(given.join);
    if (!place)
      return print_error(s, place.error());
    if (!given.once)
      return keep_joined(command_of(given), s);
    options.joins = actors::join_place{place->host, place->port, given.certificates, TEDIT_VERSION};
  } else {
    const auto link = inherited_link();
    if (!link)
      return print_error(s, link.error());
    options.link = *link;
    // Ctrl-C in a terminal reaches the whole group; the server ends its workers itself.
    std::signal(SIGINT, SIG_IGN);
  }
  if (facts.runs_plugins || (options.joins && options.confined))
    return end_of(work_in_child(options, given, s), s);
  if (auto ready = prepare_work(options, given, {}); !ready)
    return print_error(s, ready.error());
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
  command->add_flag(
    "--no-sandbox", options->no_sandbox,
    "Leave plugins all that this user can do, where the kernel cannot confine them");
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
