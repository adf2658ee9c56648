// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/load_editing.hpp"

#include <gtest/gtest.h>

#include <QFile>

#include "client-qt/model/materials.hpp"
#include "client-qt/model/receipt_words.hpp"

namespace tedit::desktop {
namespace {

fem::material steel() {
  return {"steel", 210e9, 0.3, 7850, 235e6, {}};
}

fem::load_case two_supports_and_gravity() {
  return {"a",
          {steel()},
          {{{1}, fem::fixed{}}, {{2, 3}, fem::roller{}}},
          {{{}, fem::gravity{{0, 0, -9.81}}}, {{3}, fem::force{{0, 0, 5}}}}};
}

std::vector<QString> faulty_fields(const load_item& item) {
  std::vector<QString> result;
  for (const auto& one : faults(item))
    result.push_back(one.field);
  return result;
}

TEST(Faults, NameTheFieldsOfAMaterialThatIsOutsidePhysics) {
  auto bad = steel();
  bad.young_modulus_pa = 0;
  bad.poisson_ratio = 0.5;
  bad.density_kg_m3 = -1;

  EXPECT_EQ(faulty_fields(bad),
            (std::vector<QString>{"young_modulus", "poisson_ratio", "density"}));
  EXPECT_TRUE(faults(steel()).empty());
}

TEST(Faults, ALoadNeedsSurfacesAndADirectionButGravityNoSurfaces) {
  EXPECT_EQ(faulty_fields(fem::load{{}, fem::force{}}),
            (std::vector<QString>{"surfaces", "components"}));
  EXPECT_EQ(faulty_fields(fem::load{{7}, fem::force{{NAN, 0, 1}}}),
            (std::vector<QString>{"components"}));
  EXPECT_EQ(faulty_fields(fem::load{{7}, fem::pressure{0}}), (std::vector<QString>{"components"}));
  EXPECT_TRUE(faults(fem::load{{}, fem::gravity{{0, 0, -9.81}}}).empty());
}

TEST(Faults, APrescribedDisplacementNeedsAComponent) {
  EXPECT_EQ(faulty_fields(fem::constraint{{1}, fem::prescribed_displacement{}}),
            (std::vector<QString>{"components"}));
  EXPECT_TRUE(faults(fem::constraint{{1}, fem::prescribed_displacement{{}, 0.0, {}}}).empty());
}

TEST(Items, ArePutReplacedAndRemovedAtTheirPlace) {
  auto loads = two_supports_and_gravity();

  put(loads, fem::constraint{{9}, fem::fixed{}}, 1);
  put(loads, steel());
  remove(loads, item_kind::load, 0);

  EXPECT_EQ(loads.constraints[1].surfaces, std::vector<surface_id>{9});
  EXPECT_EQ(loads.materials.size(), 2U);
  ASSERT_EQ(loads.loads.size(), 1U);
  EXPECT_EQ(loads.loads[0].surfaces, std::vector<surface_id>{3});
}

TEST(Missing, SaysWhatALoadCaseLacksToBeSolved) {
  fem::load_case loads;
  EXPECT_EQ(missing(loads), "a material, a support, a load");

  EXPECT_EQ(missing(two_supports_and_gravity()), "");
}

TEST(ReadRegions, TakesNumbersAndNothingElse) {
  EXPECT_EQ(read_regions(" 3, -4 5"), (std::vector<region_id>{3, -4, 5}));
  EXPECT_EQ(read_regions(""), std::vector<region_id>{});
  EXPECT_FALSE(read_regions("3, left"));
}

TEST(PlaceFor, AMaterialForTheRestReplacesTheOtherSuchOne) {
  auto named = steel();
  named.regions = {4};
  fem::load_case loads;
  loads.materials = {named, steel()};

  EXPECT_EQ(place_for(loads, steel()), 1U);
  EXPECT_FALSE(place_for(loads, named));
  loads.materials.pop_back();
  EXPECT_FALSE(place_for(loads, steel()));
}

TEST(FreeName, CountsUpUntilNobodyHasIt) {
  const std::vector<fem::load_case> all{{"a", {}, {}, {}}, {"a 2", {}, {}, {}}};

  EXPECT_EQ(free_name("a", all), "a 3");
  EXPECT_EQ(free_name("b", all), "b");
}

TEST(Carried, FollowsRemovedMergedAndSplitSurfaces) {
  const std::vector<surface_change> map{
    {1, surface_fate::removed, 0, "", 1, 0},
    {2, surface_fate::merged_into, 8, "", 1, 0},
    {3, surface_fate::changed, 0, "", 1, 0.5},
    {10, surface_fate::split_from, 3, "", 0, 0.5},
  };

  const auto after = carried(two_supports_and_gravity(), map);

  ASSERT_EQ(after.constraints.size(), 1U);
  EXPECT_EQ(after.constraints[0].surfaces, (std::vector<surface_id>{8, 3, 10}));
  ASSERT_EQ(after.loads.size(), 2U);  // Gravity acts without surfaces.
  EXPECT_EQ(after.loads[1].surfaces, (std::vector<surface_id>{3, 10}));
}

TEST(Marks, PointToTheItemsAsTheyStandAfterTheEdit) {
  edit_report report;
  report.receipt = {{"a", "constraint 0 (fixed)", fem::receipt_fate::dropped, {1}, 1, 0, "gone"},
                    {"a", "constraint 1 (roller)", fem::receipt_fate::reduced, {2}, 1, 1, "less"},
                    {"a", "load 1 (force)", fem::receipt_fate::kept, {}, 1, 1, "as before"},
                    {"b", "load 0 (force)", fem::receipt_fate::dropped, {3}, 1, 0, "another"}};

  const auto found = marks(report, "a");

  ASSERT_EQ(found.size(), 2U);
  EXPECT_FALSE(found[0].at.has_value());
  EXPECT_EQ(found[1].at, 0U);  // The one before it is gone.
  EXPECT_EQ(found[1].kind, item_kind::support);
  EXPECT_TRUE(found[1].text.startsWith("Roller (support 2) lost surface 2 and acts on "))
    << found[1].text.toStdString();
}

TEST(ReceiptWords, SayWhatBecameOfEachItem) {
  fem::receipt_line line;
  line.item = "load 0 (bearing force)";
  line.area_before = 4e-6;
  line.area_after = 2e-6;
  line.total_before = line.total_after = 500;
  line.fate = fem::receipt_fate::area_changed;
  EXPECT_EQ(
    receipt_words(line).toStdString(),
    "Bearing force (load 1): its surfaces have 2 mm\u00b2 (\u221250 %) now; 500 N in all, as "
    "before");
  line.fate = fem::receipt_fate::moved;
  line.surfaces_lost = {7};
  line.moved_to = {8, 9};
  line.total_after = 400;
  EXPECT_EQ(receipt_words(line).toStdString(),
            "Bearing force (load 1) lost surface 7, its share moved to surfaces 8, 9; 400 N in all "
            "instead of 500 N");
  line.item = "constraint 2 (fixed)";
  line.fate = fem::receipt_fate::dropped;
  EXPECT_EQ(receipt_words(line), "Fixed (support 3) no longer acts: it lost surface 7");
  line.item = "spring 1";
  line.text = "a spring of tomorrow";
  EXPECT_EQ(receipt_words(line), "a spring of tomorrow");
}

TEST(Materials, TheShippedLibraryHasFifteenSoundOnes) {
  QFile file(TEDIT_TEST_DATA "/../../config/materials.json");
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));

  const auto all = materials_from_json(file.readAll(), "materials.json");

  ASSERT_TRUE(all) << render(all.error());
  EXPECT_EQ(all->size(), 15U);
  EXPECT_EQ(all->front().name, "Steel S235");
  EXPECT_EQ(all->front().young_modulus_pa, 210e9);
}

TEST(Materials, AFaultyEntryIsRefusedByName) {
  const auto all = materials_from_json(
    R"({"materials": [{"name": "X", "young_modulus_pa": 1, "poisson_ratio": 0.7}]})", "lib");

  ASSERT_FALSE(all);
  EXPECT_EQ(all.error().code, ec::bad_input);
  EXPECT_NE(all.error().message.find("\"X\": poisson_ratio"), std::string::npos);
}

}  // namespace
}  // namespace tedit::desktop
