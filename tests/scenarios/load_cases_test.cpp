// SPDX-License-Identifier: AGPL-3.0-or-later
// Several load cases at once, and the stop by energy, over a real WebSocket.
#include <mutex>

#include "tests/scenarios/fixture.hpp"

namespace tedit::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class LoadCases : public ::testing::Test {
protected:
  scratch_folder folder;
  std::unique_ptr<server> host = start(options_for(folder, false));
  std::mutex mutex;  ///< Guards what the events tell.
  std::vector<solve_outcome> outcomes;
  std::vector<client::solve_status> statuses;
  std::unique_ptr<client::client> user = connect(host->url(), handlers());

  client::events handlers() {
    client::events result;
    result.on_solved = [this](const solve_outcome& outcome) {
      const std::lock_guard lock(mutex);
      outcomes.push_back(outcome);
    };
    result.on_solve_status = [this](const client::solve_status& status) {
      const std::lock_guard lock(mutex);
      statuses.push_back(status);
    };
    return result;
  }

  /// The plate pushed down with 20 kN, and the same with another name and force.
  static fem::load_case plate_case(const std::string& name, vec3 total_n) {
    auto loads = value(protocol::load_case_from_file(plate_loads));
    loads.name = name;
    loads.loads.front().kind = fem::force{total_n};
    return loads;
  }

  /// Held at two of the bores only.
  static fem::load_case hung(const std::string& name) {
    auto loads = plate_case(name, {0, 0, -5000});
    loads.constraints.front().surfaces = {72, 73, 90, 91};
    return loads;
  }

  client::committed import_plate(const std::vector<fem::load_case>& cases) {
    value(user->open("plate", true, true));
    auto done = value(user->import_file(plate_mesh, "mm", {}));
    for (const auto& one : cases)
      value(user->set_load_case(one));
    return done;
  }

  static client::solve_settings together(std::vector<std::string> names, int order = 1) {
    client::solve_settings settings;
    settings.device = "cpu";
    settings.element_order = order;
    settings.load_cases = std::move(names);
    return settings;
  }

  const fem::load_case down = plate_case("down", {0, 0, -20000});
  const fem::load_case side = plate_case("side", {0, 30000, 0});
};

/// The envelope of two reports and of two fields, number by number.
void expect_worst_of(const solve_outcome& outcome, const std::vector<client::field_event>& fields) {
  ASSERT_EQ(outcome.cases.size(), 2u);
  const auto& a = outcome.cases[0];
  const auto& b = outcome.cases[1];
  ASSERT_TRUE(outcome.envelope.has_value());
  const auto& worst = *outcome.envelope;
  EXPECT_THAT(worst.load_cases, ElementsAre(a.load_case, b.load_case));
  EXPECT_EQ(worst.max_von_mises.value, std::max(a.max_von_mises_pa, b.max_von_mises_pa));
  EXPECT_EQ(worst.max_von_mises.load_case,
            (a.max_von_mises_pa >= b.max_von_mises_pa ? a : b).load_case);
  EXPECT_EQ(worst.max_displacement.value, std::max(a.max_displacement_m, b.max_displacement_m));
  ASSERT_TRUE(worst.min_safety_factor.has_value());
  EXPECT_EQ(worst.min_safety_factor->value, std::min(*a.min_safety_factor, *b.min_safety_factor));

  ASSERT_EQ(fields.size(), 3u);
  EXPECT_EQ(fields[0].report.load_case, a.load_case);
  EXPECT_EQ(fields[1].report.load_case, b.load_case);
  const auto& both = fields[2];
  ASSERT_TRUE(both.envelope.has_value());
  EXPECT_EQ(both.envelope->version_id, a.version_id);
  ASSERT_EQ(both.vertices, fields[0].vertices);
  const auto& largest = both.values.of("von_mises_pa");
  const auto& worst_case = both.worst_cases.of("von_mises_pa");
  const auto& safety = both.values.of("safety_factor");
  ASSERT_EQ(safety.size(), both.vertices.size());
  std::size_t of_b = 0;
  for (std::size_t v = 0; v < both.vertices.size(); ++v) {
    const float x = fields[0].values.of("von_mises_pa")[v];
    const float y = fields[1].values.of("von_mises_pa")[v];
    ASSERT_EQ(largest[v], std::max(x, y));
    ASSERT_EQ(worst_case[v] == 0 ? x : y, largest[v]);
    // One material: the least safety is where the stress is largest.
    ASSERT_EQ(both.worst_cases.of("safety_factor")[v], worst_case[v]);
    ASSERT_NEAR(safety[v] * largest[v], 276e6, 276e6 * 1e-5);
    of_b += worst_case[v];
  }
  EXPECT_GT(of_b, 0u);
  EXPECT_LT(of_b, both.vertices.size());
}

