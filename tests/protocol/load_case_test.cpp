// SPDX-License-Identifier: AGPL-3.0-or-later
#include "protocol/convert.hpp"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocol/json.hpp"
#include "protocol/numbers.hpp"
#include "tedit/v1/envelope.pb.h"

namespace tedit::protocol {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

error refusal(const char* json) {
  const auto loads = load_case_from_json(json, "a.json");
  EXPECT_FALSE(loads.has_value());
  return loads ? error{} : loads.error();
}

TEST(LoadCaseJson, TheShippedFilesAreRead) {
  for (const auto& part : std::filesystem::directory_iterator(TEDIT_TEST_DATA "/parts")) {
    const auto loads = load_case_from_file(part.path() / "load_case.json");
    ASSERT_TRUE(loads.has_value()) << part.path() << render(loads.error());
    EXPECT_EQ(loads->materials.size(), 1u);
    EXPECT_FALSE(loads->constraints.empty());
    EXPECT_TRUE(std::holds_alternative<fem::force>(loads->loads.front().kind));
  }
}

TEST(LoadCaseJson, EveryKindSurvivesTheRoundTrip) {
  const auto* json = R"({
    "name": "all",
    "materials": [{"name": "a", "young_modulus_pa": 1e9, "poisson_ratio": 0.3, "regions": [4, 5]}],
    "constraints": [{"surfaces": [1], "fixed": {}}, {"surfaces": [2], "roller": {}},
                    {"surfaces": [3], "displacement": {"y_m": 0}}],
    "loads": [{"surfaces": [4], "traction": {"pa": {"x": 1}}}, {"surfaces": [5], "pressure": {"pa": 2}},
              {"surfaces": [6], "force": {"total_n": {"z": -3}}}, {"gravity": {"m_s2": {"z": -9.81}}}]
  })";
  const auto first = load_case_from_json(json, "");
  ASSERT_TRUE(first.has_value()) << render(first.error());

  const auto second = load_case_from_json(load_case_to_json(*first), "");

  ASSERT_TRUE(second.has_value());
  EXPECT_THAT(second->materials[0].regions, ElementsAre(4, 5));
  const auto& d = std::get<fem::prescribed_displacement>(second->constraints[2].kind);
  EXPECT_FALSE(d.x_m.has_value());
  EXPECT_EQ(d.y_m, 0.0);
  EXPECT_EQ(std::get<fem::traction>(second->loads[0].kind).pa, (vec3{1, 0, 0}));
  EXPECT_EQ(std::get<fem::pressure>(second->loads[1].kind).pa, 2);
  EXPECT_EQ(std::get<fem::force>(second->loads[2].kind).total_n.z, -3);
  EXPECT_EQ(std::get<fem::gravity>(second->loads[3].kind).m_s2.z, -9.81);
  EXPECT_EQ(load_case_to_json(*first), load_case_to_json(*second));
}

TEST(LoadCaseJson, FaultsAreNamed) {
  EXPECT_THAT(refusal("{").message, HasSubstr("no load case"));
  EXPECT_THAT(refusal(R"({"loads": [{"surfaces": [1], "force": {"total": {}}}]})").message,
              HasSubstr("total"));
  EXPECT_THAT(refusal(R"({"constraints": [{"surfaces": [1]}]})").message,
              HasSubstr("constraint 0 says no kind"));
  EXPECT_THAT(refusal(R"({"loads": [{"surfaces": [1]}]})").message, HasSubstr("load 0"));
  EXPECT_THAT(refusal(R"({"materials": [{"young_modulus_pa": "stiff"}]})").message,
              HasSubstr("young_modulus_pa"));
  EXPECT_EQ(refusal("[]").where, "a.json");
}

TEST(LoadCaseJson, DeepNestingIsRefusedNotCrashed) {
  EXPECT_EQ(refusal((std::string(100000, '[') + std::string(100000, ']')).c_str()).code,
            ec::bad_input);
}

TEST(LoadCaseJson, AMissingFileIsNamed) {
  const auto loads = load_case_from_file("/nowhere/l.json");

  ASSERT_FALSE(loads.has_value());
  EXPECT_EQ(loads.error().code, ec::io_error);
  EXPECT_THAT(loads.error().message, HasSubstr("/nowhere/l.json"));
}

}  // namespace
}  // namespace tedit::protocol
