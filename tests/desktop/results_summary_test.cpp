// SPDX-License-Identifier: AGPL-3.0-or-later
// From a solve's reports to the rows that people read: exact small cases, made by hand.
#include "client-qt/model/results_summary.hpp"
#include "client-qt/model/load_words.hpp"

#include <gtest/gtest.h>

#include <QLocale>

#include "client-qt/model/place_words.hpp"
#include "client-qt/model/results_table.hpp"

namespace tedit::desktop {

namespace {

solve_report report(const std::string& name, double stress) {
  solve_report result;
  result.version_id = "v2";
  result.load_case = name;
  result.device = "cpu";
  result.element_order = 2;
  result.preview = false;
  result.max_von_mises_pa = stress;
  result.max_von_mises_at = {0.5, 0, 0};
  result.max_displacement_m = 2.5e-5;
  result.max_displacement_at = {1, 1, 0};
  result.relative_error_estimate = 0.031;
  result.applied_n = {0, 0, -500};
  result.reaction_n = {0, 0, 500};
  result.surface_reactions = {{7, "Foot", {0, 0, 500}}};
  result.mass_kg = 0.12;
  result.min_safety_factor = 17.5;
  result.min_safety_factor_at = {0.5, 0, 0};
  return result;
}

fem::load_case loads(const std::string& name, double newtons = -500) {
  fem::load_case result;
  result.name = name;
  result.materials = {{"Steel", 210e9, 0.3, 7850, 235e6, {}}};
  result.constraints = {{{7}, fem::fixed{}}};
  result.loads = {{{8}, fem::force{{0, 0, newtons}}}};
  return result;
}

solve_envelope envelope(double stress) {
  solve_envelope result;
  result.version_id = "v2";
  result.load_cases = {"up", "side"};
  result.element_order = 2;
  result.preview = false;
  result.max_von_mises = {stress, {0.5, 0, 0}, "side"};
  result.max_displacement = {2.5e-5, {1, 1, 0}, "up"};
  result.min_safety_factor = worst_value{17.5, {0.5, 0, 0}, "side"};
  return result;
}

/// A version that was solved, after one that was, too.
class Summary : public testing::Test {
protected:
  Summary() {
    QLocale::setDefault(QLocale::c());
    before_.info.number = 1;
    before_.info.version_id = "v1";
    before_.outcome = solve_outcome{{report("up", 10e6)}, {}};
    before_.load_cases = {loads("up")};
    now_.info.number = 2;
    now_.info.version_id = "v2";
    now_.info.parent = 1;
    now_.outcome = solve_outcome{{report("up", 13.4e6)}, {}};
    now_.load_cases = {loads("up")};
  }
  ~Summary() override { QLocale::setDefault(QLocale::c()); }

  [[nodiscard]] results_summary made(field_state state = field_state::converged,
                                     bool with_parent = true) const {
    return summarise({&now_, with_parent ? &before_ : nullptr, state, "no pivot",
                      [](surface_id id) { return id == 7 ? QString("Foot") : QString("Top"); }});
  }
  solve_report& now() { return now_.outcome->cases.front(); }

  /// The first row of a kind in all sections; one without a title when there is none.
  static result_row row(const results_summary& in, figure kind) {
    for (const auto& section : in.sections)
      for (const auto& one : section.rows)
        if (one.kind == kind)
          return one;
    return {};
  }
  static bool has(const results_summary& in, figure kind) { return !row(in, kind).title.isEmpty(); }

