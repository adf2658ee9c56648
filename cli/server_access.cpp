// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/server_access.hpp"

#include "cli/config.hpp"
#include "cli/token.hpp"

namespace tedit::cli {

expected<client::connect_options> reach_server(const std::string& url,
                                               const std::string& token_file) {
  std::filesystem::path file = token_file;
  if (file.empty()) {
    const auto config = load_config({});
    if (!config)
      return fail(config.error());
    const auto usual = token_path(*config);
    if (!usual)
      return fail(usual.error());
    file = *usual;
  }
  const auto token = read_token(file);
  if (!token)
    return fail(token.error());
  client::connect_options how;
  how.url = url;
  how.token = *token;
  return how;
}

}  // namespace tedit::cli
