// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/text_fields.hpp"

#include <gtest/gtest.h>

#include "tedit/v1/envelope.pb.h"

namespace tedit::protocol {
namespace {

TEST(TextFields, EveryTextOfAMessageBecomesUtf8) {
  v1::ServerMessage message;
  auto* commit = message.mutable_committed();
  commit->set_cause("\xFC");
  commit->add_warnings("fine");
  commit->add_warnings(
    "S\xFC"
    "d");
  commit->mutable_report()->add_surface_map()->set_name("\x80");
  EXPECT_FALSE(has_valid_text(message));

  make_text_valid(message);

  EXPECT_TRUE(has_valid_text(message));
  EXPECT_EQ(commit->cause(), "\uFFFD");
  EXPECT_EQ(commit->warnings(0), "fine");
  EXPECT_EQ(commit->warnings(1), "S\uFFFDd");
  EXPECT_EQ(commit->report().surface_map(0).name(), "\uFFFD");
}

TEST(TextFields, BytesMayBeAnything) {
  v1::ServerMessage message;
  message.mutable_chunk()->set_data("\xFF\xFE");
  EXPECT_TRUE(has_valid_text(message));
  make_text_valid(message);
  EXPECT_EQ(message.chunk().data(), "\xFF\xFE");
}

TEST(TextFields, ALongTextIsFoundWhereverItIs) {
  v1::ClientMessage message;
  auto* edit = message.mutable_apply_edit();
  edit->set_operation("fill_hole");
  (*edit->mutable_parameters())["word"].set_text(std::string(20, 'x'));
  EXPECT_EQ(find_long_text(message, 20), "");
  EXPECT_EQ(find_long_text(message, 19), "apply_edit.parameters.value.text");
}

}  // namespace
}  // namespace tedit::protocol
