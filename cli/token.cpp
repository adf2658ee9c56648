// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/token.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "actors/node/server.hpp"

namespace tedit::cli {

namespace {

expected<std::string> make_token_file(const std::filesystem::path& file) {
  const auto token = make_token();
  if (!token)
    return token;
  std::error_code code;
  std::filesystem::create_directories(file.parent_path(), code);
  const int fd = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (fd < 0)
    return fail(ec::io_error, "cannot make " + file.string() + ": " + std::strerror(errno),
                "Choose another place with --token-file");
  const std::string line = *token + "\n";
  const bool written = write(fd, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  close(fd);
  if (!written)
    return fail(ec::io_error, "cannot write " + file.string());
  return token;
}

}  // namespace

expected<std::string> read_token(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string token;
  if (!(in >> token))
    return fail(ec::io_error, "cannot read the server's token from " + file.string(),
                "Give the file that \"tedit serve\" names, with --token-file");
  if (token.size() < 16)
    return fail(ec::invalid_argument, file.string() + " holds no token: it is too short",
                "Remove it; \"tedit serve\" makes a new one");
  return token;
}

expected<std::string> read_or_make_token(const std::filesystem::path& file) {
  struct stat about {};
  if (stat(file.c_str(), &about) != 0)
    return make_token_file(file);
  if ((about.st_mode & 077) != 0)
    return fail(ec::invalid_argument, "others may read the token in " + file.string(),
                "chmod 600 " + file.string() + ", or remove it: a new one is made");
  return read_token(file);
}

}  // namespace tedit::cli
