// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/former_names.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <fstream>
#include <span>
#include <sstream>

#include "actors/store/document_file.hpp"
#include "base/system_failure.hpp"
#include "base/unique_fd.hpp"

namespace tedit::store {

namespace {

namespace fs = std::filesystem;

constexpr auto file_name = ".tedit-names";  // A line each: seconds since 1970, before, now.
constexpr off_t most_bytes = 64 * 1024;     // Then all is forgotten: a thousand renames a day.
constexpr std::size_t longest_line = 256;
constexpr auto nowhere = ".";  // No document's name.

struct name_note {
  std::int64_t at = 0;
  std::string before;
  std::string now;
};

std::int64_t seconds_now() {
  return std::int64_t{std::time(nullptr)};
}

/// What is not whole, as of a machine that stopped, is left out.
std::vector<name_note> read_notes(const fs::path& folder) {
  std::vector<name_note> all;
  const auto path = folder / file_name;
  std::error_code code;
  if (const auto bytes = fs::file_size(path, code); code || bytes > 2 * std::size_t{most_bytes})
    return all;  // It is not ours.
  std::ifstream in(path);
  std::string line;
  const auto oldest =
    seconds_now() - std::chrono::duration_cast<std::chrono::seconds>(former_name_stays).count();
  while (std::getline(in, line)) {
    std::istringstream words(line);
    name_note one;
    std::string end;
    if (line.size() <= longest_line && words >> one.at >> one.before >> one.now >> end &&
        end == "." && one.at >= oldest && one.at <= seconds_now())
      all.push_back(std::move(one));
  }
  return all;
}

/// Errors: `io_error`.
expected<void> append_note(const fs::path& folder, const std::string& before,
                           const std::string& now) {
  const auto path = folder / file_name;
  const auto refused = [&] { return system_failure("cannot write " + path.string(), errno); };
  const unique_fd out(
    ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0600));
  struct stat about {};
  if (!out || ::fstat(out.get(), &about) != 0)
    return refused();
  if (about.st_size > most_bytes && ::ftruncate(out.get(), 0) != 0)
    return refused();
  // One write: two renames at once do not mix. It begins a line after one that is cut off.
  const auto line = "\n" + std::to_string(seconds_now()) + " " + before + " " + now + " .\n";
  if (!write_all(out.get(), std::as_bytes(std::span(line))) || ::fsync(out.get()) != 0)
    return refused();
  return {};
}

}  // namespace

expected<void> note_former_name(const fs::path& before, const fs::path& now) {
  return append_note(before.parent_path(), before.stem().string(), now.stem().string());
}

expected<void> note_deleted_name(const fs::path& file) {
  return append_note(file.parent_path(), file.stem().string(), nowhere);
}

std::vector<std::pair<std::string, std::string>> read_former_names(const fs::path& folder) {
  std::vector<std::pair<std::string, std::string>> names;
  const auto is_there = [&](const std::string& name) {
    std::error_code code;
    return fs::exists(fs::symlink_status(folder / (name + ".tedit"), code));
  };
  for (const auto& one : read_notes(folder)) {
    const bool deleted = one.now == nowhere;
    std::erase_if(names, [&](const auto& known) {
      return known.first == one.before || known.first == one.now ||
             (deleted && known.second == one.before);
    });
    if (deleted)
      continue;
    for (auto& known : names)
      if (known.second == one.before)
        known.second = one.now;
    names.emplace_back(one.before, one.now);
  }
  std::erase_if(
    names, [&](const auto& known) { return is_there(known.first) || !is_there(known.second); });
  return names;
}

}  // namespace tedit::store
