// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/embedded_server.hpp"

#include <cstdlib>

#include "actors/node/server.hpp"
#include "base/random_token.hpp"

namespace tedit::cli {

embedded_server::embedded_server() = default;

embedded_server::~embedded_server() {
  server_.reset();
  std::error_code ignored;
  if (!folder_.empty())
    std::filesystem::remove_all(folder_, ignored);
}

expected<client::connect_options> embedded_server::start(unsigned workers) {
  std::error_code code;
  auto name = (std::filesystem::temp_directory_path(code) / "tedit-run-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    return fail(ec::io_error,
                "cannot make a folder in " + std::filesystem::temp_directory_path(code).string(),
                "Set TMPDIR to a folder that can be written");
  folder_ = name;
  auto token = make_token();
  if (!token)
    return fail(token.error());
  server_options options;
  options.documents = folder_;
  options.token = *token;
  options.modeling_workers = workers;
  options.optimizer_workers = workers;
  options.solver_workers = workers;
  options.import_jobs = workers;
  auto started = server::start(options);
  if (!started)
    return fail(started.error());
  server_ = std::move(*started);
  client::connect_options how;
  how.url = server_->url();
  how.token = *token;
  return how;
}

}  // namespace tedit::cli
