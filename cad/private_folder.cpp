// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cad/private_folder.hpp"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace tedit::cad {

namespace {

namespace fs = std::filesystem;

/// Those of processes that were killed.
void remove_left_ones(std::string_view prefix) {
  std::error_code code;
  for (const auto& item : fs::directory_iterator(fs::temp_directory_path(code), code)) {
    const auto name = item.path().filename().string();
    if (!name.starts_with(prefix))
      continue;
    const pid_t owner = std::atoi(name.c_str() + prefix.size());
    struct stat about {};
    if (owner > 0 && kill(owner, 0) != 0 && errno == ESRCH &&
        lstat(item.path().c_str(), &about) == 0 && S_ISDIR(about.st_mode) &&
        about.st_uid == geteuid())
      fs::remove_all(item.path(), code);
  }
}

}  // namespace

private_folder::private_folder(std::string_view prefix) {
  std::error_code code;
  remove_left_ones(prefix);
  std::string name = (fs::temp_directory_path(code) / prefix).string();
  // As long for each process: Gmsh's mesh depends on where things lie in memory.
  const auto number = std::to_string(getpid());
  name += std::string(7 - std::min<std::size_t>(7, number.size()), '0') + number + "-XXXXXX";
  if (!code && mkdtemp(name.data()) != nullptr)
    path_ = name;
}

private_folder::~private_folder() {
  std::error_code code;
  if (!path_.empty())
    fs::remove_all(path_, code);
}

error no_private_folder() {
  return {ec::io_error,
          std::string("no temporary folder can be made: ") + std::strerror(errno),
          "Set TMPDIR to a folder with room that you may write to",
          {}};
}

}  // namespace tedit::cad
