// SPDX-License-Identifier: AGPL-3.0-or-later
#include <sys/utsname.h>
#include <unistd.h>

#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/child_process.hpp"
#include "base/forked_call.hpp"
#include "base/logging/logging.hpp"
#include "base/memory.hpp"
#include "base/processors.hpp"
#include "cad/program.hpp"
#include "cli/command.hpp"
#include "cli/config.hpp"
#include "cli/node_checks.hpp"
#include "cli/server_checks.hpp"
#include "fem/solver.hpp"
#include "mesh/formats.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/loader/confinement.hpp"

namespace tedit::cli {

namespace {

struct doctor_options {
  std::optional<std::filesystem::path> config_file;
  joining_check joins;  ///< Without a place: this machine has the server.
};

check_row check_program(const std::string& name, const std::string& what) {
  const auto path = executable_folder() / name;
  const bool there = access(path.c_str(), X_OK) == 0;
  return {name, there, there ? path.string() : "missing: " + what};
}

/// A server needs none: Containerfile leaves it out.
check_row check_render() {
  const auto path = executable_folder() / "tedit-render";
  return {"tedit-render", true,
          access(path.c_str(), X_OK) == 0
            ? path.string()
            : "no pictures here: this build is without it (-DTEDIT_RENDER=ON)"};
}

/// A build without the libraries leaves both out.
check_row check_cad() {
  for (const auto* name :
       {"tedit-cad-reader", "tedit-cad-mesher", "tedit-cad-editor", "tedit-cad-writer"})
    if (const auto there = cad::find_program(name); !there)
      return {"CAD files", true, "not read here: " + there.error().message};
  return {"CAD files", true, "STEP, IGES and BREP are read"};
}

check_row check_surface_files() {
  for (const auto* name : {"tedit-scan-reader", "tedit-scan-mesher"})
    if (const auto there = cad::find_program(name); !there)
      return {"surface files", true, "not meshed here: " + there.error().message};
  return {"surface files", true, "STL, OBJ, PLY and 3MF are read and meshed"};
}

check_row check_med() {
  const auto path = helper_program(formats::med::program);
  const bool there = access(path.c_str(), X_OK) == 0;
  return {"MED files", true,
          there ? "MED files are read and written" : "not read here: there is no " + path.string()};
}

/// What the server and its workers count on, which in a container is less than the machine has.
check_row check_machine() {
  const auto count = processors();
  const auto left = available_memory();
  return {"machine", true,
          std::to_string(count) + (count == 1 ? " processor, " : " processors, ") +
            std::to_string(whole_memory() >> 20) + " MiB of memory, " +
            std::to_string(left.bytes >> 20) + " MiB of it free"};
}

/// By doing it, in a copy of this process.
check_row check_sandbox(const doctor_options& options) {
  const auto config = load_config(options.config_file);
  const bool off = sandbox::is_switched_off();
  if (off || (config && config->sandbox == "off"))
    return {"sandbox", true,
            std::string("off (") + (off ? "TEDIT_SANDBOX" : "work.sandbox") +
              "): plugins can do all that this user can"};
  forked_limits limits;
  limits.confine = [] { return ops::confine_to(ops::reach_of_plugins({})); };
  auto done = sandbox::check();
  if (done)
    done = call_forked([](const caller_line&) {}, limits, {}, [](std::uint32_t, auto) {});
  if (done)
    return {"sandbox", true, "plugins and readers of files can be confined"};
  const bool demanded = config && config->sandbox == "on";
  return {"sandbox", !demanded,
          (demanded ? "" : "the server starts with plugins that are not confined: ") +
            render(done.error())};
}

std::vector<check_row> check_all(const doctor_options& options, const cancel_token& stop) {
  auto rows = options.joins.place.empty() ? check_server(options.config_file)
                                          : check_joining(options.joins, stop);
  rows.push_back(check_machine());
  rows.push_back(check_clock());
  rows.push_back(check_sandbox(options));
  rows.push_back(check_program("tedit-mesher", "operations cannot mesh new volume"));
  rows.push_back(check_render());
  rows.push_back(check_cad());
  rows.push_back(check_surface_files());
  rows.push_back(check_med());
  for (const auto& device : fem::list_devices())
    rows.push_back({"device " + device.name, true, device.kind + ", " + device.driver});
  const auto plugins = ops::load_default_catalogue();
  for (const auto& entry : plugins.entries())
    rows.push_back({"operation " + entry.description.id, true, entry.plugin});
  if (plugins.entries().empty())
    rows.push_back({"operations", false, "none found; set TEDIT_PLUGIN_PATH"});
  for (const auto& refused : plugins.refused())
    rows.push_back({"plugin " + refused.file.filename().string(), false, refused.reason});
  return rows;
}

int run_doctor(const doctor_options& options, session& s) {
  utsname system{};
  uname(&system);
  logging::start("warn");  // What joining notes is in the rows.
  auto rows = check_all(options, s.cancel);
  nlohmann::ordered_json json{{"version", TEDIT_VERSION},
                              {"system", std::string(system.sysname) + " " + system.release},
                              {"checks", nlohmann::ordered_json::array()}};
  std::string text = std::string("TEdit ") + TEDIT_VERSION + " on " + system.sysname + " " +
                     system.release + " (" + system.machine + ")\n";
  bool ok = true;
  for (const auto& row : rows) {
    ok = ok && row.ok;
    json["checks"].push_back({{"name", row.name}, {"ok", row.ok}, {"text", row.text}});
    text += std::string(row.ok ? "  ok    " : "  FAIL  ") + row.name + ": " + row.text + "\n";
  }
  json["ok"] = ok;
  print_result(s, json, text);
  return ok ? 0 : 1;
}

}  // namespace

void add_doctor(CLI::App& app, action& chosen) {
  auto options = std::make_shared<doctor_options>();
  auto* command = app.add_subcommand(
    "doctor",
    "Check what a server needs here, or a worker (--join): files, ports, clock, devices, plugins");
  command->add_option("--config", options->config_file,
                      "Configuration (TOML) instead of $XDG_CONFIG_HOME/tedit/config.toml");
  auto* join = command->add_option("--join", options->joins.place,
                                   "For a worker: whether the server at HOST:PORT is reached and "
                                   "takes it, instead of what a server here needs");
  auto* certificates =
    command->add_option("--certificates", options->joins.certificates,
                        "The worker's folder that \"tedit certs issue --role ROLE\" made");
  join->needs(certificates);
  certificates->needs(join);
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_doctor(*options, s); }; });
}

}  // namespace tedit::cli
