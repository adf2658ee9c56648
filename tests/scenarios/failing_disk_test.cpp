// SPDX-License-Identifier: AGPL-3.0-or-later
// Disks that refuse writes, lose them or are full: what is not on disk is not acknowledged, and
// nothing that was is lost.
#include "tests/scenarios/disk_fault.hpp"

namespace tedit::test {
namespace {

using ::testing::AnyOf;

class FailingDisk : public ::testing::TestWithParam<const char*> {
protected:
  scratch_folder folder;
  disk_fault fault{folder};

  void SetUp() override {
    if (!disk_fault::possible)
      GTEST_SKIP() << "sanitizers want to be loaded first";
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

    fault.begin(GetParam());
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

    fault.end();
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
