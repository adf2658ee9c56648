// SPDX-License-Identifier: AGPL-3.0-or-later
// The documents of a server as a whole: listed, copied, deleted.
#include <atomic>
#include <fstream>
#include <future>
#include <set>
#include <thread>

#include "tests/scenarios/fixture.hpp"
#include "tests/support/parts.hpp"

namespace tedit::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Library : public ::testing::Test {
protected:
  const scratch_folder documents;
  std::unique_ptr<server> host = start(options_for(documents, false));
  std::unique_ptr<client::client> user = connect(host->url());

  /// An imported cube that was thickened once: versions 0 and 1.
  void make(const std::string& name) {
    value(user->open(name, true, false));
    value(user->import_file(test::cube_mesh, "mm", {}));
    value(user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {}));
  }

  /// All files of documents, with what lies beside them.
  [[nodiscard]] std::set<std::string> files() const {
    std::set<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(documents.path()))
      if (const auto name = entry.path().filename().string();
          name != ".tedit-lock" && name != ".tedit-names")
        result.insert(name);
    return result;
  }

  [[nodiscard]] std::vector<std::string> names() {
    std::vector<std::string> result;
    for (const auto& one : value(user->list_documents()))
      result.push_back(one.name);
    return result;
  }

  void restart() {
    user.reset();
    host.reset();
    host = start(options_for(documents, false));
    user = connect(host->url());
  }
};

TEST_F(Library, TheListSaysWhatThereIsAndWhoHasItOpen) {
  EXPECT_TRUE(value(user->list_documents()).empty());
  make("closed");
  restart();
  make("wing");
  const auto other = connect(host->url());
  value(other->open("wing", false, false));
  const auto third = connect(host->url());
  value(third->open("unborn", false, false));
  std::ofstream(documents.path() / "two words.tedit") << "no name of a document";
  std::ofstream(documents.path() / "notes.txt") << "no document";

  const auto all = value(user->list_documents());

  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].name, "closed");
  EXPECT_FALSE(all[0].open);
  EXPECT_EQ(all[0].clients, 0U);
  EXPECT_GE(all[0].bytes, std::filesystem::file_size(documents.path() / "closed.tedit"));
  EXPECT_EQ(all[0].changed_at.size(), std::string("2026-11-23T08:45:00Z").size());
  EXPECT_FALSE(all[0].versions.has_value()) << "it would have to be opened";
  EXPECT_EQ(all[1].name, "unborn");
  EXPECT_TRUE(all[1].open);
  EXPECT_EQ(all[1].bytes, 0U);
  EXPECT_TRUE(all[1].changed_at.empty());
  EXPECT_EQ(all[1].clients, 1U);
  EXPECT_EQ(all[1].versions, 0U);
  EXPECT_FALSE(all[1].head.has_value());
  EXPECT_EQ(all[2].name, "wing");
  EXPECT_TRUE(all[2].open);
  EXPECT_EQ(all[2].clients, 2U);
  EXPECT_GT(all[2].bytes, 0U);
  EXPECT_EQ(all[2].versions, 2U);
  EXPECT_EQ(all[2].head, 1U);

  value(user->undo());
  EXPECT_EQ(value(user->list_documents())[2].head, 0U);
}

TEST_F(Library, ACopyOfAnOpenDocumentHasAllThatWasAcknowledgedAndGoesItsOwnWay) {
  make("wing");
  value(user->annotate(1, "thicker", "by a quarter"));

  value(user->copy_document("wing", "tail"));

  value(user->edit("thicken", {6}, {{"depth", 0.25e-3}}, {}));
  const auto other = connect(host->url());
  const auto copy = value(other->open("tail", false, false));
  EXPECT_EQ(copy.head->number, 1U);
  EXPECT_EQ(copy.head->name, "thicker");
  EXPECT_EQ(value(other->undo()).head.number, 0U);
  EXPECT_EQ(value(user->get_history()).versions.size(), 3U);
  EXPECT_EQ(value(other->get_history()).versions.size(), 2U);
}

TEST_F(Library, ACopyOfAClosedDocumentIsTheSameAndAskingForItOpensNothing) {
  make("wing");
  const auto head = value(user->get_history()).versions[1].version_id;
  restart();

  value(user->copy_document("wing", "tail"));

  EXPECT_EQ(value(user->status()).documents, 0U);
  EXPECT_EQ(value(user->open("tail", false, false)).head->version_id, head);
  EXPECT_EQ(value(user->open("wing", false, false)).head->version_id, head);
}

TEST_F(Library, ACopyThatIsRefusedSaysWhyAndMakesNothing) {
  make("wing");
  value(user->copy_document("wing", "tail"));
  const auto other = connect(host->url());
  value(other->open("unborn", false, false));
  std::ofstream(documents.path() / "letter.tedit") << "Dear";
  const auto before = files();

  const auto refusal = [&](const std::string& from, const std::string& to) {
    const auto got = user->copy_document(from, to);
    EXPECT_FALSE(got.has_value()) << from << " to " << to;
    EXPECT_FALSE(got || got.error().remedy.empty()) << from << " to " << to;
    return got ? error{} : got.error();
  };
  for (const auto* taken : {"tail", "wing", "unborn", "letter"}) {
    const auto why = refusal("wing", taken);
    EXPECT_EQ(why.code, ec::conflict) << taken;
    EXPECT_THAT(why.message, HasSubstr(std::string("there is a document ") + taken));
  }
  for (const std::string& name :
       {std::string(), std::string("../wing2"), std::string("two words"), std::string(".hidden"),
        std::string("a/b"), std::string("flügel"), std::string("nul\0l", 5)})
    EXPECT_EQ(refusal("wing", name).code, ec::invalid_argument) << name;
  EXPECT_EQ(refusal("wing", std::string(65, 'a')).code, ec::invalid_argument);
  for (const std::string name : {"", "../wing", "/etc/passwd", ".tedit-lock"})
    EXPECT_EQ(refusal(name, "new").code, ec::invalid_argument) << name;
  EXPECT_EQ(refusal("nothing", "new").code, ec::not_found);
  EXPECT_EQ(refusal("unborn", "new").code, ec::not_found) << "it holds nothing yet";
  EXPECT_EQ(refusal("letter", "new").code, ec::storage_error);
  EXPECT_EQ(files(), before);
}

