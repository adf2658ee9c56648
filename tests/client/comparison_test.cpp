// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/comparison.hpp"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/messages.hpp"

namespace tedit::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Two vertices, their marks, and the difference of the stress at `rows` of them.
incoming_stream stream_of(const std::string& marks, std::uint64_t rows) {
  const std::uint32_t vertices[] = {4, 9};
  const float stress[] = {1.5F, -2.5F};
  std::string bytes(8 + marks.size() + 4 * rows, '\0');
  std::memcpy(bytes.data(), vertices, 8);
  std::memcpy(bytes.data() + 8, marks.data(), marks.size());
  std::memcpy(bytes.data() + 8 + marks.size(), stress, 4 * rows);
  auto stream =
    incoming_stream::begin({1,
                            bytes.size(),
                            {{"vertices", array_type::u32, 1, 2, {}},
                             {"difference_mark", array_type::u8, 1, marks.size(), {}},
                             {"von_mises_pa_difference", array_type::f32, 1, rows, {}}}},
                           0);
  EXPECT_TRUE(stream->append(0, bytes, 0).has_value());
  return std::move(*stream);
}

v1::VersionsCompared message_of() {
  v1::VersionsCompared message;
  message.set_before(3);
  message.set_after(1);
  message.set_load_case("pull");
  message.set_tets_in_common(77);
  return message;
}

TEST(ReadComparison, EachVertexHasItsMarkAndItsDifference) {
  const auto got = read_comparison(message_of(), stream_of({'\1', '\2'}, 2));

  ASSERT_TRUE(got.has_value()) << render(got.error());
  EXPECT_EQ(got->before, 3U);
  EXPECT_EQ(got->after, 1U);
  EXPECT_EQ(got->load_case, "pull");
  EXPECT_EQ(got->what.tets_in_common, 77U);
  EXPECT_THAT(got->vertices, ElementsAre(4, 9));
  EXPECT_THAT(got->marks, ElementsAre(difference_mark::interpolated, difference_mark::outside));
  EXPECT_THAT(got->differences.of("von_mises_pa"), ElementsAre(1.5F, -2.5F));
  EXPECT_THAT(got->differences.of("displacement_m"), IsEmpty());
}

TEST(ReadComparison, WhatDoesNotFitIsRefused) {
  for (const auto& [stream, why] : std::vector<std::pair<incoming_stream, const char*>>{
         {stream_of({'\1'}, 2), "marks do not fit to its 2 vertices"},
         {stream_of({'\0', '\3'}, 2), "marks do not fit"},
         {stream_of({'\0', '\1'}, 1), "2 vertices and 1 values of von_mises_pa"}}) {
    const auto got = read_comparison(message_of(), stream);
    ASSERT_FALSE(got.has_value()) << why;
    EXPECT_EQ(got.error().code, ec::protocol_error);
    EXPECT_THAT(got.error().message, HasSubstr(why));
  }
}

}  // namespace
}  // namespace tedit::client
