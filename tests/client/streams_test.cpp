// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/streams.hpp"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedit::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Three numbers of 4 bytes, then two of 8.
stream_header header_of(std::uint64_t bytes, std::optional<std::uint64_t> first = {},
                        std::optional<std::uint64_t> second = {}) {
  return {
    1, bytes, {{"slots", array_type::u32, 1, 3, first}, {"x", array_type::f64, 1, 2, second}}};
}

std::string content(std::size_t gap) {
  const std::uint32_t slots[] = {7, 8, 9};
  const double x[] = {0.25, -1};
  std::string bytes(sizeof(slots) + gap + sizeof(x), '\0');
  std::memcpy(bytes.data(), slots, sizeof(slots));
  std::memcpy(bytes.data() + sizeof(slots) + gap, x, sizeof(x));
  return bytes;
}

void expect_read(stream_header header, const std::string& bytes) {
  auto stream = incoming_stream::begin(std::move(header), 0);
  ASSERT_TRUE(stream.has_value()) << render(stream.error());
  ASSERT_TRUE(stream->append(0, bytes, 0).has_value());
  ASSERT_TRUE(stream->complete());
  EXPECT_THAT(*stream->u32("slots", 1), ElementsAre(7, 8, 9));
  EXPECT_THAT(*stream->f64("x", 1), ElementsAre(0.25, -1));
}

TEST(Streams, ArraysOfOlderServersFollowEachOther) {
  expect_read(header_of(28), content(0));
}

TEST(Streams, ArraysAreReadWhereTheServerSays) {
  expect_read(header_of(32, 0, 16), content(4));
}

TEST(Streams, ArraysThatCannotBeAreRefused) {
  for (const auto& [header, why] : std::vector<std::pair<stream_header, const char*>>{
         {header_of(32), "end at 28"},
         {header_of(32, 0, 8), "inside the one before"},
         {header_of(28, 0, 16), "end at 32"},
         {header_of(32, 0, ~std::uint64_t{0}), "larger than"}}) {
    const auto stream = incoming_stream::begin(header, 0);
    ASSERT_FALSE(stream.has_value()) << why;
    EXPECT_THAT(stream.error().message, HasSubstr(why));
  }
}

}  // namespace
}  // namespace tedit::client
