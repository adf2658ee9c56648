// SPDX-License-Identifier: AGPL-3.0-or-later
// Disks that refuse writes, lose them or are full: what is not on disk is not acknowledged, and
// nothing that was is lost.
#include "tests/scenarios/served.hpp"

namespace tedit::test {
namespace {

using ::testing::AnyOf;

class FailingDisk : public ::testing::TestWithParam<const char*> {
protected:
  scratch_folder folder;
  std::filesystem::path fault = folder.path() / "fault";

  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers want to be loaded first";
#endif
    setenv("LD_PRELOAD", TEDIT_FAILING_DISK, 1);
    setenv("TEDIT_DISK_FAULT", fault.c_str(), 1);
  }
  void TearDown() override {
    unsetenv("LD_PRELOAD");
    unsetenv("TEDIT_DISK_FAULT");
  }

  /// Begins a fault whole or not at all: the server may look at any moment.
  void begin(const std::string& what) const {
    const auto draft = fault.string() + "-new";
    std::ofstream(draft) << what;
    std::filesystem::rename(draft, fault);
  }
};

INSTANTIATE_TEST_SUITE_P(Faults, FailingDisk, ::testing::Values("write", "sync", "full"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(FailingDisk, AcknowledgesOnlyWhatItKeeps) {
  std::string kept;
  {
    served host(folder);
    auto user = host.connect();
    value(user->open("plate", false, false));
    value(user->import_file(plate_mesh, "mm", {}));
    const auto first = value(user->edit("fill_hole", {1, 2}, {}, {}));

    begin(GetParam());
    for (int attempt = 0; attempt < 3; ++attempt) {
      const auto refused = user->edit("fill_hole", {51, 52}, {}, {});
      ASSERT_FALSE(refused.has_value());
      EXPECT_THAT(refused.error().code, AnyOf(ec::storage_error, ec::io_error))
        << render(refused.error());
      EXPECT_FALSE(refused.error().remedy.empty()) << render(refused.error());
    }
    const auto versions = value(user->get_history());
    EXPECT_EQ(versions.head, first.head.number);
    EXPECT_EQ(versions.versions.size(), 2U);

    std::filesystem::remove(fault);
    kept = value(user->edit("fill_hole", {51, 52}, {}, {})).head.version_id;
    host.kill();
  }
  served host(folder);
  auto user = host.connect();
  const auto state = value(user->open("plate", false, false));
  ASSERT_TRUE(state.head.has_value());
  EXPECT_EQ(state.head->version_id, kept);
  EXPECT_EQ(value(user->get_history()).versions.size(), 3U);
}

}  // namespace
}  // namespace tedit::test
