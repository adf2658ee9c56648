// SPDX-License-Identifier: AGPL-3.0-or-later
// Documents that get another name while people work on them.
#include <atomic>
#include <fstream>
#include <future>
#include <set>
#include <thread>

#include "actors/store/document_lock.hpp"
#include "tests/scenarios/fixture.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/raw_client.hpp"

namespace tedit::test {
namespace {

using ::testing::HasSubstr;

class Rename : public ::testing::Test {
protected:
  const scratch_folder documents;
  std::unique_ptr<server> host = start(options_for(documents, false));
  std::unique_ptr<client::client> user = connect(host->url());

  void make(const std::string& name) {
    value(user->open(name, true, false));
    value(user->import_file(test::cube_mesh, "mm", {}));
  }

  /// The documents that have a file.
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(documents.path()))
      if (entry.path().extension() == ".tedit")
        result.insert(entry.path().stem().string());
    return result;
  }

  void restart() {
    user.reset();
    host.reset();
    host = start(options_for(documents, false));
    user = connect(host->url());
  }
};

TEST_F(Rename, AllWhoHaveItOpenGoOnUnderTheNewName) {
  make("cube");
  std::promise<std::string> heard;
  client::events handlers;
  handlers.on_renamed = [&](const std::string& name) { heard.set_value(name); };
  const auto other = connect(host->url(), handlers);
  value(other->open("cube", true, false));

  value(user->rename_document("wing"));

  EXPECT_EQ(heard.get_future().get(), "wing");
  EXPECT_EQ(names(), std::set<std::string>{"wing"});
  const auto mine = value(user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {}));
  value(other->wait_surface(mine.head.version_id, patience));
  const auto theirs = value(other->edit("thicken", {6}, {{"depth", 0.25e-3}}, {}));
  value(user->wait_surface(theirs.head.version_id, patience));
  value(other->wait_surface(theirs.head.version_id, patience));
  expect_same(user->surface(), other->surface());
  value(other->annotate(2, "both", {}));

  restart();
  EXPECT_EQ(value(user->open("cube", false, false)).document, "wing") << "for a day";
  const auto again = value(user->open("wing", false, false));
  EXPECT_EQ(again.head->version_id, theirs.head.version_id);
  EXPECT_EQ(again.head->name, "both");
}

TEST_F(Rename, WhoComesBackWithTheNameBeforeFindsItUntilAnotherDocumentTakesThat) {
  make("cube");
  value(user->rename_document("wing"));
  value(user->rename_document("tail"));
  const auto late = connect(host->url());
  for (const auto* name : {"cube", "wing", "tail"})
    EXPECT_EQ(value(late->open(name, false, false)).document, "tail") << name;

  const scratch_folder elsewhere;
  const auto file = elsewhere.path() / "mailed.tedit";
  const auto bytes = value(late->export_file("tedit", {}, {}, {}));
  std::ofstream(file, std::ios::binary).write(bytes.data(), std::ssize(bytes));
  EXPECT_EQ(value(late->add_document(file, "cube", false, {})), "cube");

  EXPECT_EQ(value(late->open("cube", false, false)).document, "cube");
  EXPECT_EQ(value(late->open("wing", false, false)).document, "tail");
  value(late->open("cube", false, false));
  value(late->rename_document("wing"));
  EXPECT_EQ(value(late->open("wing", false, false)).document, "wing");
  EXPECT_EQ(names(), (std::set<std::string>{"tail", "wing"}));
}

TEST_F(Rename, WhatIsRefusedSaysWhyAndChangesNothing) {
  make("closed");
  restart();
  value(user->open("unborn", false, false));
  make("cube");
  std::ofstream(documents.path() / "letter.tedit") << "Dear";
  const auto before = names();

  for (const auto* name : {"", "../cube", "two words", ".hidden"}) {
    const auto refused = user->rename_document(name);
    ASSERT_FALSE(refused.has_value()) << name;
    EXPECT_EQ(refused.error().code, ec::invalid_argument);
    EXPECT_THAT(refused.error().remedy, HasSubstr("64 letters"));
  }
  EXPECT_EQ(user->rename_document(std::string(65, 'a')).error().code, ec::invalid_argument);
  for (const auto* name : {"closed", "unborn", "letter"}) {
    const auto refused = user->rename_document(name);
    ASSERT_FALSE(refused.has_value()) << name;
    EXPECT_EQ(refused.error().code, ec::conflict);
    EXPECT_THAT(refused.error().message, HasSubstr(std::string("there is a document ") + name));
    EXPECT_FALSE(refused.error().remedy.empty());
  }
  EXPECT_EQ(user->rename_document("wing", "another").error().code, ec::conflict);

  EXPECT_EQ(names(), before);
  EXPECT_EQ(value(user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {})).head.number, 1U);
  EXPECT_EQ(value(user->open("cube", false, false)).head->number, 1U);
}

