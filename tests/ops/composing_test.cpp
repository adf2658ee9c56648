// SPDX-License-Identifier: AGPL-3.0-or-later
// Operations that ask for others: what comes of it is what both make one after the other.
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/finish_edit.hpp"
#include "mesh/quality.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/services/host_services.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

using ::testing::HasSubstr;

class Composing : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
    plugins_.load_directory(TEDIT_BIN "/../lib/tedit/plugins");
    const auto loaded = plugins_.load_file(TEDIT_COMPOSING "/composing_plugin.so");
    ASSERT_TRUE(loaded) << render(loaded.error());
    ctx_.host = host_.get();
  }

  expected<edit_result> run(const std::string& id, const version_ptr& mesh,
                            const parameters& values, const std::vector<surface_id>& picked = {}) {
    return run_operation(plugins_, id, mesh, {picked}, values, ctx_);
  }

  /// In the middle of the top of a box of 40 x 40 x 20 mm.
  const parameters place_{{"at", std::string("0.02 0.02 0.02")},
                          {"direction", std::string("0 0 1")}};
  const version_ptr box_ = test::box_mesh({8, 8, 4}, {.04, .04, .02});
  std::shared_ptr<services> host_ = make_host_services();
  catalogue plugins_;
  context ctx_;
};

TEST_F(Composing, MakesWhatBothMakeOneAfterTheOther) {
  const auto made = run("eyelet", box_, place_);
  ASSERT_TRUE(made) << render(made.error());
  auto boss = place_;
  boss.insert({{"profile", std::string("circle")}, {"size", 8e-3}, {"height", 5e-3}});
  const auto first = run("boss", box_, boss);
  ASSERT_TRUE(first) << render(first.error());
  auto hole = place_;
  hole.insert({{"diameter", 4e-3}, {"depth", 12e-3}});
  const auto second = run("drill", first->candidate, hole);
  ASSERT_TRUE(second) << render(second.error());

  EXPECT_EQ(made->candidate->id(), second->candidate->id());
  EXPECT_DOUBLE_EQ(made->volume_change, first->volume_change + second->volume_change);
  EXPECT_GT(made->touched.size(), second->touched.size());
  for (const auto t : made->touched)
    EXPECT_TRUE(made->candidate->is_live_tet(t)) << t;
}

/// As one edit: its volume is the boundary's, and every tet that is not as it was is named.
TEST_F(Composing, PassesTheHostsChecksAsOneEdit) {
  const auto made = run("eyelet", box_, place_);
  ASSERT_TRUE(made) << render(made.error());
  const edit_claim claim{made->volume_change, made->touched, made->quality_floor,
                         made->bodies_added};
  const auto done =
    finish_edit(box_, made->candidate, claim, {made->improve, made->thorough}, {}, {});
  ASSERT_TRUE(done) << render(done.error());
  // A boss of 8 mm, 5 mm high, without the part of a hole of 4 mm that goes through it; circles are
  // polygons.
  const double boss = std::numbers::pi * 4e-3 * 4e-3 * 5e-3;
  const double most = total_volume(*done->version) - total_volume(*box_);
  EXPECT_LT(most, boss);
  EXPECT_NEAR(most, made->volume_change, 1e-15);
}

TEST_F(Composing, AnUnknownOperationIsRefusedWithTheNearestName) {
  auto values = place_;
  values["asks"] = std::string("nobody");
  const auto made = run("eyelet", box_, values);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ec::operation_not_found);
  EXPECT_THAT(made.error().remedy, HasSubstr("eyelet"));
}

TEST_F(Composing, ACircleEnds) {
  auto values = place_;
  values["asks"] = std::string("itself");
  const auto made = run("eyelet", box_, values);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ec::invalid_argument);
  EXPECT_THAT(made.error().message, HasSubstr("ask for each other 8 deep, the last for eyelet"));
}

/// The other's own checks hold: what it is asked for is what a person may ask for.
TEST_F(Composing, ValuesAreCheckedAsAPersonsAre) {
  const context alone;
  const auto nobody = alone.apply_other("boss", box_, {}, {});
  ASSERT_FALSE(nobody);
  EXPECT_EQ(nobody.error().code, ec::operation_not_found) << "without a host there is none";
  const auto wrong = others_of(plugins_, ctx_)("boss", box_, {}, {{"size", -1.0}});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, ec::invalid_parameter);
  EXPECT_FALSE(others_of(plugins_, ctx_)("boss", nullptr, {}, {}));
}

}  // namespace
}  // namespace tedit::ops
