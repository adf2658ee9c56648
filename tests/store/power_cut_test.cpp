// SPDX-License-Identifier: AGPL-3.0-or-later
// Power cuts at each operation of the disk, disks that lie, are full or fail: what was acknowledged
// is there, what was not is there whole or not at all, and nothing else ever is.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <optional>

#include "tests/store/faulty_disk.hpp"
#include "tests/store/fixture.hpp"

namespace tedit::store {
namespace {

using ::testing::AnyOf;

constexpr std::uint32_t steps = 14;

/// What a person does: versions of several pages each, other loads, names, undo and redo.
change step(std::uint32_t number) {
  const auto version = number / 2;
  if (number % 2 == 0) {
    auto c = make_change(version);
    for (std::uint32_t i = 0; i < 6; ++i)
      c.new_pages.push_back(make_page(100 * version + i, 900 + 700 * i));
    if (version > 0)
      c.redo = {{version - 1, version}};
    return c;
  }
  change c;
  c.load_cases = {{version, R"([{"name":"case )" + std::to_string(number) + R"("}])"}};
  c.annotations = {{version, "name " + std::to_string(number), "a note"}};
  if (version > 0)
    c.head = version - 1;
  c.what = "undo";
  c.details = std::to_string(number);
  return c;
}

/// The pages that the first steps stored.
std::vector<page_ptr> pages_of(const contents& all) {
  std::vector<page_ptr> pages;
  for (const auto& v : all.versions)
    for (const auto& one : step(2 * v.number).new_pages)
      pages.push_back(one);
  return pages;
}

/// All that a document says, or why it does not.
expected<std::string> said_by(const document& doc) {
  const auto all = doc.read();
  if (!all)
    return fail(all.error());
  std::string text = all->head ? std::to_string(*all->head) : "none";
  for (const auto& v : all->versions)
    text += "\n" + std::to_string(v.number) + "|" + to_hex(v.id) + "|" + v.load_cases + "|" +
            v.name + "|" + (v.redo ? std::to_string(*v.redo) : "");
  for (const auto& line : all->log)
    text += "\n" + std::to_string(line.sequence) + "|" + line.what + "|" + line.details;
  for (const auto& wanted : pages_of(*all)) {
    const auto page = doc.read_page(wanted->id());
    if (!page)
      return fail(page.error());
  }
  return text;
}

class PowerCut : public Document {
protected:
  /// The document as it says of itself after each number of steps.
  void SetUp() override {
    Document::SetUp();
    const auto doc = open();
    for (std::uint32_t i = 0; i <= steps; ++i) {
      said_.push_back(said_by(*doc).value());
      if (i < steps) {
        ASSERT_TRUE(doc->commit(step(i)));
      }
    }
  }

  /// A document that nobody has begun.
  void begin_anew() {
    fs::remove_all(folder);
    fs::create_directory(folder);
    ASSERT_NE(open(), nullptr);
  }

  /// Goes on until a step is refused, as a server does, resting now and then; how many were
  /// acknowledged.
  std::uint32_t work() {
    auto opened = document::open(file);
    std::uint32_t done = 0;
    while (opened && done < steps && (*opened)->commit(step(done))) {
      ++done;
      if (done % 5 == 0)
        (*opened)->rest();
    }
    return done;
  }

  /// How many operations a disk without faults does for all steps.
  std::int64_t operations() {
    begin_anew();
    faulty_disk disk({});
    EXPECT_EQ(work(), steps);
    return disk.operations();
  }

  /// The same until the power goes, after which a machine with a well disk starts.
  std::uint32_t work_until_cut(const disk_faults& faults, int round) {
    faulty_disk disk(faults, std::uint64_t(round * 1'000'000 + *faults.cut_at));
    const auto done = work();
    EXPECT_TRUE(disk.failed());
    disk.cut();
    return done;
  }

  /// What the document says that `open` finds.
  [[nodiscard]] expected<std::string> found() const {
    const auto opened = document::open(file);
    return opened ? said_by(**opened) : expected<std::string>(fail(opened.error()));
  }

  /// After how many steps a document says this; none: it never does.
  [[nodiscard]] std::optional<std::uint32_t> steps_of(const std::string& text) const {
    const auto at = std::ranges::find(said_, text);
    return at == said_.end() ? std::nullopt : std::optional(std::uint32_t(at - said_.begin()));
  }