TEST_F(Rename, AskedForAgainIsDoneAlready) {
  make("cube");
  value(user->rename_document("wing"));
  value(user->rename_document("wing"));
  const auto other = connect(host->url());
  value(other->open("cube", false, false));
  value(other->rename_document("wing"));
  EXPECT_EQ(names(), std::set<std::string>{"wing"});
}

TEST_F(Rename, AClosedDocumentGetsAnotherNameAndIsClosedAfterwards) {
  make("cube");
  restart();

  value(user->rename_on_server("cube", "wing"));

  EXPECT_EQ(names(), std::set<std::string>{"wing"});
  const auto listed = value(user->list_documents());
  ASSERT_EQ(listed.size(), 1U);
  EXPECT_EQ(listed[0].name, "wing");
  EXPECT_FALSE(listed[0].open);
  value(user->rename_on_server("cube", "wing"));  // Done already.
  value(user->rename_on_server("wing", "wing"));
  value(user->rename_on_server("cube", "tail"));  // It is known by that still.
  EXPECT_EQ(names(), std::set<std::string>{"tail"});
  for (const auto* name : {"cube", "wing"})
    EXPECT_EQ(value(user->open(name, false, false)).document, "tail") << name;
  EXPECT_EQ(value(user->get_history()).versions.size(), 1U);
}

TEST_F(Rename, OfADocumentThatOthersHaveOpenTheyAreTold) {
  make("cube");
  std::promise<std::string> heard;
  client::events handlers;
  handlers.on_renamed = [&](const std::string& name) { heard.set_value(name); };
  const auto other = connect(host->url(), handlers);
  value(other->open("cube", true, false));
  value(user->open("another", false, false));

  value(user->rename_on_server("cube", "wing"));

  EXPECT_EQ(heard.get_future().get(), "wing");
  EXPECT_EQ(value(other->edit("thicken", {4}, {{"depth", 0.25e-3}}, {})).head.number, 1U);
}

TEST_F(Rename, WhatIsRefusedOfAClosedOneSaysWhyAndChangesNothing) {
  make("cube");
  make("tail");
  restart();
  std::ofstream(documents.path() / "letter.tedit") << "Dear";
  const auto before = names();
  const auto refused = [&](const std::string& document, const std::string& name) {
    const auto done = user->rename_on_server(document, name);
    EXPECT_FALSE(done.has_value()) << document << " -> " << name;
    return done ? error{} : done.error();
  };

  auto why = refused("cube", "tail");
  EXPECT_EQ(why.code, ec::conflict);
  EXPECT_EQ(why.message, "there is a document tail already");
  EXPECT_EQ(why.remedy, "Give this one another name");
  why = refused("wing", "fin");
  EXPECT_EQ(why.code, ec::not_found);
  EXPECT_EQ(why.message, "there is no document wing");
  EXPECT_FALSE(why.remedy.empty());
  EXPECT_EQ(refused("cube", "two words").code, ec::invalid_argument);
  EXPECT_EQ(refused("../cube", "fin").code, ec::invalid_argument);
  why = refused("letter", "fin");
  EXPECT_EQ(why.code, ec::storage_error);
  EXPECT_THAT(why.message, HasSubstr("letter.tedit is not a database"));
  {
    auto elsewhere = store::document_lock::take(documents.path() / "cube.tedit");
    // The server may still be closing what it opened to find the name taken.
    for (const auto until = std::chrono::steady_clock::now() + patience;
         !elsewhere && std::chrono::steady_clock::now() < until;
         elsewhere = store::document_lock::take(documents.path() / "cube.tedit"))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ASSERT_TRUE(elsewhere.has_value());
    why = refused("cube", "fin");
    EXPECT_EQ(why.code, ec::conflict);
    EXPECT_THAT(why.message, HasSubstr("cube.tedit"));
    EXPECT_FALSE(why.remedy.empty());
  }

  EXPECT_EQ(names(), before);
  for (const auto until = std::chrono::steady_clock::now() + patience;
       value(user->status()).documents > 0 && std::chrono::steady_clock::now() < until;)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(value(user->status()).documents, 0U);
  value(user->rename_on_server("cube", "fin"));
  EXPECT_EQ(value(user->open("fin", false, false)).head->number, 0U);
}

