// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/box_tree.hpp"

#include <random>

#include <gmock/gmock.h>

namespace tedit {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::size_t> meeting(const box_tree& tree, const box& within) {
  std::vector<std::size_t> result;
  EXPECT_FALSE(tree.any_meeting(within, [&](std::size_t i) {
    result.push_back(i);
    return false;
  }));
  std::ranges::sort(result);
  return result;
}

TEST(BoxTree, FindsTheBoxesThatMeetAndThoseThatTouch) {
  // Cubes of side 1 along x, with gaps of 1.
  std::vector<box> boxes;
  for (int i = 0; i < 10; ++i)
    boxes.push_back({{2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}});
  const box_tree tree(boxes);

  EXPECT_THAT(meeting(tree, {{4.5, 0.5, 0.5}, {8.5, 0.5, 0.5}}), ElementsAre(2, 3, 4));
  EXPECT_THAT(meeting(tree, {{5, 1, 1}, {6, 2, 2}}), ElementsAre(2, 3));
  EXPECT_THAT(meeting(tree, {{5.1, 0, 0}, {5.9, 1, 1}}), IsEmpty());
  EXPECT_EQ(tree.extent(), (box{{0, 0, 0}, {19, 1, 1}}));
}

TEST(BoxTree, FindsEachBoxOnceAmongBoxesOfAllSizes) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto some_box = [&] {
    const double size = std::pow(10, 2 * place(random) - 2);
    const vec3 p{place(random), place(random), place(random)};
    return box{p, p}.grown(size);
  };
  std::vector<box> boxes;
  for (int i = 0; i < 500; ++i)
    boxes.push_back(some_box());
  const box_tree tree(boxes);

  for (int trial = 0; trial < 200; ++trial) {
    const auto within = some_box();
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (boxes[i].meets(within))
        wanted.push_back(i);
    EXPECT_EQ(meeting(tree, within), wanted);
  }
}

TEST(BoxTree, StopsAtTheFirstMatch) {
  const std::vector<box> same(7, box{{0, 0, 0}, {1, 1, 1}});
  int asked = 0;

  EXPECT_TRUE(
    box_tree(same).any_meeting({{0, 0, 0}, {0, 0, 0}}, [&](std::size_t) { return ++asked == 3; }));
  EXPECT_EQ(asked, 3);
}

TEST(BoxTree, OfNothingHasNothing) {
  const box_tree tree({});

  EXPECT_THAT(meeting(tree, {{-1e300, -1e300, -1e300}, {1e300, 1e300, 1e300}}), IsEmpty());
  EXPECT_EQ(tree.extent(), box{});
}

}  // namespace
}  // namespace tedit
