// SPDX-License-Identifier: AGPL-3.0-or-later
// Which fields of a result come from a solver that is far away, and when.
#include "tests/states/far_store.hpp"
#include "tests/states/session_fixture.hpp"

namespace tedit::actors {
namespace {

using names = std::vector<std::string>;

class FarFields : public Session {
protected:
  FarFields() {
    far_ = stage_.system().spawn(make_far, 0);
    session_results_ = std::make_shared<result_memory>(std::uint64_t{1} << 20);
  }
  ~FarFields() override {
    caf::anon_send_exit(far_, caf::exit_reason::user_shutdown);
    pass(milliseconds(1));
  }

  void SetUp() override {
    state().parts.results = session_results_;
    import_all();
    set_load("hanging", 5);
    helper().add_fields = [this](solve_result& result) { add_fields(result); };
    set_rate(1e6);
  }

  far_state& far() { return simulation::state_of<far_state>(far_); }
  void set_rate(double bytes_s) {
    simulation::state_of<page_store_state>(pages_).lines[far_.address()].rate = bytes_s;
  }

  /// Each of another value, so that each has pages of its own.
  void add_fields(solve_result& result) {
    const auto slots = state().graph.head()->mesh->vertex_slots();
    double value = ++solves_;
    for (const auto* name : {"displacement_m", "von_mises_pa", "stress_pa", "relative_error"}) {
      const auto* array = fem::find_array(name);
      field f;
      f.name = name;
      f.location = field_location::vertex;
      f.components = array->components;
      f.values = paged_array<double>::from(
        std::vector<double>(slots * static_cast<std::size_t>(array->components), value += .25));
      for (const auto& p : f.values.pages())
        far().pages.emplace(p->id(), p);
      result.fields.push_back(make_ref(f));
    }
    result.source = far_;
  }

  answer<held_result> watch(const caf::actor& who, std::set<std::string, std::less<>> arrays) {
    return request<held_result>(watch_request{who, std::move(arrays)});
  }

  static names in(const std::vector<field>& fields) {
    names result;
    for (const auto& one : fields)
      result.push_back(one.name);
    return result;
  }

  caf::actor far_;
  int solves_ = 0;
};

TEST_F(FarFields, OverASlowLineThoseThatNobodyWatchesStay) {
  const auto got = solve(mine_);
  finish({"solve"});
  ASSERT_TRUE(got.is_success());
  EXPECT_THAT(in(*got.value().fields), ElementsAre("displacement_m", "von_mises_pa"));
  EXPECT_EQ(far().sent, 2U);
}

TEST_F(FarFields, OverAFastOneAllCome) {
  set_rate(1e9);
  const auto got = solve(mine_);
  finish({"solve"});
  EXPECT_EQ(got.value().fields->size(), 4U);
}

TEST_F(FarFields, WhatSomebodyWatchesComesWithTheOthers) {
  watch(other_, {"stress_pa"});
  const auto got = solve(mine_);
  finish({"solve"});
  EXPECT_THAT(in(*got.value().fields), ElementsAre("displacement_m", "von_mises_pa", "stress_pa"));
  caf::anon_send(session_, detach_atom::value, other_);
  edit(.1);
  finish({"edit", "check", "commit", "solve"});
  EXPECT_EQ(heard(mine_).results.back().fields->size(), 2U) << "nobody watches it any more";
}

TEST_F(FarFields, WhoWatchesLaterGetsWhatWasLeft) {
  solve(mine_);
  finish({"solve"});
  const auto got = watch(mine_, {"stress_pa"});
  ASSERT_TRUE(got.value().result);
  EXPECT_THAT(in(*got.value().result->fields),
              ElementsAre("displacement_m", "von_mises_pa", "stress_pa"));
  EXPECT_DOUBLE_EQ(got.value().result->fields->back().values[0], 1.75);
  EXPECT_EQ(far().sent, 3U);
  EXPECT_TRUE(watch(other_, {"stress_pa"}).is_success());
  EXPECT_EQ(far().sent, 3U) << "it is here";
}

/// Two who ask at once.
TEST_F(FarFields, NoneIsThereTwice) {
  solve(mine_);
  finish({"solve"});
  const auto first = ask<held_result>(session_, watch_request{mine_, {"stress_pa"}});
  const auto second = ask<held_result>(session_, watch_request{other_, {"stress_pa"}});
  pass(milliseconds(1));
  EXPECT_EQ(first.value().result->fields->size(), 3U);
  EXPECT_EQ(second.value().result->fields->size(), 3U);
  EXPECT_EQ(far().sent, 3U);
}

TEST_F(FarFields, WhatTheSolverHasForgottenIsMadeOnceMore) {
  solve(mine_);
  finish({"solve"});
  far().forgot = true;
  const auto got = watch(mine_, {"relative_error"});
  EXPECT_FALSE(got.value().result);
  EXPECT_TRUE(got.value().solving);
  ASSERT_THAT(tasks(), ElementsAre("solve"));
  far().forgot = false;
  finish({"solve"});
  EXPECT_THAT(in(*heard(mine_).results.back().fields),
              ElementsAre("displacement_m", "von_mises_pa", "relative_error"));
}

TEST_F(FarFields, ADamagedOneIsNotTaken) {
  helper().add_fields = [this](solve_result& result) {
    add_fields(result);
    result.fields[2].components = 3;  // Of a stress.
  };
  solve(mine_);
  finish({"solve"});
  const auto got = watch(mine_, {"stress_pa"});
  EXPECT_FALSE(got.value().result);
  EXPECT_TRUE(got.value().solving);
}

/// Versions that were solved before anybody watched it are compared by it, too.
TEST_F(FarFields, AComparisonBringsWhatIsWatched) {
  solve(mine_);
  finish({"solve"});
  edit(.1);
  finish({"edit", "check", "commit", "solve"});
  watch(mine_, {"stress_pa"});
  const auto sent = far().sent;
  const auto got = request<compared>(comparison_request{++tickets_, 0, 1, "hanging"});
  EXPECT_EQ(far().sent, sent + 1) << "of the version before";
  finish({"compare"});
  ASSERT_TRUE(got.is_success());
  EXPECT_THAT(in(*got.value().difference), testing::Contains("stress_pa_difference"));
}

}  // namespace
}  // namespace tedit::actors
