// SPDX-License-Identifier: AGPL-3.0-or-later
#include <gtest/gtest.h>

#include "client-qt/model/version_store.hpp"

namespace tedit::desktop {
namespace {

client::version_info version(std::uint32_t number, const std::string& id) {
  client::version_info result;
  result.number = number;
  result.version_id = id;
  return result;
}

TEST(VersionStore, TheHeadIsFoundBeforeAnOlderOneWithTheSameContent) {
  version_store versions;
  versions.take_info(version(0, "a"));
  versions.take_info(version(1, "b"));
  versions.take_info(version(2, "a"));

  EXPECT_EQ(versions.find("a")->info.number, 2U);
  versions.set_head(0);  // As undo does it.
  EXPECT_EQ(versions.find("a")->info.number, 0U);
  EXPECT_EQ(versions.find("c"), nullptr);
}

TEST(VersionStore, WhatWasHeldOfAnotherVersionWithTheNumberIsDropped) {
  version_store versions;
  versions.take_info(version(1, "a")).report = edit_report{};

  EXPECT_TRUE(versions.take_info(version(1, "a")).report.has_value());
  EXPECT_FALSE(versions.take_info(version(1, "b")).report.has_value());
}

TEST(VersionStore, ANameThatWasToldSinceTheHistoryWasAskedForIsNewer) {
  version_store versions;
  versions.take_info(version(1, "a"));
  const int known = versions.annotations();
  auto named = version(1, "a");
  named.name = "closed";
  ASSERT_TRUE(versions.take_annotation(named));
  client::history late;
  late.versions = {version(0, "z"), version(1, "a")};

  versions.take_history(late, known);

  EXPECT_EQ(versions.all().at(1).info.name, "closed");
  EXPECT_EQ(versions.all().at(0).info.version_id, "z");
  EXPECT_FALSE(versions.take_annotation(version(7, "a"))) << "of a version that is not known";
}

}  // namespace
}  // namespace tedit::desktop