TEST_F(Rename, ADocumentWithoutANameOfItsOwnIsGivenOne) {
  EXPECT_THAT(value(user->open("", true, false)).document, HasSubstr("temporary-"));
  value(user->rename_document("wing"));
  EXPECT_TRUE(names().empty());

  value(user->import_file(test::cube_mesh, "mm", {}));
  EXPECT_EQ(names(), std::set<std::string>{"wing"});
  value(user->open("", true, false));
  value(user->import_file(test::cube_mesh, "mm", {}));
  value(user->rename_document("tail"));
  EXPECT_EQ(names(), (std::set<std::string>{"tail", "wing"}));
}

/// As one that was sent before its client heard of the new name.
TEST_F(Rename, ARequestWithTheNameBeforeIsStillUnderstood) {
  make("cube");
  raw_client raw(host->url());
  raw.hello(test::server_token);
  v1::ClientMessage open;
  open.mutable_open_document()->set_name("cube");
  ASSERT_TRUE(raw.ask(open).has_document_state());
  value(user->rename_document("wing"));
  const auto heard = raw.wait([](const v1::ServerMessage& m) { return m.has_document_renamed(); });
  EXPECT_EQ(heard.document_renamed().before(), "cube");
  EXPECT_EQ(heard.document_renamed().document(), "wing");

  v1::ClientMessage ask;
  ask.mutable_get_history()->set_document("cube");
  EXPECT_EQ(raw.ask(ask).history().document(), "wing");
  v1::ClientMessage close;
  close.mutable_close_document()->set_document("cube");
  EXPECT_TRUE(raw.ask(close).has_done());
  EXPECT_EQ(raw.ask(ask).error().code(), "not_found");
}

TEST_F(Rename, NothingIsLostOfWhatOthersDoMeanwhile) {
  make("cube");
  std::atomic<bool> end = false;
  std::atomic<int> made = 0;
  std::thread editor([&] {
    const auto other = connect(host->url());
    value(other->open("cube", true, false));
    while (!end) {
      value(other->annotate(0, std::to_string(made + 1), {}));
      ++made;
      made.notify_one();
      value(other->edit("thicken", {4}, {{"depth", 0.25e-3}}, {}));
      value(other->undo());
    }
  });
  made.wait(0);  // Or all names may be given before the other is there.
  for (int i = 0; i < 30; ++i)
    value(user->rename_document("name-" + std::to_string(i)));
  end = true;
  editor.join();
  const auto versions = value(user->get_history()).versions.size();

  restart();
  EXPECT_EQ(names(), std::set<std::string>{"name-29"});
  const auto state = value(user->open("name-29", false, false));
  EXPECT_EQ(state.head->name, std::to_string(made));
  EXPECT_EQ(value(user->get_history()).versions.size(), versions);
}

/// Who copies the file has the whole document.
TEST_F(Rename, ADocumentThatIsClosedIsOneFileAfterAWhile) {
  make("cube");
  value(user->edit("thicken", {4}, {{"depth", 0.25e-3}}, {}));
  value(user->open("other", false, false));  // The client closes the first for it.

  const auto beside = [&](const char* end) {
    return std::filesystem::exists(documents.path() / (std::string("cube.tedit") + end));
  };
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while ((beside("-wal") || beside("-shm")) && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));

  EXPECT_FALSE(beside("-wal"));
  EXPECT_FALSE(beside("-shm"));
  const scratch_folder elsewhere;
  std::filesystem::copy_file(documents.path() / "cube.tedit", elsewhere.path() / "cube.tedit");
  const auto second = start(options_for(elsewhere, false));
  EXPECT_EQ(value(connect(second->url())->open("cube", false, false)).head->number, 1U);
}

}  // namespace
}  // namespace tedit::test
