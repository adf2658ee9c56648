// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/units.hpp"

#include <gtest/gtest.h>

namespace tedit {

TEST(Units, LengthsConvertToMetres) {
  EXPECT_EQ(*metres_per_unit("mm"), 1e-3);
  EXPECT_EQ(*metres_per_unit("in"), 0.0254);
  EXPECT_EQ(*metres_per_unit("m"), 1.0);
}

TEST(Units, UnknownUnitNamesTheKnownOnes) {
  const auto unit = metres_per_unit("furlong");

  ASSERT_FALSE(unit.has_value());
  EXPECT_EQ(unit.error().code, ec::invalid_argument);
  EXPECT_NE(unit.error().remedy.find("mm"), std::string::npos);
}

}  // namespace tedit
