// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/system_failure.hpp"

#include <cerrno>
#include <system_error>

namespace tedit {

namespace {

const char* remedy_for(int error_number) {
  switch (error_number) {
    case EMFILE:
      return "This process has too many files open: start it with a higher limit (ulimit -n)";
    case ENFILE:
      return "The system has too many files open: end other programs or raise fs.file-max";
    case ENOSPC:
      return "The disk is full: free some space and try again";
    case EDQUOT:
      return "Your disk quota is used up: free some space and try again";
    case EACCES:
    case EPERM:
      return "Check the permissions and the owner of the file and its folder";
    case EROFS:
      return "The file system is mounted read-only: choose a folder that can be written";
    case ENOENT:
    case ENOTDIR:
      return "Check that the file and its folder are there";
    case EIO:
      return "The disk failed: check it, and restore the file from a backup";
    default:
      return "Check the path, its permissions and the disk";
  }
}

}  // namespace

tl::unexpected<error> system_failure(const std::string& what, int error_number) {
  return fail(ec::io_error, what + ": " + std::generic_category().message(error_number),
              remedy_for(error_number));
}

}  // namespace tedit
