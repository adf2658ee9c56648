// SPDX-License-Identifier: AGPL-3.0-or-later
// What stands between the host and a plugin: the selection's check, the log, a process of its own.
#include "ops/loader/child_operation.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ops/loader/edit_answer.hpp"
#include "ops/loader/operation_log.hpp"
#include "tests/support/meshes.hpp"

namespace tedit::ops {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The operation that does one thing wrong, on a block of 4 x 3 x 3 cells.
class HostAndPlugin : public ::testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(plugins_.load_file(TEDIT_RULE_BREAKER "/rule_breaker.so").has_value());
  }
  void TearDown() override { unsetenv("TEDIT_BREAK"); }

  expected<edit_result> here(const char* deed, std::vector<surface_id> surfaces) {
    setenv("TEDIT_BREAK", deed, 1);
    context ctx;
    return run_operation(plugins_, "rule_breaker", mesh_, {std::move(surfaces)}, {}, ctx);
  }
  expected<edit_result> in_child(const char* deed, std::vector<surface_id> surfaces) {
    setenv("TEDIT_BREAK", deed, 1);
    return run_operation_in_child(plugins_, "rule_breaker", mesh_, {std::move(surfaces)}, {},
                                  context_, {});
  }

  catalogue plugins_;
  const version_ptr mesh_ = test::box_mesh({4, 3, 3}, {0.04, 0.03, 0.03});
  context context_;
};

TEST_F(HostAndPlugin, TheMostThatWorksComesThroughTheProcess) {
  const error refused{ec::invalid_argument, "too thin", "Take 2 mm", "", {{"depth", 0.002}}};

  const auto with = answer_from_bytes(to_bytes(fail(refused), *mesh_), *mesh_);
  const auto without = answer_from_bytes(to_bytes(fail(ec::flat_plug, "flat"), *mesh_), *mesh_);

  ASSERT_FALSE(with || without);
  EXPECT_EQ(with.error().most, refused.most);
  EXPECT_EQ(with.error().remedy, "Take 2 mm");
  EXPECT_FALSE(without.error().most);
}

TEST_F(HostAndPlugin, SelectionsThatDoNotFitNeverReachThePlugin) {
  const auto nothing = here("trusts_the_host", {});
  const auto unknown = here("trusts_the_host", {1, 4711});

  ASSERT_FALSE(nothing.has_value());
  EXPECT_EQ(nothing.error().code, ec::empty_selection);
  EXPECT_EQ(nothing.error().remedy, "Surfaces to move.");
  ASSERT_FALSE(unknown.has_value());
  EXPECT_EQ(unknown.error().code, ec::surface_not_found);
}

TEST_F(HostAndPlugin, ASurfaceNamedTwiceCountsOnce) {
  operation_description two;
  two.name = "Two";
  two.selection = {"Two surfaces", 2, 2};

  EXPECT_FALSE(check_selection(two, *mesh_, {{1, 1}}).has_value());
  EXPECT_TRUE(check_selection(two, *mesh_, {{1, 2, 1}}).has_value());
  EXPECT_FALSE(check_selection(two, *mesh_, {{1, 2, 3}}).has_value());
}

TEST_F(HostAndPlugin, AnEditWithoutAVersionIsAnError) {
  const auto answer = here("no_candidate", {1});

  ASSERT_FALSE(answer.has_value());
  EXPECT_THAT(answer.error().message,
              HasSubstr("the operation \"rule_breaker\" of the plugin rule_breaker 1.0.0 made"));
}

TEST_F(HostAndPlugin, AChildGivesTheSameEdit) {
  const auto mine = here("nothing", {1, 4});
  const auto theirs = in_child("nothing", {1, 4});

  ASSERT_TRUE(mine.has_value() && theirs.has_value());
  EXPECT_EQ(theirs->candidate->id(), mine->candidate->id());
  EXPECT_EQ(theirs->touched, mine->touched);
  EXPECT_EQ(theirs->volume_change, mine->volume_change);
  EXPECT_EQ(theirs->surfaces_used, mine->surfaces_used);
  EXPECT_EQ(theirs->quality_floor, mine->quality_floor);
}

TEST_F(HostAndPlugin, AChildGivesTheSameRefusal) {
  const auto mine = here("throws", {1});
  const auto theirs = in_child("throws", {1});

  ASSERT_FALSE(mine.has_value() || theirs.has_value());
  EXPECT_EQ(render(theirs.error()), render(mine.error()));
  EXPECT_EQ(in_child("nothing", {}).error().code, ec::empty_selection);
}

TEST_F(HostAndPlugin, AHostWithoutALogIsNoTrap) {
  setenv("TEDIT_BREAK", "logs", 1);
  context ctx{{}, nullptr, nullptr};

  EXPECT_TRUE(run_operation(plugins_, "rule_breaker", mesh_, {{1}}, {}, ctx).has_value());
  ctx.log = nullptr;
  EXPECT_TRUE(
    run_operation_in_child(plugins_, "rule_breaker", mesh_, {{1}}, {}, ctx, {}).has_value());
}

TEST_F(HostAndPlugin, ProgressAndLogOfAChildArriveHere) {
  std::vector<std::string> stages;
  std::vector<std::string> lines;
  context_.run.progress = [&](double, std::string_view stage) { stages.emplace_back(stage); };
  context_.log = [&](std::string_view line) { lines.emplace_back(line); };

  ASSERT_TRUE(in_child("logs", {1}).has_value());

  EXPECT_THAT(stages, ElementsAre("moving"));
  EXPECT_THAT(lines, ElementsAre("two\nlines of 216 tets"));
}

TEST_F(HostAndPlugin, AnAnswerThatIsCutOffIsNoAnswer) {
  auto made = here("nothing", {1});
  ASSERT_TRUE(made.has_value());
  made->notices = {"a notice"};
  made->figures = {{"depth_mm", 1.5, "mm", "depth"}};
  const auto bytes = to_bytes(made, *mesh_);

  const auto whole = answer_from_bytes(bytes, *mesh_);

  ASSERT_TRUE(whole.has_value()) << render(whole.error());
  EXPECT_EQ(whole->notices, made->notices);
  EXPECT_EQ(whole->figures, made->figures);
  const auto step = std::max<std::size_t>(1, bytes.size() / 500);
  for (std::size_t size = 0; size < bytes.size(); size += step) {
    const auto part = answer_from_bytes(std::span(bytes).first(size), *mesh_);
    ASSERT_FALSE(part.has_value()) << size;
    EXPECT_EQ(part.error().code, ec::protocol_error);
  }
}

TEST(OperationLog, NamesTheOperationInEveryLine) {
  std::vector<std::string> lines;
  const auto log = operation_log("offset", [&](const std::string& line) { lines.push_back(line); });

  log("moved");
  log("two\nlines\x1b[31m");

  EXPECT_THAT(lines, ElementsAre("offset: moved", "offset: two", "offset: lines [31m"));
}

TEST(OperationLog, OneEditCannotFillALog) {
  std::vector<std::string> lines;
  const auto log = operation_log("offset", [&](const std::string& line) { lines.push_back(line); });

  for (int i = 0; i < 1000; ++i)
    log(std::string(5000, 'x'));

  ASSERT_EQ(lines.size(), 201u);
  EXPECT_EQ(lines.front().size(), 2008u);
  EXPECT_THAT(lines.back(), HasSubstr("more than 200 lines: the rest is left out"));
}

}  // namespace
}  // namespace tedit::ops
