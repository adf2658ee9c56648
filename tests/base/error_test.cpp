// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/error.hpp"

#include <gtest/gtest.h>

namespace tedit {

TEST(Error, EveryCodeHasItsOwnName) {
  for (int code = 0; code <= static_cast<int>(ec::untrusted_server); ++code)
    EXPECT_EQ(code_from_name(code_name(static_cast<ec>(code))), static_cast<ec>(code)) << code;
}

TEST(Error, UnknownNameIsInternal) {
  EXPECT_EQ(code_from_name("no_such_code"), ec::internal);
}

TEST(Error, RenderShowsMessagePlaceAndRemedy) {
  const error e{ec::bad_input, "node 7 is missing", "Mesh the part again", "line 12"};

  EXPECT_EQ(render(e), "node 7 is missing [line 12]. Mesh the part again");
}

TEST(Error, RenderLeavesOutWhatIsEmpty) {
  EXPECT_EQ(render({ec::timeout, "took too long", {}, {}}), "took too long");
}

TEST(Error, ExitStatusFollowsTheDocumentedTable) {
  EXPECT_EQ(exit_status(ec::usage), 2);
  EXPECT_EQ(exit_status(ec::bad_input), 65);
  EXPECT_EQ(exit_status(ec::unsupported_format), 65);
  EXPECT_EQ(exit_status(ec::service_unavailable), 69);
  EXPECT_EQ(exit_status(ec::device_unavailable), 69);
  EXPECT_EQ(exit_status(ec::device_lost), 1);
  EXPECT_EQ(exit_status(ec::cancelled), 130);
  EXPECT_EQ(exit_status(ec::under_constrained), 1);
}

}  // namespace tedit
