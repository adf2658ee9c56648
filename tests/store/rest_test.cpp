// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents that are open and have no descriptor; and what the system's refusals are called.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <fstream>

#include "tests/store/fixture.hpp"

namespace tedit::store {
namespace {

using Rest = Document;

/// Descriptors of this process that lead into a folder.
int descriptors_in(const fs::path& folder) {
  int count = 0;
  for (const auto& one : fs::directory_iterator("/proc/self/fd")) {
    std::error_code gone;  // The listing's own.
    const auto target = fs::read_symlink(one.path(), gone).string();
    count += target.starts_with(folder.string()) ? 1 : 0;
  }
  return count;
}

TEST_F(Rest, ADocumentThatRestsHasNoDescriptorAndNoLog) {
  const auto doc = open();
  ASSERT_TRUE(doc->commit(make_change(0)));
  EXPECT_EQ(descriptors_in(folder), 4);  // The file, its log, its index, the folder's lock.

  doc->rest();

  EXPECT_EQ(descriptors_in(folder), 1);
  EXPECT_FALSE(fs::exists(file.string() + "-wal"));
  EXPECT_FALSE(fs::exists(file.string() + "-shm"));
}

TEST_F(Rest, ADocumentWakesForWhateverIsAskedOfIt) {
  const auto doc = open();
  doc->rest();
  ASSERT_TRUE(doc->commit(make_change(0)));
  doc->rest();
  EXPECT_TRUE(doc->has_page(make_page(0)->id()));
  doc->rest();
  EXPECT_TRUE(doc->read_page(make_page(0)->id()).has_value());
  doc->rest();
  doc->rest();
  ASSERT_TRUE(doc->commit(make_change(1)));

  const auto all = doc->read();

  ASSERT_TRUE(all.has_value()) << render(all.error());
  EXPECT_EQ(all->versions.size(), 2U);
}

TEST_F(Rest, ManyDocumentsShareOneDescriptor) {
  std::vector<std::unique_ptr<document>> all;
  for (int i = 0; i < 40; ++i) {
    file = folder / (std::to_string(i) + ".tedit");
    all.push_back(open());
    ASSERT_TRUE(all.back()->commit(make_change(0)));
    all.back()->rest();
  }

  EXPECT_EQ(descriptors_in(folder), 1);
  EXPECT_EQ(refusal().code, ec::conflict);
  all.clear();
  EXPECT_EQ(descriptors_in(folder), 0);
  EXPECT_NE(open(), nullptr);
}

/// A process that was there before this one opened anything, and so shares nothing with it. Opens a
/// file when it is asked to, and closes it again.
class other_process {
public:
  explicit other_process(const fs::path& file) {
    EXPECT_EQ(::pipe2(asked_, O_CLOEXEC), 0);
    EXPECT_EQ(::pipe2(answered_, O_CLOEXEC), 0);
    child_ = ::fork();
    if (child_ == 0)
      answer(file);
    ::close(asked_[0]);
    ::close(answered_[1]);
  }
  other_process(const other_process&) = delete;
  other_process& operator=(const other_process&) = delete;
  ~other_process() {
    ::close(asked_[1]);
    ::close(answered_[0]);
    ::waitpid(child_, nullptr, 0);
  }

  /// Why it may not; nothing when it may.
  std::optional<ec> refusal() {
    ec code{};
    EXPECT_EQ(::write(asked_[1], "?", 1), 1);
    EXPECT_EQ(::read(answered_[0], &code, sizeof code), static_cast<ssize_t>(sizeof code));
    return code == ec::usage ? std::nullopt : std::optional(code);
  }

private:
  [[noreturn]] void answer(const fs::path& file) {
    ::close(asked_[1]);
    char question = 0;
    while (::read(asked_[0], &question, 1) == 1) {
      const auto opened = document::open(file);
      const auto code = opened ? ec::usage : opened.error().code;
      if (::write(answered_[1], &code, sizeof code) != static_cast<ssize_t>(sizeof code))
        break;
    }
    ::_exit(0);
  }

