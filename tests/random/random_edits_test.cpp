// SPDX-License-Identifier: AGPL-3.0-or-later
// Random sequences of edits, one on the result of the other: what `try_edit` lists holds after
// each. The same few sequences each time; TEDIT_RANDOM_EDITS=N runs N new ones of each kind. A
// sequence that breaks something is shrunk and lies as a recipe where the failure says.
#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "mesh/io/formats.hpp"
#include "mesh/io/import.hpp"
#include "tests/support/blocks.hpp"
#include "tests/support/random_edits.hpp"

namespace tedit::test {
namespace {

/// Before any property runs: how many sequences, and which.
const bool configured = [] {
  const char* many = std::getenv("TEDIT_RANDOM_EDITS");
  const auto how = many ? std::string("max_success=") + many : "seed=20 max_success=6 max_size=40";
  setenv("RC_PARAMS", how.c_str(), 0);
  setenv("TEDIT_LIBEXEC", TEDIT_BIN, 1);
  return true;
}();

const ops::catalogue& plugins() {
  static const auto loaded = [] {
    ops::catalogue result;
    result.load_directory(TEDIT_BIN "/../lib/tedit/plugins");
    return result;
  }();
  return loaded;
}

/// The numbers that choose one edit; zeros follow when they are used up.
using edit_numbers = std::vector<std::uint32_t>;

number_source source_of(const edit_numbers& numbers) {
  return [numbers, i = std::size_t{0}]() mutable -> std::uint64_t {
    // A parameter's place in its range is read from the upper bits, a choice from the lower ones.
    const std::uint64_t n = i < numbers.size() ? numbers[i++] : 0;
    return n << 32 | n;
  };
}

std::vector<edit_numbers> any_sequence(std::size_t most) {
  auto sequence = *rc::gen::container<std::vector<edit_numbers>>(
    rc::gen::resize(12, rc::gen::container<edit_numbers>(
                          rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>()))));
  sequence.resize(std::min(sequence.size(), most));
  return sequence;
}

/// Applies a sequence; a fault leaves the part and a recipe behind and fails the property.
void check_sequence(const version_ptr& start, const std::string& name, std::size_t most) {
  const double size = std::cbrt(total_volume(*start));
  auto mesh = start;
  std::vector<planned_edit> edits;
  int made = 0;
  for (const auto& numbers : any_sequence(most)) {
    edits.push_back(choose_edit(plugins(), *mesh, size, source_of(numbers)));
    const auto tried = try_edit(plugins(), mesh, edits.back());
    if (!tried.fault.empty()) {
      const auto folder = std::filesystem::temp_directory_path();
      const auto part = folder / ("tedit_" + name + ".msh");
      const auto recipe = folder / ("tedit_" + name + ".json");
      RC_ASSERT(formats::msh::write(part, *start, {"mm"}).has_value());
      write_recipe(recipe, part, tried.fault, edits);
      RC_FAIL(tried.fault + "; tedit run " + recipe.string());
    }
    if (!tried.after)
      continue;
    mesh = tried.after;
    ++made;
  }
  RC_TAG(made);
}

/// A block of unit cubes in mm: whole, with a bore, with a pit, a step, a slot or a tunnel.
version_ptr any_block() {
  const auto kind = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 6));
  const auto keep = [kind](int x, int y, int z) {
    switch (kind) {
      case 1:
        return x != 1 || y != 1;
      case 2:
        return x != 1 || y != 1 || z < 2;
      case 3:
        return x == 0 || z < 2;
      case 4:
        return y != 1 || z == 0;
      case 5:
        return x != 1 || z != 1;
      default:
        return true;
    }
  };
  return blocks({3, 3, 3}, keep, [](vec3 p) { return 1e-3 * p; });
}

RC_GTEST_PROP(RandomEdits, OnBlocksBreakNothing, ()) {
  check_sequence(any_block(), "random_block", 8);
}

version_ptr part(const std::string& name) {
  return import_mesh(TEDIT_TEST_DATA "/parts/" + name + "/" + name + ".coarse.msh", "mm")
    .value()
    .version;
}

RC_GTEST_PROP(RandomEdits, OnAPartWithFilletsBreakNothing, ()) {
  static const auto start = part("inch_block");
  check_sequence(start, "random_inch_block", 3);
}

RC_GTEST_PROP(RandomEdits, OnAPartWithHolesBreakNothing, ()) {
  static const auto start = part("holes_block");
  check_sequence(start, "random_holes_block", 3);
}

// -- the checks themselves ------------------------------------------------------------------

TEST(TryEdit, SeesWhatAnEditDid) {
  const auto start = blocks(
    {3, 3, 3}, [](int x, int y, int) { return x != 1 || y != 1; }, [](vec3 p) { return 1e-3 * p; });

  const auto filled = try_edit(plugins(), start, {"fill_hole", {7}, {}});
  const auto refused = try_edit(plugins(), start, {"fill_hole", {1}, {}});

  EXPECT_EQ(filled.fault, "");
  ASSERT_NE(filled.after, nullptr);
  EXPECT_NEAR(total_volume(*filled.after), 27e-9, 1e-18);
  EXPECT_EQ(refused.after, nullptr);
  EXPECT_FALSE(refused.refusal.message.empty());
}

TEST(TryEdit, SeesThatAVersionWasChanged) {
  ops::catalogue breaker;
  ASSERT_TRUE(breaker.load_file(TEDIT_RULE_BREAKER "/rule_breaker.so").has_value());
  const auto start = blocks(2, [](int, int, int) { return true; });
  const planned_edit edit{"rule_breaker", {1}, {}};
  EXPECT_EQ(first_fault(breaker, start, {edit}), "");
  setenv("TEDIT_BREAK", "input_unchanged", 1);

  const auto fault = first_fault(breaker, start, {edit, edit});

  unsetenv("TEDIT_BREAK");
  EXPECT_EQ(fault, "the version before changed");
}

}  // namespace
}  // namespace tedit::test
