// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/commands.hpp"

#include <gtest/gtest.h>

namespace tedit::desktop {
namespace {

command make(const QString& id, const QString& title, bool enabled = true) {
  return {id, title, "Group", {}, [] {}, [enabled] { return enabled; }};
}

TEST(FuzzyScore, WantsAllLettersInTheirOrder) {
  EXPECT_TRUE(fuzzy_score("fh", "Fill hole").has_value());
  EXPECT_TRUE(fuzzy_score("", "Fill hole").has_value());
  EXPECT_FALSE(fuzzy_score("hf", "Fill hole").has_value());
  EXPECT_FALSE(fuzzy_score("fillx", "Fill hole").has_value());
}

TEST(FuzzyScore, StartsOfWordsAndRunsCountMore) {
  EXPECT_GT(fuzzy_score("fh", "Fill hole"), fuzzy_score("fh", "Half a shell of it, h"));
  EXPECT_GT(fuzzy_score("hol", "Fill hole"), fuzzy_score("hol", "Show or like"));
}

TEST(Commands, SearchPutsTheBestFirstAndEnabledBeforeDisabled) {
  commands all;
  all.add(make("a", "Show the mesh"));
  all.add(make("b", "Fit", false));
  all.add(make("c", "Fit"));

  const auto hits = all.search("fit");

  ASSERT_EQ(hits.size(), 2U);
  EXPECT_EQ(hits[0]->id, "c");
  EXPECT_EQ(hits[1]->id, "b");
}

TEST(Commands, ADisabledOrUnknownOneIsNotRun) {
  commands all;
  int runs = 0;
  auto one = make("a", "A", false);
  one.run = [&] { ++runs; };
  all.add(one);

  EXPECT_FALSE(all.trigger("a"));
  EXPECT_FALSE(all.trigger("b"));
  EXPECT_EQ(runs, 0);
}

TEST(Commands, ACommandMayChangeTheListWhileItRuns) {
  commands all;
  auto one = make("a", "A");
  one.run = [&] { all.remove_group("Group"); };
  all.add(one);

  EXPECT_TRUE(all.trigger("a"));
  EXPECT_TRUE(all.all().empty());
}

}  // namespace
}  // namespace tedit::desktop
