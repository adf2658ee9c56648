// SPDX-License-Identifier: AGPL-3.0-or-later
#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <iostream>

#include <CLI/CLI.hpp>

#include "base/memory.hpp"
#include "cli/command.hpp"

namespace {

// A signal handler may touch no more than this.
std::atomic<std::int64_t> first_interrupt{0};  ///< On the monotonic clock, ns; 0: none came.

tedit::cancel_token* interrupt_token = nullptr;

/// Supervisors signal a process and then its whole group: what comes so soon after the first signal
/// is the same wish.
constexpr std::int64_t same_wish_ns = 500'000'000;

std::int64_t monotonic_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * std::int64_t{1'000'000'000} + now.tv_nsec;
}

extern "C" void on_interrupt(int) {
  const auto now = monotonic_ns();
  std::int64_t first = 0;
  if (first_interrupt.compare_exchange_strong(first, now))
    return interrupt_token->cancel();
  // A second signal ends the program even when the work does not listen.
  if (now - first > same_wish_ns)
    _exit(130);
}

void install_signal_handlers(tedit::cancel_token& token) {
  interrupt_token = &token;
  struct sigaction handler {};
  handler.sa_handler = on_interrupt;
  sigaction(SIGINT, &handler, nullptr);
  sigaction(SIGTERM, &handler, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

constexpr auto footer =
  R"(Exit status: 0 done, 1 the operation failed, 2 usage, 65 bad input, 69 service or device
unavailable, 130 interrupted. Progress and messages go to stderr; with --json, stdout holds one object.
"tedit COMMAND --help" explains a command.)";

/// CLI11 says no more than that a command is missing, also where a word stands that is none.
tedit::error usage_error(const CLI::App& app, const CLI::ParseError& e) {
  const auto* at = &app;
  std::string name = at->get_name();
  while (!at->get_subcommands().empty()) {
    at = at->get_subcommands().front();
    name += " " + at->get_name();
  }
  const auto commands = at->get_subcommands([](const CLI::App*) { return true; });
  if (e.get_name() != "RequiredError" || commands.empty())
    return {tedit::ec::usage, e.what(), "\"tedit --help\" lists commands and options", {}};
  std::string known;
  for (const auto* command : commands)
    known += (known.empty() ? "" : ", ") + command->get_name();
  const auto words = app.remaining(true);
  return {tedit::ec::usage,
          words.empty() ? "\"" + name + "\" needs a command"
                        : "\"" + name + "\" has no \"" + words.front() + "\"",
          "Commands: " + known + ". \"" + name + " --help\" explains them",
          {}};
}

}  // namespace

// No command can be made without memory: then the program may end by the exception.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  tedit::return_large_blocks();
  tedit::cli::session session;
  tedit::cli::action chosen;

  CLI::App app{
    "TEdit edits tetrahedral meshes of CAD parts and shows the new stress field at once."};
  app.name("tedit");
  app.footer(footer);
  app.set_version_flag("--version", TEDIT_VERSION);
  app.require_subcommand(1);
  app.fallthrough();
  app.add_flag("--json", session.json, "Print one JSON object on stdout");
  app.add_flag("-q,--quiet", session.quiet, "No progress and notices on stderr");

  tedit::cli::add_info(app, chosen);
  tedit::cli::add_import(app, chosen);
  tedit::cli::add_edit(app, chosen);
  tedit::cli::add_adapt(app, chosen);
  tedit::cli::add_formats(app, chosen);
  tedit::cli::add_convert(app, chosen);
  tedit::cli::add_check_print(app, chosen);
  tedit::cli::add_solve(app, chosen);
  tedit::cli::add_compare(app, chosen);
  tedit::cli::add_export(app, chosen);
  tedit::cli::add_run(app, chosen);
  tedit::cli::add_serve(app, chosen);
  tedit::cli::add_status(app, chosen);
  tedit::cli::add_worker(app, chosen);
  tedit::cli::add_render(app, chosen);
  tedit::cli::add_doc(app, chosen);
  tedit::cli::add_ops(app, chosen);
  tedit::cli::add_select(app, chosen);
  tedit::cli::add_plugin(app, chosen);
  tedit::cli::add_certify(app, chosen);
  tedit::cli::add_verify(app, chosen);
  tedit::cli::add_doctor(app, chosen);
  tedit::cli::add_certs(app, chosen);
  tedit::cli::add_users(app, chosen);
  tedit::cli::add_config(app, chosen);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0)
      return app.exit(e);
    return tedit::cli::print_error(session, usage_error(app, e));
  }
  install_signal_handlers(session.cancel);
  try {
    return chosen(session);
  } catch (const std::bad_alloc&) {
    return tedit::cli::print_error(session, {tedit::ec::out_of_memory,
                                             "there is not enough memory for this",
                                             "Close other programs or take a coarser mesh",
                                             {}});
  } catch (const std::exception& e) {
    return tedit::cli::print_error(
      session, {tedit::ec::internal, e.what(), "This is a defect of TEdit: please report it", {}});
  }
}
