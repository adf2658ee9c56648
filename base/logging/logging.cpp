// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/logging/logging.hpp"

#include <fmt/args.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace tedit::logging {

namespace {

spdlog::level::level_enum level_of(level how) {
  switch (how) {
    case level::debug:
      return spdlog::level::debug;
    case level::info:
      return spdlog::level::info;
    case level::warn:
      return spdlog::level::warn;
    case level::error:
      return spdlog::level::err;
  }
  return spdlog::level::err;
}

}  // namespace

void start(const std::string& from, const std::string& prefix) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("tedit"));
  spdlog::set_pattern("%H:%M:%S.%e %^%l%$ " + prefix + "%v");
  set_level(from);
}

void set_level(const std::string& from) {
  spdlog::set_level(spdlog::level::from_str(from));
}

void write(level how, std::string_view text, std::initializer_list<value> values) {
  auto* const log = spdlog::default_logger_raw();
  if (!log->should_log(level_of(how)))
    return;
  fmt::dynamic_format_arg_store<fmt::format_context> all;
  for (const auto& one : values)
    std::visit([&](const auto& held) { all.push_back(held); }, one.held());
  log->log(level_of(how),
           spdlog::string_view_t(fmt::vformat(fmt::string_view(text.data(), text.size()), all)));
}

}  // namespace tedit::logging
