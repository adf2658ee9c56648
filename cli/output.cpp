// SPDX-License-Identifier: AGPL-3.0-or-later
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "mesh/formats.hpp"

namespace tedit::cli {

namespace {

/// Names of files may hold bytes that are no UTF-8, and JSON may not.
std::string to_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

void print_result(const session& s, const nlohmann::ordered_json& result, const std::string& text) {
  end_progress(s);
  if (s.json)
    std::cout << to_line(result) << '\n';
  else
    std::cout << text;
  std::cout.flush();
}

int print_error(const session& s, const error& e) {
  end_progress(s);
  if (s.json) {
    nlohmann::ordered_json body{{"error",
                                 {{"code", code_name(e.code)},
                                  {"message", e.message},
                                  {"remedy", e.remedy},
                                  {"where", e.where}}}};
    if (e.most)
      body["error"]["most_that_works"] = {{"parameter", e.most->parameter},
                                          {"value", e.most->value}};
    std::cout << to_line(body) << '\n';
    std::cout.flush();
  }
  std::cerr << "tedit: " << render(e) << '\n';
  return exit_status(e.code);
}

execution make_execution(const session& s) {
  execution run;
  run.cancel = s.cancel;
  if (s.quiet || !isatty(STDERR_FILENO))
    return run;
  run.progress = [](double fraction, std::string_view stage) {
    std::fprintf(stderr, "\r\033[K%3d %%  %.*s", static_cast<int>(100 * fraction),
                 static_cast<int>(stage.size()), stage.data());
  };
  return run;
}

expected<const file_format*> output_format(const std::string& file) {
  auto format = format_for(file);
  if (!format)
    format.error().code = ec::usage;
  return format;
}

void end_progress(const session& s) {
  if (!s.quiet && isatty(STDERR_FILENO))
    std::fputs("\r\033[K", stderr);
}

void notice(const session& s, const std::string& text) {
  if (s.quiet)
    return;
  end_progress(s);
  std::cerr << text << '\n';
}

std::string pretty(double value, int digits) {
  char buffer[64];
  std::snprintf(buffer, sizeof(buffer), "%.*g", digits, value);
  return buffer;
}

/// Of UTF-8: as wide as they stand in a terminal, but for those of East Asia.
static std::size_t characters_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
    text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

std::string format_table(const std::vector<std::vector<std::string>>& rows,
                         const std::set<std::size_t>& labels) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t c = 0; c < row.size(); ++c)
      widths[c] = std::max(widths[c], characters_of(row[c]));
  }
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::string line = " ";
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const std::string pad(widths[c] - characters_of(rows[r][c]), ' ');
      const bool label = c == 0 || labels.contains(c);
      line += (c == 0 ? " " : "  ") + (label ? rows[r][c] + pad : pad + rows[r][c]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
    if (r == 0) {
      std::size_t total = 1;
      for (const auto width : widths)
        total += width + 2;
      text += "  " + std::string(total - 3, '-') + '\n';
    }
  }
  return text;
}

}  // namespace tedit::cli
