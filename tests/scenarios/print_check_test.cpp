// SPDX-License-Identifier: AGPL-3.0-or-later
// What hinders printing, asked of a server: figures that can be checked by hand.
#include <set>

#include "mesh/io/formats.hpp"
#include "tests/scenarios/fixture.hpp"
#include "tests/support/blocks.hpp"

namespace tedit::test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double mm = 1e-3;
constexpr double mm2 = 1e-6;

class CheckPrintOfServer : public ::testing::Test {
protected:
  scratch_folder folder;
  std::unique_ptr<server> host = start(options_for(folder, false));
  std::unique_ptr<client::client> user = connect(host->url());

  void SetUp() override { value(user->open("part", true, false)); }

  void import(const version_ptr& mesh) {
    const auto file = folder.path() / "part.msh";
    value(formats::msh::write(file, *mesh, {"m"}));
    value(user->import_file(file, "m", {}));
  }
  /// A plate of 20 x 10 x 2 mm.
  void import_plate() {
    import(blocks(
      {4, 2, 1}, [](int, int, int) { return true;
  },
      [](vec3 p) {
    return vec3{5 * mm * p.x, 5 * mm * p.y, 2 * mm * p.z};
      }));
}
  /// A post of 10 x 10 x 10 mm under the middle of a bar of 30 x 10 x 10 mm.
  void import_hammer() {
    import(blocks(
      {3, 1, 2}, [](int x, int, int z) { return x == 1 || z == 1;
},
      [](vec3 p) {
  return 10 * mm * p; }));
}  // namespace
};  // namespace tedit::test

TEST_F(CheckPrintOfServer, APlateIsThinBelowMoreThanItsThicknessAndNotBelowIt) {
  import_plate();
  const auto thin = value(user->check_print({.thinner_than = 2.1 * mm}));

  EXPECT_EQ(thin.version, 0U);
  EXPECT_EQ(thin.version_id, value(user->get_history()).versions[0].version_id);
  EXPECT_TRUE(thin.what.watertight());
  EXPECT_EQ(thin.what.bodies, 1U);
  EXPECT_NEAR(thin.what.volume, 20 * 10 * 2 * 1e-9, 1e-18);
  EXPECT_NEAR(thin.what.extent.high.x - thin.what.extent.low.x, 20 * mm, 1e-12);
  ASSERT_EQ(thin.what.thin.size(), 1U);
  EXPECT_NEAR(thin.what.thin[0].area, 2 * 200 * mm2, 1e-15) << "both sides";
  EXPECT_NEAR(thin.what.thin[0].worst, 2 * mm, 1e-12);
  EXPECT_NEAR(thin.what.plate_area, 200 * mm2, 1e-15);
  EXPECT_THAT(thin.what.overhangs, IsEmpty());
  // 8 squares on either side, two facets each.
  ASSERT_EQ(thin.facets.size(), 32U);
  EXPECT_THAT(thin.marks, Each(print_mark::thin));
  EXPECT_EQ(std::set(thin.facets.begin(), thin.facets.end()).size(), 32U);

  const auto sound = value(user->check_print({.thinner_than = 2 * mm}));
  EXPECT_THAT(sound.what.thin, IsEmpty());
  EXPECT_THAT(sound.facets, IsEmpty());
  EXPECT_FALSE(sound.what.has_findings());
}

TEST_F(CheckPrintOfServer, WhatStandsOverThePostOverhangsUnlessThePartIsTurned) {
  import_hammer();
  const auto upright = value(user->check_print({}));
  const auto turned = value(user->check_print({.up = {0, 0, -5}}));

  ASSERT_EQ(upright.what.overhangs.size(), 2U) << "one on each side of the post";
  EXPECT_NEAR(upright.what.overhang_area, 2 * 100 * mm2, 1e-15);
  EXPECT_NEAR(upright.what.overhangs[0].worst, 90 * degree, 1e-12);
  EXPECT_NEAR(upright.what.overhangs[0].at.z, 10 * mm, 1e-12);
  EXPECT_EQ(upright.facets.size(), 4U);
  EXPECT_THAT(upright.marks, Each(print_mark::overhang));
  EXPECT_EQ(upright.overhanging_places, 2U);
  value(user->wait_surface(upright.version_id, std::chrono::seconds(60)));
  const auto surface = user->surface();
  for (const auto slot : upright.facets) {
    const auto* facet = surface.facets().find(slot);
    ASSERT_NE(facet, nullptr) << "the marks are of the surface that was sent";
    for (const auto v : facet->v)
      EXPECT_NEAR(surface.positions().find(v)->z, 10 * mm, 1e-12);
  }
  EXPECT_THAT(turned.what.overhangs, IsEmpty());
  EXPECT_NEAR(turned.what.plate_area, 300 * mm2, 1e-15);
  EXPECT_EQ(turned.settings.up, (vec3{0, 0, -5}));
}

TEST_F(CheckPrintOfServer, AnyVersionCanBeCheckedAndTheHeadStaysWhereItIs) {
  import_plate();
  import_hammer();
  EXPECT_NEAR(value(user->check_print({}, 0)).what.volume, 400e-9, 1e-18);
  const auto head = value(user->check_print({}));
  EXPECT_NEAR(head.what.volume, 4000e-9, 1e-17);
  EXPECT_EQ(head.version, 1U);
  EXPECT_EQ(value(user->get_history()).head, 1U);
}

TEST_F(CheckPrintOfServer, WhatCannotBeCheckedIsRefusedWithItsReason) {
  const auto refusal = [&](const print_settings& settings,
                           std::optional<std::uint32_t> number = {}) {
    const auto got = user->check_print(settings, number);
    return got ? error{ec::internal, "answered", {}, {}} : got.error();
  };
  EXPECT_EQ(refusal({}).code, ec::conflict) << "there is no mesh yet";
  import_plate();
  EXPECT_EQ(refusal({}, 1).code, ec::not_found);
  EXPECT_EQ(refusal({.up = {0, 0, 0}}).code, ec::invalid_argument);
  EXPECT_THAT(refusal({.thinner_than = -1}).message, HasSubstr("check_print.thinner_than_m is -1"));
  EXPECT_THAT(refusal({.lean = 2}).message, HasSubstr("check_print.overhang_rad is 2"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal({.up = {0, nan, 1}}).message, HasSubstr("check_print.direction.y is nan"));
}

}  // namespace
}  // namespace tedit::test