  std::vector<std::string> said_;
};

/// How often the power goes at each operation; by hand more: TEDIT_POWER_CUTS=50.
int rounds() {
  const char* wanted = std::getenv("TEDIT_POWER_CUTS");
  return wanted ? std::atoi(wanted) : 1;
}

/// By hand all operations meet the other faults, else every third.
std::int64_t stride() {
  return std::getenv("TEDIT_POWER_CUTS") ? 1 : 3;
}

TEST_F(PowerCut, LosesNothingThatWasAcknowledged) {
  const auto last = operations();
  ASSERT_GE(last, 100);
  int cuts = 0;
  for (int round = 0; round < rounds(); ++round)
    for (std::int64_t at = 0; at < last; ++at) {
      begin_anew();
      const auto acknowledged = work_until_cut({.cut_at = at}, round);
      ++cuts;

      const auto text = found();
      ASSERT_TRUE(text.has_value()) << "cut at " << at << ": " << render(text.error());
      const auto kept = steps_of(*text);
      ASSERT_TRUE(kept.has_value()) << "cut at " << at << " left:\n" << *text;
      EXPECT_GE(*kept, acknowledged) << "cut at " << at;
      EXPECT_LE(*kept, acknowledged + 1) << "cut at " << at;
    }
  EXPECT_GE(cuts, 200);
  std::cout << cuts << " cuts at " << last << " places\n";
}

/// Then what was acknowledged may be lost; that something else is shown may not be.
TEST_F(PowerCut, OnADiskThatLiesNothingIsShownThatNeverWas) {
  const auto last = operations();
  int lost = 0, refused = 0;
  for (int round = 0; round < rounds(); ++round)
    for (std::int64_t at = 0; at < last; ++at) {
      begin_anew();
      const auto acknowledged = work_until_cut({.cut_at = at, .lies = true}, round);

      const auto text = found();
      if (!text) {
        ++refused;
        EXPECT_EQ(text.error().code,
                  text.error().code == ec::not_found ? ec::not_found : ec::storage_error)
          << render(text.error());
        EXPECT_FALSE(text.error().remedy.empty()) << render(text.error());
      }
      const auto kept = text ? steps_of(*text) : std::optional(0U);
      ASSERT_TRUE(kept.has_value()) << "cut at " << at << " left:\n" << *text;
      EXPECT_LE(*kept, acknowledged + 1);
      lost += text && *kept < acknowledged;
    }
  EXPECT_GT(lost, 0) << "the disk did not lie";
  std::cout << lost << " lost, " << refused << " refused of " << last * rounds() << " cuts\n";
}

/// One step meets the fault; then the disk is well again, and the document goes on.
void meet(PowerCut& test, const std::function<void(std::int64_t)>& try_at, std::int64_t last) {
  for (std::int64_t at = 0; at < last && !test.HasFatalFailure(); at += stride())
    try_at(at);
}

TEST_F(PowerCut, AFullDiskLeavesTheDocumentAsItWasUntilThereIsRoom) {
  int refused = 0;
  const auto try_at = [&](std::int64_t at) {
    begin_anew();
    faulty_disk disk({.full_at = at});
    auto opened = document::open(file);
    for (std::uint32_t done = 0; done < steps;) {
      const auto stored = opened ? (*opened)->commit(step(done)) : fail(opened.error());
      if (stored) {
        ++done;
        continue;
      }
      ++refused;
      EXPECT_THAT(render(stored.error()), HasSubstr("disk is full")) << "full at " << at;
      disk.empty();
      if (!opened)
        opened = document::open(file);
      ASSERT_TRUE(opened.has_value()) << render(opened.error());
      ASSERT_EQ(said_by(**opened).value_or("unreadable"), said_[done]) << "full at " << at;
    }
    EXPECT_EQ(said_by(**opened).value_or("unreadable"), said_[steps]) << "full at " << at;
  };
  meet(*this, try_at, operations());
  EXPECT_GE(refused, 20);
}

TEST_F(PowerCut, AnOperationThatFailsOnceIsToldOrMeetsNobody) {
  int refused = 0;
  const auto try_at = [&](std::int64_t at) {
    begin_anew();
    std::optional<faulty_disk> disk(std::in_place, disk_faults{.fails_at = at});
    auto opened = document::open(file);
    for (std::uint32_t done = 0; done < steps;) {
      const auto stored = opened ? (*opened)->commit(step(done)) : fail(opened.error());
      if (stored) {
        ++done;
        continue;
      }
      ++refused;
      EXPECT_THAT(render(stored.error()), HasSubstr("I/O error")) << "failed at " << at;
      if (!opened)
        opened = document::open(file);
      ASSERT_TRUE(opened.has_value()) << render(opened.error());
      ASSERT_EQ(said_by(**opened).value_or("unreadable"), said_[done]) << "failed at " << at;
    }
    opened->reset();
    disk.reset();
    EXPECT_EQ(found().value_or("unreadable"), said_[steps]) << "failed at " << at;
  };
  meet(*this, try_at, operations());
  EXPECT_GE(refused, 20);
}

/// A machine that stops while the file of a new document is written.
TEST_F(PowerCut, AHalfWrittenDraftOfANewDocumentIsInNobodysWay) {
  begin_anew();
  std::vector<char> whole(fs::file_size(file));
  std::ifstream(file, std::ios::binary).read(whole.data(), std::streamsize(whole.size()));
  for (std::size_t size = 0; size <= whole.size(); size += 512) {
    fs::remove_all(folder);
    fs::create_directory(folder);
    std::ofstream(file.string() + "-new", std::ios::binary)
      .write(whole.data(), std::streamsize(size));
    EXPECT_EQ(work(), steps) << size;
    EXPECT_EQ(found().value_or("unreadable"), said_[steps]) << size;
    EXPECT_FALSE(fs::exists(file.string() + "-new")) << size;
  }
}

}  // namespace
}  // namespace tedit::store
