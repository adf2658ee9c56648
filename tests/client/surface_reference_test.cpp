// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client/surface_reference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/recipe.hpp"

namespace tedit::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two plates at right angles, 10 x 10 mm each, that meet in the y axis: "floor" (1) in z = 0,
/// "wall" (2) in x = 0; and, where wanted, a second floor (7) at z = 10 mm.
surface_model corner(bool with_roof) {
  surface_update update;
  update.version_id = "a";
  update.surfaces = {{1, "floor", 2, 1e-4}, {2, "wall", 2, 1e-4}};
  update.vertices = {0, 1, 2, 3, 4, 5};
  update.positions = {0, 0, 0, 0.01, 0, 0, 0.01, 0.01, 0, 0, 0.01, 0, 0, 0, 0.01, 0, 0.01, 0.01};
  update.facets = {0, 1, 2, 3};
  update.facet_vertices = {0, 1, 2, 0, 2, 3, 0, 3, 5, 0, 5, 4};
  update.facet_surfaces = {1, 1, 2, 2};
  if (with_roof) {
    update.surfaces.push_back({7, "floor", 1, 5e-5});
    update.vertices.push_back(6);
    update.positions.insert(update.positions.end(), {0.01, 0.01, 0.01});
    update.facets.push_back(4);
    update.facet_vertices.insert(update.facet_vertices.end(), {4, 6, 5});
    update.facet_surfaces.push_back(7);
  }
  surface_model result;
  EXPECT_TRUE(result.apply(update));
  return result;
}

std::vector<surface_id> found(const surface_reference& one, const surface_references& known = {}) {
  const auto ids = known.find(one, corner(true));
  EXPECT_TRUE(ids) << render(ids.error());
  return ids.value_or(std::vector<surface_id>{});
}

error reason(const surface_reference& one, const surface_references& known = {}) {
  const auto ids = known.find(one, corner(true));
  EXPECT_FALSE(ids);
  return ids ? error{} : ids.error();
}

TEST(SurfaceReference, ANameIsAllThatAreCalledSo) {
  EXPECT_THAT(found({.name = "floor"}), ElementsAre(1, 7));
  EXPECT_THAT(found({.name = "wall"}), ElementsAre(2));
  const auto refused = reason({.name = "roof"});
  EXPECT_EQ(refused.code, ec::surface_not_found);
  EXPECT_EQ(refused.message, "no surface is called \"roof\"");
  EXPECT_EQ(refused.remedy, "Its surfaces are called floor, wall");
}

TEST(SurfaceReference, APointIsTheNearestSurfaceThatIsNearEnough) {
  EXPECT_THAT(found({.at_mm = vec3{6, 5, 0.1}}), ElementsAre(1));
  EXPECT_THAT(found({.at_mm = vec3{0, 5, 6}}), ElementsAre(2));
  // The part's size is 17.3 mm: a hundredth of it is 0.17 mm.
  const auto refused = reason({.at_mm = vec3{6, 5, 2.5}});
  EXPECT_EQ(refused.code, ec::surface_not_found);
  EXPECT_EQ(refused.message, "the nearest surface to (6, 5, 2.5) mm, 1, is 2.5 mm away");
  EXPECT_THAT(found({.at_mm = vec3{6, 5, 2.5}, .within_mm = 2.6}), ElementsAre(1));
  EXPECT_THAT(found({.name = "wall", .at_mm = vec3{6, 5, 0}, .within_mm = 7}), ElementsAre(2));
}

TEST(SurfaceReference, APointBetweenSurfacesSaysNothingUnlessAFeatureIsMeant) {
  const auto refused = reason({.at_mm = vec3{0, 5, 0}});
  EXPECT_EQ(refused.code, ec::invalid_argument);
  EXPECT_EQ(refused.message, "(0, 5, 0) mm lies between surfaces 1 and 2");
  EXPECT_THAT(found({.at_mm = vec3{0, 5, 0}, .feature = feature_kind::hole}), ElementsAre(1));
}

