// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ops/loader/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path good_plugins = TEDIT_BIN "/../lib/tedit/plugins";
const std::filesystem::path bad_plugins = TEDIT_BAD_PLUGINS;

std::string refusal(const char* file) {
  catalogue c;
  c.load_directory(good_plugins);
  const auto loaded = c.load_file(bad_plugins / file);
  EXPECT_FALSE(loaded.has_value());
  EXPECT_EQ(c.refused().size(), 1u);
  return loaded ? "" : loaded.error().message;
}

TEST(Catalogue, LoadsTheBuiltInOperation) {
  catalogue c;

  c.load_directory(good_plugins);

  ASSERT_TRUE(c.find("fill_hole").has_value());
  EXPECT_TRUE(c.refused().empty());
}

TEST(Catalogue, EachFaultyPluginIsRefusedWithItsReason) {
  EXPECT_THAT(refusal("no_entry.so"), HasSubstr("no entry tedit_plugin_query"));
  EXPECT_THAT(refusal("wrong_magic.so"), HasSubstr("wrong magic number"));
  const auto sdk = [](std::uint32_t minor) {
    return std::to_string(sdk_major) + "." + std::to_string(minor);
  };
  EXPECT_THAT(refusal("newer_sdk.so"),
              HasSubstr("SDK " + sdk(sdk_minor + 1) + ", this host offers " + sdk(sdk_minor)));
  EXPECT_THAT(refusal("next_sdk.so"), HasSubstr("SDK " + std::to_string(sdk_major + 1) + "." +
                                                std::to_string(sdk_minor) + ", this host offers"));
  EXPECT_THAT(refusal("last_sdk.so"), HasSubstr("SDK " + std::to_string(sdk_major - 1) + "."));
  EXPECT_THAT(refusal("other_compiler.so"), HasSubstr("built with gcc-1 libstdc++-1 strings-0"));
  EXPECT_THAT(refusal("no_layout.so"), HasSubstr("its descriptor is incomplete"));
  const auto size = std::to_string(sizeof(edit_result));
  const auto larger = std::to_string(sizeof(edit_result) + 8);
  EXPECT_THAT(refusal("other_layout.so"),
              HasSubstr("another layout of edit_result (" + larger + " bytes, " + size + " here)"));
  EXPECT_THAT(refusal("other_members.so"),
              HasSubstr("another layout of mesh_version (as large, but its members differ)"));
  EXPECT_THAT(refusal("new_type.so"),
              HasSubstr("a type that this host does not have (stress_view)"));
  EXPECT_THAT(refusal("throws.so"), HasSubstr("no licence file"));
  EXPECT_THAT(refusal("duplicate.so"), HasSubstr("fill_hole is taken"));
  EXPECT_THAT(refusal("not_there.so"), HasSubstr("not_there.so"));
}

TEST(Catalogue, AFaultyPluginDoesNotKeepTheOthersOut) {
  catalogue c;

  c.load_directory(bad_plugins);
  c.load_directory(good_plugins);

  // One of the faulty ones loads as fill_hole; the others are noted.
  EXPECT_TRUE(c.find("fill_hole").has_value());
  EXPECT_GE(c.refused().size(), 5u);
}

TEST(Catalogue, AnUnknownOperationNamesTheNearest) {
  catalogue c;
  c.load_directory(good_plugins);

  const auto found = c.find("fil_hole");

  ASSERT_FALSE(found.has_value());
  EXPECT_THAT(found.error().remedy, HasSubstr("fill_hole"));
}

operation_description sample() {
  operation_description d;
  d.id = "sample";
  d.parameters = {
    {"depth", "", "", parameter_type::real, "m", 0.0, 1.0, {}, 0.5},
    {"layers", "", "", parameter_type::integer, "", 1.0, 9.0, {}, std::int64_t{2}},
    {"exact", "", "", parameter_type::boolean, "", {}, {}, {}, false},
    {"side", "", "", parameter_type::choice, "", {}, {}, {"in", "out"}, std::string("in")},
  };
  return d;
}

TEST(Parameters, DefaultsFillWhatIsNotGiven) {
  const auto values = complete_parameters(sample(), {{"depth", std::string("0.25")}});

  ASSERT_TRUE(values.has_value());
  EXPECT_EQ(std::get<double>(values->at("depth")), 0.25);
  EXPECT_EQ(std::get<std::int64_t>(values->at("layers")), 2);
  EXPECT_EQ(std::get<bool>(values->at("exact")), false);
}

TEST(Parameters, LengthsMayBeGivenInMillimetres) {
  auto description = sample();
  const auto depth = std::ranges::find(description.parameters, "depth", &parameter_description::id);
  depth->unit = "m";

  const auto values = complete_parameters(description, {{"depth_mm", std::string("250")}});
  const auto twice = complete_parameters(description, {{"depth_mm", 250.0}, {"depth", 0.25}});

  ASSERT_TRUE(values.has_value()) << render(values.error());
  EXPECT_EQ(std::get<double>(values->at("depth")), 0.25);
  ASSERT_FALSE(twice.has_value());
  EXPECT_THAT(render(twice.error()), HasSubstr("depth: it is given twice"));
  // Without a unit there are no millimetres.
  EXPECT_FALSE(complete_parameters(sample(), {{"layers_mm", 2.0}}).has_value());
}

