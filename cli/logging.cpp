// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/logging.hpp"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace tedit::cli {

void start_logging(const std::string& level, const std::string& prefix) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("tedit"));
  spdlog::set_pattern("%H:%M:%S.%e %^%l%$ " + prefix + "%v");
  spdlog::set_level(spdlog::level::from_str(level));
}

}  // namespace tedit::cli
