// SPDX-License-Identifier: AGPL-3.0-or-later
#include <unistd.h>

#include <memory>

#include <CLI/CLI.hpp>

#include "base/child_process.hpp"
#include "cli/command.hpp"

namespace tedit::cli {

namespace {

/// Hands over to the program that links VTK; its options are its own.
int run_render(const std::vector<std::string>& arguments, session& s) {
  const auto program = (executable_folder() / "tedit-render").string();
  std::vector<char*> list{const_cast<char*>(program.c_str())};
  for (const auto& argument : arguments)
    list.push_back(const_cast<char*>(argument.c_str()));
  std::string json = "--json";
  if (s.json)
    list.push_back(json.data());
  list.push_back(nullptr);
  execv(program.c_str(), list.data());
  return print_error(s, {ec::service_unavailable,
                         "the program " + program + " is not there",
                         "Build it with -DTEDIT_RENDER=ON",
                         {}});
}

}  // namespace

void add_render(CLI::App& app, action& chosen) {
  auto* command = app.add_subcommand("render", "Draw the field of a VTU file as a PNG picture");
  command->prefix_command();
  command->set_help_flag();
  command->fallthrough(false);  // Else its options are taken for unknown ones of the program.
  command->callback([command, &chosen] {
    const auto arguments = command->remaining();
    chosen = [arguments](session& s) { return run_render(arguments, s); };
  });
}

}  // namespace tedit::cli
