// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/operation_message.hpp"

#include <gtest/gtest.h>

#include "protocol/forms.hpp"

namespace tedit::protocol {
namespace {

ops::operation_description sample() {
  ops::operation_description d;
  d.id = "offset";
  d.name = "Offset";
  d.summary = "Moves a surface.";
  d.version = "1.2.3";
  d.selection = {"The surface", 1, 4};
  d.parameters = {
    {"distance", "Distance", "How far.", ops::parameter_type::real, "m", -1.0, 1.0, {}, 0.001},
    {"layers",
     "Layers",
     "",
     ops::parameter_type::integer,
     "",
     1.0,
     {},
     {},
     std::int64_t{3},
     "distance"},
    {"exact", "Exact", "", ops::parameter_type::boolean, "", {}, {}, {}, true},
    {"name", "Name", "", ops::parameter_type::text, "", {}, {}, {}, std::string("x")},
    {"side", "Side", "", ops::parameter_type::choice, "", {}, {}, {"in", "out"}, std::string("in")},
    {"axis", "Axis", "", ops::parameter_type::axis, "m", {}, {}, {}, std::string()},
    {"plane", "Plane", "", ops::parameter_type::plane, "m", {}, {}, {}, std::string()},
    {"path", "Path", "", ops::parameter_type::polyline, "m", 3.0, {}, {}, std::string()},
    {"places", "Places", "", ops::parameter_type::list, "m", {}, 2.0, {}, std::string("1, 2")},
  };
  return d;
}

TEST(Catalogue, ComesBackFromItsJson) {
  const auto sent = sample();

  const operation_catalogue all{{{sent, "plug 1.0.0"}}, {{"bad.so", "too new", "x", 3, "restart"}}};
  const auto got = from_json<operation_catalogue>(to_json(all));

  ASSERT_TRUE(got.has_value()) << render(got.error());
  ASSERT_EQ(got->refused.size(), 1u);
  EXPECT_EQ(got->refused[0].reason, "too new");
  EXPECT_EQ(got->refused[0].crashes, 3u);
  ASSERT_EQ(got->operations.size(), 1u);
  const auto& [d, plugin] = got->operations.front();
  EXPECT_EQ(plugin, "plug 1.0.0");
  EXPECT_EQ(d.id, sent.id);
  EXPECT_EQ(d.name, sent.name);
  EXPECT_EQ(d.summary, sent.summary);
  EXPECT_EQ(d.version, sent.version);
  EXPECT_EQ(d.selection.help, sent.selection.help);
  EXPECT_EQ(d.selection.minimum, 1u);
  EXPECT_EQ(d.selection.maximum, 4u);
  ASSERT_EQ(d.parameters.size(), sent.parameters.size());
  for (std::size_t i = 0; i < d.parameters.size(); ++i) {
    const auto& p = d.parameters[i];
    const auto& q = sent.parameters[i];
    EXPECT_EQ(p.id, q.id);
    EXPECT_EQ(p.type, q.type) << p.id;
    EXPECT_EQ(p.unit, q.unit) << p.id;
    EXPECT_EQ(p.min, q.min) << p.id;
    EXPECT_EQ(p.max, q.max) << p.id;
    EXPECT_EQ(p.choices, q.choices) << p.id;
    EXPECT_EQ(p.default_value, q.default_value) << p.id;
    EXPECT_EQ(p.instead_of, q.instead_of) << p.id;
  }
}

TEST(Catalogue, WhatIsNoCatalogueIsRefused) {
  EXPECT_FALSE(from_json<operation_catalogue>("{\"operations\": 3}").has_value());
  EXPECT_FALSE(from_json<operation_catalogue>("operations").has_value());
}

}  // namespace
}  // namespace tedit::protocol
