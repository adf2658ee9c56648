// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/place_text.hpp"

#include <gtest/gtest.h>

namespace {

TEST(PlaceText, IsInMillimetresWithoutRoundingErrors) {
  EXPECT_EQ(tedit::place_text({0.0015, -0.002, 1.25}), "(1.5, -2, 1250) mm");
  EXPECT_EQ(tedit::place_text({6.722e-18, -1e-12, 0.004518}), "(0, 0, 4.518) mm");
  EXPECT_EQ(tedit::place_text({2e-9, 0, 0}), "(2e-06, 0, 0) mm");
}

}  // namespace
