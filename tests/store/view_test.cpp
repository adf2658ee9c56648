// SPDX-License-Identifier: AGPL-3.0-or-later
// Looking at a document's file: also of older formats, also while it is open, and changing nothing.
#include <sys/wait.h>

#include <fstream>
#include <random>
#include <set>

#include "actors/store/document_lock.hpp"
#include "actors/store/document_view.hpp"
#include "base/guard.hpp"
#include "tests/store/fixture.hpp"

namespace tedit::store {
namespace {

class View : public Document {
protected:
  [[nodiscard]] std::string bytes_of(const fs::path& path) const {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder))
      result.insert(entry.path().filename().string());
    return result;
  }

  void take(const char* fixture) const {
    fs::copy_file(fs::path(TEDIT_TEST_DATA "/documents") / fixture, file);
  }
};

/// Somebody else who has a document open, a step at a time. Begun before this process has touched
/// SQLite's files: what it knows of them must not be inherited.
class writer {
public:
  explicit writer(const fs::path& file) {
    EXPECT_EQ(::pipe(to_child_), 0);
    EXPECT_EQ(::pipe(to_parent_), 0);
    child_ = ::fork();
    if (child_ == 0)
      ::_exit(work(file));
  }
  writer(const writer&) = delete;
  writer& operator=(const writer&) = delete;
  ~writer() {
    EXPECT_EQ(::write(to_child_[1], "e", 1), 1);
    int status = -1;
    ::waitpid(child_, &status, 0);
    EXPECT_EQ(status, 0);
  }

  /// Has it commit the next version, and waits until that is done.
  void commit() {
    char done = 0;
    EXPECT_EQ(::write(to_child_[1], "c", 1), 1);
    EXPECT_EQ(::read(to_parent_[0], &done, 1), 1);
    EXPECT_EQ(done, 'c');
  }

private:
  int work(const fs::path& file) {
    const auto doc = document::open(file);
    char step = 0;
    for (std::uint32_t number = 0; ::read(to_child_[0], &step, 1) == 1 && step == 'c'; ++number) {
      const bool good = doc && (*doc)->commit(make_change(number));
      if (::write(to_parent_[1], good ? "c" : "x", 1) != 1)
        return 1;
    }
    return 0;  // Without closing the document, as a kill would have it.
  }

  int to_child_[2] = {};
  int to_parent_[2] = {};
  pid_t child_ = 0;
};

TEST_F(View, ReadsAnOlderFormatAndLeavesTheFileAsItIs) {
  take("cube_format_1.tedit");
  const auto before = bytes_of(file);
  {
    const auto document = document_view::open(file);
    ASSERT_TRUE(document.has_value()) << render(document.error());
    EXPECT_EQ((*document)->format(), 1);
    const auto found = (*document)->read();
    ASSERT_TRUE(found.has_value()) << render(found.error());
    EXPECT_TRUE(found->damage.empty());
    EXPECT_EQ(found->rows.versions.size(), 3U);
    EXPECT_EQ(found->rows.head, 1U);
    const auto ids = (*document)->page_ids();
    ASSERT_TRUE(ids.has_value());
    EXPECT_EQ(ids->size(), 8U);
    for (const auto& id : *ids)
      EXPECT_TRUE((*document)->read_page(id).has_value());
  }
  EXPECT_EQ(bytes_of(file), before);
  EXPECT_EQ(names(), (std::set<std::string>{"part.tedit"}));
}

TEST_F(View, SeesOneMomentOfADocumentThatGoesOn) {
  writer other(file);
  other.commit();
  {
    const auto document = document_view::open(file);
    ASSERT_TRUE(document.has_value()) << render(document.error());
    ASSERT_EQ((*document)->read().value().rows.versions.size(), 1U);

    other.commit();

    EXPECT_EQ((*document)->read().value().rows.versions.size(), 1U);
    EXPECT_TRUE(document_lock::held(file));
  }
  EXPECT_EQ(document_view::open(file).value()->read().value().rows.versions.size(), 2U);
  other.commit();
  const auto found = document_view::open(file).value()->read();
  EXPECT_EQ(found->rows.versions.size(), 3U);
  EXPECT_TRUE(found->damage.empty());
}

