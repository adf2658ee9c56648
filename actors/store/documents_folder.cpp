// SPDX-License-Identifier: AGPL-3.0-or-later
#include "actors/store/documents_folder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "actors/store/deletion.hpp"
#include "base/system_failure.hpp"

namespace tedit::store {

namespace {

namespace fs = std::filesystem;

constexpr mode_t others = S_IRWXG | S_IRWXO;

tl::unexpected<error> refused(const std::string& what, int reason) {
  auto failure = system_failure(what, reason);
  failure.value().remedy += "; or choose another folder with --documents";
  return failure;
}

/// Folders that are made are their owner's alone, as the XDG rules want it.
expected<void> make_folder(const fs::path& folder) {
  struct stat about {};
  if (::stat(folder.c_str(), &about) == 0) {
    if (S_ISDIR(about.st_mode))
      return {};
    return refused("cannot use " + folder.string() + " as a folder", ENOTDIR);
  }
  if (folder.has_relative_path())
    if (auto made = make_folder(folder.parent_path()); !made)
      return made;
  if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
    return refused("cannot make the folder " + folder.string(), errno);
  return {};
}

/// A document, or what lies beside one.
bool belongs_to_documents(const std::string& name) {
  return name.ends_with(".tedit") || name.find(".tedit-") != std::string::npos ||
         name == ".tedit-lock";
}

/// Takes from others what they may do with `path`, when it is ours; whether there was anything.
bool close_to_others(const fs::path& path, mode_t kind, mode_t wanted) {
  struct stat about {};
  return ::lstat(path.c_str(), &about) == 0 && (about.st_mode & S_IFMT) == kind &&
         about.st_uid == ::geteuid() && (about.st_mode & others) != 0 &&
         ::chmod(path.c_str(), wanted) == 0;
}

constexpr auto draft_suffix = ".tedit-adding";

/// With what SQLite made beside it.
bool is_draft(const std::string& name) {
  return name.starts_with('.') && name.find(draft_suffix) != std::string::npos;
}

}  // namespace

fs::path draft_of(const fs::path& file) {
  return file.parent_path() / ("." + file.stem().string() + draft_suffix);
}

expected<void> check_writable(const fs::path& folder) {
  std::error_code code;
  auto there = fs::absolute(folder, code);
  while (!fs::exists(there, code) && there.has_relative_path())
    there = there.parent_path();
  auto name = (there / ".tedit-check-XXXXXX").string();
  const int opened = ::mkostemp(name.data(), O_CLOEXEC);
  if (opened < 0)
    return refused("cannot write in " + there.string(), errno);
  const bool written = ::write(opened, "x", 1) == 1;
  const int reason = errno;
  ::close(opened);
  ::unlink(name.c_str());
  if (!written)
    return refused("cannot write in " + there.string(), reason);
  return {};
}

expected<std::vector<std::string>> prepare_documents_folder(const fs::path& folder) {
  std::error_code code;
  if (auto ready =
        make_folder(fs::absolute(folder, code)).and_then([&] { return check_writable(folder); });
      !ready)
    return fail(ready.error());
  std::vector<std::string> news;
  bool only_documents = true;
  int closed = 0;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    if (is_draft(entry.path().filename().string()))
      ::unlink(entry.path().c_str());
    else if (is_erased(entry.path()))
      finish_erasing(entry.path());
    else if (belongs_to_documents(entry.path().filename().string()))
      closed += close_to_others(entry.path(), S_IFREG, 0600) ? 1 : 0;
    else
      only_documents = false;
  }
  struct stat about {};
  const bool open_to_others = ::stat(folder.c_str(), &about) == 0 && (about.st_mode & others) != 0;
  if (closed > 0)
    news.push_back("others could read " + std::to_string(closed) + " files in " + folder.string() +
                   "; they are 0600 now");
  if (open_to_others && only_documents && close_to_others(folder, S_IFDIR, 0700))
    news.push_back("others could look into " + folder.string() + "; it is 0700 now");
  else if (open_to_others)
    news.push_back("others can look into " + folder.string() +
                   ", which holds more than documents; close it with chmod 700");
  return news;
}

}  // namespace tedit::store
