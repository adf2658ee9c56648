// SPDX-License-Identifier: AGPL-3.0-or-later
#include <poll.h>
#include <sys/stat.h>

#include <fstream>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "actors/node/server.hpp"
#include "base/logging/logging.hpp"
#include "cli/command.hpp"
#include "cli/config.hpp"
#include "cli/config_options.hpp"
#include "cli/service_notice.hpp"
#include "cli/token.hpp"
#include "sandbox/sandbox.hpp"

namespace tedit::cli {

namespace {

struct serve_options {
  config_options config;
  std::string ready_file;
  bool in_process = false;
};

server_options to_server_options(const server_config& config) {
  const auto limit = [](double seconds) {
    return std::chrono::milliseconds(static_cast<std::int64_t>(1000 * seconds));
  };
  server_options options;
  options.address = config.address;
  options.port = static_cast<std::uint16_t>(config.port);
  options.allowed_origins = config.allowed_origins;
  options.allowed_hosts = config.allowed_hosts;
  options.certificates = config.certificates;
  options.unencrypted_behind_proxy = config.unencrypted_behind_proxy;
  if (!config.node_certificates.empty())
    options.node_certificates = config.node_certificates;
  options.node_address = config.node_address;
  options.node_port = static_cast<std::uint16_t>(config.node_port);
  options.device = config.device;
  options.safe_mode = config.safe_mode;
  options.quarantine_after = static_cast<unsigned>(config.quarantine_after);
  options.modeling_workers = static_cast<unsigned>(config.modeling_workers);
  options.optimizer_workers = static_cast<unsigned>(config.optimizer_workers);
  options.solver_workers = static_cast<unsigned>(config.solver_workers);
  options.cad_jobs = static_cast<unsigned>(config.cad_jobs);
  options.import_jobs = static_cast<unsigned>(config.import_jobs);
  options.sandbox = config.sandbox == "on" ? !sandbox::is_switched_off()
                                           : config.sandbox == "auto" && sandbox::is_wanted();
  if (config.sandbox == "auto" && !options.sandbox && !sandbox::is_switched_off())
    if (const auto can = sandbox::check(); !can)
      logging::warn("{}", render(can.error()));
  options.modeling_memory_mb = static_cast<unsigned>(config.modeling_memory_mb);
  options.import_limit = limit(config.import_timeout_s);
  options.edit_limit = limit(config.edit_timeout_s);
  options.solve_limit = limit(config.solve_timeout_s);
  options.unused_limit = limit(config.close_unused_after_s);
  options.temporary_limit = limit(config.keep_unnamed_s);
  options.upload_bytes = static_cast<std::uint64_t>(config.upload_bytes);
  options.all_upload_bytes = static_cast<std::uint64_t>(config.all_upload_bytes);
  options.result_bytes = static_cast<std::uint64_t>(config.result_bytes);
  options.version_bytes = static_cast<std::uint64_t>(config.version_bytes);
  options.traces = config.traces;
  return options;
}

/// Written when the server is ready, so that scripts need not guess; it appears whole or not at
/// all.
expected<void> write_ready_file(const std::string& path, const nlohmann::ordered_json& state) {
  const auto draft = path + ".part";
  std::ofstream out(draft);
  out << state.dump() << "\n";
  out.close();
  std::error_code code;
  std::filesystem::rename(draft, path, code);
  if (!out || code)
    return fail(ec::io_error, "cannot write " + path);
  return {};
}

int run_serve(const serve_options& given, session& s) {
  const auto config = effective_config(given.config);
  if (!config)
    return print_error(s, config.error());
  logging::start(s.quiet ? "warn" : config->log_level);
  auto options = to_server_options(*config);
  options.worker_processes = !given.in_process;
  const auto documents = documents_folder(*config);
  const auto token_file = token_path(*config);
  if (!documents || !token_file)
    return print_error(s, documents ? token_file.error() : documents.error());
  options.documents = *documents;
  const auto token = read_or_make_token(*token_file);
  if (!token)
    return print_error(s, token.error());
  options.token = *token;
  options.users = *users_path(*config);  // Beside a token that was found.
  auto started = server::start(options);
  if (!started)
    return print_error(s, started.error());
  nlohmann::ordered_json state{{"url", (*started)->url()},
                               {"token_file", token_file->string()},
                               {"documents", options.documents.string()},
                               {"pid", getpid()}};
  if (const auto port = (*started)->node_port())
    state["node_port"] = *port;
  const auto shown = (*started)->fingerprint();
  if (!shown.empty())
    state["certificate_sha256"] = shown;
  if (!given.ready_file.empty())
    if (auto written = write_ready_file(given.ready_file, state); !written)
      return print_error(s, written.error());
  print_result(s, state,
               "listening on " + (*started)->url() + "\n" +
                 (shown.empty() ? "" : "  SHA-256   " + shown + "\n") + "  token     " +
                 token_file->string() + "\n  documents " + options.documents.string() +
                 "\n  end with Ctrl-C; clients: tedit run RECIPE.json --server " +
                 (*started)->url() + "\n" +
                 ((*started)->node_port() ? "  workers of other machines join at port " +
                                              std::to_string(*(*started)->node_port()) + "\n"
                                          : std::string()));
  std::fflush(stdout);
  tell_service_manager("READY=1");
  // The signal that ends the server ends this wait, too: Linux gives it to the main thread.
  while (!s.cancel.cancelled())
    ::poll(nullptr, 0, 500);
  tell_service_manager("STOPPING=1");
  notice(s, "stopping");
  (*started)->stop();
  return 0;
}

}  // namespace

void add_serve(CLI::App& app, action& chosen) {
  auto options = std::make_shared<serve_options>();
  auto* command = app.add_subcommand("serve", "Serve clients over WebSocket until Ctrl-C");
  add_config_options(*command, options->config);
  command->add_option("--ready-file", options->ready_file,
                      "Write URL and token file here (JSON) when clients can connect");
  command->add_flag("--in-process", options->in_process,
                    "Workers on threads: a crash of one ends the server");
  command->callback(
    [options, &chosen] { chosen = [options](session& s) { return run_serve(*options, s); }; });
}

}  // namespace tedit::cli
