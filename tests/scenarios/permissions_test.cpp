// SPDX-License-Identifier: AGPL-3.0-or-later
// What a server leaves on the disk is its owner's alone, whatever the umask.
#include <sys/stat.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

namespace fs = std::filesystem;

unsigned mode_of(const fs::path& path) {
  struct stat about {};
  return ::lstat(path.c_str(), &about) == 0 ? about.st_mode & 07777 : 0;
}

/// Nothing is withheld by the umask while it lives.
class open_umask {
public:
  open_umask() : before_(::umask(0)) {}
  open_umask(const open_umask&) = delete;
  open_umask& operator=(const open_umask&) = delete;
  ~open_umask() { ::umask(before_); }

private:
  mode_t before_;
};

class Permissions : public ::testing::Test {
protected:
  Permissions() { options.documents = folder.path() / "state/documents"; }

  void edit_something() {
    const auto host = start(options);
    const auto user = connect(host->url());
    value(user->open("plate", false, false));
    value(user->import_file(plate_mesh, "mm", {}));
    expect_private();  // With the files that are there while it is in use.
  }

  void expect_private() const {
    EXPECT_EQ(mode_of(options.documents), 0700U);
    int files = 0;
    for (const auto& entry : fs::directory_iterator(options.documents)) {
      EXPECT_EQ(mode_of(entry.path()), 0600U) << entry.path();
      ++files;
    }
    EXPECT_GE(files, 2);  // A document and the lock at least.
  }

  const open_umask none;
  const scratch_folder folder;
  server_options options = options_for(folder, false);
};

TEST_F(Permissions, NewFoldersAndFilesAreTheirOwnersAlone) {
  edit_something();

  expect_private();
  EXPECT_EQ(mode_of(folder.path() / "state"), 0700U);
}

TEST_F(Permissions, ThoseFromBeforeBecomeSo) {
  edit_something();
  fs::permissions(options.documents, fs::perms::all);
  for (const auto& entry : fs::directory_iterator(options.documents))
    fs::permissions(entry.path(), fs::perms(0644));

  (void)start(options);

  expect_private();
}

TEST_F(Permissions, AFolderWithOtherThingsKeepsItsOwnAndItsDocumentsAreClosed) {
  edit_something();
  fs::permissions(options.documents, fs::perms(0755));
  fs::permissions(options.documents / "plate.tedit", fs::perms(0644));
  std::ofstream(options.documents / "letter.txt") << "for all";

  (void)start(options);

  EXPECT_EQ(mode_of(options.documents), 0755U);
  EXPECT_EQ(mode_of(options.documents / "plate.tedit"), 0600U);
  EXPECT_EQ(mode_of(options.documents / "letter.txt"), 0666U);
}

TEST_F(Permissions, ADocumentThatIsPutThereLaterIsClosedWhenItIsOpened) {
  edit_something();
  const auto host = start(options);
  fs::copy_file(options.documents / "plate.tedit", options.documents / "copy.tedit");
  fs::permissions(options.documents / "copy.tedit", fs::perms(0644));

  EXPECT_TRUE(value(connect(host->url())->open("copy", false, false)).head.has_value());

  EXPECT_EQ(mode_of(options.documents / "copy.tedit"), 0600U);
}

const bool has_med = fs::exists(TEDIT_BIN "/tedit-med");  // Where libmed was.

/// A worker may start no program: its keeper starts the one that has libmed in it.
TEST(Exports, MedGoesThroughConfinedWorkersBothWays) {
  if (!has_med)
    GTEST_SKIP() << "built without libmed";
  const scratch_folder folder;
  const auto host = start(options_for(folder, true));
  const auto user = connect(host->url());
  value(user->open("plate", false, false));
  const auto plate = value(user->import_file(plate_mesh, "mm", {}));
  const auto med = value(user->export_file("med", "", "mm", {}));
  const auto file = folder.path() / "plate.med";
  std::ofstream(file, std::ios::binary).write(med.data(), static_cast<std::streamsize>(med.size()));

  value(user->open("again", false, false));
  const auto again = value(user->import_file(file, "mm", {}));

  EXPECT_EQ(again.head.tets, plate.head.tets);
  EXPECT_EQ(again.head.boundary_facets, plate.head.boundary_facets);
  std::ofstream(file, std::ios::binary) << "\x89HDF\r\n\x1a\n and no more";
  const auto broken = user->import_file(file, "mm", {});
  ASSERT_FALSE(broken.has_value());
  EXPECT_EQ(broken.error().message, "the head of the HDF5 file is cut off or damaged");
}

/// Nothing that a worker could leave when it dies: files are written in memory.
TEST(Exports, LeaveNothingInTheTemporaryFolder) {
  const scratch_folder folder;
  const scratch_folder temporary;
  ::setenv("TMPDIR", temporary.path().c_str(), 1);
  auto options = options_for(folder, true);
  const auto host = start(options);
  ::unsetenv("TMPDIR");
  const auto user = connect(host->url());
  value(user->open("plate", false, false));
  value(user->import_file(plate_mesh, "mm", {}));
  std::atomic<bool> done = false;
  std::atomic<int> seen = 0;
  std::thread watcher([&] {
    while (!done)
      for (const auto& entry : fs::directory_iterator(temporary.path()))
        seen += entry.path().filename().string().starts_with("tedit-export") ? 1 : 0;
  });

  for (const auto format : written_formats())
    if (format != "med" || has_med) {
      EXPECT_GT(value(user->export_file(std::string(format), {}, "mm", {})).size(), 1000U);
    }

  done = true;
  watcher.join();
  EXPECT_EQ(seen, 0);
}

}  // namespace
}  // namespace tedit::test
