// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/catalogue.hpp"

#include <gtest/gtest.h>

namespace tedit::desktop {
namespace {

TEST(Catalogue, AnOperationIsFoundByItsId) {
  ops::operation_description about;
  about.id = "try_all";
  about.name = "Try all";
  const auto all = translated({{{about, "plug 1.0.0"}}, {{"bad.so", "too new"}}});

  ASSERT_NE(all.find("try_all"), nullptr);
  EXPECT_EQ(all.find("try_all")->about.name, "Try all");  // No word of ours: left as it is.
  EXPECT_EQ(all.find("other"), nullptr);
  ASSERT_EQ(all.refused.size(), 1U);
}

}  // namespace
}  // namespace tedit::desktop
