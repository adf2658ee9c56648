// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/token.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "base/random_token.hpp"
#include "base/system_failure.hpp"

namespace tedit::cli {

namespace {

expected<std::string> make_token_file(const std::filesystem::path& file) {
  auto token = make_token();
  if (!token)
    return token;
  std::error_code code;
  if (!std::filesystem::exists(file.parent_path(), code)) {  // Made for its owner alone.
    std::filesystem::create_directories(file.parent_path(), code);
    std::filesystem::permissions(file.parent_path(), std::filesystem::perms::owner_all, code);
  }
  const int fd = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (fd < 0)
    return system_failure("cannot make " + file.string(), errno);
  const std::string line = *token + "\n";
  const bool written = write(fd, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  const int reason = errno;
  close(fd);
  if (!written) {
    unlink(file.c_str());  // Half a token would be taken for one.
    return system_failure("cannot write " + file.string(), reason);
  }
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
  return read_private_token(file);
}

expected<std::string> read_private_token(const std::filesystem::path& file) {
  struct stat about {};
  if (stat(file.c_str(), &about) != 0)
    return system_failure("cannot read " + file.string(), errno);
  if ((about.st_mode & 077) != 0)
    return fail(ec::invalid_argument, "others may read the token in " + file.string(),
                "chmod 600 " + file.string() + ", or remove it: a new one is made");
  return read_token(file);
}

}  // namespace tedit::cli