TEST_F(LoadCases, AreSolvedTogetherAndFollowEveryEdit) {
  const auto imported = import_plate({down, side});
  const auto before = value(user->solve_cases(together({"down", "side"}), {}));
  expect_worst_of(before, value(user->wait_fields(imported.head.version_id, patience)));

  const auto filled = value(user->edit("fill_hole", {1, 2}, {}, {}));
  const auto fields = value(user->wait_fields(filled.head.version_id, patience));
  ASSERT_EQ(fields.size(), 3u);
  EXPECT_EQ(value(user->wait_field(filled.head.version_id, patience)).envelope->version_id,
            filled.head.version_id);
  const solve_outcome after{{fields[0].report, fields[1].report}, fields[2].envelope};
  expect_worst_of(after, fields);
  EXPECT_NE(after.cases[0].compliance_j, before.cases[0].compliance_j);

  // Undo shows what is kept.
  value(user->undo());
  const auto kept = value(user->wait_fields(imported.head.version_id, patience));
  EXPECT_EQ(kept[1].report.compliance_j, before.cases[1].compliance_j);
  value(user->redo());

  // Each alone on the edited part says the same.
  for (std::size_t c = 0; c < 2; ++c) {
    auto alone = together({});
    alone.load_case = after.cases[c].load_case;
    const auto report = value(user->solve(alone, {}));
    EXPECT_NEAR(report.compliance_j, after.cases[c].compliance_j, 1e-5 * report.compliance_j);
    EXPECT_NEAR(report.max_von_mises_pa, after.cases[c].max_von_mises_pa,
                1e-4 * report.max_von_mises_pa);
  }
}

TEST_F(LoadCases, OneIsToldAsItAlwaysWas) {
  const auto imported = import_plate({down, side});

  const auto outcome = value(user->solve_cases(together({"side"}), {}));
  const auto fields = value(user->wait_fields(imported.head.version_id, patience));

  ASSERT_EQ(outcome.cases.size(), 1u);
  EXPECT_EQ(outcome.cases[0].load_case, "side");
  EXPECT_FALSE(outcome.envelope.has_value());
  ASSERT_EQ(fields.size(), 1u);
  EXPECT_FALSE(fields[0].envelope.has_value());
  EXPECT_EQ(fields[0].remaining, 0u);
  EXPECT_EQ(fields[0].values.of("displacement_m").size(), 3 * fields[0].vertices.size());
}

TEST_F(LoadCases, AllMeansThoseOfEachHead) {
  import_plate({down, side});
  auto all = together({});
  all.all_load_cases = true;
  EXPECT_EQ(value(user->solve_cases(all, {})).cases.size(), 2u);
  value(user->set_load_case(hung("hung")));

  const auto filled = value(user->edit("fill_hole", {1, 2}, {}, {}));
  const auto fields = value(user->wait_fields(filled.head.version_id, patience));

  ASSERT_EQ(fields.size(), 4u);
  EXPECT_THAT(fields[3].envelope->load_cases, ElementsAre("down", "side", "hung"));
  // Other supports are others' reactions.
  EXPECT_EQ(fields[1].report.surface_reactions.size(), 8u);
  EXPECT_EQ(fields[2].report.surface_reactions.size(), 4u);
  auto alone = together({"hung"});
  const auto report = value(user->solve(alone, {}));
  EXPECT_NEAR(report.compliance_j, fields[2].report.compliance_j, 1e-5 * report.compliance_j);
}

