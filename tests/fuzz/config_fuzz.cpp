// SPDX-License-Identifier: AGPL-3.0-or-later
#include <cmath>

#include "cli/config.hpp"
#include "tests/fuzz/promise.hpp"

namespace {

using namespace tedit;

void check_accepted(const cli::server_config& config) {
  for (const int port : {config.port, config.node_port})
    fuzz::require(port >= 0 && port <= 65535, "a port is one");
  for (const int workers :
       {config.modeling_workers, config.optimizer_workers, config.solver_workers, config.cad_jobs})
    fuzz::require(workers >= 0 && workers <= 64, "workers are at most 64");
  for (const double seconds :
       {config.edit_timeout_s, config.import_timeout_s, config.solve_timeout_s,
        config.close_unused_after_s, config.keep_unnamed_s})
    fuzz::require(std::isfinite(seconds) && seconds > 0, "times are positive numbers");
  for (const auto bytes :
       {config.upload_bytes, config.all_upload_bytes, config.result_bytes, config.version_bytes})
    fuzz::require(bytes >= std::int64_t{1} << 20, "budgets have a MiB at least");
  for (const auto* path : {&config.certificates, &config.token_file, &config.users_file,
                           &config.documents, &config.node_certificates})
    fuzz::require(path->empty() || path->front() == '/', "paths are absolute");
}

}  // namespace

/// The bytes are the server's configuration.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::memory_file file({data, size});
  const auto config = cli::read_config(file.path());
  if (config) {
    check_accepted(*config);
    return 0;
  }
  fuzz::require_reason(config.error());
  fuzz::require(size == 0 || !config.error().where.empty(), "a refusal names file and line");
  return 0;
}
