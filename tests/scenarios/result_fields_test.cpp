// SPDX-License-Identifier: AGPL-3.0-or-later
// What a client can have of a result beside displacement and von Mises stress, and what belongs to
// a version without making a new one: names, notes, load cases.
#include <condition_variable>
#include <future>
#include <mutex>

#include "mesh/io/formats.hpp"
#include "tests/scenarios/fixture.hpp"
#include "tests/support/blocks.hpp"

namespace tedit::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double pull_pa = 2e6;
constexpr double yield_pa = 276e6;

/// A bar along x, 4 x 1 x 1 m, held by rollers on three sides that meet, pulled at its end: the
/// stress is uniaxial and the same everywhere.
fem::load_case tension(const std::string& name, double yield = yield_pa) {
  fem::load_case loads;
  loads.name = name;
  loads.materials = {{"alloy", 70e9, 0.3, 2700, yield, {}}};
  for (const surface_id side : {1, 3, 5})
    loads.constraints.push_back({{side}, fem::roller{}});
  loads.loads.push_back({{2}, fem::traction{{pull_pa, 0, 0}}});
  return loads;
}

const client::watched_quantities all_there_are{"stress_pa", "safety_factor", "relative_error",
                                               "largest_strain"};

class ResultFields : public ::testing::Test {
protected:
  scratch_folder folder;
  std::unique_ptr<server> host = start(options_for(folder, false));
  std::mutex mutex;  ///< Guards what the events tell.
  std::condition_variable came;
  std::vector<client::field_event> fields;
  std::unique_ptr<client::client> user = connect(host->url(), handlers());

  client::events handlers() {
    client::events result;
    result.on_field = [this](const client::field_event& field) {
      const std::lock_guard lock(mutex);
      fields.push_back(field);
      came.notify_all();
    };
    return result;
  }

  client::committed import_bar(const std::vector<fem::load_case>& cases) {
    const auto bar = blocks({4, 1, 1}, [](int, int, int) { return true; });
    const auto file = folder.path() / "bar.msh";
    value(formats::msh::write(file, *bar, {"m"}));
    value(user->open("bar", true, true));
    auto done = value(user->import_file(file, "m", {}));
    for (const auto& one : cases)
      value(user->set_load_case(one));
    return done;
  }

  static client::solve_settings exactly() {
    client::solve_settings settings;
    settings.device = "cpu";
    settings.tolerance = 1e-11;
    settings.all_load_cases = true;
    return settings;
  }

  /// The first field after the first `skip` ones that `fits`.
  client::field_event wait_for(const std::function<bool(const client::field_event&)>& fits,
                               std::size_t skip = 0) {
    std::unique_lock lock(mutex);
    std::optional<client::field_event> found;
    came.wait_for(lock, patience, [&] {
      for (std::size_t i = skip; i < fields.size() && !found; ++i)
        if (fits(fields[i]))
          found = fields[i];
      return found.has_value();
    });
    if (!found)
      throw std::runtime_error("no such field came");
    return *found;
  }
};

TEST_F(ResultFields, ABarInTensionHasForceOverAreaAlongItAndNothingElse) {
  import_bar({tension("pull")});
  EXPECT_THAT(value(user->watch_fields(all_there_are)),
              HasSubstr("solve"));  // Not yet.
  value(user->solve_cases(exactly(), {}));
  const auto field = wait_for([](const auto& one) { return !one.interim(); });

  const auto n = field.vertices.size();
  ASSERT_EQ(n, 20U);
  ASSERT_EQ(field.values.of("stress_pa").size(), 6 * n);
  ASSERT_EQ(field.values.of("safety_factor").size(), n);
  ASSERT_EQ(field.values.of("relative_error").size(), n);
  ASSERT_EQ(field.values.of("largest_strain").size(), n);
  for (std::size_t v = 0; v < n; ++v) {
    EXPECT_NEAR(field.values.of("stress_pa")[6 * v], pull_pa, 1e-6 * pull_pa);
    for (std::size_t c = 1; c < 6; ++c)
      EXPECT_NEAR(field.values.of("stress_pa")[6 * v + c], 0, 1e-6 * pull_pa);
    EXPECT_NEAR(field.values.of("safety_factor")[v], yield_pa / pull_pa, 1e-5 * yield_pa / pull_pa);
    EXPECT_LT(field.values.of("relative_error")[v], 1e-6);  // A uniform stress is met exactly.
    EXPECT_NEAR(field.values.of("largest_strain")[v], pull_pa / 70e9, 1e-6 * pull_pa / 70e9);
  }
}

TEST_F(ResultFields, WhatIsAskedForLaterComesWithoutAnotherSolveAndGoesWhenItIsNotWanted) {
  const auto imported = import_bar({tension("pull", 0)});
  value(user->solve_cases(exactly(), {}));
  EXPECT_THAT(value(user->wait_field(imported.head.version_id, patience)).values.of("stress_pa"),
              IsEmpty());

  EXPECT_EQ(value(user->watch_fields({"stress_pa", "safety_factor"})), "");
  const auto more = value(user->wait_field(imported.head.version_id, patience));
  EXPECT_EQ(more.values.of("stress_pa").size(), 6 * more.vertices.size());
  EXPECT_THAT(more.values.of("relative_error"), IsEmpty());
  EXPECT_THAT(more.values.of("safety_factor"), IsEmpty());  // No yield strength is known.

  EXPECT_EQ(value(user->watch_fields({})), "");
  EXPECT_THAT(value(user->wait_field(imported.head.version_id, patience)).values.of("stress_pa"),
              IsEmpty());
}