TEST_F(Library, ADocumentIsDeletedByWhoHasItOpenAndItsNameIsFree) {
  make("wing");
  value(user->copy_document("wing", "tail"));

  value(user->delete_document("wing"));

  EXPECT_EQ(files(), std::set<std::string>{"tail.tedit"});
  EXPECT_EQ(user->undo().error().code, ec::invalid_argument) << "no document is open";
  EXPECT_EQ(user->delete_document("wing").error().code, ec::not_found);
  EXPECT_FALSE(value(user->open("wing", false, false)).head.has_value()) << "a new one";
  restart();
  EXPECT_THAT(names(), ElementsAre("tail"));
}

TEST_F(Library, AClosedDocumentIsDeletedAndSoIsADamagedOne) {
  make("wing");
  make("tail");
  restart();
  {
    std::fstream bytes(documents.path() / "tail.tedit",
                       std::ios::binary | std::ios::in | std::ios::out);
    bytes.seekp(6000);
    bytes << std::string(3000, 'x');
  }
  EXPECT_FALSE(user->open("tail", false, false).has_value());
  value(user->delete_document("wing"));
  value(user->delete_document("tail"));
  EXPECT_TRUE(files().empty());
}

TEST_F(Library, NobodyDeletesWhatAnotherHasOpen) {
  make("wing");
  auto other = connect(host->url());
  value(other->open("wing", true, false));

  for (auto* who : {&user, &other}) {
    const auto refused = (*who)->delete_document("wing");
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ec::conflict);
    EXPECT_THAT(refused.error().message, HasSubstr("wing is open in other clients (1: "));
    EXPECT_THAT(refused.error().remedy, HasSubstr("closed there"));
  }
  EXPECT_EQ(value(user->undo()).head.number, 0U) << "all goes on as before";
  value(other->wait_surface(value(user->redo()).head.version_id, patience).map([](auto&&) {
    return 0;
  }));

  value(other->close_document());
  value(other->close_document());
  EXPECT_EQ(other->undo().error().code, ec::invalid_argument) << "none is open";
  value(user->delete_document("wing"));
  EXPECT_TRUE(files().empty());
}

TEST_F(Library, WhatIsNoDocumentIsNotDeleted) {
  std::ofstream(documents.path() / "letter.tedit") << "Dear";
  std::ofstream(documents.path() / ".tedit-names") << "";
  for (const std::string name :
       {"", "../letter", "letter.tedit/..", ".tedit-names", "two words", "/etc/passwd"})
    EXPECT_EQ(user->delete_document(name).error().code, ec::invalid_argument) << name;
  EXPECT_EQ(user->delete_document(std::string(3000, 'a')).error().code, ec::invalid_argument);
  const auto refused = user->delete_document("letter");
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ec::storage_error);
  EXPECT_THAT(refused.error().remedy, HasSubstr("by hand"));
  EXPECT_TRUE(std::filesystem::exists(documents.path() / "letter.tedit"));
}

TEST_F(Library, NamesOfBeforeDoNotBringADeletedDocumentBackNorLeadToALaterOne) {
  make("cube");
  value(user->rename_document("wing"));
  value(user->delete_document("cube"));  // It is still known by that.
  EXPECT_TRUE(files().empty());
  make("wing");
  const auto other = connect(host->url());
  const auto found = value(other->open("cube", false, false));
  EXPECT_EQ(found.document, "cube");
  EXPECT_FALSE(found.head.has_value());

  restart();
  EXPECT_EQ(value(user->open("cube", false, false)).document, "cube") << "also after a restart";
}

/// Whatever the order, everybody gets an answer, and a copy is whole.
TEST_F(Library, ManyCopiesAndDeletionsAtOnceLeaveWhatTheySaid) {
  make("wing");
  std::atomic<bool> end = false;
  std::thread editor([&] {
    while (!end) {
      value(user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {}));
      value(user->undo());
    }
  });
  std::vector<std::future<std::set<std::string>>> workers;
  for (int w = 0; w < 3; ++w)
    workers.push_back(std::async(std::launch::async, [&, w] {
      const auto mine = connect(host->url());
      std::set<std::string> there;
      for (int i = 0; i < 12; ++i) {
        const auto name = "copy-" + std::to_string(w) + "-" + std::to_string(i);
        value(mine->copy_document(i % 3 == 1 && !there.empty() ? *there.begin() : "wing", name));
        there.insert(name);
        if (i % 2 == 0) {
          value(mine->delete_document(*there.begin()));
          there.erase(there.begin());
        }
      }
      return there;
    }));
  std::set<std::string> expected_names{"wing"};
  for (auto& one : workers)
    expected_names.merge(one.get());
  end = true;
  editor.join();

  restart();
  const auto found = names();
  EXPECT_EQ(std::set(found.begin(), found.end()), expected_names);
  for (const auto& name : found)
    EXPECT_TRUE(value(user->open(name, false, false)).head.has_value()) << name;
}

}  // namespace
}  // namespace tedit::test