  int asked_[2]{};
  int answered_[2]{};
  pid_t child_ = 0;
};

TEST_F(Rest, ADocumentThatRestsIsKeptFromOtherProcesses) {
  other_process same(file);
  other_process next(folder / "next.tedit");
  auto doc = open();
  doc->rest();
  EXPECT_EQ(same.refusal(), ec::conflict);
  EXPECT_EQ(next.refusal(), std::nullopt);

  doc.reset();

  EXPECT_EQ(same.refusal(), std::nullopt);
}

TEST_F(Rest, WhatAnotherProgramDidMeanwhileIsNoticed) {
  const auto doc = open();
  ASSERT_TRUE(doc->commit(make_change(0)));
  doc->rest();
  tamper("UPDATE seal SET rows = 9");

  const auto done = doc->commit(make_change(1));

  ASSERT_FALSE(done.has_value());
  EXPECT_THAT(done.error().message, HasSubstr("changed by another program"));
  doc->rest();
  fs::remove(file);
  const auto gone = doc->commit(make_change(1));
  ASSERT_FALSE(gone.has_value());
  EXPECT_THAT(gone.error().remedy, HasSubstr("are there"));
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(Rest, AProgramOfTheOlderFormatKeepsItsDocument) {
  fs::copy_file(TEDIT_TEST_DATA "/documents/cube_format_1.tedit", file);
  const auto lock = file.string() + "-lock";
  const int theirs = ::open(lock.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
  ASSERT_EQ(::flock(theirs, LOCK_EX | LOCK_NB), 0);

  const auto e = refusal();

  EXPECT_EQ(e.code, ec::conflict);
  EXPECT_THAT(e.message, HasSubstr("older program"));
  EXPECT_EQ(look_up("PRAGMA user_version"), "1");
  ::close(theirs);
  EXPECT_NE(open(), nullptr);
  EXPECT_EQ(look_up("PRAGMA user_version"), "3");
  EXPECT_FALSE(fs::exists(lock));  // They refuse the new format; nobody needs it any more.
}

/// Allows this process no more descriptors than it has, for as long as it lives.
class no_more_descriptors {
public:
  no_more_descriptors() {
    ::getrlimit(RLIMIT_NOFILE, &before_);
    auto now = before_;
    now.rlim_cur = 0;
    ::setrlimit(RLIMIT_NOFILE, &now);
  }
  no_more_descriptors(const no_more_descriptors&) = delete;
  no_more_descriptors& operator=(const no_more_descriptors&) = delete;
  ~no_more_descriptors() { ::setrlimit(RLIMIT_NOFILE, &before_); }

private:
  rlimit before_{};
};

TEST_F(Rest, TooManyOpenFilesAreCalledThat) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers look at memory through a pipe, which cannot be had then";
#endif
  const auto resting = open();
  resting->rest();
  error at_open;
  error at_commit;
  {
    const no_more_descriptors here;
    at_open = document::open(folder / "new.tedit").error();
    at_commit = resting->commit(make_change(0)).error();
  }

  for (const auto& e : {at_open, at_commit}) {
    EXPECT_THAT(e.message, HasSubstr("Too many open files"));
    EXPECT_THAT(e.remedy, HasSubstr("ulimit -n"));
  }
  EXPECT_TRUE(resting->commit(make_change(0)));
}

TEST_F(Rest, MissingPermissionsAreCalledThat) {
  open();
  ::chmod(file.c_str(), 0);
  ::chmod(folder.c_str(), 0755);
  const auto child = ::fork();
  if (child == 0) {
    if (::geteuid() == 0 && ::setuid(65534) != 0)
      ::_exit(9);
    const auto opened = document::open(file);
    const bool said = !opened && opened.error().message.ends_with("Permission denied") &&
                      opened.error().remedy.find("permissions") != std::string::npos;
    ::_exit(said ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace tedit::store