TEST_F(LoadCases, FirstFieldsComeWhileTheyAreSolved) {
  import_plate({down, side, hung("hung")});
  value(user->solve_cases(together({"down", "side"}, 2), {}));
  value(user->get_history());  // Everything that was sent before it has arrived.
  {
    const std::lock_guard lock(mutex);
    ASSERT_GE(outcomes.size(), 2u);
    EXPECT_TRUE(outcomes.front().envelope->interim);
    EXPECT_TRUE(outcomes.front().envelope->preview);
    const auto& last = outcomes.back();
    EXPECT_FALSE(last.envelope->interim);
    EXPECT_FALSE(last.envelope->preview);
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_NEAR(outcomes.front().cases[c].compliance_j, last.cases[c].compliance_j,
                  1e-3 * last.cases[c].compliance_j);
    ASSERT_FALSE(statuses.empty());
    for (const auto& status : statuses)
      EXPECT_THAT(status.load_cases, ElementsAre("down", "side"));
    outcomes.clear();
  }
  // With different supports some have not begun when the first ones have a field.
  value(user->solve_cases(together({"down", "hung"}, 2), {}));
  value(user->get_history());
  const std::lock_guard lock(mutex);
  ASSERT_EQ(outcomes.size(), 1u);
  EXPECT_FALSE(outcomes.front().envelope->interim);
}

TEST_F(LoadCases, AnEnergyToleranceEndsEarlyWithAPreview) {
  import_plate({down, side});
  auto rough = together({"down", "side"}, 2);
  rough.energy_tolerance = 1e-2;
  const auto quick = value(user->solve_cases(rough, {}));
  auto one = together({"down"}, 2);
  one.energy_tolerance = 1e-2;
  const auto alone = value(user->solve(one, {}));
  const auto exact = value(user->solve_cases(together({"down", "side"}, 2), {}));

  EXPECT_TRUE(alone.preview);
  EXPECT_TRUE(quick.envelope->preview);
  EXPECT_FALSE(exact.envelope->preview);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_TRUE(quick.cases[c].preview);
    EXPECT_FALSE(quick.cases[c].interim) << "it is all that comes";
    EXPECT_FALSE(exact.cases[c].preview);
    EXPECT_LT(quick.cases[c].iterations, exact.cases[c].iterations);
    // 1 % in the energy norm is 1e-4 of the compliance.
    EXPECT_NEAR(quick.cases[c].compliance_j, exact.cases[c].compliance_j,
                1e-3 * exact.cases[c].compliance_j);
  }
}

TEST_F(LoadCases, WhatCannotBeSolvedIsNamed) {
  auto loose = plate_case("loose", {0, 0, 1});
  loose.constraints.clear();
  auto soft = plate_case("soft", {0, 0, 1});
  soft.materials.front().young_modulus_pa /= 2;
  import_plate({down, loose, soft});

  const auto refused = [&](const client::solve_settings& settings) {
    const auto result = user->solve_cases(settings, {});
    return result ? error{} : result.error();
  };
  const auto not_held = refused(together({"down", "loose"}));
  EXPECT_EQ(not_held.code, ec::under_constrained);
  EXPECT_THAT(not_held.message, HasSubstr("load case 'loose': the part is not held"));
  EXPECT_THAT(refused(together({"down", "soft"})).message,
              HasSubstr("load case 'soft' has other materials than 'down'"));
  EXPECT_THAT(refused(together({"down", "up"})).message, HasSubstr("\"up\""));
  EXPECT_THAT(refused(together({"down", "down"})).message, HasSubstr("\"down\" is named twice"));
  auto both = together({"down"});
  both.load_case = "down";
  EXPECT_EQ(refused(both).code, ec::invalid_argument);
  auto rough = together({"down"});
  rough.energy_tolerance = 0.7;
  EXPECT_THAT(refused(rough).message, HasSubstr("energy tolerance"));
  EXPECT_TRUE(user->solve(together({"down"}), {}).has_value());
}

TEST_F(LoadCases, AreExportedWithTheirNamesAndTheEnvelope) {
  import_plate({down, side});
  value(user->solve_cases(together({"down", "side"}), {}));

  const auto vtu = value(user->export_file("vtu", "", "", {}));

  const std::string text(vtu.begin(), vtu.end());
  for (const auto* name :
       {"von_mises_pa (down)", "stress_pa (side)", "envelope_von_mises", "envelope_case",
        "envelope_safety_factor", "envelope_safety_factor_case", "case_0", "case_1"})
    EXPECT_THAT(text, HasSubstr("Name=\"" + std::string(name) + "\""));
}

}  // namespace
}  // namespace tedit::test