TEST_F(View, GoesOnAfterDamageAndNamesAllOfIt) {
  take("cube_format_1.tedit");
  (void)open();
  tamper("UPDATE version SET report = 'x' WHERE number = 2");
  tamper("UPDATE log SET details = 'y' WHERE sequence = 3");

  const auto found = document_view::open(file).value()->read();

  ASSERT_TRUE(found.has_value()) << render(found.error());
  ASSERT_EQ(found->damage.size(), 2U);
  EXPECT_THAT(found->damage[0].message, HasSubstr("version 2"));
  EXPECT_THAT(found->damage[1].message, HasSubstr("line 3 of the log"));
  EXPECT_EQ(found->rows.versions.size(), 2U);
  EXPECT_EQ(found->rows.log.size(), 4U);
}

TEST_F(View, RowsThatWereTakenAwayAreDamageToo) {
  take("cube_format_1.tedit");
  (void)open();
  tamper("DELETE FROM log WHERE sequence = 2");

  const auto found = document_view::open(file).value()->read();

  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->damage.size(), 1U);
  EXPECT_THAT(found->damage[0].message, HasSubstr("rows where"));
}

TEST_F(View, ACopyIsTheSameDocumentAndReplacesNothing) {
  {
    writer other(file);
    for (int n = 0; n < 3; ++n)
      other.commit();
    ASSERT_GT(fs::file_size(file.string() + "-wal"), 0U) << "its log is not in the file yet";
    const auto document = document_view::open(file);
    ASSERT_TRUE(document.has_value()) << render(document.error());
    const auto copied = (*document)->copy_to(folder / "copy.tedit");
    ASSERT_TRUE(copied.has_value()) << render(copied.error());
    const auto again = (*document)->copy_to(folder / "copy.tedit");
    ASSERT_FALSE(again.has_value());
    EXPECT_EQ(again.error().code, ec::conflict);
  }
  const auto wanted = open()->read().value();
  EXPECT_EQ(names(), (std::set<std::string>{".tedit-lock", "part.tedit", "copy.tedit"}));
  file = folder / "copy.tedit";
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  const auto all = open()->read();
  ASSERT_TRUE(all.has_value()) << render(all.error());
  EXPECT_EQ(all->versions.size(), 3U);
  EXPECT_EQ(all->versions[2].id, wanted.versions[2].id);
}

TEST_F(View, ACopyThatIsCancelledAtAnyMomentLeavesNothing) {
  std::mt19937 noise(1);  // Nothing that a compression would take out.
  {
    const auto doc = open();
    for (std::uint32_t n = 0; n < 3; ++n) {
      auto one = make_change(n);
      for (int i = 0; i < 50; ++i) {
        std::vector<std::byte> bytes(60'000);
        for (auto& b : bytes)
          b = static_cast<std::byte>(noise());
        one.new_pages.push_back(page::from_bytes(bytes));
      }
      ASSERT_TRUE(doc->commit(one));
    }
  }
  const auto copy = folder / "copy.tedit";
  const auto view = document_view::open(file).value();
  const auto before = names();
  const auto try_at = [&](const cancel_token& stop) {
    return guarded({stop, {}}, [&] { return view->copy_to(copy); });
  };
  const cancel_token never;
  ASSERT_TRUE(try_at(never).has_value());
  EXPECT_EQ(fs::file_size(copy), fs::file_size(file));
  EXPECT_GE(never.polls(), 3U) << "of 9 MB, 4 MiB go at once";
  fs::remove(copy);

  for (std::uint64_t poll = 1; poll <= never.polls(); ++poll) {
    const auto stopped = try_at(cancel_token::at_poll(poll));
    ASSERT_FALSE(stopped.has_value()) << poll;
    EXPECT_EQ(stopped.error().code, ec::cancelled);
    EXPECT_EQ(names(), before);
  }
}

TEST_F(View, WhatIsNoDocumentIsSaid) {
  EXPECT_EQ(document_view::open(file).error().code, ec::not_found);
  std::ofstream(file) << "solid part";
  EXPECT_THAT(document_view::open(file).error().message, HasSubstr("is not a database"));
  EXPECT_EQ(names(), (std::set<std::string>{"part.tedit"}));
}

TEST_F(View, TellsWhetherSomebodyHoldsADocument) {
  EXPECT_FALSE(document_lock::held(file));
  EXPECT_TRUE(names().empty());
  {
    const auto doc = open();
    EXPECT_TRUE(document_lock::held(file));
    EXPECT_FALSE(document_lock::held(folder / "other.tedit"));
  }
  EXPECT_FALSE(document_lock::held(file));
}

}  // namespace
}  // namespace tedit::store