TEST(SurfaceReference, IsMadeOfANameWhereThatIsEnoughAndElseOfAPlace) {
  const auto part = corner(true);
  EXPECT_EQ(reference_to(2, part), surface_reference{.name = "wall"});
  // Two are called so: the middle of one of the two facets (0, 0, 0), (10, 0, 0), (10, 10, 0).
  const auto floor = reference_to(1, part);
  ASSERT_TRUE(floor && floor->at_mm);
  EXPECT_EQ(floor->name, "");
  EXPECT_NEAR(floor->at_mm->x, 6.6667, 1e-9) << "to a ten-thousandth";
  EXPECT_NEAR(floor->at_mm->y, 3.3333, 1e-9);
  EXPECT_EQ(floor->at_mm->z, 0);
  for (const surface_id id : {1, 2, 7})
    EXPECT_THAT(found(*reference_to(id, part)), ElementsAre(id));
  EXPECT_EQ(reference_to(2, part, "edit 1")->made_by, "edit 1");
  EXPECT_EQ(reference_to(5, part), std::nullopt);
}

TEST(SurfaceReference, TakesThePlaceOfNumbersOnceEach) {
  const auto part = corner(true);
  std::vector<surface_reference> references;
  std::vector<surface_id> ids{2, 5, 1};
  const auto of = [&](surface_id id) { return reference_to(id, part); };
  refer_to_surfaces(ids, references, of);
  EXPECT_THAT(ids, ElementsAre(place_of_reference(0), 5, place_of_reference(1)));
  fem::load_case loads;
  loads.constraints.push_back({.surfaces = {1}});
  loads.loads.push_back({.surfaces = {7, 2}});
  refer_to_surfaces(loads, references, of);
  EXPECT_THAT(loads.constraints[0].surfaces, ElementsAre(place_of_reference(1)));
  EXPECT_THAT(loads.loads[0].surfaces, ElementsAre(place_of_reference(2), place_of_reference(0)));
  EXPECT_EQ(references.size(), 3U);
}

TEST(SurfaceReference, IsSaidInWords) {
  EXPECT_EQ(words_of(surface_reference{.at_mm = vec3{1, 2.5, -3}, .feature = feature_kind::hole}),
            "hole at (1, 2.5, -3) mm");
  EXPECT_EQ(words_of({4, place_of_reference(0), place_of_reference(1)},
                     {{.made_by = "pin"}, {.name = "Top", .made_by = "pin"}}),
            "4, what pin made, Top of what pin made");
}

TEST(SurfaceReference, WhatAnEditMadeHasItsLabel) {
  surface_references known;
  known.note("roof", corner(false), corner(true));
  known.note("nothing", corner(true), corner(true));
  known.note("", corner(false), corner(true));
  EXPECT_THAT(found({.made_by = "roof"}, known), ElementsAre(7));
  EXPECT_THAT(found({.name = "floor", .made_by = "roof"}, known), ElementsAre(7));
  EXPECT_EQ(reason({.made_by = "boss"}, known).message, "no edit so far was labelled \"boss\"");
  EXPECT_EQ(reason({.made_by = "nothing"}, known).message,
            "the edit \"nothing\" made no surface of its own");
  EXPECT_EQ(reason({.name = "wall", .made_by = "roof"}, known).message,
            "of what the edit \"roof\" made no surface is called \"wall\"");
  const auto later = known.find({.made_by = "roof"}, corner(false));
  ASSERT_FALSE(later);
  EXPECT_EQ(later.error().message, "of what the edit \"roof\" made no surface is left");
}

TEST(SurfaceReference, AFeatureIsAskedForAndTheMeaningsStandWhereTheReferencesStood) {
  std::vector<selection_query> asked;
  const auto select = [&](const selection_query& query) -> expected<std::vector<found_feature>> {
    asked.push_back(query);
    return std::vector<found_feature>{{.kind = query.kind, .surfaces = {2, 9}}};
  };
  const std::vector<surface_reference> references{
    {.name = "wall", .feature = feature_kind::protrusion}, {.name = "floor"}};

  const auto meanings = meanings_of(references, {}, corner(true), select);

  ASSERT_TRUE(meanings) << render(meanings.error());
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked[0].kind, feature_kind::protrusion);
  EXPECT_THAT(asked[0].surfaces, ElementsAre(2));
  EXPECT_THAT(*meanings, ElementsAre(ElementsAre(2, 9), ElementsAre(1, 7)));
  std::vector<surface_id> ids{-3, place_of_reference(1), 9, place_of_reference(0)};
  put_surfaces(ids, *meanings);
  EXPECT_THAT(ids, ElementsAre(-3, 1, 7, 9, 2));
  std::vector<surface_id> plain{4, 4};
  put_surfaces(plain, {});
  EXPECT_THAT(plain, ElementsAre(4, 4));

  const auto refused = meanings_of(references, {}, corner(true), [](const selection_query&) {
    return expected<std::vector<found_feature>>(fail(ec::not_a_protrusion, "it is flat"));
  });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ec::not_a_protrusion);
}

