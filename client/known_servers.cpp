// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/known_servers.hpp"

#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "base/system_failure.hpp"
#include "certs/folders.hpp"
#include "tls/context.hpp"

namespace tedit::client {

namespace fs = std::filesystem;

namespace {

/// The lines of a file, with `use(place, fingerprint, line)` for those that name a server.
template <class Use>
expected<void> each_server(const fs::path& file, const std::string& text, Use use) {
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.empty() || line.starts_with('#')) {
      use(std::string(), std::string(), line);
      continue;
    }
    std::istringstream words(line);
    std::string place;
    std::string written;
    words >> place >> written;
    const auto fingerprint = tls::read_fingerprint(written);
    if (fingerprint.empty())
      return fail(ec::bad_input, "a line of the known servers is no \"HOST:PORT SHA256\"",
                  "Mend the line, or take it out", file.string() + ":" + std::to_string(number));
    use(place, fingerprint, line);
  }
  return {};
}

}  // namespace

expected<known_servers> known_servers::of_user() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state == '/')
    return known_servers(fs::path(state) / "tedit/known_servers");
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return known_servers(fs::path(home) / ".local/state/tedit/known_servers");
  return fail(ec::invalid_argument, "neither XDG_STATE_HOME nor HOME is set",
              "Set one of them: the servers that you know are kept below it");
}

/// Empty when there is no file. Who may write to it says which servers are trusted.
expected<std::string> known_servers::content() const {
  struct stat about {};
  if (::stat(file_.c_str(), &about) != 0) {
    if (errno == ENOENT)
      return std::string();
    return system_failure("cannot read " + file_.string(), errno);
  }
  if ((about.st_mode & 022) != 0)
    return fail(ec::invalid_argument, "others may write to " + file_.string(),
                "chmod 600 " + file_.string() + ", and look whether it says what you know");
  std::ifstream in(file_, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in)
    return fail(ec::io_error, "cannot read " + file_.string());
  return text.str();
}

expected<std::string> known_servers::find(const std::string& place) const {
  auto text = content();
  if (!text)
    return text;
  std::string found;
  if (auto ok = each_server(
        file_, *text,
        [&](const std::string& where, const std::string& fingerprint, const std::string&) {
          if (where == place)
            found = fingerprint;
        });
      !ok)
    return fail(ok.error());
  return found;
}

expected<void> known_servers::remember(const std::string& place,
                                       const std::string& fingerprint) const {
  const auto before = content();
  if (!before)
    return fail(before.error());
  std::string text;
  if (auto ok =
        each_server(file_, *before,
                    [&](const std::string& where, const std::string&, const std::string& line) {
                      if (where != place)
                        text += line + "\n";
                    });
      !ok)
    return fail(ok.error());
  std::error_code code;
  if (!fs::exists(file_.parent_path(), code)) {  // Made for its owner alone.
    fs::create_directories(file_.parent_path(), code);
    fs::permissions(file_.parent_path(), fs::perms::owner_all, code);
  }
  return certs::replace_file(file_, text + place + " " + fingerprint + "\n");
}

}  // namespace tedit::client
