// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/catalogue.hpp"

#include <gtest/gtest.h>

#include "protocol/operation_message.hpp"

namespace tedit::desktop {
namespace {

/// Every type of parameter, with and without limits.
ops::operation_description every_type() {
  using type = ops::parameter_type;
  ops::operation_description about;
  about.id = "try_all";
  about.name = "Try all";
  about.summary = "One of each.";
  about.version = "1.2.3";
  about.selection = {"Two surfaces", 2, 3};
  about.parameters = {
    {"on", "On", "A switch.", type::boolean, "", {}, {}, {}, true},
    {"layers", "Layers", "", type::integer, "", 1.0, 20.0, {}, std::int64_t{3}},
    {"depth", "Depth", "How deep.", type::real, "m", 0.0, {}, {}, 2.5e-3},
    {"side", "Side", "", type::choice, "", {}, {}, {"left", "right"}, std::string("right")},
    {"note", "Note", "", type::text, "", {}, {}, {}, std::string("x")},
  };
  return about;
}

TEST(Catalogue, WhatTheServerWritesIsReadBack) {
  const auto sent = every_type();
  const auto json = protocol::catalogue_to_json({{sent, "plug 1.0.0"}}, {{"bad.so", "too new"}});

  const auto got = catalogue_from_json(json);

  ASSERT_TRUE(got.has_value()) << render(got.error());
  ASSERT_EQ(got->operations.size(), 1U);
  const auto& about = got->operations[0].about;
  EXPECT_EQ(about.id, "try_all");
  EXPECT_EQ(about.selection.minimum, 2U);
  EXPECT_EQ(about.selection.maximum, 3U);
  ASSERT_EQ(about.parameters.size(), sent.parameters.size());
  for (std::size_t i = 0; i < sent.parameters.size(); ++i) {
    EXPECT_EQ(about.parameters[i].id, sent.parameters[i].id);
    EXPECT_EQ(about.parameters[i].type, sent.parameters[i].type);
    EXPECT_EQ(about.parameters[i].min, sent.parameters[i].min);
    EXPECT_EQ(about.parameters[i].max, sent.parameters[i].max);
    EXPECT_EQ(about.parameters[i].choices, sent.parameters[i].choices);
    EXPECT_EQ(about.parameters[i].default_value, sent.parameters[i].default_value) << i;
  }
  EXPECT_EQ(got->operations[0].plugin, "plug 1.0.0");
  ASSERT_EQ(got->refused.size(), 1U);
  EXPECT_EQ(got->refused[0].reason, "too new");
  EXPECT_NE(got->find("try_all"), nullptr);
  EXPECT_EQ(got->find("other"), nullptr);
}

TEST(Catalogue, NonsenseIsRefused) {
  const auto got = catalogue_from_json("{\"operations\": [");

  ASSERT_FALSE(got.has_value());
  EXPECT_EQ(got.error().code, ec::protocol_error);
}

}  // namespace
}  // namespace tedit::desktop