TEST_F(ResultFields, AQuantityThatIsNotThereIsRefusedWithThoseThatAre) {
  import_bar({tension("pull")});

  for (const auto* name : {"heat_w", "element_stress_pa", ""}) {
    const auto refused = user->watch_fields({"stress_pa", name});
    ASSERT_FALSE(refused.has_value()) << name;
    EXPECT_EQ(refused.error().code, ec::invalid_argument);
    EXPECT_THAT(refused.error().message, HasSubstr("\"" + std::string(name) + "\" to watch"));
    EXPECT_THAT(refused.error().remedy, HasSubstr("stress_pa, safety_factor, relative_error"));
  }
}

TEST_F(ResultFields, ANewLoadCaseMakesTheOldResultWorthless) {
  import_bar({tension("pull")});
  value(user->solve_cases(exactly(), {}));
  auto weaker = tension("pull");
  weaker.loads.front().kind = fem::traction{{1, 0, 0}};
  value(user->set_load_case(weaker));

  EXPECT_THAT(value(user->watch_fields({"stress_pa"})), HasSubstr("solve"));
}

TEST_F(ResultFields, ASectionHasWhatIsWatchedAndAnEnvelopeItsSafety) {
  import_bar({tension("pull"), tension("again")});
  value(user->solve_cases(exactly(), {}));
  value(user->watch_fields(all_there_are));

  const auto of_case = value(user->cut({2.5, 0, 0}, {1, 0, 0}, "again", {}));
  const auto points = of_case.positions.size() / 3;
  ASSERT_GT(points, 3U);
  ASSERT_EQ(of_case.values.of("stress_pa").size(), 6 * points);
  EXPECT_EQ(of_case.values.of("relative_error").size(), points);
  EXPECT_EQ(of_case.values.of("largest_strain").size(), points);
  for (std::size_t p = 0; p < points; ++p) {
    EXPECT_NEAR(of_case.values.of("stress_pa")[6 * p], pull_pa, 1e-6 * pull_pa);
    EXPECT_NEAR(of_case.values.of("safety_factor")[p], yield_pa / pull_pa,
                1e-5 * yield_pa / pull_pa);
  }
  const auto of_all = value(user->cut({2.5, 0, 0}, {1, 0, 0}, "", {}));
  EXPECT_THAT(of_all.values.of("stress_pa"), IsEmpty());
  EXPECT_EQ(of_all.values.of("safety_factor").size(), points);
}

// -- names and notes -------------------------------------------------------------------

TEST_F(ResultFields, ANameAndANoteAreToldToAllAndSurviveUndoAndTheServer) {
  std::promise<client::version_info> told;
  client::events handlers;
  handlers.on_annotated = [&](const client::version_info& info) { told.set_value(info); };
  const auto other = connect(host->url(), handlers);
  import_bar({});
  value(other->open("bar", false, false));
  value(user->import_file(folder.path() / "bar.msh", "m", {}));

  value(user->annotate(1, "finer \u00d8 25", "two lines\nof a note"));
  auto event = told.get_future();
  ASSERT_EQ(event.wait_for(patience), std::future_status::ready);
  EXPECT_EQ(event.get().name, "finer \u00d8 25");
  value(user->undo());
  EXPECT_EQ(value(user->get_history()).versions.at(1).note, "two lines\nof a note");

  user.reset();
  host.reset();
  host = start(options_for(folder, false));
  user = connect(host->url());
  value(user->open("bar", false, false));
  const auto kept = value(user->get_history());
  EXPECT_EQ(kept.versions.at(1).name, "finer \u00d8 25");
  EXPECT_EQ(kept.versions.at(0).name, "");
  value(user->annotate(1, "", ""));
  EXPECT_EQ(value(user->get_history()).versions.at(1).name, "");
}

TEST_F(ResultFields, NamesThatCannotBeAreRefused) {
  import_bar({});
  const auto code = [&](std::uint32_t number, const std::string& name, const std::string& note) {
    const auto refused = user->annotate(number, name, note);
    return refused ? ec::internal : refused.error().code;
  };
  EXPECT_EQ(code(7, "x", ""), ec::not_found);
  EXPECT_EQ(code(0, "two\nlines", ""), ec::invalid_argument);
  EXPECT_EQ(code(0, std::string(81, 'x'), ""), ec::invalid_argument);
  EXPECT_EQ(code(0, "", std::string(4001, 'x')), ec::invalid_argument);
  std::string eighty;
  for (int i = 0; i < 80; ++i)
    eighty += "\u00e4";  // Two bytes each.
  value(user->annotate(0, eighty, ""));
}

// -- load cases that go ----------------------------------------------------------------

TEST_F(ResultFields, ARemovedLoadCaseIsSolvedNoMoreTheLastOneNeither) {
  const auto imported = import_bar({tension("first"), tension("second")});
  EXPECT_EQ(value(user->solve_cases(exactly(), {})).cases.size(), 2U);

  value(user->remove_load_case("first"));
  EXPECT_THAT(value(user->get_history()).versions.at(0).load_cases, ElementsAre("second"));
  const auto rest = value(user->solve_cases(exactly(), {}));
  ASSERT_EQ(rest.cases.size(), 1U);
  EXPECT_EQ(rest.cases.front().load_case, "second");

  value(user->remove_load_case("second"));
  EXPECT_THAT(value(user->get_history()).versions.at(0).load_cases, IsEmpty());
  const auto refused = user->remove_load_case("second");
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::not_found);
}

}  // namespace
}  // namespace tedit::test
