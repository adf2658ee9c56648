// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/config_options.hpp"

#include <CLI/CLI.hpp>

namespace tedit::cli {

void add_config_options(CLI::App& command, config_options& options) {
  command.add_option("--config", options.config_file,
                     "Configuration (TOML) instead of $XDG_CONFIG_HOME/tedit/config.toml");
  command.add_option("--address", options.address, "Address to listen on (default 127.0.0.1)");
  command.add_option("--port", options.port, "Port; 0 takes a free one (default 7464)")
    ->check(CLI::Range(0, 65535));
  command.add_option("--documents", options.documents, "Folder of the documents");
  command.add_option("--token-file", options.token_file,
                     "File with the secret that clients must give; it is made when missing");
  command.add_option("--certificates", options.certificates,
                     "Folder of \"tedit certs issue --role server\", or with fullchain.pem and "
                     "privkey.pem: clients connect by wss://");
  command.add_option("--node-certificates", options.node_certificates,
                     "Folder of \"tedit certs issue --role server\": workers of other machines "
                     "may join");
  command.add_option("--node-address", options.node_address,
                     "Address where they join (default 127.0.0.1)");
  command
    .add_option("--node-port", options.node_port,
                "Port where they join; 0 takes a free one (default 7465)")
    ->check(CLI::Range(0, 65535));
  command.add_option("--device", options.device, "Device for solves that name none");
  command.add_flag("--safe-mode", options.safe_mode,
                   "Only the operations that came with the program, no other plugins");
}

expected<server_config> effective_config(const config_options& given, config_origins* origins) {
  config_origins from;
  auto config = load_config(given.config_file, &from);
  if (!config)
    return config;
  const auto take = [&](const auto& option, auto& value, const char* key, const char* name) {
    if (!option)
      return;
    value = *option;
    from[key] = name;
  };
  take(given.address, config->address, "server.address", "--address");
  take(given.port, config->port, "server.port", "--port");
  take(given.documents, config->documents, "server.documents", "--documents");
  take(given.token_file, config->token_file, "server.token_file", "--token-file");
  take(given.certificates, config->certificates, "server.certificates", "--certificates");
  take(given.node_certificates, config->node_certificates, "nodes.certificates",
       "--node-certificates");
  take(given.node_address, config->node_address, "nodes.address", "--node-address");
  take(given.node_port, config->node_port, "nodes.port", "--node-port");
  take(given.device, config->device, "work.device", "--device");
  if (given.safe_mode) {
    config->safe_mode = true;
    from["plugins.safe_mode"] = "--safe-mode";
  }
  if (origins)
    *origins = std::move(from);
  return config;
}

}  // namespace tedit::cli