operation_description placed() {
  operation_description d;
  d.id = "placed";
  d.parameters = {
    {"at", "", "", parameter_type::point, "m", {}, {}, {}, std::string()},
    {"along", "", "", parameter_type::direction, "", {}, {}, {}, std::string("0, 0, 1")},
    {"by", "", "", parameter_type::vector, "m", {}, {}, {}, std::string("0, 0, 0")},
    {"shape", "", "", parameter_type::file, "", {}, {}, {}, std::string()},
  };
  return d;
}

TEST(Parameters, PointsAndDirectionsAreThreeNumbers) {
  const auto values = complete_parameters(placed(), {{"at_mm", std::string("10,-2.5  30")}});
  ASSERT_TRUE(values.has_value()) << render(values.error());

  const auto at = vector_of(*values, "at");
  ASSERT_TRUE(at.has_value());
  EXPECT_NEAR(norm(*at - vec3{0.01, -0.0025, 0.03}), 0, 1e-15);
  EXPECT_EQ(vector_of(*values, "along"), (vec3{0, 0, 1}));
  // Left to the operation, where its description lets it be empty.
  EXPECT_EQ(vector_of(*complete_parameters(placed(), {}), "at"), std::nullopt);
  EXPECT_FALSE(complete_parameters(placed(), {{"along", std::string(" ")}}).has_value());
}

TEST(Parameters, AVectorIsAWayInMetresAndMayBeZero) {
  const auto values = complete_parameters(placed(), {{"by_mm", std::string("10, 0, -5")}});
  ASSERT_TRUE(values.has_value()) << render(values.error());

  EXPECT_LT(norm(*vector_of(*values, "by") - vec3{0.01, 0, -0.005}), 1e-15);
  EXPECT_EQ(vector_of(*complete_parameters(placed(), {}), "by"), vec3{});
  EXPECT_FALSE(complete_parameters(placed(), {{"by", std::string("1, 2")}}).has_value());
}

TEST(Parameters, AFileIsItsContentAndNeverAPath) {
  const std::string content = "data:a.stl;base64,Zm9v";
  const auto values = complete_parameters(placed(), {{"shape", content}});
  const auto path = complete_parameters(placed(), {{"shape", std::string("/etc/passwd")}});

  ASSERT_TRUE(values.has_value()) << render(values.error());
  EXPECT_EQ(std::get<std::string>(values->at("shape")), content);
  ASSERT_FALSE(path.has_value());
  EXPECT_THAT(render(path.error()), HasSubstr("shape: it is not the content of a file"));
  EXPECT_FALSE(complete_parameters(placed(), {{"shape", 3.0}}).has_value());
}

TEST(Parameters, WhatIsNoPointOrDirectionIsRefused) {
  for (const char* text :
       {"1, 2", "1, 2, 3, 4", "1, 2, x", "1, 2, nan", "1, 2, inf", "1, 2, 1e31", "1, 2, 3 mm", ""})
    for (const char* id : {"at", "along"}) {
      const bool empty = *text == 0 && std::string_view(id) == "at";
      EXPECT_EQ(complete_parameters(placed(), {{id, std::string(text)}}).has_value(), empty)
        << id << " = " << text;
    }
  EXPECT_FALSE(complete_parameters(placed(), {{"along", std::string("0, 0, 0")}}).has_value());
  EXPECT_FALSE(complete_parameters(placed(), {{"at", 1.0}}).has_value());
}

TEST(Parameters, WhatDoesNotFitIsRefusedByName) {
  const auto refused = [](const char* name, parameter_value value) {
    const auto values = complete_parameters(sample(), {{name, std::move(value)}});
    EXPECT_FALSE(values.has_value());
    return values ? "" : render(values.error());
  };

  EXPECT_THAT(refused("depth", 1.5), HasSubstr("1.5 is out of range"));
  EXPECT_THAT(refused("depth", std::string("deep")), HasSubstr("depth: it is a number"));
  EXPECT_THAT(refused("layers", 1.5), HasSubstr("whole number"));
  EXPECT_THAT(refused("exact", std::string("maybe")), HasSubstr("true or false"));
  EXPECT_THAT(refused("side", std::string("up")), HasSubstr("Choose one of in out"));
  EXPECT_THAT(refused("dept", 0.1), HasSubstr("Did you mean depth?"));
  EXPECT_THAT(refused("depth", std::nan("")), HasSubstr("finite"));
  EXPECT_THAT(refused("depth", std::string("nan")), HasSubstr("finite"));
}

TEST(Parameters, OneWithoutARangeStillHasALimit) {
  auto description = sample();
  description.parameters[0].max.reset();

  const auto values = complete_parameters(description, {{"depth", 1e308}});

  ASSERT_FALSE(values.has_value());
  EXPECT_THAT(render(values.error()), HasSubstr("1e+308 is out of range. It takes 0 to 1e+30 m"));
}

}  // namespace
}  // namespace tedit::ops
