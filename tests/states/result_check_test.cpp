// SPDX-License-Identifier: AGPL-3.0-or-later
// What a solver sends is looked at before anybody sees it.
#include "actors/session/result_check.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "tests/simulation/client.hpp"
#include "tests/simulation/server.hpp"

namespace tedit::actors {
namespace {

using ::testing::HasSubstr;

class ResultCheck : public ::testing::Test {
protected:
  ResultCheck() {
    for (const auto& one : loads_)
      outcome_.cases.push_back({.version_id = to_hex(mesh_->id()), .load_case = one.name});
    outcome_.envelope.emplace();
    outcome_.envelope->version_id = to_hex(mesh_->id());
    add("von_mises_pa (a)", 1);
    add("displacement_m (b)", 3);
    add("envelope_von_mises", 1);
    add("envelope_case", 1);
    add("element_stress_pa (a)", 6, field_location::tet);
  }

  void add(const std::string& name, int components, field_location where = field_location::vertex) {
    const auto slots = where == field_location::tet ? mesh_->tet_slots() : mesh_->vertex_slots();
    const std::vector<double> values(slots * static_cast<std::size_t>(components), 1.5);
    fields_.push_back({name, where, components, paged_array<double>::from(values)});
  }

  [[nodiscard]] expected<void> check() const {
    return check_solved(outcome_, fields_, *mesh_, loads_);
  }
  /// What is said of it; empty when it passes.
  [[nodiscard]] std::string objection() const {
    const auto ok = check();
    EXPECT_TRUE(ok || ok.error().code == ec::protocol_error);
    return ok ? "" : ok.error().message;
  }

  version_ptr mesh_ = simulation::imported_part(1);
  load_case_list loads_{simulation::made_up_load_case("a", 1),
                        simulation::made_up_load_case("b", 2)};
  solve_outcome outcome_;
  std::vector<field> fields_;
};

TEST_F(ResultCheck, AResultPasses) {
  EXPECT_EQ(objection(), "");
}

TEST_F(ResultCheck, ReportsAreOfWhatWasAskedFor) {
  outcome_.cases[1].load_case = "c";
  EXPECT_EQ(objection(), "a solver sent a result of another version or load case");
  outcome_.cases[1].load_case = "b";
  outcome_.cases[0].version_id = std::string(32, '0');
  EXPECT_EQ(objection(), "a solver sent a result of another version or load case");
  outcome_.cases[0].version_id = outcome_.cases[1].version_id;
  outcome_.cases.pop_back();
  EXPECT_EQ(objection(), "a solver sent 1 results for 2 load cases");
}

TEST_F(ResultCheck, EachNumberOfAReportIsFinite) {
  const auto bad = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::function<void(solve_report&)>> spoil{
    [=](auto& r) { r.max_von_mises_pa = bad; },
    [=](auto& r) { r.max_displacement_at.z = bad; },
    [=](auto& r) { r.min_safety_factor = bad; },
    [=](auto& r) { r.mass_kg = bad; },
    [=](auto& r) {
      r.surface_reactions = {{1, "", {0, bad, 0}}};
    },
    [=](auto& r) {
      r.singular_places = {{fem::singularity::clamp_rim, {}, bad}};
    }};
  for (std::size_t i = 0; i < spoil.size(); ++i) {
    const auto good = outcome_.cases[1];
    spoil[i](outcome_.cases[1]);
    EXPECT_THAT(objection(), HasSubstr("not finite")) << i;
    outcome_.cases[1] = good;
  }
  outcome_.envelope->max_von_mises.value = bad;
  EXPECT_THAT(objection(), HasSubstr("an envelope"));
}

TEST_F(ResultCheck, ArraysFitTheMeshAndHoldNumbers) {
  const auto good = fields_;
  fields_[0].name = "von_mises_pa (c)";
  EXPECT_EQ(objection(), "a solver sent an array that nobody knows");

  fields_ = good;
  fields_[1].components = 1;
  EXPECT_THAT(objection(), HasSubstr("displacement_m (b) that does not fit the mesh"));

  fields_ = good;
  fields_[0].location = field_location::tet;
  EXPECT_THAT(objection(), HasSubstr("does not fit the mesh"));

  fields_ = good;
  std::vector<double> values(mesh_->vertex_slots(), 1.5);
  values.back() = -std::numeric_limits<double>::infinity();
  fields_[2].values = paged_array<double>::from(values);
  EXPECT_THAT(objection(), HasSubstr("envelope_von_mises with numbers that are not finite"));
  values.pop_back();
  fields_[2].values = paged_array<double>::from(values);
  EXPECT_THAT(objection(), HasSubstr("does not fit the mesh"));
}

}  // namespace
}  // namespace tedit::actors
