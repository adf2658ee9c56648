// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/io/file.hpp"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>

#include "base/system_failure.hpp"

namespace tedit {

namespace fs = std::filesystem;

namespace {

tl::unexpected<error> io_failure(const std::string& what, const fs::path& path,
                                 const std::string& reason) {
  return fail(ec::io_error, what + " " + path.string() + ": " + reason, "Check the path");
}

tl::unexpected<error> io_failure(const std::string& what, const fs::path& path, int reason) {
  return system_failure(what + " " + path.string(), reason);
}

}  // namespace

expected<std::vector<char>> read_file(const fs::path& path) {
  std::error_code code;
  const auto status = fs::status(path, code);
  if (!fs::exists(status))
    return io_failure("cannot read", path, "there is no such file");
  if (!fs::is_regular_file(status))
    return io_failure("cannot read", path, "it is no regular file");
  const auto size = fs::file_size(path, code);
  std::ifstream in(path, std::ios::binary);
  if (code || !in)
    return io_failure("cannot read", path, code ? code.value() : errno);
  std::vector<char> bytes(size);
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(in.gcount()) != size)
    return io_failure("cannot read", path, "it ended early");
  return bytes;
}

expected<void> file_target::write(const std::function<void(std::ostream&)>& write) const {
  if (!memory_)
    return write_file(path_, write);
  std::ostringstream out(std::ios::binary);
  write(out);
  if (!out)
    return fail(ec::out_of_memory, "there is no memory to write the file in");
  *memory_ = std::move(out).str();
  return {};
}

expected<void> write_file(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  std::error_code code;
  if (path.has_parent_path())
    fs::create_directories(path.parent_path(), code);
  const fs::path temporary = path.string() + ".part" + std::to_string(getpid());
  {
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    if (!out)
      return io_failure("cannot write", path, errno);
    write(out);
    out.flush();
    if (!out) {
      const int reason = errno;
      fs::remove(temporary, code);
      return io_failure("cannot write", path, reason);
    }
  }
  fs::rename(temporary, path, code);
  if (code) {
    const int reason = code.value();
    fs::remove(temporary, code);
    return io_failure("cannot write", path, reason);
  }
  return {};
}

}  // namespace tedit