// -- in the file --------------------------------------------------------------------------

constexpr const char* recipe_with_references = R"([
  {"edit": {"operation": "boss", "surfaces": [5, {"name": "Top"}], "label": "pin"}},
  {"load_case": {"name": "pull",
    "materials": [{"young_modulus_pa": 2e11, "poisson_ratio": 0.3}],
    "constraints": [{"surfaces": [{"at_mm": [1, 2.5, -3], "within_mm": 0.5, "as": "hole"}],
                     "fixed": {}}],
    "loads": [{"surfaces": [{"made_by": "pin"}, 8], "force": {"total_n": {"z": -5}}}]}}])";

TEST(SurfaceReference, IsReadAndWrittenWithItsStep) {
  const auto read = recipe_from_json(recipe_with_references);
  ASSERT_TRUE(read) << render(read.error());
  const auto& edit = std::get<edit_step>(read->steps[0]);
  EXPECT_EQ(edit.label, "pin");
  EXPECT_THAT(edit.references, ElementsAre(surface_reference{.name = "Top"}));
  EXPECT_THAT(edit.request.surfaces, ElementsAre(5, place_of_reference(0)));
  const auto& loads = std::get<load_case_step>(read->steps[1]);
  EXPECT_THAT(loads.references, ElementsAre(surface_reference{.at_mm = vec3{1, 2.5, -3},
                                                              .within_mm = 0.5,
                                                              .feature = feature_kind::hole},
                                            surface_reference{.made_by = "pin"}));
  EXPECT_THAT(loads.loads.loads.at(0).surfaces, ElementsAre(place_of_reference(1), 8));

  const auto again = recipe_from_json(to_json(*read));
  ASSERT_TRUE(again) << to_json(*read) << render(again.error());
  EXPECT_EQ(*again, *read);
  EXPECT_THAT(to_json(read->steps[0]), HasSubstr(R"("surfaces":[5,{"name":"Top"}])"));
}

TEST(SurfaceReference, WhatSaysNothingOrComesTooEarlyIsRefusedByItsStep) {
  const auto said = [](const std::string& surfaces, const std::string& more = "") {
    const auto read = recipe_from_json(R"([{"edit": {"operation": "erode", "surfaces": [)" +
                                       surfaces + "]" + more + "}}]");
    EXPECT_FALSE(read) << surfaces;
    return read ? "" : render(read.error());
  };
  EXPECT_THAT(said("{}"), HasSubstr("each of step 1 (edit): \"surfaces\" says no surface"));
  EXPECT_THAT(said(R"({"as": "hole"})"), HasSubstr("Give its name, made_by or at_mm"));
  EXPECT_THAT(said(R"({"at_mm": [1, 2]})"), HasSubstr("\"at_mm\""));
  EXPECT_THAT(said(R"({"at_mm": [1, 2, 1e300]})"), HasSubstr("1e+300"));
  EXPECT_THAT(said(R"({"name": "a", "within_mm": 1})"), HasSubstr("for a point"));
  EXPECT_THAT(said(R"({"name": "a", "as": "boss"})"), HasSubstr("hole, protrusion or smooth"));
  EXPECT_THAT(said(R"({"nane": "a"})"), HasSubstr("unknown field \"nane\""));
  EXPECT_THAT(said(R"({"made_by": "pin"})", R"(, "label": "pin")"),
              HasSubstr("step 1 (edit): no edit before it has the label \"pin\""));
  const auto twice = recipe_from_json(
    R"([{"edit": {"operation": "a", "label": "x"}}, {"edit": {"operation": "b", "label": "x"}}])");
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().message, HasSubstr("step 2 (edit): another edit has the label \"x\""));
}

}  // namespace
}  // namespace tedit::client
