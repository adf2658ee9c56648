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
              {"surfaces": [6], "force": {"total_n": {"z": -3}}}, {"gravity": {"m_s2": {"z": -9.81}}},
              {"surfaces": [7], "normal_force": {"total_n": 4}}, {"surfaces": [8], "moment": {"total_nm": {"y": 5}}},
              {"surfaces": [9], "remote_force": {"total_n": {"x": 6}, "at_m": {"z": 7}, "moment_nm": {"y": 8}}},
              {"surfaces": [10], "bearing_force": {"total_n": {"x": 9}}},
              {"surfaces": [11], "pressure": {"pa": 1, "gradient_pa_m": {"z": -2}, "at_m": {"z": 3}}}]
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
  EXPECT_EQ(std::get<fem::normal_force>(second->loads[4].kind).total_n, 4);
  EXPECT_EQ(std::get<fem::moment>(second->loads[5].kind).total_nm, (vec3{0, 5, 0}));
  EXPECT_EQ(std::get<fem::remote_force>(second->loads[6].kind),
            (fem::remote_force{{6, 0, 0}, {0, 0, 7}, {0, 8, 0}}));
  EXPECT_EQ(std::get<fem::bearing_force>(second->loads[7].kind).total_n, (vec3{9, 0, 0}));
  EXPECT_EQ(std::get<fem::pressure>(second->loads[8].kind),
            (fem::pressure{1, {0, 0, -2}, {0, 0, 3}}));
  EXPECT_EQ(load_case_to_json(*first), load_case_to_json(*second));
}

/// A load case with every number that there is.
constexpr const char* every_number = R"({
  "materials": [{"young_modulus_pa": 1e9, "poisson_ratio": 0.3, "density_kg_m3": 1, "yield_strength_pa": 1}],
  "constraints": [{"surfaces": [1], "fixed": {}}, {"surfaces": [3], "displacement": {"x_m": 1, "y_m": 1, "z_m": 1}}],
  "loads": [{"surfaces": [4], "traction": {"pa": {"x": 1, "y": 1, "z": 1}}}, {"surfaces": [5], "pressure": {"pa": 1}},
            {"surfaces": [6], "force": {"total_n": {"x": 1, "y": 1, "z": 1}}},
            {"gravity": {"m_s2": {"x": 1, "y": 1, "z": 1}}},
            {"surfaces": [7], "normal_force": {"total_n": 1}},
            {"surfaces": [8], "moment": {"total_nm": {"x": 1, "y": 1, "z": 1}}},
            {"surfaces": [9], "remote_force": {"total_n": {"x": 1, "y": 1, "z": 1}, "at_m": {"x": 1, "y": 1, "z": 1},
                                               "moment_nm": {"x": 1, "y": 1, "z": 1}}},
            {"surfaces": [10], "bearing_force": {"total_n": {"x": 1, "y": 1, "z": 1}}},
            {"surfaces": [11], "pressure": {"pa": 1, "gradient_pa_m": {"x": 1, "y": 1, "z": 1},
                                            "at_m": {"x": 1, "y": 1, "z": 1}}}]
})";

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// Calls work(message, field, name) for each number with a fraction that is set.
void for_each_number(
  Message& message, const std::string& before,
  const std::function<void(Message&, const FieldDescriptor*, const std::string&)>& work) {
  const auto& access = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  access.ListFields(message, &fields);
  for (const auto* field : fields) {
    const auto name = before + field->name();
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE)
      work(message, field, name);
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE)
      continue;
    if (!field->is_repeated())
      for_each_number(*access.MutableMessage(&message, field), name + ".", work);
    for (int i = 0; field->is_repeated() && i < access.FieldSize(message, field); ++i)
      for_each_number(*access.MutableRepeatedMessage(&message, field, i),
                      name + "[" + std::to_string(i) + "].", work);
  }
}

TEST(LoadCaseJson, EveryNumberMustBeFiniteAndInRangeAndIsNamed) {
  auto message = *message_from_json<v1::LoadCase>(every_number);
  int numbers = 0;

  for_each_number(message, "", [&](Message& at, const FieldDescriptor* field, const auto& name) {
    ++numbers;
    const double before = at.GetReflection()->GetDouble(at, field);
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1.1e30, -1e308}) {
      at.GetReflection()->SetDouble(&at, field, bad);
      const auto refused = load_case_from_json(message_to_json(message), "a.json");
      ASSERT_FALSE(refused.has_value()) << name << " = " << bad;
      EXPECT_EQ(refused.error().code, ec::bad_input);
      EXPECT_THAT(refused.error().message, HasSubstr(name + " is "));
      EXPECT_THAT(refused.error().remedy, HasSubstr("-1e+30 to 1e+30"));
      EXPECT_EQ(refused.error().where, "a.json");
    }
    at.GetReflection()->SetDouble(&at, field, before);
  });

  EXPECT_EQ(numbers, 4 + 3 + 3 + 1 + 3 + 3 + 1 + 3 + 9 + 3 + 7);
  EXPECT_TRUE(load_case_from_json(message_to_json(message), "").has_value());
}

/// What a client may send: numbers at any depth, also in lists and maps.
TEST(Numbers, OfAnyMessageAreFoundAndNamed) {
  v1::ClientMessage message;
  (*message.mutable_apply_edit()->mutable_parameters())["depth"].set_real(1);
  (*message.mutable_apply_edit()->mutable_parameters())["radius"].set_real(HUGE_VAL);

  const auto map = check_numbers(message, finite_number(), ec::invalid_argument);
  message.mutable_cut_section()->mutable_normal()->set_y(std::nan(""));
  const auto plane = check_numbers(message, finite_number(), ec::invalid_argument);
  message.mutable_solve()->set_tolerance(1e308);

  ASSERT_FALSE(map.has_value());
  EXPECT_EQ(map.error().code, ec::invalid_argument);
  EXPECT_EQ(map.error().message, "apply_edit.parameters[radius].value.real is inf");
  EXPECT_EQ(map.error().remedy, "Give a finite number");
  ASSERT_FALSE(plane.has_value());
  EXPECT_EQ(plane.error().message, "cut_section.normal.y is nan");
  EXPECT_TRUE(check_numbers(message, finite_number(), ec::invalid_argument).has_value());
}

TEST(LoadCaseJson, WarningsGoAlong) {
  fem::load_case before;
  before.constraints = {{{1}, fem::roller{}, "look at the support"}};
  before.loads = {{{2}, fem::pressure{3}, "look at the load"}};

  const auto after = load_case_from_json(load_case_to_json(before), "");

  ASSERT_TRUE(after.has_value()) << render(after.error());
  EXPECT_EQ(after->constraints[0].warning, "look at the support");
  EXPECT_EQ(after->loads[0].warning, "look at the load");
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
