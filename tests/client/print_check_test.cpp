// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/print_check.hpp"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/messages.hpp"

namespace tedit::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Facets 4 and 9 with these marks.
incoming_stream stream_of(const std::string& marks) {
  const std::uint32_t facets[] = {4, 9};
  std::string bytes(8, '\0');
  std::memcpy(bytes.data(), facets, 8);
  bytes += marks;
  auto stream = incoming_stream::begin(
    {1,
     bytes.size(),
     {{"facets", array_type::u32, 1, 2, {}}, {"marks", array_type::u8, 1, marks.size(), {}}}},
    0);
  EXPECT_TRUE(stream->append(0, bytes, 0).has_value());
  return std::move(*stream);
}

TEST(ReadPrintCheck, EachFacetHasItsMark) {
  v1::PrintChecked message;
  message.set_version(3);
  message.set_version_id("abc");
  message.set_thin_places(1001);
  message.set_overhanging_places(2);
  message.set_open_edges(5);
  const auto got = read_print_check(message, stream_of({'\1', '\3'}));

  ASSERT_TRUE(got.has_value()) << render(got.error());
  EXPECT_EQ(got->version, 3U);
  EXPECT_EQ(got->version_id, "abc");
  EXPECT_EQ(got->thin_places, 1001U);
  EXPECT_EQ(got->overhanging_places, 2U);
  EXPECT_FALSE(got->what.watertight());
  EXPECT_THAT(got->facets, ElementsAre(4, 9));
  EXPECT_THAT(got->marks, ElementsAre(print_mark::thin, print_mark::both));
}

TEST(ReadPrintCheck, WhatDoesNotFitIsRefused) {
  for (const auto* marks : {"\1", "\1\2\3", "\1\4"}) {
    const auto got = read_print_check({}, stream_of(marks));
    ASSERT_FALSE(got.has_value());
    EXPECT_EQ(got.error().code, ec::protocol_error);
    EXPECT_THAT(got.error().message, HasSubstr("do not fit to its 2 facets"));
  }
  EXPECT_FALSE(read_print_check({}, stream_of({'\0', '\1'})).has_value()) << "sound is no mark";
}

}  // namespace
}  // namespace tedit::client
