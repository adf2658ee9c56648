// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/plugin_new.hpp"

#include <array>
#include <fstream>
#include <regex>

#include "base/child_process.hpp"
#include "cli/plugin_templates.hpp"

namespace tedit::cli {

namespace {

namespace fs = std::filesystem;

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// "offset_surface" as a title, "Offset surface", and as a test suite, "OffsetSurface".
std::array<std::string, 2> title_and_suite(const std::string& name) {
  const auto upper = [](char c) { return static_cast<char>(c >= 'a' && c <= 'z' ? c - 32 : c); };
  std::string title = name;
  std::string suite;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] == '_')
      title[i] = ' ';
    else
      suite += i == 0 || name[i - 1] == '_' ? upper(name[i]) : name[i];
  }
  title[0] = upper(title[0]);
  return {title, suite};
}

std::string filled(std::string text, const std::string& name) {
  const auto [title, suite] = title_and_suite(name);
  replace_all(text, "@NAME@", name);
  replace_all(text, "@TITLE@", title);
  replace_all(text, "@SUITE@", suite);
  // Build trees and installations have the same inner order.
  replace_all(text, "@TEDIT_DIR@",
              (executable_folder() / "../lib/cmake/TEdit").lexically_normal().string());
  return text;
}

expected<void> check_name(const std::string& name) {
  static const std::regex snake_case("[a-z][a-z0-9]*(_[a-z0-9]+)*");
  if (!std::regex_match(name, snake_case))
    return fail(ec::usage, "\"" + name + "\" is not snake_case",
                "Use small letters, digits and single underscores, a letter first");
  if (name.size() > 40)
    return fail(ec::usage, "\"" + name + "\" has " + std::to_string(name.size()) + " characters",
                "Take at most 40");
  return {};
}

}  // namespace

expected<new_plugin> make_plugin_folder(const std::string& name, const fs::path& parent) {
  if (auto ok = check_name(name); !ok)
    return fail(ok.error());
  const fs::path folder = (parent / name).lexically_normal();
  std::error_code code;
  if (fs::exists(fs::symlink_status(folder, code)))
    return fail(ec::io_error, folder.string() + " is there already",
                "Choose another name, or another folder with --dir");
  fs::create_directories(folder / "tests", code);
  if (code)
    return fail(ec::io_error, "cannot make " + folder.string() + ": " + code.message(),
                "Choose a folder that you may write to with --dir");
  const std::vector<std::pair<std::string, std::string>> files{
    {"CMakeLists.txt", plugin_templates::cmake},
    {"operation.cpp", plugin_templates::operation},
    {"README.md", std::string(plugin_templates::readme) + plugin_templates::building},
    {"tests/" + name + "_test.cpp", plugin_templates::test}};
  new_plugin made{folder, {}};
  for (const auto& [file, text] : files) {
    std::ofstream out(folder / file);
    out << filled(text, name);
    out.close();
    if (!out) {
      fs::remove_all(folder, code);
      return fail(ec::io_error, "cannot write " + (folder / file).string(),
                  "Make room on the disk, or choose another folder with --dir");
    }
    made.files.push_back(file);
  }
  return made;
}

}  // namespace tedit::cli