  /// A field on four vertices at x = 0, 0.5, 1, 1.5, in whose report the second is singular.
  void give_field(const std::vector<float>& stress) {
    client::surface_update update;
    update.version_id = "v2";
    update.vertices = {0, 1, 2, 3};
    update.positions = {0, 0, 0, 0.5, 0, 0, 1, 1, 0, 1.5, 0, 0};
    update.facets = {0, 1};
    update.facet_vertices = {0, 1, 2, 1, 3, 2};
    update.facet_surfaces = {7, 8};
    client::surface_model surface;
    ASSERT_TRUE(surface.apply(update));
    now_.surface = std::make_shared<const client::surface_model>(surface);
    now().max_von_mises_singularity = fem::singularity::clamp_rim;
    now().singular_places = {{fem::singularity::clamp_rim, {0.5, 0, 0}, 13.4e6}};
    now().singular_places_count = 1;
    auto field = std::make_shared<client::field_event>();
    field->report = now();
    field->vertices = {0, 1, 2, 3};
    field->values["von_mises_pa"] = stress;
    now_.fields = {field};
  }

  version_record before_;
  version_record now_;
};

TEST_F(Summary, OneLoadCaseHasItsFiguresAndThePartItsMass) {
  const auto all = made();

  EXPECT_EQ(all.state, QString("Version 2: final"));
  EXPECT_TRUE(all.final);
  EXPECT_TRUE(all.missing.isEmpty());
  ASSERT_EQ(all.sections.size(), 2U);
  EXPECT_EQ(all.sections[0].title, QString("up"));
  EXPECT_EQ(all.sections[1].title, QString("Part"));
  const auto stress = row(all, figure::stress);
  EXPECT_EQ(stress.value, (shown_quantity{"13.4", "MPa"}));
  EXPECT_EQ(stress.at, std::optional(vec3{0.5, 0, 0}));
  EXPECT_TRUE(stress.warning.isEmpty());
  EXPECT_EQ(row(all, figure::displacement).value, (shown_quantity{"0.025", "mm"}))
    << "as in the legend";
  EXPECT_EQ(row(all, figure::safety).value, (shown_quantity{"17.5", {}}));
  EXPECT_EQ(row(all, figure::mass).value, (shown_quantity{"120", "g"}));
  EXPECT_EQ(row(all, figure::error).value, (shown_quantity{"3.1", "%"}));
  EXPECT_TRUE(all.sections[0].hints.isEmpty());
  EXPECT_FALSE(has(all, figure::sound_stress));
}

TEST_F(Summary, WhatChangedStandsBesideWhatItWasBefore) {
  const auto all = made();

  const auto stress = row(all, figure::stress);
  EXPECT_EQ(all.before, std::optional(1U));
  EXPECT_EQ(stress.before, (std::optional(shown_quantity{"10", "MPa"})));
  EXPECT_EQ(stress.change, QString("+34 %"));
  EXPECT_EQ(row(all, figure::mass).change, QString("0.0 %"));
  EXPECT_FALSE(row(all, figure::reaction).compares);
}

TEST_F(Summary, AVersionBeforeThatIsNotKnownOrHadOtherLoadsGivesNoChange) {
  before_.load_cases = {loads("up", -400)};
  EXPECT_FALSE(row(made(), figure::stress).before);
  EXPECT_TRUE(row(made(), figure::stress).compares);

  // The edit itself took a load away: then the difference is its doing.
  now_.report.emplace();
  now_.report->receipt = {{"up", "load 1 (force)", fem::receipt_fate::reduced, {}, 0, 0, {}, {}}};
  EXPECT_TRUE(row(made(), figure::stress).before);

  before_.outcome->cases.front().element_order = 1;
  EXPECT_FALSE(row(made(), figure::stress).before);
  before_.outcome.reset();
  EXPECT_FALSE(row(made(), figure::stress).before);
  EXPECT_TRUE(row(made(), figure::stress).change.isEmpty());

  const auto alone = made(field_state::converged, false);
  EXPECT_FALSE(alone.before);
  EXPECT_FALSE(row(alone, figure::stress).compares);
}

TEST_F(Summary, SeveralLoadCasesBeginWithTheWorstOfAll) {
  now_.outcome = solve_outcome{{report("up", 13.4e6), report("side", 20e6)}, envelope(20e6)};
  before_.outcome = solve_outcome{{report("up", 10e6), report("side", 16e6)}, envelope(16e6)};
  now_.load_cases = before_.load_cases = {loads("up"), loads("side")};

  const auto all = made();

  ASSERT_EQ(all.sections.size(), 4U);
  EXPECT_EQ(all.sections[0].title, QString("Worst of 2 load cases"));
  const auto& worst = all.sections[0].rows;
  ASSERT_EQ(worst.size(), 3U);
  EXPECT_EQ(worst[0].value.text(), QString("20 MPa"));
  EXPECT_EQ(worst[0].note, QString("in side"));
  EXPECT_EQ(worst[0].change, QString("+25 %"));
  EXPECT_EQ(worst[1].note, QString("in up"));
  EXPECT_EQ(worst[2].kind, figure::safety);
  EXPECT_EQ(all.sections[1].load_case, "up");
  EXPECT_EQ(all.sections[2].rows[0].value.text(), QString("20 MPa"));
  EXPECT_EQ(all.sections[3].rows.size(), 1U) << "one mass for all";

  before_.outcome->cases.pop_back();  // One of them was not solved before: no envelope to compare.
  EXPECT_FALSE(made().sections[0].rows[0].before);
}

TEST_F(Summary, AMassThatDiffersStandsWithItsLoadCase) {
  auto heavy = report("side", 20e6);
  heavy.mass_kg = 0.3;
  now_.outcome = solve_outcome{{report("up", 13.4e6), heavy}, envelope(20e6)};

  const auto all = made();

  ASSERT_EQ(all.sections.size(), 3U);
  EXPECT_EQ(all.sections[1].rows.back().value.text(), QString("120 g"));
  EXPECT_EQ(all.sections[2].rows.back().value.text(), QString("300 g"));
}

TEST_F(Summary, WhatIsNotKnownHasNoRowButAHint) {
  now().min_safety_factor.reset();
  now().mass_kg.reset();
  now_.load_cases.front().materials.front().yield_strength_pa = 0;

  const auto all = made();

  EXPECT_FALSE(has(all, figure::safety));
  EXPECT_FALSE(has(all, figure::mass));
  ASSERT_EQ(all.sections.size(), 1U);
  ASSERT_EQ(all.sections[0].hints.size(), 2);
  EXPECT_TRUE(all.sections[0].hints[0].contains("yield strength"));
  EXPECT_TRUE(all.sections[0].hints[1].contains("density"));
}

TEST_F(Summary, ValuesOfZeroHaveNoRow) {
  now().max_von_mises_pa = 0;
  now().max_displacement_m = 0;
  now().relative_error_estimate = 0;
  now().min_safety_factor = 1e6;  // The cap: nothing stresses the part.
  now().surface_reactions.push_back({9, "Side", {1e-4, 0, 0}});  // Noise beside 500 N.

  const auto all = made();

  EXPECT_FALSE(has(all, figure::stress));
  EXPECT_FALSE(has(all, figure::displacement));
  EXPECT_FALSE(has(all, figure::safety));
  EXPECT_FALSE(has(all, figure::error));
  ASSERT_EQ(all.sections[0].rows.size(), 2U);  // The reaction of the foot, and the sum.
  EXPECT_EQ(all.sections[0].hints.size(), 1);
}

TEST_F(Summary, ReactionsAreBySupportAndTheirSumIsSetAgainstTheLoads) {
  now_.load_cases.front().constraints = {{{7, 9}, fem::fixed{}}, {{10}, fem::roller{}}};
  now().surface_reactions = {
    {7, "Foot", {0, 0, 300}}, {9, "Top", {40, 0, 50}}, {10, "Side", {-40, 0, 150}}};

  const auto all = made();
  std::vector<result_row> reactions;
  for (const auto& one : all.sections[0].rows)
    if (one.kind == figure::reaction || one.kind == figure::reaction_sum)
      reactions.push_back(one);

  ASSERT_EQ(reactions.size(), 3U);
  EXPECT_EQ(reactions[0].title, QString("Reaction: Fixed"));
  EXPECT_EQ(reactions[0].where, QString("Foot, Top"));
  EXPECT_EQ(reactions[0].surfaces, (std::vector<surface_id>{7, 9}));
  EXPECT_EQ(reactions[0].value.text(), QString("352.3 N"));  // |(40, 0, 350)|
  EXPECT_EQ(reactions[0].note, QString("x 40 N; z 350 N"));
  EXPECT_EQ(reactions[1].value.text(), QString("155.2 N"));
  EXPECT_EQ(reactions[2].value.text(), QString("500 N"));
  EXPECT_EQ(reactions[2].note, QString("along +z; balances the loads"));
  EXPECT_TRUE(reactions[2].warning.isEmpty());

  now().applied_n = {0, 0, -450};
  EXPECT_TRUE(row(made(), figure::reaction_sum).warning.contains("50 N"));
}

TEST_F(Summary, ASingularPlaceWarnsAndTheLargestStressElsewhereIsSaidWhereItIsKnown) {
  give_field({9e6F, 13.4e6F, 8e6F, 2e6F});

  const auto all = made();
  EXPECT_TRUE(row(all, figure::stress).warning.contains("rim of a clamp"));
  EXPECT_TRUE(row(all, figure::stress).warning.contains("no measure of strength"));
  EXPECT_TRUE(row(all, figure::safety).warning.contains("rim of a clamp"));
  const auto sound = row(all, figure::sound_stress);
  EXPECT_EQ(sound.value.text(), QString("9 MPa"));
  EXPECT_EQ(sound.at, std::optional(vec3{0, 0, 0}));
}

TEST_F(Summary, ALargestStressElsewhereThatNobodyLookedAtIsNotSaid) {
  give_field({6e6F, 13.4e6F, 5e6F, 2e6F});  // Below half of the largest none was looked at.
  EXPECT_FALSE(has(made(), figure::sound_stress));

  give_field({9e6F, 13.4e6F, 8e6F, 2e6F});
  now().singular_places_count = 30;  // The list is cut off at 10 MPa: 9 MPa may be one of them.
  now().singular_places.push_back({fem::singularity::clamp_rim, {2, 0, 0}, 10e6});
  auto field = std::make_shared<client::field_event>(*now_.fields.front());
  field->report = now();
  now_.fields = {field};
  EXPECT_FALSE(has(made(), figure::sound_stress));
}

TEST_F(Summary, ASafetyFactorBelowOneIsAWarning) {
  now().min_safety_factor = 0.8;

  EXPECT_TRUE(row(made(), figure::safety).warning.startsWith("Below 1"));
}

TEST_F(Summary, WithoutATrueFieldThereIsNoRowButTheReasonAndWhatToDo) {
  using enum field_state;
  const std::pair<field_state, const char*> expected[] = {{none, "not solved yet"},
                                                          {waiting, "solver runs"},
                                                          {solving, "solver runs"},
                                                          {failed, "no pivot"},
                                                          {stopped, "was stopped"}};
  for (const auto& [state, words] : expected) {
    const auto all = made(state);
    EXPECT_TRUE(all.sections.empty()) << words;
    EXPECT_TRUE(all.missing.contains(words)) << all.missing.toStdString();
    EXPECT_TRUE(all.state.isEmpty());
  }
  now_.load_cases.clear();
  EXPECT_TRUE(made(none).missing.contains("Add supports and loads"));
  EXPECT_TRUE(summarise({}).missing.contains("Open a part"));
}

TEST_F(Summary, AFirstFieldIsAPreviewAndIsComparedWithNothing) {
  auto field = std::make_shared<client::field_event>();
  field->report = report("up", 12e6);
  field->report.interim = true;
  field->report.preview = true;
  now_.fields = {field};
  now_.outcome.reset();

  const auto all = made(field_state::interim);

  EXPECT_TRUE(all.state.startsWith("Version 2: preview"));
  EXPECT_FALSE(all.final);
  EXPECT_EQ(row(all, figure::stress).value.text(), QString("12 MPa"));
  EXPECT_FALSE(row(all, figure::stress).before);
}

TEST_F(Summary, LinearTetsAreAPreview) {
  now().element_order = 1;
  now().preview = true;

  EXPECT_TRUE(made().state.contains("linear tets"));
  EXPECT_FALSE(made().final);
}

TEST(ErrorWords, HaveTheLimitsOfTheManual) {
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(error_words(0.031), QString("good: on average stresses are within about 3.1 %"));
  EXPECT_TRUE(error_words(0.05).startsWith("good"));
  EXPECT_TRUE(error_words(0.0501).startsWith("fair"));
  EXPECT_TRUE(error_words(0.1001).startsWith("rough"));
  EXPECT_TRUE(error_words(0.2001).startsWith("poor"));
}

// -- as a table ----------------------------------------------------------------------

TEST_F(Summary, IsCopiedAsATableWithNumbersInCellsOfTheirOwn) {
  now_.info.parent.reset();
  auto all = made(field_state::converged, false);
  name_places(all, [](const vec3&) { return QString("Foot\tand Top"); });

  const auto lines = as_text_table(all).split('\n');

  ASSERT_EQ(lines.size(), 9);  // Titles, seven rows, and the end of the last one.
  EXPECT_EQ(lines[0], QString("Load case\tFigure\tValue\tUnit\tWhere\tNote"));
  EXPECT_EQ(lines[1], QString("up\tLargest von Mises stress\t13.4\tMPa\tFoot and Top\t"));
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(lines[i].count('\t'), 5) << lines[i].toStdString();
  EXPECT_TRUE(as_html_table(all).contains("<td>13.4</td><td>MPa</td>"));
  EXPECT_EQ(as_html_table(all).count("<tr>"), 8);
}

TEST_F(Summary, TheTableHasTheVersionBeforeWithTheMinusOfAKeyboard) {
  now().max_von_mises_pa = 8e6;
  const auto lines = as_text_table(made()).split('\n');

  EXPECT_TRUE(lines[0].endsWith("\tVersion 1\tUnit\tChange")) << lines[0].toStdString();
  EXPECT_TRUE(lines[1].endsWith("\t10\tMPa\t-20 %")) << lines[1].toStdString();
  before_.outcome.reset();
  EXPECT_TRUE(as_text_table(made()).split('\n')[1].endsWith("\t-\t\t-"));
}

TEST_F(Summary, NumbersHaveTheDecimalPointOfTheLocale) {
  QLocale::setDefault(QLocale("de_DE"));
  now().max_von_mises_pa = 13.46e6;

  const auto all = made();

  EXPECT_EQ(row(all, figure::stress).value.text(), QString("13,46 MPa"));
  EXPECT_EQ(row(all, figure::safety).value.text(), QString("17,5"));
  EXPECT_EQ(row(all, figure::mass).change, QString("0,0 %"));
  EXPECT_TRUE(as_text_table(all).contains("\t13,46\tMPa\t"));
  EXPECT_TRUE(row(all, figure::error).note.contains("3,1"));
}

TEST(ShownNumbers, HaveAUnitByTheirSize) {
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(shown(1.2e-7, "m").text(), QString("120 nm"));
  EXPECT_EQ(shown(2, "m").text(), QString("2 m"));
  EXPECT_EQ(shown(0.0125, "m").text(), QString("12.5 mm"));
  EXPECT_EQ(shown(4e4, "Pa").text(), QString("40 kPa"));
  EXPECT_EQ(shown(-13.4e6, "Pa").text(), QString("-13.4 MPa"));
  EXPECT_EQ(shown(3e5, "N").text(), QString("300 kN"));
  EXPECT_EQ(shown(0, "N").text(), QString("0 N"));
  EXPECT_EQ(shown(39.7, "kg").text(), QString("39.7 kg"));
  EXPECT_EQ(shown(2e-6, "m3").text(), QString::fromUtf8("2000 mm³"));
}

TEST(ShownNumbers, SideBySideStayReadable) {
  const fem::load push{{1}, fem::force{{0.5, -1.25, 3}}};
  const fem::constraint moved{{2}, fem::prescribed_displacement{1.5e-3, {}, -2e-3}};
  QLocale::setDefault(QLocale("de_DE"));
  EXPECT_TRUE(words(push).endsWith("3,288 N (0,5; -1,25; 3)")) << words(push).toStdString();
  EXPECT_TRUE(words(moved).endsWith("x 1,5 mm; z -2 mm")) << words(moved).toStdString();
  QLocale::setDefault(QLocale::c());
  EXPECT_TRUE(words(push).endsWith("3.288 N (0.5, -1.25, 3)")) << words(push).toStdString();
}

// -- places --------------------------------------------------------------------------

/// A unit square of two triangles on surfaces 1 and 2, and one beside it, upright, on surface 3.
client::surface_model corner() {
  client::surface_update update;
  update.version_id = "v";
  update.vertices = {0, 1, 2, 3, 4};
  update.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, -1};
  update.facets = {0, 1, 2};
  update.facet_vertices = {0, 1, 2, 0, 2, 3, 1, 4, 2};
  update.facet_surfaces = {1, 2, 3};
  client::surface_model result;
  EXPECT_TRUE(result.apply(update));
  return result;
}

QString name(surface_id id) {
  return QString("S%1").arg(id);
}

TEST(Places, AreOnASurfaceWhereSomeMeetOrInside) {
  const std::vector<vec3> points{{0.75, 0.25, 0}, {1, 0.5, 0}, {1, 1, 0}, {0.75, 0.25, -0.1}};

  const auto found = find_places(corner(), points);

  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[0].surfaces, (std::vector<surface_id>{1}));
  EXPECT_EQ(found[0].depth_m, 0);
  EXPECT_EQ(found[0].outward, (vec3{0, 0, 1}));
  EXPECT_EQ(found[1].surfaces, (std::vector<surface_id>{1, 3}));
  EXPECT_EQ(found[2].surfaces, (std::vector<surface_id>{1, 2, 3}));
  EXPECT_EQ(found[3].surfaces, (std::vector<surface_id>{1}));
  EXPECT_DOUBLE_EQ(found[3].depth_m, 0.1);
}

TEST(Places, AreSaidByTheNamesOfSurfaces) {
  QLocale::setDefault(QLocale::c());
  EXPECT_EQ(words({{1}, 0, {}}, name), QString("S1"));
  EXPECT_EQ(words({{1, 3}, 0, {}}, name), QString("where S1 and S3 meet"));
  EXPECT_EQ(words({{1, 2, 3}, 0, {}}, name), QString("where S1, S2 and S3 meet"));
  EXPECT_EQ(words({{1, 2, 3, 4}, 0, {}}, name), QString("where 4 surfaces meet, S1 among them"));
  EXPECT_EQ(words({{1}, 0.0012, {}}, name), QString("inside, 1.2 mm from S1"));
  EXPECT_EQ(words({{1, 2}, 0, {}}, [](surface_id) { return QString("Wall"); }), QString("Wall"));
  EXPECT_EQ(words({}, name), QString());
}

TEST(Places, OfAPartWithoutFacetsAreNone) {
  EXPECT_EQ(find_places({}, std::vector<vec3>{{1, 0, 0}}).size(), 1U);
}

}  // namespace
}  // namespace tedit::desktop
